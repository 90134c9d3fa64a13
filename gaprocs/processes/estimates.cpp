#include "gaprocs/processes/estimates.hpp"

#include "gaprocs/policies/coding.hpp"
#include "gaprocs/processes/peers.hpp"
#include "netlist/network/network.hpp"
#include "runtime/timer.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>

namespace placedpar {

namespace {

void measure_objective(ProcessEnvironment& environment, const Objective& objective, double fitness) {
    if (auto value = objective.value(fitness))
        environment.measure("best_objective", *value, objective.unit);
    else
        environment.measure("best_objective", "not a finite number");
    if (objective.optimum)
        environment.measure("known_optimum", *objective.optimum, objective.unit);
}

} // namespace

void measure_individual(ProcessEnvironment& environment, const SearchProblem& problem, const Individual& individual,
                        const std::vector<double>& values) {
    if (auto objective = problem.objective())
        measure_objective(environment, *objective, individual.fitness);
    else
        environment.measure("best_fitness", individual.fitness);
    if (values.empty())
        environment.measure("best_string", problem.representation().text(individual.genome));
    auto names = problem.parameter_names(), units = problem.parameter_units();
    for (std::size_t i = 0; i < values.size(); ++i)
        environment.measure(names[i], values[i], units[i]);
}

Estimates::Estimates(ProcessEnvironment& environment, const ProblemRegistry& problems)
    : environment_(environment), problems_(problems), inputs_(environment.inputs<EstimateMessage>("from_masters")),
      last_(inputs_.size()) {
    for (const Peer& search : peers_at(environment.network(), environment.index(), "from_masters"))
        processes_.push_back(search.process);
}

void Estimates::note_taken(std::size_t process) { taken_[process].push_back(now()); }

void Estimates::receive(std::size_t search) {
    for (EstimateMessage estimate = inputs_[search].input(); !estimate.end; estimate = inputs_[search].input()) {
        note(processes_[search], estimate);
        last_[search] = std::move(estimate);
    }
}

/// A search that is on no processor answers at the very time at which it takes a sample: perhaps before that is noted.
void Estimates::note(std::size_t process, const EstimateMessage& estimate) {
    const std::vector<Time>& taken = taken_[process];
    Time response = estimate.samples <= taken.size() ? now() - taken[estimate.samples - 1] : Time{};
    response_ += response;
    longest_ = std::max(longest_, response);
    ++received_;
}

void Estimates::report() const {
    if (searches() == 0)
        return;
    environment_.measure("estimates", static_cast<double>(received_));
    if (received_ == 0)
        return;
    environment_.measure("response", in_milliseconds(response_) / static_cast<double>(received_), "ms");
    environment_.measure("longest_response", in_milliseconds(longest_), "ms");
    report_fittest();
}

/// Read as its search codes the problem's strings.
void Estimates::report_fittest() const {
    std::size_t fittest = searches();
    for (std::size_t search = 0; search < searches(); ++search)
        if (last_[search].generation > 0 &&
            (fittest == searches() || last_[search].best.fitness > last_[fittest].best.fitness))
            fittest = search;
    const ProcessInstance& process = environment_.network().processes[processes_[fittest]];
    auto coding = Coding::named(std::get<std::string>(process.parameters.at("coding")));
    auto problem = problems_.find(environment_.text("problem")).problem()->coded(coding);
    environment_.measure("best_of", process.name);
    measure_individual(environment_, *problem, last_[fittest].best, problem->decode(last_[fittest].best.genome));
}

} // namespace placedpar
