#pragma once

#include "gaprocs/policies/coding.hpp"
#include "gaprocs/settings.hpp"
#include "hydraulics/circuit/circuit_sample.hpp"
#include "identification/circuit_problem.hpp"

#include <cstddef>
#include <optional>

namespace placedpar::identification {

/// While a link's pressure moves too slowly over the window there is nothing to learn, and the search would follow the
/// noise: no generation is made. Too slowly means below both limits; the one on flow lets through a soft hose, whose
/// pressure rises slowly.
struct ExcitationGate {
    double slope_psi_per_s = 800; ///< rms; ours: keeps 9 of 10 estimates within 10 % up to the mid noise
    double flow_in3_per_s = 6.9;  ///< rms, C dP/dt: the same at the thesis's C of .0086
};

/// How compliances are identified.
struct IdentificationWay {
    SearchSettings search;
    std::size_t bits = CircuitProblem::usual_bits; ///< of one compliance
    Coding coding = Coding::natural;
    hydraulics::UsableSamples usable;
    std::optional<ExcitationGate> gate; ///< the thesis has none
    std::size_t searches = 1;           ///< with different random numbers; the spread of their answers is reported
};

/// As chapter 3 describes it: natural binary, no elite, no gate, one search over the 0.4 s of the transient.
IdentificationWay thesis_way();
/// The same "during the pressure rise" (section 3.4): on its samples only.
IdentificationWay rising_way();
/// What an engineer would want: Gray code, one elite, the first two samples after the valve opens left out, the
/// gate, 21 searches.
IdentificationWay service_way();

/// Samples needed before the first generation.
std::size_t samples_for_first_generation(const IdentificationWay&);

} // namespace placedpar::identification
