#include "gaprocs/processes/kinds.hpp"

#include "gaprocs/processes/messages.hpp"
#include "netlist/kinds/environment.hpp"
#include "runtime/parallel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace placedpar {

namespace {

std::size_t samples_to_send(const ProcessEnvironment& environment, std::size_t recorded) {
    auto wanted = static_cast<std::size_t>(environment.integer("samples"));
    if (wanted > recorded)
        throw std::invalid_argument(fmt::format("samples = {}, but the record of \"{}\" has {}", wanted,
                                                environment.text("problem"), recorded));
    return wanted == 0 ? recorded : wanted;
}

} // namespace

/// The host sends each sample of the record to every master, as fast as they take them.
void run_host(ProcessEnvironment& environment, const ProblemRegistry& problems) {
    const RecordedProblem& recorded = problems.find(environment.text("problem"));
    std::size_t samples = samples_to_send(environment, recorded.samples());
    auto masters = environment.outputs<HostMessage>("to_masters");
    par_for(masters.size(), [&](std::size_t m) {
        HostMessage message;
        message.bytes = static_cast<std::uint32_t>(environment.integer("sample_bytes"));
        for (std::size_t i = 0; i < samples; ++i) {
            message.sample = recorded.record()[i];
            masters[m].output(message);
        }
        message.end = true;
        masters[m].output(message);
    });
}

} // namespace placedpar
