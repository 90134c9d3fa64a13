#include "explore/optimise/machine_search.hpp"

#include "gaprocs/front_search.hpp"
#include "gaprocs/search.hpp"
#include "runtime/random.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace placedpar {

namespace {

constexpr int most_draws = 20'000; ///< failed draws in a row after which no further machine is expected

constexpr std::size_t at_once = 1000; ///< largest number of machines in one call of MachineTrials::try_out

[[noreturn]] void refuse_empty() { throw UserError("no combination satisfies the study's condition"); }

/// Draws a number below `count`, uniform up to the resolution of 64 bits.
std::uint64_t draw_below(std::uint64_t count, RandomStream& random) {
    if (count <= RandomStream::max())
        return random.below(static_cast<std::uint32_t>(count));
    std::uint64_t high = random();
    return (high << 32 | random()) % count;
}

void note_why(SearchCourse& course, const std::string& why) {
    Infeasible& noted = course.why[why.substr(0, why.find('\n'))];
    if (noted.machines++ == 0)
        noted.said = why;
}

} // namespace

MachineSearch::MachineSearch(const Study& study, const MachineSpace& space, MachineTrials& trials, Listener listener)
    : wanted_(*study.search), space_(space), trials_(trials), listener_(std::move(listener)) {}

std::optional<SearchCourse> MachineSearch::genetic() {
    SearchCourse course{.way = "genetic"};
    SearchSettings settings = front_settings(BitString(space_.bits()), wanted_.population);
    settings.initial = first_population();
    Search search(space_.bits(), settings, RandomStream(wanted_.seed, "optimise"));
    for (std::uint64_t generation = 1; generation <= wanted_.generations; ++generation) {
        std::vector<std::uint64_t> machines;
        for (const Genome& genome : search.population())
            machines.push_back(space_.machine_of(genome));
        if (!take(course, machines, fmt::format("generation {} of {}", generation, wanted_.generations)))
            return std::nullopt;
        search.next_generation(fitness_of(machines));
    }
    return course;
}

/// Draws the population only from machines that satisfy the study's condition. A population drawn from all machines
/// might contain none of them.
std::vector<Genome> MachineSearch::first_population() {
    RandomStream random(wanted_.seed, "optimise/first");
    std::vector<Genome> population;
    for (int draws = 0; population.size() < wanted_.population; ++draws) {
        if (draws == most_draws)
            refuse_empty();
        Genome genome = Genome::random(space_.bits(), random);
        if (!space_.holds(space_.machine_of(genome)))
            continue;
        population.push_back(std::move(genome));
        draws = 0;
    }
    return population;
}

/// Returns the front_fitness() of the machines. If a machine occurs several times, all but the first count as
/// infeasible.
std::vector<double> MachineSearch::fitness_of(const std::vector<std::uint64_t>& machines) {
    std::vector<Merit> merits;
    std::set<std::uint64_t> seen;
    for (std::uint64_t machine : machines)
        merits.push_back(seen.insert(machine).second ? trials_.of(machine).merit : Merit{});
    return front_fitness(merits);
}

std::optional<SearchCourse> MachineSearch::random(std::size_t simulated) {
    SearchCourse course{.way = "random"};
    RandomStream random(wanted_.seed, "optimise/random");
    std::set<std::uint64_t> drawn;
    while (course.machines.size() < simulated) {
        std::vector<std::uint64_t> machines =
            draw(std::min(simulated - course.machines.size(), at_once), drawn, random);
        if (machines.empty())
            break;
        if (!take(course, machines, "random search"))
            return std::nullopt;
    }
    return course;
}

/// Draws `wanted` machines that have not been drawn before; fewer if almost no such machine is left.
std::vector<std::uint64_t> MachineSearch::draw(std::size_t wanted, std::set<std::uint64_t>& drawn,
                                               RandomStream& random) {
    std::vector<std::uint64_t> machines;
    for (int draws = 0; machines.size() < wanted && draws < most_draws; ++draws)
        if (std::uint64_t machine = draw_below(space_.count(), random);
            !drawn.contains(machine) && space_.holds(machine)) {
            drawn.insert(machine);
            machines.push_back(machine);
            draws = 0;
        }
    return machines;
}

std::optional<SearchCourse> MachineSearch::exhaustive() {
    SearchCourse course{.way = "exhaustive"};
    for (std::uint64_t machine = 0; machine < space_.count();) {
        std::vector<std::uint64_t> machines;
        for (; machine < space_.count() && machines.size() < at_once; ++machine)
            if (space_.holds(machine))
                machines.push_back(machine);
        if (!take(course, machines, "exhaustive search"))
            return std::nullopt;
    }
    return course;
}

/// Tries the machines, and adds the new machines that were simulated to the course. Returns false if interrupted.
bool MachineSearch::take(SearchCourse& course, const std::vector<std::uint64_t>& machines, const std::string& step) {
    listener_({course, step, 0});
    if (!trials_.try_out(machines, [&](std::uint64_t runs) { listener_({course, step, runs}); }))
        return false;
    for (std::uint64_t machine : machines) {
        if (!course.tried.insert(machine).second)
            continue;
        const Trial& trial = trials_.of(machine);
        if (!trial.merit.feasible)
            note_why(course, trial.why);
        if (!trial.simulated)
            continue;
        course.machines.push_back(machine);
        course.merits.push_back(trial.merit);
    }
    trials_.require_measures();
    return true;
}

} // namespace placedpar
