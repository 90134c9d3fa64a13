#include "gaprocs/processes/kinds.hpp"

#include "gaprocs/processes/estimates.hpp"
#include "gaprocs/processes/kind_checks.hpp"
#include "gaprocs/processes/messages.hpp"
#include "gaprocs/processes/peers.hpp"
#include "gaprocs/processes/search_description.hpp"
#include "gaprocs/usual_settings.hpp"
#include "netlist/kinds/description.hpp"
#include "netlist/kinds/environment.hpp"
#include "runtime/channel.hpp"
#include "runtime/parallel.hpp"
#include "runtime/timer.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <limits>
#include <string>
#include <utility>
#include <variant>

namespace placedpar {

namespace {

std::size_t samples_to_send(const ProcessEnvironment& environment, std::size_t recorded) {
    auto wanted = static_cast<std::size_t>(environment.integer("samples"));
    if (wanted > recorded)
        throw UserError(fmt::format("samples = {}, but the record of \"{}\" has only {}", wanted,
                                    environment.text("problem"), recorded));
    return wanted == 0 ? recorded : wanted;
}

/// Returns the samples that the host sends. If the problem has an objective, returns one empty sample for each
/// generation.
std::vector<Sample> samples_of(const ProcessEnvironment& environment, const RecordedProblem& recorded) {
    if (recorded.problem()->objective())
        return empty_record(static_cast<std::size_t>(environment.integer("generations")));
    auto first = recorded.record().begin();
    return {first, first + static_cast<std::ptrdiff_t>(samples_to_send(environment, recorded.samples()))};
}

/// Collects the times of one stage on the way of the samples from the sensors to the masters.
class Stage {
public:
    void note(Time time) {
        all_ += time;
        longest_ = std::max(longest_, time);
        ++count_;
    }
    void report(ProcessEnvironment& environment, const std::string& name) const {
        if (count_ == 0)
            return;
        environment.measure(name, in_milliseconds(all_) / static_cast<double>(count_), "ms");
        environment.measure("longest_" + name, in_milliseconds(longest_), "ms");
    }

private:
    Time all_{}, longest_{};
    std::size_t count_ = 0;
};

/// The host computer's process. It sends each sample to every master as soon as the master takes it, and receives the
/// estimates. The samples come from the sensors, or from the record if no sensors are connected.
class Host {
public:
    Host(ProcessEnvironment& environment, const ProblemRegistry& problems)
        : environment_(environment), recorded_(problems.find(environment.text("problem"))),
          samples_(samples_of(environment, recorded_)),
          bytes_(recorded_.problem()->channels() == 0
                     ? 0
                     : static_cast<std::uint32_t>(environment.integer("sample_bytes"))),
          to_masters_(environment.outputs<HostMessage>("to_masters")),
          masters_(peers_at(environment.network(), environment.index(), "to_masters")),
          estimates_(environment, problems) {
        if (environment.connected("to_alarm"))
            for (std::size_t search = 0; search < estimates_.searches(); ++search)
                answered_.emplace_back("answered to " + environment.process());
    }

    void run() {
        const bool has_sensors = environment_.connected("from_sensors");
        const std::size_t senders = has_sensors ? 1 : to_masters_.size();
        par_for(senders + estimates_.searches() + (answered_.empty() ? 0 : 1), [&](std::size_t i) {
            if (i < senders)
                has_sensors ? pass_on() : send(i);
            else if (i < senders + estimates_.searches())
                receive(i - senders);
            else
                tell_alarm();
        });
        from_sensors_.report(environment_, "from_sensors");
        to_all_.report(environment_, "to_masters");
        estimates_.report();
    }

private:
    void send(std::size_t master) {
        HostMessage message;
        message.bytes = bytes_;
        for (const Sample& sample : samples_) {
            message.sample = sample;
            to_masters_[master].output(message);
            estimates_.note_taken(masters_[master].process);
        }
        message.end = true;
        to_masters_[master].output(message);
    }

    /// Passes on each sample of the sensors to all masters in parallel.
    void pass_on() {
        auto sensors = environment_.input<HostMessage>("from_sensors");
        for (bool end = false; !end;) {
            HostMessage message = sensors.input();
            const Time arrived = now();
            end = message.end;
            if (!end) {
                from_sensors_.note(arrived - message.read_at);
                read_at_.push_back(message.read_at);
            }
            message.bytes = bytes_;
            par_for(to_masters_.size(), [&](std::size_t master) {
                to_masters_[master].output(message);
                if (!end)
                    estimates_.note_taken(masters_[master].process);
            });
            if (!end)
                to_all_.note(now() - arrived);
        }
    }

    void receive(std::size_t search) {
        if (answered_.empty())
            return estimates_.receive(search, [](std::size_t) {});
        auto answered = answered_[search].out();
        estimates_.receive(search, [&](std::size_t samples) { answered.output(samples); });
        answered.output(no_more);
    }

    /// Sends the fittest estimate to the alarm each time that all searches have answered a sample.
    void tell_alarm() {
        auto alarm = environment_.output<Finding>("to_alarm");
        std::vector<std::size_t> answered(answered_.size(), 0);
        for (;;) {
            const auto last = static_cast<std::size_t>(std::ranges::min_element(answered) - answered.begin());
            if (answered[last] == no_more)
                break;
            answered[last] = answered_[last].in().input();
            if (const std::size_t samples = answered[last];
                std::ranges::count(answered, samples) == std::ssize(answered) && samples != no_more)
                alarm.output({{finding_bytes},
                              false,
                              samples,
                              samples <= read_at_.size() ? read_at_[samples - 1] : Time{},
                              now(),
                              estimates_.fittest_values()});
        }
        alarm.output({{finding_bytes}, true, 0, {}, {}, {}});
    }

    static constexpr std::size_t no_more = std::numeric_limits<std::size_t>::max();
    static constexpr std::uint32_t finding_bytes =
        16; ///< 4 bytes for the sample's number, 4 for the time, 8 for a parameter

    ProcessEnvironment& environment_;
    const RecordedProblem& recorded_;
    std::vector<Sample> samples_;
    std::uint32_t bytes_;
    std::vector<Output<HostMessage>> to_masters_;
    std::vector<Peer> masters_;
    Estimates estimates_;
    Stage from_sensors_, to_all_;
    std::vector<Time> read_at_; ///< times at which the sensors read their samples
    /// One channel for each search, if there is an alarm. receive() outputs the number of samples that the search has
    /// answered; tell_alarm() inputs this number.
    std::deque<Channel<std::size_t>> answered_;
};

std::vector<MeasurementDescription> host_measurements() {
    std::vector<MeasurementDescription> all{
        {"from_sensors", "ms",
         "mean time from when the sensors read a sample until the host has it; absent without sensors"},
        {"longest_from_sensors", "ms", "the longest of these times"},
        {"to_masters", "ms",
         "mean time from when the host has a sample until all masters have it; absent without sensors"},
        {"longest_to_masters", "ms", "the longest of these times"},
        {"estimates", "", "number of estimates received"},
        {"response", "ms", "mean time from when a master took a sample until its estimate arrived"},
        {"longest_response", "ms", "the longest response"},
        {"accurate_after", "ms",
         "time after which the fittest estimate stays accurate; absent if the last estimate is not accurate"},
        {"best_of", "", "the master whose last estimate is the fittest"},
    };
    for (MeasurementDescription& each :
         search_description::individual_measurements("the fittest of the last estimates"))
        all.push_back(std::move(each));
    return all;
}

} // namespace

ProcessKind host_kind(const ProblemRegistry& problems) {
    using namespace search_description;
    using namespace description;
    return {
        .name = "ga.host",
        .about = "The host computer's process: sends each sample of the problem's record to every master, as fast as "
                 "the masters take it, and receives the estimates that come back.",
        .ports = {output<HostMessage>("to_masters", "host message", "an array: one end for each master"),
                  optional(input<EstimateMessage>("from_masters", "estimate",
                                                  "an array: one end for each master whose estimates come back")),
                  optional(input<HostMessage>("from_sensors", "host message",
                                              "samples that ga.sensors reads; they replace the samples of the record")),
                  optional(
                      output<Finding>("to_alarm", "finding",
                                      "the fittest estimate after each sample, sent when all estimates have arrived"))},
        .parameters = {problem(),
                       integer("samples", {.unit = "samples", .by_default = 0, .least = 0, .most = 1e9},
                               "number of samples of the record that are sent; 0: all"),
                       integer("generations", {.unit = "generations", .by_default = 100, .least = 1, .most = 1e7},
                               "number of generations for a problem without a record; the host requests each "
                               "generation by an empty sample"),
                       bytes_in_message("sample_bytes", 16, "size of a sample in a message"),
                       real("accuracy", {.by_default = 0, .least = 0, .most = 1},
                            "an estimate is accurate if the relative error of each parameter is at most this number; "
                            "only for a simulated record, whose true parameters are known; 0: not checked")},
        .measurements = host_measurements(),
        .body = [&problems](ProcessEnvironment& environment) { Host(environment, problems).run(); },
        .check = [&problems](const Network& network,
                             std::size_t process) { return check_host(network, process, problems); },
        .is_determinate =
            [](const Network& network, std::size_t process) {
                // With the parameter `accuracy` or an alarm, results depend on the order in which estimates arrive.
                return std::get<double>(network.processes[process].parameters.at("accuracy")) == 0 &&
                       !other_end(network, process, "to_alarm");
            }};
}

} // namespace placedpar
