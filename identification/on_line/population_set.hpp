#pragma once

#include "gaprocs/representation/genome.hpp"
#include "identification/on_line/link_estimate.hpp"
#include "identification/on_line/set_problem.hpp"
#include "identification/on_line/settings.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {
struct Individual; // gaprocs/policies/individual.hpp
}

namespace placedpar::identification {

/// The search for the compliances of one set of links that share oil (Figure 3.13 of the thesis). It has a population
/// that searches the compliances of these links together, and an estimate for each link. Population and estimates
/// survive changes of the main valve's configuration.
///
/// The random numbers depend on the seed, the names of excavator and set, and the number of samples seen. The results
/// therefore depend only on the set's own samples. Other sets, or a restart of the program, do not change them.
class PopulationSet {
public:
    /// Holds everything that is needed to restore the object.
    struct State {
        std::vector<Genome> population; ///< the elite first
        std::vector<SetSample> window;  ///< oldest first
        std::size_t to_skip = 0;        ///< number of usable samples that are still to be left out
        std::uint64_t samples = 0;      ///< number of samples seen, usable or not
        std::uint64_t generations = 0;
        std::vector<LinkEstimate> estimates; ///< one for each link, in the order of links_of() (population_sets.hpp)

        friend bool operator==(const State&, const State&) = default;
    };

    /// Draws the first population. `name` is part of the names of the random streams.
    PopulationSet(hydraulics::LinkSet links, const DiagnosisSettings& settings, std::uint64_t seed, std::string name);
    PopulationSet(hydraulics::LinkSet links, const DiagnosisSettings& settings, std::uint64_t seed, std::string name,
                  State state);

    hydraulics::LinkSet links() const { return links_; }
    const State& state() const { return state_; }

    /// Adds the newest sample to the window, the samples over which strings are evaluated. If the window is full and
    /// the pressure of at least one link changes fast enough (excitation_gate.hpp), makes `search.window.trials`
    /// generations. Returns the number of generations made. REQUIRES: the problem has the links of this set.
    std::size_t take(const SetProblem& problem, const SetSample& sample, double time_s);

    /// Empties the window after a change of configuration or a gap in the samples, because earlier samples do not
    /// describe the present circuit. Population and estimates stay.
    void restart_window();

private:
    void push(const SetSample& sample);
    void evolve(const SetProblem& problem, double time_s);
    /// Restores the bits of each link whose pressure changes too slowly (excitation_gate.hpp) from `former`, the
    /// population before the newest generations. The samples say nothing about these links, so the generations changed
    /// their bits at random.
    void keep_frozen_columns(const std::vector<Genome>& former);
    void add_errors(const SetProblem& problem);
    void record(const SetProblem& problem, const Individual& best, double time_s);

    hydraulics::LinkSet links_;
    DiagnosisSettings settings_;
    std::uint64_t seed_;
    std::string name_;
    State state_;
};

} // namespace placedpar::identification
