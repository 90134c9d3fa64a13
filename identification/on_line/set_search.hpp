#pragma once

#include "gaprocs/search.hpp"
#include "identification/flow_weights.hpp"
#include "identification/identification.hpp"
#include "identification/on_line/set_problem.hpp"
#include "identification/whole_search.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::identification {

/// The compliances found for one set of links that move together, with a population of its own.
struct SetAnswer {
    hydraulics::LinkSet set;
    std::string configurations; ///< configurations in which the set was searched, such as "ad"
    std::size_t samples;
    std::uint64_t generations;
    std::vector<LinkIdentified> links; ///< in the order of links_of()
};

/// The search for the compliances of one set of links over all samples in which they move together, from all
/// configurations of the main valve. The population is kept from one round to the next. Rounds and weights work as in
/// whole_search.hpp.
class SetSearch {
public:
    static constexpr std::size_t fewest_samples = 10; ///< a set with fewer samples is not searched

    SetSearch(hydraulics::LinkSet set, const WholeWay& way, const hydraulics::FlowConstants& flow, RandomStream random);

    /// Adds a sample taken in this configuration. The links in `sample` are in the order of its circuit. Keeps the last
    /// 1,024 samples.
    void add(hydraulics::Configuration, hydraulics::CircuitSample sample);
    /// Makes the generations of a round if there are enough samples, and if samples have been added since the last
    /// round.
    void round();
    /// Makes the rounds that are still missing and returns the answer, or nullopt if there are too few samples.
    std::optional<SetAnswer> answer();

private:
    struct Part {
        SetProblem problem;
        std::vector<hydraulics::CircuitSample> samples;
        std::optional<FlowWeights> weights;
    };

    void evolve();
    std::size_t samples() const;
    std::vector<double> found_in(const Part& part) const; ///< in the circuit's order
    /// Returns the least-squares fit over the samples of all configurations, in the order of links_of().
    std::vector<LeastSquares> least_squares() const;

    hydraulics::LinkSet set_;
    WholeWay way_;
    hydraulics::FlowConstants flow_;
    Search search_;
    std::map<hydraulics::Configuration, Part> parts_;
    std::size_t rounds_ = 0, fresh_ = 0; ///< fresh: samples since the last round
};

/// The interpolation between readings can change a compliance by up to this share. Standard errors do not include this
/// change.
inline constexpr double model_share = 0.02;

/// Returns the mean of independent results, weighted by their standard errors and model_share.
LeastSquares combined(const std::vector<LeastSquares>& results);

} // namespace placedpar::identification
