#include "gaprocs/representation/parameter_coding.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace placedpar {

namespace {

void validate(const ParameterField& field, std::size_t number) {
    if (field.bits < 1 || field.bits > ParameterCoding::most_bits)
        throw std::invalid_argument(
            fmt::format("parameter {}: {} bits, expected 1 to {}", number, field.bits, ParameterCoding::most_bits));
    if (!std::isfinite(field.low) || !std::isfinite(field.high) || !(field.low < field.high))
        throw std::invalid_argument(
            fmt::format("parameter {}: the range is {} to {}, expected two finite numbers, the lower number first",
                        number, field.low, field.high));
    if (!std::isfinite(field.high - field.low))
        throw std::invalid_argument(
            fmt::format("parameter {}: the width of the range {} to {} is beyond the range of a double", number,
                        field.low, field.high));
}

} // namespace

ParameterCoding::ParameterCoding(std::vector<ParameterField> fields) : fields_(std::move(fields)) {
    if (fields_.empty())
        throw std::invalid_argument("a binary string must code at least one parameter");
    for (const ParameterField& field : fields_) {
        validate(field, places_.size());
        places_.push_back({bits_, field.bits, field.low, field.resolution(), field.whole});
        bits_ += field.bits;
    }
}

std::vector<std::size_t> ParameterCoding::fields() const {
    std::vector<std::size_t> bits;
    for (const ParameterField& field : fields_)
        bits.push_back(field.bits);
    return bits;
}

RealVector ParameterCoding::reals() const {
    std::vector<RealRange> ranges;
    for (const ParameterField& field : fields_)
        ranges.push_back({field.low, field.high});
    return RealVector(std::move(ranges));
}

} // namespace placedpar
