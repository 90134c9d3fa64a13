#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <tuple>
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
// "tournament", "tournament(3)", "tournament(size = 3)".

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
    std::vector<std::string> strings = {}; ///< of what strings it works on; empty: of all

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

/// One of several policies; by default the first, with its own defaults.
template <class... Policies>
class OneOf {
public:
    OneOf() = default;
    template <class Policy>
    constexpr OneOf(Policy policy) requires(std::is_same_v<Policy, Policies> || ...) : policy_(std::move(policy)) {}

    /// As read() takes it.
    std::string text() const {
        auto print = [](const auto& policy) {
            return describe_policy<std::remove_cvref_t<decltype(policy)>>().text(numbers_of(policy));
        };
        return std::visit(print, policy_);
    }
    bool has_numbers() const {
        auto any = []<class Policy>(const Policy&) {
            return std::tuple_size_v<decltype(stated_numbers<Policy>())> > 0;
        };
        return std::visit(any, policy_);
    }
    static std::vector<PolicyDescription> descriptions() { return {describe_policy<Policies>()...}; }

    /// Of steps whose policies say what they can work on: whether this one can, and the names of those that can.
    template <class Kind>
    bool fits(Kind kind) const {
        return std::visit([&](const auto& policy) { return policy.fits(kind); }, policy_);
    }
    template <class Kind>
    static std::vector<std::string> fitting(Kind kind) {
        std::vector<std::string> names;
        auto add = [&](bool fits, std::string_view name) {
            if (fits)
                names.emplace_back(name);
        };
        (add(Policies::fits(kind), Policies::name), ...);
        return names;
    }

protected:
    /// The Step, a class derived from this one, that a text names. Throws as read_policy().
    template <class Step>
    static Step read(std::string_view text) {
        NamedPolicy named = read_policy(text, descriptions());
        constexpr std::array make{+[](const std::vector<double>& n) { return Step(make_policy<Policies>(n)); }...};
        return make[named.index](named.numbers);
    }
    constexpr const std::variant<Policies...>& policy() const { return policy_; }

private:
    std::variant<Policies...> policy_;
};

} // namespace placedpar
