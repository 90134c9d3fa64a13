// Tests facts about fitness landscapes that hold for every coding, and descents followed one by one.

#include "experiments/chapter_6/kit/landscape.hpp"
#include "experiments/chapter_6/kit/plant_runs.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

using namespace placedpar;

namespace {

/// Returns the squared error of every string of a reading over the first window of the record of seed 4, computed
/// sample by sample.
std::vector<double> errors_one_by_one(const Recoding& reading) {
    const SearchProblem& problem = plant_search_problem();
    std::vector<Sample> window = plant_record({}, RandomStream(4, "plant"));
    window.resize(30);
    std::vector<double> errors;
    for (std::size_t number = 0; number < std::size_t{1} << reading.length(); ++number) {
        Genome string(reading.length());
        string.set_field(0, reading.length(), number);
        const Genome read = reading.to_problem(string);
        double sum = 0;
        for (const Sample& sample : window)
            sum += problem.error(read, sample) * problem.error(read, sample);
        errors.push_back(sum);
    }
    return errors;
}

/// Follows the steepest descent by single bits. A neighbour is lower only if its error is lower by a millionth, since
/// strings that stand for the same plant have the same error.
std::size_t end_of_descent(const std::vector<double>& errors, std::size_t from) {
    while (true) {
        std::size_t best = from;
        for (std::size_t bit = 1; bit < errors.size(); bit <<= 1)
            if (errors[from ^ bit] < errors[best] * (1 - 1e-6))
                best = from ^ bit;
        if (best == from)
            return from;
        from = best;
    }
}

} // namespace

TEST_CASE("a coding renames strings: as many are fit and near the pole in Gray code as in natural binary") {
    for (std::size_t bits : {1u, 2u}) {
        const LandscapeFacts natural = enumerate_landscape(plant_reading(bits), 4),
                             gray = enumerate_landscape(plant_reading(bits, Coding::gray), 4);
        CHECK(natural.fit_percent == gray.fit_percent);
        CHECK(natural.good_strings == gray.good_strings);
    }
}

TEST_CASE("descents from all strings end where they end one by one") {
    for (const Coding& coding : {Coding(Coding::natural), Coding(Coding::gray)}) {
        const Recoding reading = plant_reading(1, coding);
        const LandscapeFacts facts = enumerate_landscape(reading, 4);
        const std::vector<double> errors = errors_one_by_one(reading);
        const double least = *std::ranges::min_element(errors);
        std::set<std::size_t> ends;
        double at_optimum = 0;
        for (std::size_t from = 0; from < errors.size(); ++from) {
            const std::size_t end = end_of_descent(errors, from);
            ends.insert(end);
            at_optimum += errors[end] <= least * 1.001;
        }
        CHECK(facts.optimum_percent == doctest::Approx(100 * at_optimum / static_cast<double>(errors.size())));
        CHECK(facts.minima >= ends.size()); // strings with equal errors may each be one
    }
}

TEST_CASE("percentages of a landscape are between 0 and 100, and a correlation between -1 and 1") {
    for (std::uint64_t seed : {1u, 2u, 3u}) {
        const LandscapeFacts facts = enumerate_landscape(plant_reading(2), seed);
        for (double percent : {facts.fit_percent, facts.optimum_percent, facts.good_percent}) {
            CHECK(percent >= 0);
            CHECK(percent <= 100);
        }
        CHECK(std::abs(facts.correlation) <= 1);
        CHECK(facts.minima >= 1);
        CHECK(facts.optimum_percent > 0); // the descent from the optimum ends there
    }
}

TEST_CASE("with two or three bits a parameter no string is near the pole, so no descent ends there") {
    for (std::size_t bits : {2u, 3u}) { // in steps of .25, beta is at best .12 from the pole's .371
        const LandscapeFacts facts = enumerate_landscape(plant_reading(bits), 4);
        CHECK(facts.good_strings == 0);
        CHECK(facts.good_percent == 0);
    }
}

TEST_CASE("the error of one sample by its moments is the square of the prediction's error") {
    const SearchProblem& problem = plant_search_problem();
    const std::vector<Sample> record = plant_record({.noise = 0.3}, RandomStream(9, "plant"));
    Genome string(37);
    string.set_field(0, 37, 0x0F5A5A5A5Aull);
    for (std::size_t i : {0u, 50u, 100u}) {
        const double error = problem.error(string, record[i]);
        CHECK(WindowMoments(std::span(record).subspan(i, 1)).squared_error(string) == doctest::Approx(error * error));
    }
}

TEST_CASE("noise lowers the best fitness that the don't-care bits can reach") {
    const std::vector<double> clean = fitness_by_low_bits(0, 4), noisy = fitness_by_low_bits(1, 4);
    CHECK(std::ranges::max(clean) == doctest::Approx(300).epsilon(0.01)); // 30 samples of B = 10
    CHECK(std::ranges::max(noisy) < 295);
    CHECK(std::ranges::min(clean) < std::ranges::max(clean));
}
