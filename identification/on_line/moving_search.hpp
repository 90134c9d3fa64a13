#pragma once

#include "hydraulics/circuit/configuration_watch.hpp"
#include "hydraulics/data/parameters.hpp"
#include "identification/on_line/set_search.hpp"

#include <functional>
#include <string>

namespace placedpar::identification {

/// The constants of a machine from which the configurations of its main valve are recognised.
struct RecognisedMachine {
    hydraulics::MainValve valve;
    hydraulics::CrossOverLimits limits;
    hydraulics::PerLink<double> healthy_in3_per_psi{}; ///< compliances of the healthy links

    static RecognisedMachine of(const hydraulics::Parameters&);
};

/// Searches for the compliances of a machine that works and changes its configuration (thesis 3.3). Takes one reading
/// after the other. For each reading, recognises the main valve's configuration and the links into which oil flows.
/// Samples of these links go to the search of their population set: the set of links that share oil, with a population
/// of its own (Figure 3.13). When the configuration or the links change, each set in use until then makes a round of
/// generations (SetSearch::round()).
class MovingSearch {
public:
    /// Returns the settings of a search for this number of links.
    using WayFor = std::function<WholeWay(std::size_t links)>;

    /// `period_s` is the time between readings. The random stream of a set has the name `prefix` + name of the set.
    MovingSearch(const RecognisedMachine&, double period_s, WayFor, std::uint64_t seed, std::string prefix,
                 std::size_t most_samples);

    MovingSearchState state() const;
    /// Continues from a saved state. REQUIRES: the state is of an object that was constructed with the same arguments.
    void go_on_from(MovingSearchState);

    /// Takes the next reading, one period after the last reading. Returns the sets whose searches made a round of
    /// generations.
    std::vector<hydraulics::LinkSet> take(const hydraulics::ValveReading&, double time_s);
    /// Forgets the last readings after a gap, but keeps all samples and populations.
    void restart();
    /// Returns the number of readings taken.
    std::size_t readings() const { return state_.readings; }
    /// Returns the configuration at the last reading.
    hydraulics::Configuration configuration() const { return state_.configuration; }
    /// Returns the sets of links into which oil flowed at the last reading.
    const std::vector<hydraulics::LinkSet>& in_use() const { return state_.in_use; }
    /// Returns the searches of all sets ever used.
    const std::map<hydraulics::LinkSet, SetSearch>& searches() const { return searches_; }
    /// Makes the rounds of generations that are still missing at the end of the readings. Returns the answers of all
    /// sets with enough samples, in the order of Figure 3.13.
    std::vector<SetAnswer> answers();

private:
    void release(std::vector<PendingSample>& pending);
    std::vector<hydraulics::LinkSet> end_stretches(const std::vector<hydraulics::LinkSet>& sets);
    void collect(hydraulics::LinkSet set, double time_s);
    SetSearch& search_of(hydraulics::LinkSet set);

    hydraulics::FlowConstants flow_;
    WayFor way_;
    std::uint64_t seed_;
    std::string prefix_;
    std::size_t most_samples_;
    hydraulics::ConfigurationWatch watch_;
    MovingSearchState state_; ///< without the states of the watch and the searches
    std::map<hydraulics::LinkSet, SetSearch> searches_;
};

} // namespace placedpar::identification
