#include "native/rank_run.hpp"

#include "native/native_run.hpp"
#include "native/native_trace.hpp"
#include "native/pace.hpp"
#include "native/placement.hpp"
#include "native/rank_channel.hpp"
#include "native/rank_clock.hpp"
#include "native/rank_member.hpp"
#include "native/rank_result.hpp"
#include "native/run_parts.hpp"
#include "netlist/failed_process.hpp"
#include "netlist/network/names.hpp"
#include "netlist/software.hpp"
#include "ranks/ranks.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <limits>
#include <list>
#include <mutex>
#include <stdexcept>
#include <stop_token>
#include <thread>
#include <utility>

namespace placedpar {

namespace {

using namespace native;

constexpr std::size_t most_ranks = std::numeric_limits<std::size_t>::max(); // the number of ranks has no limit here

/// Returns the rank of each node.
std::vector<std::size_t> ranks_of_nodes(const Network& network, const RankRunSettings& settings, std::size_t ranks) {
    return place_nodes(network, {ranks, "rank", "mpirun -n", most_ranks},
                       settings.loads ? settings.loads() : std::vector<Time>{});
}

/// Throws UserError if messages of the channel cannot travel to another rank.
void require_packed_form(const AnyChannel& channel, const NetworkChannel& declared, const Network& network) {
    if (channel.packed_form())
        return;
    const ProcessInstance& from = network.processes[declared.from.process];
    throw UserError(fmt::format("{}: the channel \"{}\" from the port \"{}\" of kind \"{}\" leads to another rank, but "
                                "its messages cannot be packed: the kind must define a PackedForm",
                                declared.connected.text(), declared.name, declared.from.port, from.kind));
}

/// Calls an action about ten times a second, on a thread of its own.
class Watcher {
public:
    explicit Watcher(std::function<void()> action)
        : thread_([this, action = std::move(action)](const std::stop_token& ended) {
              std::unique_lock lock(mutex_);
              while (!changed_.wait_for(lock, ended, std::chrono::milliseconds(100), [] { return false; }) &&
                     !ended.stop_requested())
                  action();
          }) {}

private:
    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::jthread thread_; ///< destroyed first
};

enum class Note : std::uint8_t { of_a_process, result };

/// The part of a native run in this rank, that is, in this copy of the program that mpirun started.
class RankRun {
public:
    RankRun(const Network& network, const RankRunSettings& settings, Ranks& ranks, RankMail& mail)
        : network_(network), settings_(settings), ranks_(ranks), mail_(mail),
          results_(static_cast<std::size_t>(mail.count())),
          rank_of_node_(ranks_of_nodes(network, settings, results_.size())),
          member_(mail, simulation_, network.channels.size()) {
        catalogue_ = settings.make_catalogue([this](MessageBytes note) {
            note.push_back(static_cast<std::uint8_t>(Note::of_a_process));
            member_.send_note(std::move(note));
        });
        software_.emplace(network, *catalogue_, settings.seed);
        for (std::size_t i = 0; i < network.channels.size(); ++i)
            lead(i);
        start_processes();
        member_.receive_notes([this](int from, const MessageBytes& note) { take_note(from, note); });
        member_.before_reports([this] { note_ends(); });
        if (settings.trace)
            simulation_.trace_to(
                log_.emplace(simulation_.kernel(), settings.trace->until(), settings.trace->most_of(results_.size())));
    }

    /// Returns the rank of each node, as a text.
    std::string placement() const { return fmt::format("{}", fmt::join(rank_of_node_, " ")); }

    std::optional<RunReport> run() {
        const std::vector<ComparedClock> before = compare_clocks_if_recorded();
        execute();
        const std::vector<ComparedClock> after = compare_clocks_if_recorded();
        if (!is_first()) {
            MessageBytes note = packed(own_result());
            note.push_back(static_cast<std::uint8_t>(Note::result));
            member_.send_note(std::move(note));
            return std::nullopt;
        }
        member_.receive_notes_until([this] { return results_come_ + 1 == results_.size(); });
        if (observing_failed_)
            std::rethrow_exception(observing_failed_);
        rethrow_failure();
        RunReport common = report();
        if (log_)
            hand_over_logs(common, before, after);
        return common;
    }

private:
    std::size_t own() const { return static_cast<std::size_t>(mail_.own()); }
    bool is_first() const { return own() == 0; }
    std::size_t rank_of(std::size_t process) const { return rank_of_node_[network_.processes[process].node]; }

    std::vector<ComparedClock> compare_clocks_if_recorded() {
        return log_ ? compare_clocks(ranks_) : std::vector<ComparedClock>{};
    }

    /// Connects this rank's end of a channel that leads to or from another rank.
    void lead(std::size_t number) {
        const NetworkChannel& declared = network_.channels[number];
        if (declared.from.at_edge() || declared.to.at_edge())
            return;
        const std::size_t from = rank_of(declared.from.process), to = rank_of(declared.to.process);
        AnyChannel& channel = software_->channel(number);
        if (from == to)
            return;
        require_packed_form(channel, declared, network_);
        if (from == own())
            givers_.emplace_back(member_, channel, number, static_cast<int>(to));
        else if (to == own())
            takers_.emplace_back(member_, channel, number, static_cast<int>(from));
        else
            return;
        led_.push_back(&channel);
    }

    void start_processes() {
        std::vector<bool> nodes(network_.nodes.size());
        for (std::size_t i = 0; i < nodes.size(); ++i)
            nodes[i] = rank_of_node_[i] == own();
        Pace* const pace = settings_.pace > 0 ? &simulation_.add<Pace>(network_, settings_.pace) : nullptr;
        software_->start_natively(simulation_, nodes, pace);
        software_->expect_partners(software_->processes());
    }

    void execute() {
        member_.begin();
        const Watcher watcher([this] {
            if (settings_.is_interrupted())
                member_.interrupt();
        });
        RankResult& own = results_[this->own()];
        try {
            own.part.result = simulation_.run(Time::max(), [&] { own.part.waited = times_waited(*software_); });
        } catch (...) {
            own.failure = describe_failure();
        }
    }

    /// Describes the current exception.
    RankFailure describe_failure() const {
        RankFailure failure{Time::max(), true, ""};
        try {
            if (!simulation_.who_failed())
                throw;
            failure.time = simulation_.who_failed()->time;
            rethrow_with_process(*simulation_.who_failed(), network_, *catalogue_);
        } catch (const UserError& refused) {
            failure.is_defect = false;
            failure.text = refused.what();
        } catch (const std::exception& thrown) {
            failure.text = thrown.what();
        }
        return failure;
    }

    /// Notes which processes use the ends of channels between ranks, for the report of a deadlock. This function is
    /// called when all ranks have stopped, while their processes still wait.
    void note_ends() { results_[own()].ends = users_of(led_, simulation_.kernel()); }

    RankResult& own_result() {
        RankResult& own = results_[this->own()];
        own.part.measurements = software_->measurements();
        own.part.rested = member_.rested();
        own.part.waited.resize(network_.processes.size());
        own.part.sent.resize(results_.size());
        for (const RankGiver& giver : givers_)
            own.part.sent[static_cast<std::size_t>(giver.to())].add(giver.sent());
        own.begun = member_.begun();
        if (log_)
            own.notices = log_->take();
        return own;
    }

    void take_note(int from, const MessageBytes& note) {
        const std::span<const std::uint8_t> bytes(note.data(), note.size() - 1);
        try {
            if (static_cast<Note>(note.back()) == Note::of_a_process)
                return settings_.receive_note(bytes);
            results_[static_cast<std::size_t>(from)] = rank_result_from(bytes);
            ++results_come_;
        } catch (...) {
            observing_failed_ = std::current_exception();
            member_.interrupt();
        }
    }

    /// Throws the earliest failure of all ranks, if there is one.
    void rethrow_failure() const {
        const auto time = [](const RankResult& result) { return result.failure ? result.failure->time : Time::max(); };
        auto first = std::ranges::min_element(results_, {}, time);
        if (!first->failure)
            first = std::ranges::find_if(results_, [](const RankResult& each) { return each.failure.has_value(); });
        if (first == results_.end())
            return;
        const std::string text = fmt::format("rank {}: {}", first - results_.begin(), first->failure->text);
        if (first->failure->is_defect)
            throw std::logic_error(text);
        throw UserError(text);
    }

    /// Converts the records of all ranks to the clock of rank 0, and passes them to the trace. The run lasts from the
    /// moment at which the first rank began to the moment at which the last rank ended.
    void hand_over_logs(RunReport& report, const std::vector<ComparedClock>& before,
                        const std::vector<ComparedClock>& after) {
        std::vector<Reading> begun;
        for (const RankResult& result : results_)
            begun.push_back(result.begun);
        const CommonClock clock(before, after, std::move(begun));
        std::vector<Notices> logs;
        for (std::size_t rank = 0; rank < results_.size(); ++rank) {
            Notices& log = logs.emplace_back(std::move(results_[rank].notices));
            const auto convert = [&](Time& time) { time = clock.convert(rank, time); };
            std::ranges::for_each(log.all, convert, &Notice::at);
            convert(log.over);
            if (log.full_at)
                convert(*log.full_at);
            report.result.time = std::max(report.result.time, log.over);
        }
        report.clocks = clock.clocks();
        settings_.trace->set("rank", std::move(logs));
    }

    RunReport report() {
        own_result();
        std::optional<Deadlock> deadlock = join_deadlocks(results_, network_);
        std::vector<RunPart> parts;
        for (RankResult& result : results_) {
            parts.push_back(std::move(result.part));
            parts.back().result.deadlock.reset();
        }
        parts.front().result.deadlock = std::move(deadlock);
        return join_parts(network_, rank_of_node_, "rank", std::move(parts));
    }

    const Network& network_;
    const RankRunSettings& settings_;
    Ranks& ranks_;
    RankMail& mail_;
    std::vector<RankResult> results_; ///< by rank; a rank above 0 uses only its own result
    std::size_t results_come_ = 0;    ///< number of results that have arrived from other ranks
    std::exception_ptr observing_failed_;
    std::vector<std::size_t> rank_of_node_;
    std::shared_ptr<const Catalogue> catalogue_;
    std::optional<Software> software_;
    Simulation simulation_;
    std::optional<NoticeLog> log_; ///< empty if the run is not recorded
    RankMember member_;
    std::list<RankGiver> givers_;
    std::list<RankTaker> takers_;
    std::vector<const AnyChannel*> led_; ///< the channels to and from other ranks
};

} // namespace

std::optional<RunReport> run_on_ranks(const Network& network, const RankRunSettings& settings, Ranks& ranks) {
    const std::unique_ptr<RankMail> mail = ranks.open_mail();
    std::optional<RankRun> run;
    const auto prepare = [&] {
        require_native(network);
        require_enough_nodes(network, static_cast<std::size_t>(ranks.count()));
        run.emplace(network, settings, ranks, *mail);
        if (settings.loads && settings.is_interrupted())
            throw UserError("interrupted before the run began");
        return run->placement();
    };
    return all_prepared(ranks, prepare) ? run->run() : std::nullopt;
}

} // namespace placedpar
