#include "gaprocs/processes/kinds.hpp"

#include "gaprocs/processes/kind_checks.hpp"
#include "gaprocs/processes/messages.hpp"
#include "gaprocs/processes/search_description.hpp"
#include "netlist/kinds/description.hpp"
#include "netlist/kinds/environment.hpp"
#include "runtime/timer.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace placedpar {

namespace {

/// Outputs a sample of the record at the end of every period. If the host is late, samples wait; `read_at` is still the
/// end of the sample's period.
void read_sensors(ProcessEnvironment& environment, const ProblemRegistry& problems) {
    const auto& record = problems.find(environment.text("problem")).record();
    const auto asked = static_cast<std::size_t>(environment.integer("samples"));
    const auto count = asked == 0 ? record.size() : asked;
    const Time period(static_cast<std::int64_t>(std::llround(environment.real("period") * 1e9)));
    auto host = environment.output<HostMessage>("to_host");
    HostMessage message;
    message.bytes = static_cast<std::uint32_t>(environment.integer("sample_bytes"));
    Time latest{};
    for (std::size_t i = 0; i < count; ++i) {
        message.read_at = static_cast<std::int64_t>(i + 1) * period;
        message.sample = record.at(i);
        wait_until(message.read_at);
        host.output(message);
        latest = std::max(latest, now() - message.read_at);
    }
    message.end = true;
    host.output(message);
    environment.measure("samples", static_cast<double>(count));
    environment.measure("longest_wait", in_milliseconds(latest), "ms");
}

/// Raises the alarm when the first parameter has exceeded `limit` in `in_a_row` successive findings.
void watch(ProcessEnvironment& environment) {
    auto host = environment.input<Finding>("from_host");
    const auto needed = environment.integer("in_a_row");
    const double limit = environment.real("limit");
    std::int64_t above = 0, count = 0;
    bool raised = false;
    Time from_host{}, from_sensors{}, longest{};
    for (Finding finding = host.input(); !finding.end; finding = host.input()) {
        ++count;
        from_host += now() - finding.sent_at;
        from_sensors += now() - finding.read_at;
        longest = std::max(longest, now() - finding.read_at);
        above = finding.parameters.front() > limit ? above + 1 : 0;
        if (above < needed || raised)
            continue;
        raised = true;
        environment.measure("raised", in_milliseconds(now()), "ms");
        environment.measure("raised_after", in_milliseconds(now() - finding.read_at), "ms");
        environment.measure("sample", static_cast<double>(finding.sample));
        environment.measure("value", finding.parameters.front());
    }
    environment.measure("findings", static_cast<double>(count));
    if (!raised)
        environment.measure("raised", "no");
    if (count == 0)
        return;
    environment.measure("from_host", in_milliseconds(from_host) / static_cast<double>(count), "ms");
    environment.measure("from_sensors", in_milliseconds(from_sensors) / static_cast<double>(count), "ms");
    environment.measure("longest_from_sensors", in_milliseconds(longest), "ms");
}

} // namespace

ProcessKind sensors_kind(const ProblemRegistry& problems) {
    using namespace search_description;
    using namespace description;
    return {.name = "ga.sensors",
            .about = "Reads the sensors of a machine: outputs a sample of the problem's record every period, or later "
                     "if the host has not taken the preceding sample.",
            .ports = {output<HostMessage>("to_host", "host message", "to a ga.host")},
            .parameters = {problem(),
                           integer("samples", {.unit = "samples", .by_default = 0, .least = 0, .most = 1e9},
                                   "number of samples of the record that are read; 0: all"),
                           real("period", {.unit = "ms", .by_default = 20, .least = 0.001, .most = 1e6},
                                "time between two samples; the first sample is read after one period"),
                           bytes_in_message("sample_bytes", 16, "size of a sample in a message")},
            .measurements = {{"samples", "", "number of samples that were read"},
                             {"longest_wait", "ms", "the longest time from reading a sample until the host had it"}},
            .body = [&problems](ProcessEnvironment& environment) { read_sensors(environment, problems); },
            .check = [&problems](const Network& network,
                                 std::size_t process) { return check_host(network, process, problems); },
            .is_determinate = always};
}

ProcessKind alarm_kind(const ProblemRegistry&) {
    using namespace description;
    return {.name = "ga.alarm",
            .about = "Raises an alarm when the first parameter of the host's findings has exceeded a limit several "
                     "times in a row.",
            .ports = {input<Finding>("from_host", "finding", "from a ga.host")},
            .parameters = {real("limit", {.by_default = 0.0099, .least = 0, .most = 1e9},
                                "limit of the parameter, in its unit; the default is 15 % above the boom's compliance"),
                           integer("in_a_row", {.by_default = 5, .least = 1, .most = 1e6},
                                   "number of successive findings above the limit that raise the alarm")},
            .measurements = {{"findings", "", "number of findings received from the host"},
                             {"raised", "ms", "time at which the alarm was raised; \"no\" if it was not raised"},
                             {"raised_after", "ms", "time from when the sensors read the sample that raised the alarm"},
                             {"sample", "", "number of the sample that raised the alarm"},
                             {"value", "", "value of the parameter in the finding that raised the alarm"},
                             {"from_host", "ms", "mean time that a finding took from the host to this process"},
                             {"from_sensors", "ms", "mean time from when a sample was read until its finding arrived"},
                             {"longest_from_sensors", "ms", "the longest of these times"}},
            .body = watch,
            .is_determinate = always};
}

} // namespace placedpar
