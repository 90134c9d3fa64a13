#include "gaprocs/processes/estimates.hpp"

#include "gaprocs/policies/coding.hpp"
#include "gaprocs/processes/peers.hpp"
#include "netlist/network/network.hpp"
#include "runtime/timer.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>

namespace placedpar {

namespace {

/// Reports the objective without penalty, and the total violation of the constraints.
void measure_constrained(ProcessEnvironment& environment, const Objective& objective, const Merit& merit) {
    if (merit.feasible)
        environment.measure("best_objective", objective.goal == Goal::maximise ? 0 - merit.costs[0] : merit.costs[0],
                            objective.unit);
    else
        environment.measure("best_objective", "not feasible");
    environment.measure("violation", merit.violation);
}

void measure_objective(ProcessEnvironment& environment, const SearchProblem& problem, const Objective& objective,
                       const Individual& individual) {
    if (problem.has_constraints())
        measure_constrained(environment, objective, problem.merit(individual.genome).value());
    else if (auto value = objective.value(individual.fitness))
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
        measure_objective(environment, problem, *objective, individual);
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
      last_(inputs_.size()), answers_(inputs_.size()), accuracy_(environment.real("accuracy")) {
    if (accuracy_ > 0 && problems.find(environment.text("problem")).problem()->true_parameters().empty())
        throw UserError(fmt::format("accuracy = {}, but the true parameters of \"{}\" are unknown: they are known only "
                                    "for a simulated record",
                                    accuracy_, environment.text("problem")));
    for (const Peer& search : peers_at(environment.network(), environment.index(), "from_masters"))
        processes_.push_back(search.process);
}

void Estimates::note_taken(std::size_t process) { taken_[process].push_back(now()); }

void Estimates::receive(std::size_t search, const std::function<void(std::size_t samples)>& received) {
    for (EstimateMessage estimate = inputs_[search].input(); !estimate.end; estimate = inputs_[search].input()) {
        answers_[search].push_back({estimate.samples, now()});
        const std::size_t samples = estimate.samples;
        last_[search] = std::move(estimate);
        if (accuracy_ > 0)
            judge_fittest();
        received(samples);
    }
}

void Estimates::judge_fittest() {
    const std::vector<double> truth = problems_.find(environment_.text("problem")).problem()->true_parameters();
    const std::vector<double> found = values_of(fittest());
    bool accurate = std::equal(truth.begin(), truth.end(), found.begin(), found.end(), [&](double wanted, double is) {
        return std::abs(is - wanted) <= accuracy_ * std::abs(wanted);
    });
    if (!accurate)
        accurate_since_.reset();
    else if (!accurate_since_)
        accurate_since_ = now();
}

/// Returns the response time, at least 0. A search without a processor takes no time, so its estimate may arrive before
/// note_taken() is called.
Time Estimates::response(std::size_t search, const Answer& answer) const {
    return std::max(answer.came - taken_.at(processes_[search]).at(answer.samples - 1), Time{});
}

void Estimates::report() const {
    if (searches() == 0)
        return;
    std::size_t received = 0;
    for (const std::vector<Answer>& answers : answers_)
        received += answers.size();
    environment_.measure("estimates", static_cast<double>(received));
    if (received == 0)
        return;
    report_responses(received);
    report_fittest();
}

void Estimates::report_responses(std::size_t received) const {
    Time all{}, longest{};
    for (std::size_t search = 0; search < searches(); ++search)
        for (const Answer& answer : answers_[search]) {
            all += response(search, answer);
            longest = std::max(longest, response(search, answer));
        }
    environment_.measure("response", in_milliseconds(all) / static_cast<double>(received), "ms");
    environment_.measure("longest_response", in_milliseconds(longest), "ms");
}

std::size_t Estimates::fittest() const {
    std::size_t fittest = searches();
    for (std::size_t search = 0; search < searches(); ++search)
        if (last_[search].generation > 0 &&
            (fittest == searches() || last_[search].best.fitness > last_[fittest].best.fitness))
            fittest = search;
    return fittest;
}

/// Returns the parameters of a search's last estimate, decoded by the coding of this search.
std::vector<double> Estimates::values_of(std::size_t search) const {
    return problem_of(search)->decode(last_[search].best.genome);
}

void Estimates::report_fittest() const {
    std::size_t best = fittest();
    environment_.measure("best_of", environment_.network().processes[processes_[best]].name);
    measure_individual(environment_, *problem_of(best), last_[best].best, values_of(best));
    if (accurate_since_)
        environment_.measure("accurate_after", in_milliseconds(*accurate_since_), "ms");
}

std::shared_ptr<const SearchProblem> Estimates::problem_of(std::size_t search) const {
    const ProcessInstance& process = environment_.network().processes[processes_[search]];
    auto coding = Coding::named(std::get<std::string>(process.parameters.at("coding")));
    return problems_.find(environment_.text("problem")).problem()->coded(coding);
}

} // namespace placedpar
