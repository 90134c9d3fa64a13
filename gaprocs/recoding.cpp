#include "gaprocs/recoding.hpp"

#include "gaprocs/representation/coding.hpp"
#include "text/counted.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <stdexcept>

namespace placedpar {

namespace {

constexpr std::size_t most_field_bits = 63; // not 64, because code_around() computes with signed numbers

std::size_t sum_of(const std::vector<std::size_t>& bits) {
    return std::accumulate(bits.begin(), bits.end(), std::size_t{0});
}

void validate_field(std::size_t number, std::size_t bits, std::size_t problem_bits) {
    if (problem_bits < 1 || problem_bits > most_field_bits)
        throw std::invalid_argument(fmt::format("field {} has {} in the problem, expected 1 to {}", number + 1,
                                                counted(problem_bits, "bit"), most_field_bits));
    if (bits < 1 || bits > problem_bits)
        throw std::invalid_argument(
            fmt::format("field {} is bred with {}, expected 1 to {}, the number of bits that it has in the problem",
                        number + 1, counted(bits, "bit"), problem_bits));
}

/// Returns `centre` - 2^(`bits` - 1) + `code`, limited to the codes of a field of `problem_bits` bits.
std::uint64_t code_around(std::uint64_t centre, std::uint64_t code, std::size_t bits, std::size_t problem_bits) {
    auto highest = static_cast<std::int64_t>((std::uint64_t{1} << problem_bits) - 1);
    std::int64_t below = std::int64_t{1} << (bits - 1);
    return static_cast<std::uint64_t>(
        std::clamp(static_cast<std::int64_t>(centre + code) - below, std::int64_t{0}, highest));
}

} // namespace

void Recoding::validate() const {
    if (bits.empty() || bits.size() != problem_bits.size())
        throw std::invalid_argument(fmt::format("the problem's string has {}, but bits are given for {}",
                                                counted(problem_bits.size(), "field"), bits.size()));
    if (coding == Coding::real)
        throw std::invalid_argument("the coding \"real\" has no fields of bits, expected \"natural\" or \"gray\"");
    for (std::size_t i = 0; i < bits.size(); ++i)
        validate_field(i, bits[i], problem_bits[i]);
    if (around && around->size() != problem_length())
        throw std::invalid_argument(fmt::format("the bias point has {}, the problem's string has {}",
                                                counted(around->size(), "bit"), problem_length()));
}

std::size_t Recoding::length() const { return stuffed_bits(sum_of(bits), coding.dont_care()); }

std::size_t Recoding::problem_length() const { return sum_of(problem_bits); }

Genome Recoding::to_problem(const Genome& bred) const {
    Genome read = coding.dont_care() == 0 ? bred : unstuffed(bred, coding.dont_care());
    bool gray = coding.way() == Coding::gray.way();
    Genome problem(problem_length());
    for (std::size_t i = 0, from = 0, to = 0; i < bits.size(); from += bits[i], to += problem_bits[i], ++i) {
        std::uint64_t code = read.field(from, bits[i]);
        if (gray)
            code = gray_decoded(code);
        if (std::size_t missing = problem_bits[i] - bits[i]; missing > 0)
            code = around ? code_around(around->field(to, problem_bits[i]), code, bits[i], problem_bits[i])
                          : code << missing;
        problem.set_field(to, problem_bits[i], code);
    }
    return problem;
}

std::vector<Genome> Recoding::to_problem(std::span<const Genome> bred) const {
    std::vector<Genome> read;
    read.reserve(bred.size());
    for (const Genome& genome : bred)
        read.push_back(to_problem(genome));
    return read;
}

Recoding natural_recoding(std::vector<std::size_t> problem_bits) {
    return {.problem_bits = problem_bits, .bits = problem_bits};
}

} // namespace placedpar
