#include "netlist/repeated_run.hpp"

#include "netlist/kinds/own_code.hpp"

#include <algorithm>
#include <map>
#include <new>
#include <string>

namespace placedpar {

bool RecordedRun::can_be_repeated() const {
    return report && report->result.ending == Ending::completed && course.can_be_repeated;
}

bool is_determinate(const Network& network, const Catalogue& catalogue) {
    auto needs_machine = [](const NetworkChannel& channel) {
        return channel.placement.broadcast_on != nowhere || channel.end_at_code();
    };
    if (std::ranges::any_of(network.channels, needs_machine) || !network.faults.empty())
        return false;
    for (std::size_t i = 0; i < network.processes.size(); ++i) {
        const ProcessInstance& process = network.processes[i];
        const ProcessKind& kind = *catalogue.find(process.kind);
        auto says = [&] { return kind.is_determinate && kind.is_determinate(network, i); };
        if (!ask_kind(kind, process, "whether it is determinate", says))
            return false;
    }
    return true;
}

RepeatedRun::RepeatedRun(const Network& network, const Catalogue& catalogue, std::uint64_t seed,
                         const RecordedRun& recorded)
    : network_(network), recorded_(recorded), software_(network, catalogue, seed) {
    software_.start(simulation_, std::vector<Executive*>(network.nodes.size()));
    auto original = recorded.histories.begin();
    for (Process* process : software_.processes())
        process->keep(histories_.emplace_back(course_, *original++));
}

std::optional<RunReport> RepeatedRun::run() {
    RunReport report;
    course_.on_divergence = [this] { simulation_.interrupt(); };
    try {
        report.result = simulation_.run();
    } catch (const std::bad_alloc&) {
        if (!course_.has_diverged)
            throw;
        return std::nullopt;
    } catch (...) { // The repetition is given up for one of two reasons: the process has departed from its recorded
                    // history, or a simulated run would perhaps throw the exception at another time or not at all.
        return std::nullopt;
    }
    if (course_.has_diverged)
        return std::nullopt;
    if (report.result.ending == Ending::interrupted)
        return report;
    if (report.result.ending != Ending::completed)
        return std::nullopt;
    report = *recorded_.report;
    report.measurements = in_recorded_order(software_.measurements());
    report.result.fingerprint = fingerprint_with(recorded_.events, report.measurements);
    report.measurements = in_order_of_netlist(std::move(report.measurements), network_);
    return report;
}

/// Returns the measurements in the recorded order. Each process makes its measurements in the same order as in the
/// recorded run.
std::vector<Measurement> RepeatedRun::in_recorded_order(const std::vector<Measurement>& measured) const {
    std::map<std::string, std::list<Measurement>> of_process;
    for (const Measurement& each : measured)
        of_process[each.process].push_back(each);
    std::vector<Measurement> ordered;
    for (const Measurement& then : recorded_.report->measurements) {
        std::list<Measurement>& own = of_process[then.process];
        ordered.push_back(std::move(own.front()));
        own.pop_front();
    }
    return ordered;
}

} // namespace placedpar
