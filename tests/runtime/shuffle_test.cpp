// Tests shuffled runs: every order of processes that share an executive occurs, and priorities still hold.

#include "runtime/hardware/processor.hpp"
#include "runtime/hardware/workstation.hpp"
#include "runtime/parallel.hpp"
#include "runtime/simulation.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <functional>
#include <set>
#include <string>

using namespace placedpar;
using namespace placedpar::hardware;

namespace {

enum class On { nothing, processor, workstation };

Executive* executive(Simulation& simulation, On on) {
    switch (on) {
    case On::processor: return &simulation.add<Processor>("t");
    case On::workstation: return &simulation.add<Workstation>("w");
    case On::nothing: break;
    }
    return nullptr;
}

/// Returns the orders in which processes write their letters in runs with many seeds. `make` makes the processes.
std::set<std::string> orders_of_letters(On on, const std::function<void(Simulation&, Executive*, std::string&)>& make) {
    std::set<std::string> seen;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        Simulation simulation;
        std::string order;
        make(simulation, executive(simulation, on), order);
        simulation.shuffle(seed);
        simulation.run();
        seen.insert(order);
    }
    return seen;
}

const std::set<std::string> orders_of_abc{"abc", "acb", "bac", "bca", "cab", "cba"};

} // namespace

TEST_CASE("in shuffled runs, processes on the same executive begin in every order") {
    for (const On on : {On::nothing, On::processor, On::workstation})
        CHECK(orders_of_letters(on, [](Simulation& simulation, Executive* where, std::string& order) {
                  for (const char letter : {'a', 'b', 'c'})
                      simulation.process(
                          std::string(1, letter), [&order, letter] { order += letter; }, where);
              }) == orders_of_abc);
}

TEST_CASE("in shuffled runs, the components of a PAR run in every order") {
    for (const On on : {On::nothing, On::processor, On::workstation})
        CHECK(orders_of_letters(on, [](Simulation& simulation, Executive* where, std::string& order) {
                  simulation.process(
                      "parent", [&order] { par([&] { order += "a"; }, [&] { order += "b"; }, [&] { order += "c"; }); },
                      where);
              }) == orders_of_abc);
}

TEST_CASE("in shuffled runs, processes of high priority still run first") {
    CHECK(orders_of_letters(On::processor, [](Simulation& simulation, Executive* where, std::string& order) {
              simulation.process(
                  "parent",
                  [&order] {
                      par([&] { compute(Cycles{100}), order += "a"; }, [&] { compute(Cycles{100}), order += "b"; });
                      compute(Cycles{1});
                      pri_par([&] { order += "h"; }, [&] { order += "l"; });
                  },
                  where);
          }) == std::set<std::string>{"abhl", "bahl"});
}

TEST_CASE("without a shuffle, processes begin in the order in which they were made") {
    Simulation simulation;
    auto& processor = simulation.add<Processor>("t");
    std::string order;
    for (const char letter : {'a', 'b', 'c'})
        simulation.process(
            std::string(1, letter), [&order, letter] { order += letter; }, &processor);
    simulation.run();
    CHECK(order == "abc");
}
