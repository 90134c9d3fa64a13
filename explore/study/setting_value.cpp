#include "explore/study/setting_value.hpp"

#include "netlist/elaborate/evaluator.hpp"
#include "netlist/elaborate/option_statements.hpp"
#include "netlist/language/parser.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <utility>

namespace placedpar {

namespace {

const Scopes& no_names() {
    static const Scopes scopes{Catalogue()};
    return scopes;
}

/// Returns the number, or both numbers if the suffix has two meanings and the setting is not a frequency.
std::string meaning_of(const Integer& integer, bool of_frequency) {
    if (of_frequency || integer.value == integer.decimal)
        return fmt::format("{}", integer.decimal);
    return fmt::format("{} or {}", integer.value, integer.decimal);
}

std::string meaning_of(double real) {
    constexpr double exact = 9007199254740992; // 2^53: larger doubles do not represent all integers
    return real == std::floor(real) && std::abs(real) < exact ? fmt::format("{}", static_cast<std::int64_t>(real))
                                                              : fmt::format("{}", real);
}

std::string meaning_of(const std::optional<Constant>& constant, const std::string& spelling, bool of_frequency) {
    if (!constant)
        return '"' + spelling + '"';
    if (const Integer* integer = constant->integer())
        return meaning_of(*integer, of_frequency);
    if (const double* real = constant->real())
        return meaning_of(*real);
    const std::string* text = constant->text();
    return text ? '"' + *text + '"' : spelling; // an array keeps its spelling
}

} // namespace

std::optional<Constant> constant_of_setting(const std::string& text) {
    Reporter reporter;
    std::optional<Constant> constant;
    attempt([&] {
        TokenStream tokens(std::make_shared<const SourceFile>("", text), "", reporter);
        ExpressionPointer expression = Parser(tokens, reporter).parse_whole_expression();
        if (!reporter.failed())
            constant = Evaluator(no_names(), reporter).evaluate(*expression);
    });
    return constant;
}

std::optional<double> number_of_setting(const std::string& text) {
    std::optional<Constant> constant = constant_of_setting(text);
    if (!constant || !constant->is_number())
        return std::nullopt;
    return constant->integer() ? static_cast<double>(constant->integer()->decimal) : *constant->real();
}

bool is_frequency(const std::string& name) {
    std::string plain = name.substr(name.rfind('.') + 1);
    return plain == "clock" || plain == "linkspeed";
}

SettingValue::SettingValue(const std::string& name, std::string spelling) : spelling_(std::move(spelling)) {
    std::optional<Constant> constant = constant_of_setting(spelling_);
    meaning_ = meaning_of(constant, spelling_, is_frequency(name));
    is_real_ = constant && constant->real();
}

const SettingValue& better_spelt(const SettingValue& first, const SettingValue& other) {
    return first.is_real() && !other.is_real() ? other : first;
}

} // namespace placedpar
