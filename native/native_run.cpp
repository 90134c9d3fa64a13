#include "native/native_run.hpp"

#include "native/crossing.hpp"
#include "native/group.hpp"
#include "native/native_trace.hpp"
#include "native/pace.hpp"
#include "native/placement.hpp"
#include "native/run_parts.hpp"
#include "netlist/failed_process.hpp"
#include "netlist/software.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <exception>
#include <list>
#include <map>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace placedpar {

namespace {

using namespace native;

std::vector<std::size_t> threads_of_nodes(const Network& network, const NativeSettings& settings) {
    return place_nodes(network, {settings.threads}, settings.loads ? settings.loads() : std::vector<Time>{});
}

/// The part of a run that one thread executes.
struct Strand {
    std::shared_ptr<const Catalogue> catalogue;
    std::unique_ptr<Software> software;
    Simulation simulation;
    Pace* pace = nullptr;              ///< null if computations run at the speed of the computer
    std::optional<NoticeLog> log = {}; ///< empty if the run is not recorded
    std::vector<Time> waited = {};     ///< how long each process had waited when the work ended
    std::optional<RunResult> result;   ///< no value if the run threw an exception
    std::exception_ptr thrown;
};

class NativeRun {
public:
    NativeRun(const Network& network, const NativeSettings& settings)
        : network_(network), thread_of_node_(threads_of_nodes(network, settings)), strands_(settings.threads),
          trace_(settings.trace) {
        for (Strand& strand : strands_) {
            strand.catalogue = settings.make_catalogue();
            strand.software = std::make_unique<Software>(network, *strand.catalogue, settings.seed);
            group_.add(strand.simulation);
            if (trace_)
                strand.simulation.trace_to(
                    strand.log.emplace(strand.simulation.kernel(), trace_->until(), trace_->most_of(strands_.size())));
            if (settings.pace > 0)
                strand.pace = &strand.simulation.add<Pace>(network, settings.pace);
        }
        for (std::size_t i = 0; i < network.channels.size(); ++i)
            cross(i);
        start_processes();
    }

    RunReport run(const std::function<bool()>& is_interrupted) {
        std::vector<std::jthread> threads;
        start(threads);
        std::unique_lock lock(mutex_);
        while (!ended_.wait_for(lock, std::chrono::milliseconds(100), [&] { return running_ == 0; }))
            if (is_interrupted())
                group_.interrupt();
        lock.unlock();
        threads.clear();
        rethrow_failure();
        if (trace_)
            hand_over_logs();
        return report();
    }

private:
    std::size_t thread_of(std::size_t process) const { return thread_of_node_[network_.processes[process].node]; }

    void cross(std::size_t channel) {
        const NetworkChannel& c = network_.channels[channel];
        const std::size_t from = thread_of(c.from.process), to = thread_of(c.to.process);
        if (from == to)
            return;
        crossings_[{from, to}].emplace_back(strands_[from].software->channel(channel), group_.member(from),
                                            strands_[to].software->channel(channel), group_.member(to));
    }

    void start_processes() {
        std::vector<Process*> all(network_.processes.size());
        for (std::size_t thread = 0; thread < strands_.size(); ++thread) {
            std::vector<bool> nodes(network_.nodes.size());
            for (std::size_t i = 0; i < nodes.size(); ++i)
                nodes[i] = thread_of_node_[i] == thread;
            strands_[thread].software->start_natively(strands_[thread].simulation, nodes, strands_[thread].pace);
            for (std::size_t i = 0; i < all.size(); ++i)
                if (Process* const made = strands_[thread].software->processes()[i])
                    all[i] = made;
        }
        for (Strand& strand : strands_)
            strand.software->expect_partners(all);
    }

    enum class Gate { closed, open, cancelled };

    void set_gate(Gate gate) {
        gate_ = gate;
        gate_.notify_all();
    }

    /// Starts all threads. No thread begins its part before all threads exist. Otherwise, if a thread could not be
    /// started, the others would wait for it for ever.
    void start(std::vector<std::jthread>& threads) {
        try {
            for (Strand& strand : strands_)
                threads.emplace_back([&] { execute(strand); });
        } catch (const std::system_error& refused) {
            set_gate(Gate::cancelled);
            throw UserError(fmt::format("thread {} of {} cannot be started: {}: give a smaller number to --threads",
                                        threads.size() + 1, strands_.size(), refused.code().message()));
        } catch (...) {
            set_gate(Gate::cancelled);
            throw;
        }
        group_.begin();
        set_gate(Gate::open);
    }

    /// Executes the part on its own thread.
    void execute(Strand& strand) {
        gate_.wait(Gate::closed);
        if (gate_ == Gate::cancelled)
            return;
        try {
            strand.result = strand.simulation.run(Time::max(), [&] { strand.waited = times_waited(*strand.software); });
        } catch (...) {
            strand.thrown = std::current_exception();
        }
        const std::lock_guard lock(mutex_);
        if (--running_ == 0)
            ended_.notify_one();
    }

    /// Returns the part in which a process threw an exception first; null if no process did. Rethrows an exception that
    /// did not come from a process.
    const Strand* first_failure() const {
        const Strand* first = nullptr;
        const auto time = [](const Strand& strand) { return strand.simulation.who_failed()->time; };
        for (const Strand& strand : strands_)
            if (strand.thrown && !strand.simulation.who_failed())
                std::rethrow_exception(strand.thrown);
            else if (strand.thrown && (!first || time(strand) < time(*first)))
                first = &strand;
        return first;
    }

    void rethrow_failure() const {
        const Strand* const first = first_failure();
        if (!first)
            return;
        try {
            std::rethrow_exception(first->thrown);
        } catch (...) {
            rethrow_with_process(*first->simulation.who_failed(), network_, *first->catalogue);
        }
    }

    void hand_over_logs() {
        std::vector<Notices> logs;
        for (Strand& strand : strands_)
            logs.push_back(strand.log->take());
        trace_->set("thread", std::move(logs));
    }

    RunReport report() {
        std::vector<RunPart> parts;
        for (std::size_t i = 0; i < strands_.size(); ++i)
            parts.push_back({std::move(*strands_[i].result), strands_[i].software->measurements(),
                             std::move(strands_[i].waited), group_.member(i).rested()});
        for (const auto& [ends, crossings] : crossings_) {
            const auto [from, to] = ends;
            parts[from].sent.resize(parts.size());
            for (const Crossing& crossing : crossings)
                parts[from].sent[to].add(crossing.sent());
        }
        return join_parts(network_, thread_of_node_, "thread", std::move(parts));
    }

    const Network& network_;
    std::vector<std::size_t> thread_of_node_;
    std::deque<Strand> strands_;
    NativeTrace* trace_;
    Group group_;
    /// The channels between different threads, by the numbers of the sender's and the receiver's thread.
    std::map<std::pair<std::size_t, std::size_t>, std::list<Crossing>> crossings_;
    std::atomic<Gate> gate_{Gate::closed};
    std::mutex mutex_;
    std::condition_variable ended_;
    std::size_t running_ = strands_.size(); ///< number of threads that have not ended
};

} // namespace

void require_native(const Network& network) {
    for (const Node& node : network.nodes)
        if (node.runs_own_code)
            throw UserError(fmt::format("{}: \"{}\" executes the code of a transputer, which cannot run natively",
                                        node.declared.text(), node.name));
    for (const LinkConnection& wire : network.connections)
        if (wire.at_run_time)
            throw UserError(fmt::format("{}: this connection is switched during the run, but a native run has no "
                                        "switches",
                                        wire.connected.text()));
    if (!network.faults.empty())
        throw UserError(fmt::format("{}: a native run cannot have faults, because it has no simulated machine",
                                    network.faults.front().stated.text()));
}

RunReport run_natively(const Network& network, const NativeSettings& settings) {
    require_native(network);
    return NativeRun(network, settings).run(settings.is_interrupted);
}

} // namespace placedpar
