#pragma once

#include "gaprocs/policies/coding.hpp"
#include "gaprocs/settings.hpp"
#include "hydraulics/circuit/circuit_sample.hpp"
#include "identification/circuit_problem.hpp"
#include "identification/excitation_gate.hpp"

#include <cstddef>
#include <optional>

namespace placedpar::identification {

/// The settings of a search as in chapter 3, over one transient of a record. To identify every movement of a record, by
/// an improved method, use the diagnosis (on_line/record_diagnosis.hpp).
struct IdentificationWay {
    SearchSettings search;
    std::size_t bits = CircuitProblem::usual_bits; ///< bits per compliance
    Coding coding = Coding::natural;
    hydraulics::UsableSamples usable;
    std::optional<ExcitationGate> gate; ///< nullopt: the search always runs, as in the thesis
};

/// Returns the settings of chapter 3: natural binary, no elite, one search over the 0.4 s of the transient.
IdentificationWay thesis_way();
/// Returns the settings for a search "during the pressure rise" (section 3.4), which uses only the samples of the rise.
IdentificationWay rising_way();

/// Returns the number of samples that the first generation needs.
std::size_t samples_for_first_generation(const IdentificationWay&);

} // namespace placedpar::identification
