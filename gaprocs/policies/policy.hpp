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

// A policy is one way to do a step of a genetic algorithm, a plain struct such as
//
//     struct TournamentReproduction {
//         static constexpr std::string_view name = "tournament", about = "the best of `size` drawn at random",
//                                           source = "D. Goldberg and K. Deb, 1991";
//         std::size_t size = 2;
//         static constexpr auto numbers() { return std::tuple(PolicyNumber{"size", &TournamentReproduction::size, 1,
//         1000}); }
//     };
//
// and a step is done by a OneOf<...> of them. Library and netlists name a policy by the same text:
// "tournament", "tournament(3)", "tournament(size = 3)". A program can add structs of its own to a step:
// Step::add<TournamentReproduction>(), before anything else asks the step for its policies.

/// A number of a policy, a double, a size or a bool (0 or 1): its name, where it lies, its range with both ends, and a
/// line about it, with its unit.
template <class Policy, class T>
struct PolicyNumber {
    std::string_view name;
    T Policy::*member;
    double least, most;
    std::string_view about = "";
};

template <class Policy, class T> // for Clang 14, which deduces none for an aggregate
PolicyNumber(std::string_view, T Policy::*, double, double, std::string_view = "")->PolicyNumber<Policy, T>;

struct PolicyNumberDescription {
    std::string name;
    double by_default, least, most;
    bool whole;
    std::string about = ""; ///< one line; empty: its name says it
};

/// A policy as the catalogue lists it.
struct PolicyDescription {
    std::string name;
    std::string about; ///< one line
    std::vector<PolicyNumberDescription> numbers;
    std::string source = ""; ///< where it is from: chapter or equation of the thesis, else who proposed it
    std::vector<std::string> strings = {}; ///< kinds of strings that the policy works on; empty: all

    /// "tournament(size = 2)": as text() of the policy with these numbers.
    std::string text(const std::vector<double>& values) const;
    /// With the numbers by default.
    std::string text() const;
};

/// Which of the known policies a text names, and its numbers.
struct NamedPolicy {
    std::size_t index;
    std::vector<double> numbers; ///< each in range, whole where it shall be; those not given by default
};

/// Throws UserError, saying what there is: no such policy, no such number, one too many or given twice, out of range,
/// or no text of the form "name", "name(2)", "name(number = 2, 3.5)".
NamedPolicy read_policy(std::string_view text, const std::vector<PolicyDescription>& known);

/// The numbers that a policy or a problem states; none where it states nothing.
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

/// REQUIRES: as many values as it has numbers.
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

/// What `work`, code that a program adds, gives. Throws UserError for whatever it throws: whose() and what was thrown.
template <class Whose, class Work>
auto tried(const Whose& whose, const Work& work) {
    try {
        return work();
    } catch (...) {
        throw UserError(std::string(whose()) + ": " + what_was_thrown());
    }
}

/// A policy that a program adds to those of a step. Each step that takes such lists, last of its policies, a class
/// derived from this one, which keeps what the step asks of a policy behind functions: one indirect call for a whole
/// population where the step works on one.
class OwnPolicy {
public:
    template <class Policy>
    explicit OwnPolicy(const Policy& policy) : description_(describe_policy<Policy>()), numbers_(numbers_of(policy)) {}

    const PolicyDescription& description() const { return description_; }
    const std::vector<double>& numbers() const { return numbers_; }

protected:
    /// What `work` gives. Throws UserError, which names the policy, for whatever it throws.
    template <class Work>
    auto tried(Work work) const {
        return placedpar::tried([&] { return named(); }, work);
    }
    /// Within tried(), of what the policy gave. Throws UserError.
    static void require(bool right, const char* otherwise);

private:
    std::string named() const;

    PolicyDescription description_;
    std::vector<double> numbers_;
};

/// Throws UserError: a name that is taken or cannot be asked for, a number whose default is out of its range, or one
/// that is named twice.
void require_policy_fits(const PolicyDescription& added, std::string_view noun,
                         const std::vector<PolicyDescription>& known);

/// One of several policies; by default the first, with its own defaults. Step is the class derived from this one.
template <class Step, class... Policies>
class OneOf {
public:
    /// What holds the policies that a program adds, if any may be added.
    using Own = std::tuple_element_t<sizeof...(Policies) - 1, std::tuple<Policies...>>;

    OneOf() = default;
    /// Throws UserError, which names the policy, for whatever a program's own policy throws while it is copied.
    constexpr OneOf(const OneOf& other) : policy_(other.copied()) {}
    constexpr OneOf(OneOf&&) = default;
    constexpr OneOf& operator=(const OneOf& other) { return *this = OneOf(other); }
    constexpr OneOf& operator=(OneOf&&) = default;
    ~OneOf() = default;
    template <class Policy>
    constexpr OneOf(Policy policy) requires(std::is_same_v<Policy, Policies> || ...) : policy_(std::move(policy)) {}

    /// The step that a text names. Throws as read_policy().
    static Step named(std::string_view text) {
        NamedPolicy named = read_policy(text, descriptions());
        return known()[named.index].make(named.numbers);
    }
    /// From now on a text can name this policy. Throws as require_policy_fits(), and UserError for whatever its
    /// constructor throws, then or when it is named. REQUIRES: called by one thread, before a search begins.
    template <class Policy>
    static void add() requires std::derived_from<Own, OwnPolicy> {
        auto whose = [] { return "the policy \"" + std::string(Policy::name) + "\" for " + std::string(Step::noun); };
        PolicyDescription added = placedpar::tried(whose, describe_policy<Policy>);
        require_policy_fits(added, Step::noun, descriptions());
        known().push_back({std::move(added), [whose](const std::vector<double>& numbers) {
                               return placedpar::tried(whose, [&] { return Step(Own(make_policy<Policy>(numbers))); });
                           }});
    }

    /// As named() takes it.
    std::string text() const {
        auto [described, numbers] = description();
        return described.text(numbers);
    }
    /// Throws UserError: a policy that was made as a struct can have any number.
    void require_numbers_in_range() const { read_policy(text(), {description().first}); }
    /// Lists the policies of PlacedPar, then those that were added, in their order.
    static std::vector<PolicyDescription> descriptions() {
        std::vector<PolicyDescription> all;
        for (const Known& each : known())
            all.push_back(each.description);
        return all;
    }

    /// For steps whose policies say what they can work on: whether this policy can, and the names of the policies that
    /// can.
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

    /// A policy by name, and how the step is made of it.
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
