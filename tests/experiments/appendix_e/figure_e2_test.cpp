// Tests the machine of Figure E.2: its structure by appendix E, and its drawings.

#include "tests/experiments/kit/replay_in_memory.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace placedpar;

namespace {

const Replay& replay_of_figure_e2() {
    static const Replay replay = test::replay_named("figure-e2");
    return replay;
}

double number_of(const std::string& row) {
    const auto cells = test::row_named(replay_of_figure_e2().comparisons.at(0), row);
    CAPTURE(row);
    REQUIRE(cells.size() == 1);
    return cells[0].simulated;
}

std::size_t count_of_words(const std::string& text, const std::string& words) {
    std::size_t count = 0;
    for (std::size_t at = text.find(words); at != text.npos; at = text.find(words, at + 1))
        ++count;
    return count;
}

} // namespace

TEST_CASE("four islands with three slaves each are sixteen transputers, joined in a ring") {
    CHECK(number_of("islands") == 4);
    CHECK(number_of("slaves of an island") == 3);
    CHECK(number_of("transputers") == number_of("islands") * (1 + number_of("slaves of an island")));
    CHECK(number_of("links that join the islands in a ring") == number_of("islands"));
    CHECK(number_of("links from a master to its slaves") == 1); // the slaves are in a chain
    CHECK(number_of("individuals of an island") * number_of("islands") == 120);
}

TEST_CASE("the run breeds at the thesis's rate of 12 times 9.8 generations per second, to 5 %") {
    const Comparison& run = replay_of_figure_e2().comparisons.at(1);
    CHECK(run.judged);
    const auto rate = test::row_named(run, "generations of 120 individuals").at(0);
    CHECK(*rate.reference == doctest::Approx(12 * 9.8));
    CHECK(rate.simulated > 0.95 * 117.6);
    CHECK(rate.simulated < 1.05 * 117.6);
    const auto compliance = test::row_named(run, "C_BOi").at(0);
    CHECK(compliance.simulated > 0.9 * 0.0086);
    CHECK(compliance.simulated < 1.1 * 0.0086);
    CHECK(run.judge_of(compliance) == Judge::own);
    CHECK(run.judge_of(rate) == Judge::thesis);
    CHECK(replay_of_figure_e2().within_tolerance());
}

TEST_CASE("the drawings have the processors and the processes by name") {
    REQUIRE(replay_of_figure_e2().drawings.size() == 2);
    const NamedDrawing &machine = replay_of_figure_e2().drawings[0], &software = replay_of_figure_e2().drawings[1];
    CHECK(machine.name == "figure-e2");
    CHECK(software.name == "figure-4-2");
    CHECK(count_of_words(machine.svg, "T800") >= 16);
    for (int island = 0; island < 4; ++island)
        CHECK(count_of_words(software.svg, "master[" + std::to_string(island) + "]") >= 1);
    CHECK(machine.svg != software.svg);
}
