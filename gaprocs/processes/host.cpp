#include "gaprocs/processes/kinds.hpp"

#include "gaprocs/processes/kind_checks.hpp"
#include "gaprocs/processes/messages.hpp"
#include "gaprocs/processes/search_description.hpp"
#include "gaprocs/usual_settings.hpp"
#include "netlist/kinds/description.hpp"
#include "netlist/kinds/environment.hpp"
#include "runtime/parallel.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

namespace {

std::size_t samples_to_send(const ProcessEnvironment& environment, std::size_t recorded) {
    auto wanted = static_cast<std::size_t>(environment.integer("samples"));
    if (wanted > recorded)
        throw UserError(fmt::format("samples = {}, but the record of \"{}\" has {}", wanted,
                                    environment.text("problem"), recorded));
    return wanted == 0 ? recorded : wanted;
}

/// A sample without a number for each generation, or the samples of the record.
std::vector<Sample> samples_of(const ProcessEnvironment& environment, const RecordedProblem& recorded) {
    if (recorded.problem()->objective())
        return empty_record(static_cast<std::size_t>(environment.integer("generations")));
    auto first = recorded.record().begin();
    return {first, first + static_cast<std::ptrdiff_t>(samples_to_send(environment, recorded.samples()))};
}

/// The host sends each sample to every master, as fast as they take them.
void run_host(ProcessEnvironment& environment, const ProblemRegistry& problems) {
    const RecordedProblem& recorded = problems.find(environment.text("problem"));
    std::vector<Sample> samples = samples_of(environment, recorded);
    auto masters = environment.outputs<HostMessage>("to_masters");
    par_for(masters.size(), [&](std::size_t m) {
        HostMessage message;
        message.bytes =
            recorded.problem()->channels() == 0 ? 0 : static_cast<std::uint32_t>(environment.integer("sample_bytes"));
        for (const Sample& sample : samples) {
            message.sample = sample;
            masters[m].output(message);
        }
        message.end = true;
        masters[m].output(message);
    });
}

} // namespace

ProcessKind host_kind(const ProblemRegistry& problems) {
    using namespace search_description;
    using namespace description;
    return {.name = "ga.host",
            .about = "The host computer's part: sends each sample of the problem's record to every master, as fast as "
                     "they take it.",
            .ports = {output<HostMessage>("to_masters", "host message", "an array: one end for each master")},
            .parameters = {problem(),
                           integer("samples", {.unit = "samples", .by_default = 0, .least = 0, .most = 1e9},
                                   "how many samples of the record are sent; 0: all"),
                           integer("generations", {.unit = "generations", .by_default = 100, .least = 1, .most = 1e7},
                                   "how long a problem without a record is searched; each is asked for by an empty "
                                   "sample"),
                           bytes_in_message("sample_bytes", 16, "a sample in a message")},
            .body = [&problems](ProcessEnvironment& environment) { run_host(environment, problems); },
            .check = [&problems](const Network& network,
                                 std::size_t process) { return check_host(network, process, problems); }};
}

} // namespace placedpar
