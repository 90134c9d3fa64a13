#pragma once

#include "gaprocs/search.hpp"
#include "identification/identification.hpp"
#include "identification/on_line/moving_state.hpp"
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

/// The search for the compliances of one set of links, over all samples in which these links move together, in any
/// configuration of the main valve. The search goes in rounds: a number of generations, after which the weights of the
/// junctions' flows are computed anew (whole_search.hpp). The population is kept from one round to the next.
class SetSearch {
public:
    static constexpr std::size_t fewest_samples = 10; ///< a set with fewer samples is not searched

    /// Keeps the last `most_samples` samples. REQUIRES: the search of `way` has an elite.
    SetSearch(hydraulics::LinkSet set, const WholeWay& way, const hydraulics::FlowConstants& flow, RandomStream random,
              std::size_t most_samples);

    SetSearchState state() const;
    /// Continues from a saved state. REQUIRES: the state is of an object with the same settings and random stream.
    void go_on_from(SetSearchState);

    /// Adds a sample taken in this configuration. The links in `sample` are in the order of its circuit.
    void add(hydraulics::Configuration, hydraulics::CircuitSample sample);
    /// Makes the generations of a round if there are enough samples, and if samples have been added since the last
    /// round. Returns whether it made a round.
    bool round();
    std::size_t rounds() const { return rounds_; }
    std::uint64_t generations() const { return search_.generation(); }
    std::size_t samples() const; ///< number of samples kept
    /// Returns the index of the newest sample. REQUIRES: there is a sample.
    std::size_t newest_index() const;
    /// Returns the answer of the rounds so far. REQUIRES: a round has been made.
    SetAnswer answer_so_far() const;
    /// Makes the rounds that are still missing and returns the answer, or nullopt if there are too few samples.
    std::optional<SetAnswer> answer();

private:
    struct Part {
        SetProblem problem;
        ConfigurationSamples of;
    };

    Part& part_of(hydraulics::Configuration);
    void drop_oldest();
    void evolve();
    /// Returns the best individual of the last generation, which is the first of the elite.
    const Genome& best() const { return search_.population().front(); }
    std::vector<double> found_in(const Part& part) const; ///< in the circuit's order
    /// Returns the least-squares fit over the samples of all configurations, in the order of links_of().
    std::vector<LeastSquares> least_squares() const;

    hydraulics::LinkSet set_;
    WholeWay way_;
    hydraulics::FlowConstants flow_;
    Search search_;
    std::size_t most_samples_;
    std::map<hydraulics::Configuration, Part> parts_;
    std::size_t rounds_ = 0, fresh_ = 0; ///< as in SetSearchState
};

/// The equations interpolate between readings, which can change a compliance by up to this share. Standard errors do
/// not include this change.
inline constexpr double model_share = 0.02;

/// Returns the mean of independent results, weighted by their standard errors and model_share.
LeastSquares combined(const std::vector<LeastSquares>& results);

} // namespace placedpar::identification
