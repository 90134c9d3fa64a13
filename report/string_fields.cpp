#include "report/string_fields.hpp"

#include <tuple>

namespace placedpar {

namespace {

Genome all_ones(std::size_t bits) {
    Genome genome(bits);
    for (std::size_t i = 0; i < bits; ++i)
        genome.set(i, true);
    return genome;
}

} // namespace

bool StringField::is_like(const StringField& other) const {
    return std::tie(unit, bits, least, most) == std::tie(other.unit, other.bits, other.least, other.most);
}

std::vector<StringField> string_fields(const SearchProblem& problem) {
    auto bits = problem.fields();
    if (bits.empty())
        return {};
    auto natural = problem.coded(Coding::natural);
    auto least = natural->decode(Genome(natural->bits())), most = natural->decode(all_ones(natural->bits()));
    auto names = problem.parameter_names(), units = problem.parameter_units();
    std::vector<StringField> fields;
    for (std::size_t i = 0; i < bits.size(); ++i)
        fields.push_back({names[i], units[i], bits[i], least[i], most[i]});
    return fields;
}

} // namespace placedpar
