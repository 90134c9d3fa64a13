#include "gaprocs/policies/policy.hpp"

#include "text/nearest.hpp"
#include "text/number.hpp"
#include "text/user_error.hpp"

#include <boost/algorithm/string/trim.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace placedpar {

namespace {

std::string range_of(const PolicyNumberDescription& number) {
    return fmt::format("{} is {} from {} to {}", number.name, number.whole ? "a whole number" : "a number",
                       number.least, number.most);
}

std::vector<std::string> texts_of(const std::vector<PolicyDescription>& known) {
    std::vector<std::string> texts;
    for (const PolicyDescription& each : known)
        texts.push_back(each.text());
    return texts;
}

/// The parts of a text "name(arguments)".
struct Call {
    std::string_view name;
    std::optional<std::string_view> arguments;
};

Call read_call(std::string_view text) {
    text = boost::algorithm::trim_copy(text);
    std::size_t open = text.find('(');
    if (open == text.npos)
        return {text, std::nullopt};
    if (text.back() != ')')
        throw UserError(fmt::format("\"{}\" has no closing parenthesis at its end", text));
    return {boost::algorithm::trim_copy(text.substr(0, open)), text.substr(open + 1, text.size() - open - 2)};
}

std::size_t index_of(std::string_view name, const std::vector<PolicyDescription>& known) {
    std::vector<std::string> names;
    for (const PolicyDescription& each : known)
        names.push_back(each.name);
    auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end())
        return static_cast<std::size_t>(found - names.begin());
    auto guess = did_you_mean(name, names);
    throw UserError(fmt::format("\"{}\" is not one of {}{}", name, fmt::join(texts_of(known), ", "),
                                guess.empty() ? "" : "; " + guess));
}

double read_number(std::string_view text, const PolicyNumberDescription& number) {
    std::optional<double> value = parse_number<double>(text);
    if (!value)
        throw UserError(fmt::format("\"{}\" is not a number: {}", text, range_of(number)));
    bool fits = *value >= number.least && *value <= number.most && (!number.whole || *value == std::floor(*value));
    if (!fits)
        throw UserError(fmt::format("{} = {} is out of range: {}", number.name, text, range_of(number)));
    return *value;
}

/// The numbers that a text gives to a policy.
class Arguments {
public:
    explicit Arguments(const PolicyDescription& policy) : policy_(policy), given_(policy.numbers.size()) {}

    void take(std::string_view argument, std::size_t place) {
        std::size_t equals = argument.find('=');
        std::size_t index =
            equals == argument.npos ? place : index_of_number(boost::algorithm::trim_copy(argument.substr(0, equals)));
        if (index >= given_.size())
            throw UserError(takes());
        if (given_[index])
            throw UserError(fmt::format("{} of {} is given twice", policy_.numbers[index].name, policy_.name));
        auto value = equals == argument.npos ? argument : argument.substr(equals + 1);
        given_[index] = read_number(boost::algorithm::trim_copy(value), policy_.numbers[index]);
    }

    std::vector<double> values() const {
        std::vector<double> values;
        for (std::size_t i = 0; i < given_.size(); ++i)
            values.push_back(given_[i].value_or(policy_.numbers[i].by_default));
        return values;
    }

private:
    std::size_t index_of_number(std::string_view name) const {
        auto is_named = [&](const PolicyNumberDescription& number) { return number.name == name; };
        auto found = std::find_if(policy_.numbers.begin(), policy_.numbers.end(), is_named);
        if (found == policy_.numbers.end())
            refuse_name(name);
        return static_cast<std::size_t>(found - policy_.numbers.begin());
    }

    [[noreturn]] void refuse_name(std::string_view name) const {
        std::vector<std::string> names;
        for (const PolicyNumberDescription& number : policy_.numbers)
            names.push_back(number.name);
        const std::string meant = did_you_mean(name, names);
        throw UserError(fmt::format("{} has no number \"{}\"; {}{}", policy_.name, name,
                                    meant.empty() ? "" : meant + " ", takes()));
    }

    std::string takes() const {
        if (policy_.numbers.empty())
            return fmt::format("{} takes no number", policy_.name);
        std::vector<std::string> ranges;
        for (const PolicyNumberDescription& number : policy_.numbers)
            ranges.push_back(range_of(number));
        return fmt::format("{} takes at most {} number{}: {}", policy_.name, ranges.size(),
                           ranges.size() == 1 ? "" : "s", fmt::join(ranges, ", "));
    }

    const PolicyDescription& policy_;
    std::vector<std::optional<double>> given_;
};

} // namespace

std::string PolicyDescription::text(const std::vector<double>& values) const {
    if (values.empty())
        return name;
    std::vector<std::string> printed;
    for (std::size_t i = 0; i < values.size(); ++i)
        printed.push_back(fmt::format("{} = {}", numbers[i].name, values[i]));
    return fmt::format("{}({})", name, fmt::join(printed, ", "));
}

std::string OwnPolicy::named() const { return fmt::format("the policy \"{}\"", description_.text(numbers_)); }

void OwnPolicy::require(bool right, const char* otherwise) {
    if (!right)
        throw UserError(otherwise);
}

void require_policy_fits(const PolicyDescription& added, std::string_view noun,
                         const std::vector<PolicyDescription>& known) {
    auto refuse = [&](const std::string& why) {
        throw UserError(fmt::format("this program adds a policy \"{}\" for {}, but {}", added.name, noun, why));
    };
    auto may_be_in_a_name = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '.' || c == '-';
    };
    if (added.name.empty() || !std::ranges::all_of(added.name, may_be_in_a_name))
        refuse("a name may contain only a to z, 0 to 9, \".\" and \"-\"");
    if (added.name == "usual" || std::ranges::count(known, added.name, &PolicyDescription::name) > 0)
        refuse(fmt::format("this name is taken: choose another name, such as \"own.{}\"",
                           added.name.substr(added.name.rfind('.') + 1)));
    try {
        read_policy(added.text(), {added});
    } catch (const UserError& wrong) {
        refuse(wrong.what());
    }
}

std::string PolicyDescription::text() const { return text(Arguments(*this).values()); }

NamedPolicy read_policy(std::string_view text, const std::vector<PolicyDescription>& known) {
    Call call = read_call(text);
    std::size_t index = index_of(call.name, known);
    Arguments arguments(known[index]);
    if (!call.arguments)
        return {index, arguments.values()};
    std::string_view rest = *call.arguments;
    for (std::size_t place = 0;; ++place) {
        std::size_t comma = rest.find(',');
        arguments.take(boost::algorithm::trim_copy(rest.substr(0, comma)), place);
        if (comma == rest.npos)
            return {index, arguments.values()};
        rest = rest.substr(comma + 1);
    }
}

} // namespace placedpar
