#include "gaprocs/processes/island_run.hpp"

#include "gaprocs/processes/kind_checks.hpp"
#include "gaprocs/processes/parameters.hpp"
#include "gaprocs/processes/peers.hpp"

#include <algorithm>
#include <cstdint>
#include <variant>

namespace placedpar {

namespace {

std::size_t size_named(const ProcessInstance& process, const char* parameter) {
    return static_cast<std::size_t>(std::get<std::int64_t>(process.parameters.at(parameter)));
}

} // namespace

std::size_t samples_awaited(const Network& network, const Archipelago& archipelago, std::size_t island) {
    const ProcessInstance& self = network.processes[archipelago.islands()[island].process];
    return schedule_of(self).in_step() ? archipelago.samples_needed_around(island) : samples_needed(self);
}

std::optional<std::size_t> samples_sent_to(const Network& network, std::size_t process,
                                           const ProblemRegistry& problems) {
    auto host = other_end(network, process, "from_host");
    if (!host || host->at_edge() || network.processes[host->process].kind != "ga.host")
        return std::nullopt;
    const ProcessInstance& sending = network.processes[host->process];
    auto recorded = named_problem(problems, sending);
    if (!recorded)
        return std::nullopt;
    if (recorded->problem()->objective())
        return size_named(sending, "generations");
    auto samples = size_named(sending, "samples");
    return samples > 0 ? samples : recorded->samples();
}

std::optional<IslandRun> run_of(const Network& network, const Archipelago& archipelago, std::size_t island,
                                const ProblemRegistry& problems) {
    std::size_t process = archipelago.islands()[island].process;
    auto samples = samples_sent_to(network, process, problems);
    auto recorded = named_problem(problems, network.processes[process]);
    if (!samples || !recorded)
        return std::nullopt;
    if (recorded->problem()->objective())
        return IslandRun{.samples = *samples, .first = 1, .trials = 1};
    return IslandRun{.samples = *samples,
                     .first = samples_awaited(network, archipelago, island),
                     .trials = size_named(network.processes[process], "trials")};
}

} // namespace placedpar
