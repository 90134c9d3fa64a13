#pragma once

#include "gaprocs/representation/genome.hpp"
#include "hydraulics/circuit/circuit_error.hpp"
#include "hydraulics/circuit/circuit_sample.hpp"
#include "hydraulics/circuit/configuration_watch.hpp"
#include "identification/on_line/link_estimate.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace placedpar::identification {

/// These types hold what is needed to restore the diagnosis of a working machine, for example after a restart of the
/// program.

/// The samples that a SetSearch, the search for the compliances of one set of links, took in one configuration of the
/// main valve.
struct ConfigurationSamples {
    hydraulics::Configuration configuration;
    std::vector<hydraulics::CircuitSample> samples; ///< oldest first; links in the order of the circuit
    /// The weights of the junctions' flows from the last round of generations (FlowWeights::rows).
    std::optional<hydraulics::PerJunction<hydraulics::PerJunction<double>>> weights;

    friend bool operator==(const ConfigurationSamples&, const ConfigurationSamples&) = default;
};

/// The state of a SetSearch.
struct SetSearchState {
    std::vector<Genome> population; ///< the elite first
    std::uint64_t generations = 0;
    std::uint64_t drawn = 0;           ///< numbers drawn from the random stream
    std::size_t rounds = 0, fresh = 0; ///< `rounds` of generations made, and `fresh` samples since the last round
    std::vector<ConfigurationSamples> configurations; ///< ordered by configuration

    friend bool operator==(const SetSearchState&, const SetSearchState&) = default;
};

/// A sample that waits a few readings before the search uses it. The configuration may have changed during its last
/// readings, and the program recognises such a change only some readings later.
struct PendingSample {
    hydraulics::LinkSet set;
    hydraulics::CircuitSample sample;

    friend bool operator==(const PendingSample&, const PendingSample&) = default;
};

/// The state of a MovingSearch, which recognises configurations and passes samples to the searches of all sets.
struct MovingSearchState {
    hydraulics::ConfigurationWatch::State watch;
    std::size_t readings = 0;
    hydraulics::Configuration configuration{}; ///< at the last reading
    std::vector<hydraulics::LinkSet> in_use;   ///< sets in use at the last reading
    std::vector<PendingSample> pending;        ///< oldest first
    /// For each set, the first reading that its next sample may use, so that samples do not overlap.
    std::map<hydraulics::LinkSet, std::size_t> next;
    std::map<hydraulics::LinkSet, SetSearchState> searches;

    friend bool operator==(const MovingSearchState&, const MovingSearchState&) = default;
};

/// The state of a MovingDiagnosis, which judges the links by the answers of a MovingSearch.
struct MovingDiagnosisState {
    MovingSearchState search;
    std::map<hydraulics::LinkSet, std::vector<LinkEstimate>> estimates; ///< in the order of links_of()
    /// Index of the link's last reading that cannot be right, such as a frozen pressure. It is kept until a set that
    /// contains the link has been searched with samples of later readings; afterwards it is empty.
    hydraulics::PerLink<std::optional<std::size_t>> impossible{};

    friend bool operator==(const MovingDiagnosisState&, const MovingDiagnosisState&) = default;
};

} // namespace placedpar::identification
