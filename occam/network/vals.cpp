#include "occam/network/vals.hpp"

#include "occam/check/constant.hpp"
#include "occam/network/kind.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <memory>
#include <variant>
#include <vector>

namespace placedpar::occam {

namespace {

/// Returns the number as a constant of the type; nothing if it does not fit.
std::optional<Constant> constant_of_number(const Value& number, Basic basic) {
    if (const auto* real = std::get_if<double>(&number)) {
        const auto single = static_cast<float>(*real);
        if (basic == Basic::real64)
            return Constant{std::bit_cast<std::int64_t>(*real), nullptr};
        return std::isfinite(single) ? std::optional(Constant{std::bit_cast<std::int32_t>(single), nullptr})
                                     : std::nullopt;
    }
    const std::int64_t integer = std::get<std::int64_t>(number);
    const bool fits = integer >= most_negative(basic) && integer <= most_positive(basic);
    return fits ? std::optional(Constant{integer, nullptr}) : std::nullopt;
}

std::string print_value(const Value& value) {
    return std::visit([](const auto& of) { return fmt::format("{}", of); }, value);
}

/// Returns the reason why a VAL cannot have this value: a number is out of the range of the type, or a text has the
/// wrong length.
std::string refusal(const Value& chosen, const Type& type) {
    if (std::holds_alternative<std::string>(chosen))
        return fmt::format("its type is {}, and a text must have exactly this size", name_of(type));
    if (std::holds_alternative<double>(chosen))
        return fmt::format("the number is too large for {}", name_of(type));
    return fmt::format("{} holds whole numbers from {} to {}", name_of(type), most_negative(type.basic),
                       most_positive(type.basic));
}

/// Sets the VAL to the text. Returns false if the type of the VAL states a length, and the text has another length.
bool set_text(Program& program, Declaration& val, const std::string& text) {
    Abbreviation& abbreviation = std::get<Abbreviation>(val.form);
    const auto& written = abbreviation.type;
    const bool is_open = !written || (!written->dimensions.empty() && !written->dimensions.front());
    if (!is_open && text.size() != val.constant->bytes->size())
        return false;
    if (is_open)
        val.type = program.types.array(plain(*val.type).element, static_cast<std::uint32_t>(text.size()));
    val.constant = Constant{0, std::make_shared<const std::vector<std::uint8_t>>(text.begin(), text.end())};
    abbreviation.value.type = val.type;
    abbreviation.value.constant = val.constant;
    return true;
}

/// Sets the VAL to the value. Returns false if the value does not fit in the type of the VAL.
bool set_val(Program& program, Declaration& val, const Value& chosen) {
    if (const auto* const text = std::get_if<std::string>(&chosen))
        return set_text(program, val, *text);
    const auto constant = constant_of_number(chosen, plain(*val.type).basic);
    if (constant)
        val.constant = constant;
    return constant.has_value();
}

} // namespace

std::optional<Value> netlist_value(const Constant& constant, const Type& of) {
    const Type& type = plain(of);
    if (type.kind == Type::Kind::array && plain(*type.element).is(Basic::byte))
        return std::string(constant.bytes->begin(), constant.bytes->end());
    if (type.kind != Type::Kind::basic)
        return std::nullopt;
    if (!is_real(type.basic))
        return constant.bits;
    const double value = type.basic == Basic::real64
                             ? std::bit_cast<double>(constant.bits)
                             : double{std::bit_cast<float>(static_cast<std::uint32_t>(constant.bits))};
    return std::isfinite(value) ? std::optional<Value>(value) : std::nullopt;
}

void choose_val(Program& program, Declaration& val, const ValChoice& choose, Reporter& reporter) {
    if (!choose || !val.constant || !std::holds_alternative<Abbreviation>(val.form))
        return;
    const auto original = netlist_value(*val.constant, *val.type);
    if (!original || program.files[val.at.file]->path().starts_with('<'))
        return;
    const Location at = program.location(val.at);
    const Value chosen = choose(netlist_name(val.name), *original, at);
    if (chosen != *original && !set_val(program, val, chosen))
        reporter.error(
            at,
            fmt::format("{} cannot be set to {}: {}", val.name, print_value(chosen), refusal(chosen, plain(*val.type))),
            "");
}

} // namespace placedpar::occam
