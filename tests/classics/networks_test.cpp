// Tests the classical networks of the examples against their known results.

#include "classics/kinds.hpp"

#include "netlist/kinds/catalogue.hpp"
#include "netlist/kinds/csp_kinds.hpp"
#include "netlist/machine.hpp"
#include "netlist/read.hpp"
#include "text/diagnostic.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <string>

using namespace placedpar;

namespace {

RunReport run_example(const std::string& file, const Overrides& overrides = {}, std::uint64_t seed = 1) {
    Catalogue catalogue;
    add_csp_kinds(catalogue);
    add_classical_kinds(catalogue);
    ReadResult read = read_netlist(std::string(PLACEDPAR_SOURCE_DIR) + "/examples/" + file, catalogue, overrides);
    INFO(render(read.diagnostics));
    REQUIRE(read.network);
    return Machine(*read.network, catalogue, seed).run();
}

double milliseconds(const RunReport& report) { return in_milliseconds(report.result.time); }

RunReport run_farm(const std::string& deal, int workers, std::uint64_t seed = 1) {
    return run_example("csp/farm/farm.cfs", {{"deal", "\"" + deal + "\""}, {"workers", std::to_string(workers)}}, seed);
}

RunReport run_buffer(int capacity) {
    return run_example("csp/bounded-buffer/buffer.cfs", {{"capacity", std::to_string(capacity)}});
}

} // namespace

TEST_CASE("philosophers in a circle deadlock; with a butler all of them eat") {
    CHECK(run_example("csp/philosophers/philosophers.cfs").result.ending == Ending::completed);
    RunReport starved = run_example("csp/philosophers/philosophers.cfs", {{"butler", "0"}});
    REQUIRE(starved.result.ending == Ending::stuck);
    CHECK(starved.result.deadlock->cycle.size() == 10); // each philosopher waits for a fork, which waits for the next
}

TEST_CASE("with a butler all philosophers eat at a table of any size") {
    for (const char* n : {"2", "3", "4", "6", "7", "12"}) {
        CAPTURE(n);
        CHECK(run_example("csp/philosophers/philosophers.cfs", {{"n", n}}).result.ending == Ending::completed);
        CHECK(run_example("csp/philosophers/philosophers.cfs", {{"n", n}, {"butler", "0"}}).result.ending ==
              Ending::stuck);
    }
}

TEST_CASE("the sieve finds the primes up to 100") {
    RunReport report = run_example("csp/sieve/sieve.cfs");
    REQUIRE(report.result.ending == Ending::completed);
    const int primes[] = {2,  3,  5,  7,  11, 13, 17, 19, 23, 29, 31, 37, 41,
                          43, 47, 53, 59, 61, 67, 71, 73, 79, 83, 89, 97};
    for (std::size_t i = 0; i < std::size(primes); ++i)
        CHECK(report.measured(fmt::format("sieve[{}]", i), "prime") == primes[i]);
    CHECK(report.measured("sieve[0]", "passed") == 49); // the odd numbers from 3 to 99
}

TEST_CASE("a sieve with more processes than primes ends, and one with fewer passes numbers on") {
    RunReport more = run_example("csp/sieve/sieve.cfs", {{"last", "10"}, {"primes", "6"}});
    CHECK(more.result.ending == Ending::completed);
    CHECK(more.measured("sieve[3]", "prime") == 7);
    CHECK(more.measured("sieve[4]", "prime") == 0);
    // There are 21 primes above 7.
    CHECK(run_example("csp/sieve/sieve.cfs", {{"primes", "4"}}).measured("sieve[3]", "passed") == 21);
}

TEST_CASE("the mesh multiplies vectors by its matrix") {
    RunReport report = run_example("csp/matrix/matrix.cfs");
    REQUIRE(report.result.ending == Ending::completed);
    for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 3; ++j) {
            double product = 0;
            for (int i = 0; i < 3; ++i)
                product += (k + i) * (3 * i + j + 1);
            CHECK(report.measured(fmt::format("column[{}]", j), fmt::format("row[{}]", k)) == product);
        }
}

TEST_CASE("dealing tasks to idle workers is faster than in turn, and both do every task") {
    for (int workers : {1, 2, 4}) {
        RunReport idle = run_farm("idle", workers), turn = run_farm("turn", workers);
        double tasks = 0;
        for (int i = 0; i < workers; ++i)
            tasks += idle.measured(fmt::format("worker[{}]", i), "tasks");
        CHECK(tasks == 60);
        CHECK(turn.measured("worker[0]", "tasks") == 60 / workers);
        CHECK(milliseconds(idle) <= milliseconds(turn));
    }
    for (std::uint64_t seed = 1; seed <= 20; ++seed) // the seed decides the lengths of the tasks
        CHECK(milliseconds(run_farm("idle", 4, seed)) < 0.9 * milliseconds(run_farm("turn", 4, seed)));
    CHECK(milliseconds(run_farm("idle", 4)) < milliseconds(run_farm("idle", 1)) / 3.5);
}

TEST_CASE("a bounded buffer respects its capacity and delivers all packets in order") {
    for (int capacity : {1, 5, 10}) {
        RunReport report = run_buffer(capacity);
        CHECK(report.result.ending == Ending::completed);
        CHECK(report.measured("buffer", "most_held") == capacity); // the producer is faster than the consumer
        CHECK(report.measured("consumer", "last_number") == 99);
    }
    CHECK(run_buffer(1000).measured("buffer", "most_held") < 100);
}
