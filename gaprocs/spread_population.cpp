#include "gaprocs/spread_population.hpp"

#include "gaprocs/recoding.hpp"
#include "gaprocs/representation/coding.hpp"
#include "text/user_error.hpp"

#include <cstdint>
#include <utility>

namespace placedpar {

namespace {

/// Returns `count` codes below 2^bits at equal distances, in random order (Fisher and Yates).
std::vector<std::uint64_t> spread_codes(std::size_t count, std::size_t bits, RandomStream& random) {
    std::vector<std::uint64_t> codes;
    double begin = random.uniform(), all = static_cast<double>(std::uint64_t{1} << bits);
    for (std::size_t i = 0; i < count; ++i)
        codes.push_back(
            static_cast<std::uint64_t>((static_cast<double>(i) + begin) * all / static_cast<double>(count)));
    for (std::size_t left = count; left > 1; --left)
        std::swap(codes[left - 1], codes[random.below(static_cast<std::uint32_t>(left))]);
    return codes;
}

} // namespace

std::vector<Genome> spread_population(std::size_t count, const Recoding& reading, RandomStream& random) {
    std::vector<Genome> population(count, Genome(reading.length()));
    std::size_t position = 0, step = 1 + reading.coding.dont_care();
    bool gray = reading.coding.way() == Coding::gray.way();
    for (std::size_t bits : reading.bits) {
        std::vector<std::uint64_t> codes = spread_codes(count, bits, random);
        for (std::size_t bit = 0; bit < bits; ++bit, position += step)
            for (std::size_t i = 0; i < count; ++i) {
                std::uint64_t code = gray ? gray_code(codes[i]) : codes[i];
                population[i].set(position, ((code >> (bits - 1 - bit)) & 1u) != 0);
            }
    }
    return population;
}

std::vector<Genome> spread_population(std::size_t count, const SearchProblem& problem, RandomStream& random) {
    auto fields = problem.fields();
    if (fields.empty() || problem.representation().kind() != StringKind::binary)
        throw UserError("a spread population needs strings with fields of bits that code numbers, but this problem's "
                        "strings have no fields");
    return spread_population(count, {.problem_bits = fields, .bits = fields, .coding = problem.coding()}, random);
}

} // namespace placedpar
