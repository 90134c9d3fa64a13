#pragma once

#include "gaprocs/search.hpp"
#include "identification/on_line/estimate.hpp"
#include "identification/on_line/set_problem.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::monitor {

/// A population and what it has found: the part of the diagnosis that outlives changes of configuration.
///
/// Its random numbers depend on the seed, the names of machine and set, and how many samples it has seen, so
/// that what it finds is a function of its samples alone, whatever other sets do, and goes on after a restart
/// exactly as it would have without one.
class PopulationSet {
public:
    /// All that a restart needs.
    struct State {
        std::vector<Genome> population; // the elite first
        std::vector<SetSample> window;  // oldest first
        std::size_t to_skip = 0;        // usable samples still to be left out
        std::uint64_t samples = 0;      // seen, usable or not
        std::uint64_t generations = 0;
        std::vector<Estimate> estimates; // of each link, in the order of links_of()
    };

    /// Draws the first population. `name` is that of the random streams.
    PopulationSet(hydraulics::LinkSet links, const DiagnosisSettings& settings, std::uint64_t seed, std::string name);
    PopulationSet(hydraulics::LinkSet links, const DiagnosisSettings& settings, std::uint64_t seed, std::string name,
                  State state);

    hydraulics::LinkSet links() const { return links_; }
    const State& state() const { return state_; }

    /// The newest sample: window, gate and, when both allow it, the trials. Gives the number of generations.
    /// REQUIRES: the problem is one of this set's links.
    std::size_t take(const SetProblem& problem, const SetSample& sample, double time_s);

    /// After a change of configuration, or a gap in the samples: samples of before say nothing of the circuit
    /// of now. Population and estimates stay.
    void restart_window();

private:
    void push(const SetSample& sample);
    void evolve(const SetProblem& problem, double time_s);
    /// Gives the links that are not excited their columns of the former population back: their bits would only
    /// drift.
    void keep_frozen_columns(const std::vector<Genome>& former);
    void record(const SetProblem& problem, const Individual& best, double time_s);

    hydraulics::LinkSet links_;
    DiagnosisSettings settings_;
    std::uint64_t seed_;
    std::string name_;
    State state_;
};

} // namespace placedpar::monitor
