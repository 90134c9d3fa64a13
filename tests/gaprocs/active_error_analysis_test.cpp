#include "gaprocs/active_error_analysis.hpp"

#include "tests/gaprocs/line_problem.hpp"

#include <doctest/doctest.h>

#include <vector>

using namespace placedpar;

namespace {

/// Returns a line of slope `code` / 256.
Individual line_of(std::uint64_t code) {
    Individual line{Genome(8), 0};
    line.genome.set_field(0, 8, code);
    return line;
}

} // namespace

TEST_CASE("the errors of each island's best individual are those at the newest samples") {
    auto problem = make_search_problem(LineProblem());
    std::vector<Sample> samples{{100, 0}, {1, 0.5}, {2, 0.5}};
    std::vector<Individual> bests{line_of(128), line_of(64)};
    std::vector<std::size_t> windows{2, 1};
    ErrorsOfBest found = errors_of_best(*problem, bests, windows, samples);
    CHECK(found.windows == windows);
    CHECK(found.errors == std::vector<std::vector<double>>{{0, -0.5}, {0.25, 0}});
}

TEST_CASE("errors that depend on the first sample of a window are computed separately for each window") {
    auto problem = make_search_problem(LineAlongWindow());
    std::vector<Sample> samples{{100, 0}, {1, 0.75}, {2, 0.5}, {4, 2}};
    std::vector<Individual> bests{line_of(128), line_of(64)};
    std::vector<std::size_t> windows{3, 2};
    ErrorsOfBest found = errors_of_best(*problem, bests, windows, samples);
    CHECK(found.by_window ==
          std::vector<std::vector<std::vector<double>>>{{{.25, -.25, -.25}, {.5, .5, 1.5}}, {{-.5, -.5}, {0, 1}}});
    ErrorMatrix matrix(found, ErrorMatrix::Sum::squares);
    CHECK(matrix.error(0, 0) == 3 * .0625);
    CHECK(matrix.error(1, 0) == .5); // more than in the longer window, although that contains this window
    CHECK(matrix.error(1, 1) == 1);
}

TEST_CASE("the answer is the chosen island's best until the next analysis") {
    auto problem = make_search_problem(LineProblem());
    ActiveErrorAnalysis analysis(*problem, {4, 2}, IslandChoice::named("row"), RandomStream(1, "answer"));
    std::vector<Individual> bests{line_of(128), line_of(64)};
    // The slope changes from 1/2 to 1/4. The short window contains only samples after the change.
    std::vector<Sample> samples{{1, 0.5}, {1, 0.501}, {1, 0.25}, {1, 0.26}};
    analysis.analyse(bests, samples);
    CHECK(analysis.island() == 1);
    CHECK(analysis.answer() == bests[1]);
    samples = {{1, 0.5}, {1, 0.501}, {1, 0.5}, {1, 0.51}};
    CHECK(analysis.answer() == bests[1]);
    analysis.analyse(bests, samples);
    CHECK(analysis.island() == 0);
    CHECK(analysis.answer() == bests[0]);
}
