#include "gaprocs/representation/representation.hpp"

#include "runtime/random.hpp"
#include "text/counted.hpp"
#include "text/number.hpp"
#include "text/user_error.hpp"

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>

namespace placedpar {

namespace {

Genome random_string(const BitString& bits, RandomStream& random) { return Genome::random(bits.bits(), random); }

Genome random_string(const RealVector& reals, RandomStream& random) {
    Genome genome(reals.bits());
    for (std::size_t i = 0; i < reals.parameters(); ++i)
        reals.set(genome, i, reals.range(i).low + (reals.range(i).high - reals.range(i).low) * random.uniform());
    return genome;
}

/// Returns a random permutation, by the shuffle of Fisher and Yates.
Genome random_string(const Permutation& permutation, RandomStream& random) {
    std::vector<std::size_t> order(permutation.places());
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t left = order.size(); left > 1; --left)
        std::swap(order[left - 1], order[random.below(static_cast<std::uint32_t>(left))]);
    return permutation.encode(order);
}

double distance_of(const BitString&, const Genome& a, const Genome& b) { return static_cast<double>(difference(a, b)); }

double distance_of(const RealVector& reals, const Genome& a, const Genome& b) {
    double squares = 0;
    for (std::size_t i = 0; i < reals.parameters(); ++i) {
        double step = (reals.value(a, i) - reals.value(b, i)) / (reals.range(i).high - reals.range(i).low);
        squares += step * step;
    }
    return std::sqrt(squares);
}

/// Returns for each place the places before and after it in a closed tour.
std::vector<std::array<std::size_t, 2>> neighbours_of(const std::vector<std::size_t>& tour) {
    std::vector<std::array<std::size_t, 2>> neighbours(tour.size());
    for (std::size_t i = 0; i < tour.size(); ++i)
        neighbours[tour[i]] = {tour[(i + tour.size() - 1) % tour.size()], tour[(i + 1) % tour.size()]};
    return neighbours;
}

double distance_of(const Permutation& permutation, const Genome& a, const Genome& b) {
    auto tour = permutation.decode(a);
    auto others = neighbours_of(permutation.decode(b));
    std::size_t edges = 0;
    for (std::size_t i = 0; i < tour.size(); ++i) {
        const auto& neighbours = others[tour[i]];
        edges += std::ranges::count(neighbours, tour[(i + 1) % tour.size()]) == 0;
    }
    return static_cast<double>(edges);
}

std::string text_of(const BitString&, const Genome& genome) { return genome.to_string(); }
template <class Numbers>
std::string text_of(const Numbers& numbers, const Genome& genome) {
    return fmt::format("{}", fmt::join(numbers.decode(genome), " "));
}

template <class T>
std::vector<T> read_numbers(std::string_view text, std::size_t count) {
    std::vector<std::string> words;
    std::string trimmed(text);
    boost::algorithm::trim(trimmed);
    boost::algorithm::split(words, trimmed, boost::is_any_of(" ,\t"), boost::token_compress_on);
    if (words.size() != count)
        throw UserError(fmt::format("\"{}\" has {}, expected {}", trimmed, counted(words.size(), "number"), count));
    std::vector<T> numbers(count);
    for (std::size_t i = 0; i < count; ++i) {
        std::optional<T> number = parse_number<T>(words[i]);
        if (!number)
            throw UserError(
                fmt::format("\"{}\" is not a {}number", words[i], std::is_same_v<T, double> ? "" : "whole "));
        numbers[i] = *number;
    }
    return numbers;
}

Genome read_string(const BitString& bits, std::string_view text) {
    std::string characters = boost::algorithm::trim_copy(std::string(text));
    auto is_bit = [](char each) { return each == '0' || each == '1'; };
    if (characters.size() != bits.bits() || !std::ranges::all_of(characters, is_bit))
        throw UserError(fmt::format("\"{}\" is not a string of {} characters 0 and 1", characters, bits.bits()));
    return Genome::from_string(characters);
}

Genome read_string(const RealVector& reals, std::string_view text) {
    auto numbers = read_numbers<double>(text, reals.parameters());
    Genome genome(reals.bits());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        RealRange range = reals.range(i);
        if (!(numbers[i] >= range.low && numbers[i] <= range.high))
            throw UserError(fmt::format("{} is out of range: number {} of a string may be from {} to {}", numbers[i],
                                        i + 1, range.low, range.high));
        reals.set(genome, i, numbers[i]);
    }
    return genome;
}

Genome read_string(const Permutation& permutation, std::string_view text) {
    auto order = read_numbers<std::size_t>(text, permutation.places());
    std::vector<bool> there(order.size());
    for (std::size_t each : order) {
        if (each >= order.size() || there[each])
            throw UserError(fmt::format("{} {}; a permutation has each number from 0 to {} once", each,
                                        each < order.size() ? "occurs twice" : "is not an element", order.size() - 1));
        there[each] = true;
    }
    return permutation.encode(order);
}

} // namespace

std::string_view name_of(StringKind kind) {
    return kind == StringKind::binary ? "binary strings" : kind == StringKind::real ? "real vectors" : "permutations";
}

BitString::BitString(std::size_t bits) : bits_(bits) {
    if (bits == 0)
        throw std::invalid_argument("the binary string has 0 bits, expected at least 1");
}

RealVector::RealVector(std::vector<RealRange> ranges) : ranges_(std::move(ranges)) {
    if (ranges_.empty())
        throw std::invalid_argument("the vector has 0 numbers, expected at least 1");
    for (std::size_t i = 0; i < ranges_.size(); ++i) {
        if (!std::isfinite(ranges_[i].low) || !std::isfinite(ranges_[i].high) || !(ranges_[i].low < ranges_[i].high))
            throw std::invalid_argument(
                fmt::format("parameter {}: the range is {} to {}, expected two finite numbers, the lower number first",
                            i, ranges_[i].low, ranges_[i].high));
        if (!std::isfinite(ranges_[i].high - ranges_[i].low))
            throw std::invalid_argument(
                fmt::format("parameter {}: the width of the range {} to {} is beyond the range of a double", i,
                            ranges_[i].low, ranges_[i].high));
    }
}

double RealVector::value(const Genome& genome, std::size_t number) const {
    return std::bit_cast<double>(genome.words()[number]);
}

void RealVector::set(Genome& genome, std::size_t number, double value) const {
    genome.set_word(number, std::bit_cast<std::uint64_t>(std::clamp(value, ranges_[number].low, ranges_[number].high)));
}

std::vector<double> RealVector::decode(const Genome& genome) const {
    std::vector<double> values(ranges_.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = value(genome, i);
    return values;
}

Permutation::Permutation(std::size_t places) : places_(places) {
    if (places == 0)
        throw std::invalid_argument("the permutation has 0 elements, expected at least 1");
}

std::vector<std::size_t> Permutation::decode(const Genome& genome) const {
    return {genome.words().begin(), genome.words().end()};
}

Genome Permutation::encode(std::span<const std::size_t> order) const {
    Genome genome(bits());
    for (std::size_t i = 0; i < order.size(); ++i)
        genome.set_word(i, order[i]);
    return genome;
}

std::size_t Representation::bits() const {
    return std::visit([](const auto& each) { return each.bits(); }, of_);
}

Genome Representation::random(RandomStream& random) const {
    return std::visit([&](const auto& each) { return random_string(each, random); }, of_);
}

std::vector<Genome> Representation::random_population(std::size_t count, RandomStream& random) const {
    std::vector<Genome> population;
    population.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        population.push_back(this->random(random));
    return population;
}

double Representation::distance(const Genome& a, const Genome& b) const {
    return std::visit([&](const auto& each) { return distance_of(each, a, b); }, of_);
}

std::string Representation::text(const Genome& genome) const {
    return std::visit([&](const auto& each) { return text_of(each, genome); }, of_);
}

bool Representation::holds(std::span<const Genome> strings) const {
    auto is_one = [&](const Genome& genome) {
        if (genome.size() != bits() || kind() == StringKind::binary)
            return genome.size() == bits();
        if (kind() == StringKind::permutation) {
            std::vector<std::size_t> places = permutation().decode(genome);
            std::ranges::sort(places);
            return places.back() < places.size() && std::ranges::adjacent_find(places) == places.end();
        }
        for (std::size_t i = 0; i < reals().parameters(); ++i)
            if (double value = reals().value(genome, i);
                !(value >= reals().range(i).low && value <= reals().range(i).high))
                return false;
        return true;
    };
    return std::ranges::all_of(strings, is_one);
}

Genome Representation::read(std::string_view text) const {
    return std::visit([&](const auto& each) { return read_string(each, text); }, of_);
}

} // namespace placedpar
