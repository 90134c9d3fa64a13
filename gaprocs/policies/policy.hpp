#pragma once

#include "runtime/user_code.hpp"
#include "text/user_error.hpp"

#include <concepts>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace placedpar {

// A policy is one way to do a step of a genetic algorithm, such as selection. It is a plain struct, for example:
//
//     struct TournamentReproduction {
//         static constexpr std::string_view name = "tournament", about = "the best of `size` drawn at random",
//                                           source = "D. Goldberg and K. Deb, 1991";
//         std::size_t size = 2;
//         static constexpr auto numbers() { return std::tuple(PolicyNumber{"size", &TournamentReproduction::size, 1,
//         1000}); }
//     };
//
// A step is a class derived from OneOf<...>. The arguments of OneOf are the policies. The library and netlists name a
// policy by the same text: "tournament", "tournament(3)", "tournament(size = 3)". A program adds its own struct to a
// step by calling Step::add<TournamentReproduction>(), before any code asks the step for its policies.

/// A number that configures a policy. Its `member` is a double, a std::size_t or a bool (0 or 1). `least` and `most`
/// are the limits of its value; `about` is one line of text, with the unit.
template <class Policy, class T>
struct PolicyNumber {
    std::string_view name;
    T Policy::*member;
    double least, most;
    std::string_view about = "";
};

template <class Policy, class T> // Clang 14 cannot deduce the arguments of an aggregate
PolicyNumber(std::string_view, T Policy::*, double, double, std::string_view = "")->PolicyNumber<Policy, T>;

struct PolicyNumberDescription {
    std::string name;
    double by_default, least, most;
    bool whole;
    std::string about = ""; ///< one line; empty if the name needs no explanation
};

struct PolicyDescription {
    std::string name;
    std::string about; ///< one line
    std::vector<PolicyNumberDescription> numbers;
    std::string source = "";               ///< origin: a chapter or equation of the thesis, or the author
    std::vector<std::string> strings = {}; ///< names of the kinds of strings that the policy works on; empty: any kind

    /// Returns the policy with these values of its numbers, as a netlist writes it: "tournament(size = 2)".
    std::string text(const std::vector<double>& values) const;
    /// Returns the text of the policy with its default numbers.
    std::string text() const;
};

/// A policy that was read from a text, with the values of its numbers.
struct NamedPolicy {
    std::size_t index; ///< index of the policy in the list `known` of read_policy()
    /// Values of all numbers of the policy; a number that the text omits has its default value.
    std::vector<double> numbers;
};

/// Reads a policy from a text such as "name", "name(2)" or "name(number = 2, 3.5)". Throws UserError if the text has
/// another form, names an unknown policy or number, or has too many numbers, and if a number is given twice or is out
/// of range. The message says what would be right.
NamedPolicy read_policy(std::string_view text, const std::vector<PolicyDescription>& known);

/// Returns Policy::numbers(), or an empty tuple if there is no such function. `Policy` may also be a problem.
template <class Policy>
constexpr auto stated_numbers() {
    if constexpr (requires { Policy::numbers(); })
        return Policy::numbers();
    else
        return std::tuple<>();
}

template <class Policy>
PolicyDescription describe_policy() {
    auto describe = [](const auto& number) {
        double by_default = static_cast<double>(Policy{}.*number.member);
        bool whole = !std::is_same_v<std::remove_cvref_t<decltype(Policy{}.*number.member)>, double>;
        return PolicyNumberDescription{std::string(number.name), by_default, number.least, number.most, whole,
                                       std::string(number.about)};
    };
    auto describe_all = [&](const auto&... number) {
        return std::vector<PolicyNumberDescription>{describe(number)...};
    };
    PolicyDescription described{std::string(Policy::name), std::string(Policy::about),
                                std::apply(describe_all, stated_numbers<Policy>())};
    if constexpr (requires { Policy::source; })
        described.source = Policy::source;
    return described;
}

template <class Policy>
std::vector<double> numbers_of(const Policy& policy) {
    auto values = [&](const auto&... number) {
        return std::vector<double>{static_cast<double>(policy.*number.member)...};
    };
    return std::apply(values, stated_numbers<Policy>());
}

/// Returns the policy with these values of its numbers. REQUIRES: one value for each number of the policy.
template <class Policy>
Policy make_policy(const std::vector<double>& values) {
    Policy policy;
    auto value = values.begin();
    auto set = [&](const auto& number) {
        auto& member = policy.*number.member;
        member = static_cast<std::remove_reference_t<decltype(member)>>(*value++);
    };
    std::apply([&](const auto&... number) { (set(number), ...); }, stated_numbers<Policy>());
    return policy;
}

/// Returns the result of `work`, which is user-defined code. If `work` throws anything, throws a UserError, whose
/// message is whose() followed by the text of the exception.
template <class Whose, class Work>
auto tried(const Whose& whose, const Work& work) {
    try {
        return work();
    } catch (...) {
        throw UserError(std::string(whose()) + ": " + what_was_thrown());
    }
}

/// Base class of the classes that hold a user-defined policy. A step that allows user-defined policies has a class
/// derived from OwnPolicy as its last policy. The derived class keeps the user's call operator in a std::function.
class OwnPolicy {
public:
    template <class Policy>
    explicit OwnPolicy(const Policy& policy) : description_(describe_policy<Policy>()), numbers_(numbers_of(policy)) {}

    const PolicyDescription& description() const { return description_; }
    const std::vector<double>& numbers() const { return numbers_; }

protected:
    /// Returns the result of `work`. If `work` throws anything, throws UserError with the policy's name.
    template <class Work>
    auto tried(Work work) const {
        return placedpar::tried([&] { return named(); }, work);
    }
    /// Throws UserError with the text `otherwise` unless `right` is true. REQUIRES: called within tried().
    static void require(bool right, const char* otherwise);

private:
    std::string named() const;

    PolicyDescription description_;
    std::vector<double> numbers_;
};

/// Throws UserError if `added` cannot join the policies `known`: the name of `added` is taken or has a character that
/// is not allowed, a default is out of range, or two numbers have the same name.
void require_policy_fits(const PolicyDescription& added, std::string_view noun,
                         const std::vector<PolicyDescription>& known);

/// Holds one of several policies for a step of a genetic algorithm. By default, this is the first policy of the list
/// with its default numbers. `Step` is the class derived from OneOf.
template <class Step, class... Policies>
class OneOf {
public:
    /// The last policy: the class of user-defined policies, if the step allows them.
    using Own = std::tuple_element_t<sizeof...(Policies) - 1, std::tuple<Policies...>>;

    OneOf() = default;
    /// If the copy constructor of a user-defined policy throws anything, throws UserError with the policy's name.
    constexpr OneOf(const OneOf& other) : policy_(other.copied()) {}
    constexpr OneOf(OneOf&&) = default;
    constexpr OneOf& operator=(const OneOf& other) { return *this = OneOf(other); }
    constexpr OneOf& operator=(OneOf&&) = default;
    ~OneOf() = default;
    template <class Policy>
    constexpr OneOf(Policy policy) requires(std::is_same_v<Policy, Policies> || ...) : policy_(std::move(policy)) {}

    /// Returns the step with the policy that a text names, such as "tournament(3)". Throws what read_policy() throws.
    static Step named(std::string_view text) {
        NamedPolicy named = read_policy(text, descriptions());
        return known()[named.index].make(named.numbers);
    }
    /// Adds a user-defined policy; named() then accepts its name. Throws what require_policy_fits() throws. If the
    /// policy's constructor throws anything, add() or named() throws UserError. REQUIRES: called by one thread, before
    /// a search begins.
    template <class Policy>
    static void add() requires std::derived_from<Own, OwnPolicy> {
        auto whose = [] { return "the policy \"" + std::string(Policy::name) + "\" for " + std::string(Step::noun); };
        PolicyDescription added = placedpar::tried(whose, describe_policy<Policy>);
        require_policy_fits(added, Step::noun, descriptions());
        known().push_back({std::move(added), [whose](const std::vector<double>& numbers) {
                               return placedpar::tried(whose, [&] { return Step(Own(make_policy<Policy>(numbers))); });
                           }});
    }

    /// Returns the policy as a text that named() can read.
    std::string text() const {
        auto [described, numbers] = description();
        return described.text(numbers);
    }
    /// Throws UserError if a number is out of its range. A policy from named() has only numbers in range; a policy that
    /// a program constructs may have any number.
    void require_numbers_in_range() const { read_policy(text(), {description().first}); }
    /// Describes PlacedPar's own policies, followed by the added policies in the order in which they were added.
    static std::vector<PolicyDescription> descriptions() {
        std::vector<PolicyDescription> all;
        for (const Known& each : known())
            all.push_back(each.description);
        return all;
    }

    /// Returns whether the policy works on this kind of string. fitting() returns the names of all policies that work
    /// on it. REQUIRES: all policies of the step have fits().
    template <class Kind>
    bool fits(Kind kind) const {
        return std::visit([&](const auto& policy) { return policy.fits(kind); }, policy_);
    }
    template <class Kind>
    static std::vector<std::string> fitting(Kind kind) {
        std::vector<std::string> names;
        for (const Known& each : known())
            if (named(each.description.name).fits(kind))
                names.push_back(each.description.name);
        return names;
    }

protected:
    constexpr const std::variant<Policies...>& policy() const { return policy_; }

private:
    constexpr std::variant<Policies...> copied() const {
        if constexpr (std::derived_from<Own, OwnPolicy>)
            if (std::holds_alternative<Own>(policy_))
                return placedpar::tried([&] { return "the policy \"" + text() + "\""; }, [&] { return policy_; });
        return policy_;
    }

    std::pair<PolicyDescription, std::vector<double>> description() const {
        auto describe = []<class Policy>(const Policy& policy) {
            if constexpr (std::derived_from<Policy, OwnPolicy>)
                return std::pair(policy.description(), policy.numbers());
            else
                return std::pair(describe_policy<Policy>(), numbers_of(policy));
        };
        return std::visit(describe, policy_);
    }

    /// A policy of the step, with the function that makes it.
    struct Known {
        PolicyDescription description;
        std::function<Step(const std::vector<double>& numbers)> make;
    };
    static std::vector<Known>& known() {
        static std::vector<Known> all = those_of_the_house();
        return all;
    }
    static std::vector<Known> those_of_the_house() {
        std::vector<Known> all;
        auto list = [&]<class Policy>(std::type_identity<Policy>) {
            if constexpr (!std::derived_from<Policy, OwnPolicy>)
                all.push_back({describe_policy<Policy>(),
                               [](const std::vector<double>& numbers) { return Step(make_policy<Policy>(numbers)); }});
        };
        (list(std::type_identity<Policies>()), ...);
        return all;
    }

    std::variant<Policies...> policy_;
};

} // namespace placedpar
