#pragma once

#include "gaprocs/policies/coding.hpp"
#include "gaprocs/settings.hpp"
#include "hydraulics/circuit/circuit_sample.hpp"
#include "identification/circuit_problem.hpp"
#include "identification/excitation_gate.hpp"

#include <cstddef>
#include <optional>

namespace placedpar::identification {

/// How compliances are searched for as chapter 3 does, in one transient of a record. Who wants what an engineer would
/// add, and all movements of a record, takes the diagnosis (on_line/record_diagnosis.hpp).
struct IdentificationWay {
    SearchSettings search;
    std::size_t bits = CircuitProblem::usual_bits; ///< of one compliance
    Coding coding = Coding::natural;
    hydraulics::UsableSamples usable;
    std::optional<ExcitationGate> gate; ///< the thesis has none
};

/// As chapter 3 describes it: natural binary, no elite, one search over the 0.4 s of the transient.
IdentificationWay thesis_way();
/// The same "during the pressure rise" (section 3.4): on its samples only.
IdentificationWay rising_way();

/// Samples needed before the first generation.
std::size_t samples_for_first_generation(const IdentificationWay&);

} // namespace placedpar::identification
