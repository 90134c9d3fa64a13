#pragma once

#include "gaprocs/policies/policy.hpp"
#include "gaprocs/representation/representation.hpp"

#include <cstddef>
#include <functional>
#include <string_view>
#include <variant>
#include <vector>

namespace placedpar {

class RandomStream;

struct RandomStart {
    static constexpr std::string_view name = "random", about = "every string is drawn at random", source = "thesis 1.1";
};

/// Spreads the codes of each field (the bits of one parameter) evenly over the field's range. Assigns the codes to the
/// strings in random order, separately for each field.
struct SpreadStart {
    static constexpr std::string_view
        name = "spread",
        about = "the codes of each field are spread evenly over its range, in a random order for each field",
        source = "thesis 6.3, predefined populations; M. McKay et al., 1979";
};

/// A user-defined struct that returns strings for the first population, at most `population` strings. The search draws
/// the missing strings at random. The struct has the call operator
///
///     std::vector<Genome> operator()(std::size_t population, const Representation& representation,
///                                    RandomStream& random) const;
class OwnStart : public OwnPolicy {
public:
    template <class Policy>
    explicit OwnStart(Policy policy) : OwnPolicy(policy), begin_(std::move(policy)) {}
    std::vector<Genome> operator()(std::size_t population, const Representation& representation,
                                   RandomStream& random) const {
        return tried([&] {
            std::vector<Genome> strings = begin_(population, representation, random);
            require(strings.size() <= population && representation.holds(strings),
                    "it must return valid strings of the problem, and not more than the population has individuals");
            return strings;
        });
    }

private:
    std::function<std::vector<Genome>(std::size_t, const Representation&, RandomStream&)> begin_;
};

/// The policy that makes the first population. A search that reads its first strings from a file does not use the
/// policy.
class InitialPopulation : public OneOf<InitialPopulation, RandomStart, SpreadStart, OwnStart> {
public:
    using OneOf::OneOf;
    static constexpr std::string_view
        noun = "initial-population",
        about = "strings of the first population: drawn at random, spread evenly, or read from a file";

    bool is_spread() const { return std::holds_alternative<SpreadStart>(policy()); }
    /// Returns the policy if it is user-defined, otherwise null.
    const OwnStart* own() const { return std::get_if<OwnStart>(&policy()); }
};

} // namespace placedpar
