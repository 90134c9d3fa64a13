#include "gaprocs/policies/island_choice.hpp"

#include "runtime/random.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <variant>

namespace placedpar {

namespace {

std::size_t greatest_ratio(const ErrorMatrix& matrix, ErrorMatrix::Normaliser normaliser) {
    std::size_t best = 0;
    for (std::size_t island = 1; island < matrix.islands(); ++island)
        if (matrix.ratio(island, normaliser) > matrix.ratio(best, normaliser))
            best = island;
    return best;
}

} // namespace

std::size_t PrintedChoice::operator()(const ErrorsOfBest& bests, RandomStream&) const {
    return greatest_ratio({bests, ErrorMatrix::Sum::squares}, ErrorMatrix::Normaliser::column);
}

std::size_t PlainSumChoice::operator()(const ErrorsOfBest& bests, RandomStream&) const {
    return greatest_ratio({bests, ErrorMatrix::Sum::plain}, ErrorMatrix::Normaliser::column);
}

std::size_t MeansChoice::operator()(const ErrorsOfBest& bests, RandomStream&) const {
    return greatest_ratio({bests, ErrorMatrix::Sum::means}, ErrorMatrix::Normaliser::column);
}

std::size_t RowChoice::operator()(const ErrorsOfBest& bests, RandomStream&) const {
    return greatest_ratio({bests, ErrorMatrix::Sum::squares}, ErrorMatrix::Normaliser::row);
}

std::size_t FixedChoice::operator()(const ErrorsOfBest& bests, RandomStream&) const {
    IslandChoice(*this).validate_for(bests.windows.size());
    return island;
}

std::size_t RandomChoice::operator()(const ErrorsOfBest& bests, RandomStream& random) const {
    return random.below(static_cast<std::uint32_t>(bests.windows.size()));
}

std::size_t OwnChoice::operator()(const ErrorsOfBest& bests, RandomStream& random) const {
    return tried([&] {
        std::size_t island = choose_(bests, random);
        require(island < bests.windows.size(), "it chose an island that does not exist; islands are numbered from 0");
        return island;
    });
}

void IslandChoice::validate_for(std::size_t islands) const {
    if (auto fixed = std::get_if<FixedChoice>(&policy()); fixed && fixed->island >= islands)
        throw UserError(
            fmt::format("the choice is island {}, but the number of islands is {}; expected an island from 0 to {}",
                        fixed->island, islands, islands - 1));
}

std::size_t IslandChoice::operator()(const ErrorsOfBest& bests, RandomStream& random) const {
    return std::visit([&](const auto& way) { return way(bests, random); }, policy());
}

} // namespace placedpar
