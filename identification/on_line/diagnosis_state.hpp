#pragma once

#include "identification/on_line/alarm.hpp"
#include "identification/on_line/excavator_parameters.hpp"
#include "identification/on_line/frozen_watch.hpp"
#include "identification/on_line/link_track.hpp"
#include "identification/on_line/moving_state.hpp"
#include "identification/on_line/population_set.hpp"
#include "identification/on_line/set_watch.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::identification {

/// The readings of a sample that is not complete yet.
struct OpenSample {
    std::size_t readings = 0;
    double first_s = 0; ///< time of the first reading
    double after_s = 0; ///< sum over all readings of their times since the first reading

    double middle_s() const { return first_s + after_s / static_cast<double>(readings); }
    friend bool operator==(const OpenSample&, const OpenSample&) = default;
};

/// Holds everything that is needed to restore a Diagnosis.
struct DiagnosisState {
    std::string name; ///< name of the excavator
    ExcavatorParameters parameters;
    std::optional<hydraulics::Configuration> configuration;
    hydraulics::LinkSet active;
    std::optional<double> time_s;  ///< time of the last reading
    bool time_may_restart = false; ///< whether a control system has connected since the last reading
    std::uint64_t samples = 0;     ///< number of instants read
    OpenSample open;
    std::optional<double> sample_s; ///< mean time of the last complete sample; nullopt after the windows have restarted
    hydraulics::PerLink<LinkTrack> tracks;
    std::map<hydraulics::LinkSet, PopulationSet::State> sets; ///< all sets ever used
    /// Healthy compliances: set by the control system, or else typical of the machine's kind.
    hydraulics::PerLink<double> health_in3_per_psi{};
    hydraulics::PerLink<FrozenWatch> pressures, angles;
    std::map<hydraulics::LinkSet, SetWatch::State> watches; ///< one for each set ever used
    bool judged = false;       ///< whether a verdict may have changed since the alarms were last determined
    std::vector<Alarm> alarms; ///< active alarms
    std::optional<MovingDiagnosisState> moving; ///< nullopt: the control system reports the configuration

    friend bool operator==(const DiagnosisState&, const DiagnosisState&) = default;
};

} // namespace placedpar::identification
