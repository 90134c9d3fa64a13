// Uses PlacedPar as a library: two communicating processes, and something of every room.

#include "placedpar/experiments/kit/experiment.hpp"
#include "placedpar/explore/problems.hpp"
#include "placedpar/gaprocs/objective_problem.hpp"
#include "placedpar/gaprocs/traditional.hpp"
#include "placedpar/gaprocs/usual_settings.hpp"
#include "placedpar/hydraulics/data/record_table.hpp"
#include "placedpar/identification/identification.hpp"
#include "placedpar/monitor/service/service.hpp"
#include "placedpar/runtime/hardware/link.hpp"
#include "placedpar/runtime/simulation.hpp"
#include "runtime/channel.hpp"

#include <cstdio>

namespace {

// With both namespaces opened, Link is the excavator's; the transputers' is hardware::Link.
std::size_t number_of_the_boom() {
    using namespace placedpar;
    using namespace placedpar::hydraulics;
    return index_of(Link::boom);
}

struct Parabola {
    placedpar::ParameterCoding representation() const { return placedpar::ParameterCoding(1, {-2, 2, 8}); }
    double objective(std::span<const double> x) const { return x[0] * x[0]; }
};

/// A search problem defined by this program, solved by the library.
bool parabola_is_searched() {
    auto parabola = placedpar::minimise(Parabola{});
    auto settings = placedpar::usual_settings(*parabola);
    return placedpar::run_traditional(*parabola, 50, settings, placedpar::RandomStream(1, "parabola"))
               .best()
               .best.fitness == 0;
}

bool every_room_is_there() {
    placedpar::ProblemRegistry problems = placedpar::known_problems(1);
    return placedpar::Genome::from_string("101").field(0, 3) == 5 &&
           placedpar::known_kinds(problems).find("ga.master") &&
           placedpar::identification::thesis_way().search.elite == 0 && !placedpar::experiments().empty();
}

} // namespace

int main() {
    placedpar::Simulation simulation;
    placedpar::Channel<int> c("c", simulation.add<placedpar::hardware::Link>().from_a_to_b());
    int received = 0;
    simulation.process("sender", [&] { c.out().output(Channel{42}.number); });
    simulation.process("receiver", [&] { received = c.in().input(); });
    bool completed = simulation.run().ending == placedpar::Ending::completed;
    std::printf("received %d\n", received);
    return completed && received == 42 && number_of_the_boom() == 1 && parabola_is_searched() && every_room_is_there()
               ? 0
               : 1;
}
