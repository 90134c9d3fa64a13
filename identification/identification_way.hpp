#pragma once

#include "gaprocs/policies/coding.hpp"
#include "gaprocs/settings.hpp"
#include "hydraulics/circuit/circuit_sample.hpp"
#include "identification/circuit_problem.hpp"
#include "identification/excitation_gate.hpp"

#include <cstddef>
#include <optional>

namespace placedpar::identification {

/// The settings of a search as in chapter 3 of the thesis, over one transient of a record. A transient is the time in
/// which a pressure changes after a valve has opened. For a whole record of many movements, use the diagnosis
/// (on_line/record_diagnosis.hpp) instead.
struct IdentificationWay {
    SearchSettings search;
    std::size_t bits = CircuitProblem::usual_bits; ///< bits per compliance
    Coding coding = Coding::natural;
    hydraulics::UsableSamples usable;
    /// The gate stops the search while the pressure hardly changes. If nullopt, the search always runs, as in the
    /// thesis.
    std::optional<ExcitationGate> gate;
};

/// Returns the settings of chapter 3: natural binary code, no elite, one search over the 0.4 s of the transient.
IdentificationWay thesis_way();
/// Returns the settings for a search "during the pressure rise" (thesis 3.4), which uses only samples with rising
/// pressures.
IdentificationWay rising_way();

/// Returns how many samples must be there before the first generation.
std::size_t samples_for_first_generation(const IdentificationWay&);

} // namespace placedpar::identification
