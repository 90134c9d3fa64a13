#pragma once

#include "gaprocs/policies/policy.hpp"
#include "gaprocs/representation/genome.hpp"
#include "gaprocs/representation/representation.hpp"
#include "runtime/random.hpp"

#include <functional>
#include <span>
#include <utility>

namespace placedpar {

/// A user-defined crossover or mutation, protected against errors in the user's code. The call operator works on a
/// whole population.
class OwnVariation : public OwnPolicy {
public:
    bool fits(StringKind kind) const {
        return tried([&] { return fits_(kind); });
    }
    /// Crosses or mutates as the call operators of Crossover and Mutation do. Throws UserError if the user's code
    /// throws, or if the code leaves an individual that is not a string of the representation.
    void operator()(std::span<Genome> population, double probability, const Representation& representation,
                    RandomStream& random) const {
        tried([&] {
            vary_(population, probability, representation, random);
            require(representation.holds(population), "it made an individual that is not a string of the problem");
        });
    }

protected:
    using Vary = std::function<void(std::span<Genome>, double, const Representation&, RandomStream&)>;

    template <class Policy>
    OwnVariation(const Policy& policy, Vary vary) : OwnPolicy(policy), fits_(Policy::fits), vary_(std::move(vary)) {}

private:
    bool (*fits_)(StringKind);
    Vary vary_;
};

} // namespace placedpar
