#include "explore/optimise/machine_space.hpp"

#include "text/user_error.hpp"

#include <bit>

namespace placedpar {

namespace {

const StudyProduct& only_product(const Study& study) {
    if (study.products.size() > 1)
        throw UserError("a study with [search] cannot have [[also]] or [[table]]: leave them out");
    return study.products.front();
}

bool is_fixed(const StudyAxis& axis) { return axis.count() == 1; }

/// Returns the coding of the settings with several values. Code c means value number floor(values * c / 2^bits).
ParameterCoding coding_of(const StudyProduct& product) {
    std::vector<ParameterField> fields;
    for (const StudyAxis& axis : product.axes)
        if (std::uint64_t values = axis.count(); !is_fixed(axis))
            fields.push_back({.low = 0,
                              .high = static_cast<double>(values),
                              .bits = static_cast<std::size_t>(std::bit_width(values - 1)),
                              .whole = true});
    if (fields.empty())
        throw UserError("the search has nothing to choose: give some setting in [set] several values");
    return ParameterCoding(std::move(fields));
}

} // namespace

MachineSpace::MachineSpace(const Study& study)
    : product_(only_product(study)), count_(product_.count()), coding_(coding_of(product_)) {}

std::vector<std::string> MachineSpace::names() const {
    std::vector<std::string> names;
    for (const StudyAxis& axis : product_.axes)
        if (!is_fixed(axis))
            names.push_back(axis.name);
    return names;
}

Overrides MachineSpace::fixed() const {
    Overrides set;
    for (const StudyAxis& axis : product_.axes)
        if (is_fixed(axis))
            set[axis.name] = axis.at(0);
    return set;
}

std::uint64_t MachineSpace::machine_of(const Genome& genome) const {
    std::uint64_t machine = 0;
    std::size_t field = 0;
    for (const StudyAxis& axis : product_.axes)
        if (!is_fixed(axis))
            machine = machine * axis.count() + static_cast<std::uint64_t>(coding_.value(genome, field++));
    return machine;
}

} // namespace placedpar
