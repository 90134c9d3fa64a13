#pragma once

#include "gaprocs/coding.hpp"
#include "gaprocs/settings.hpp"
#include "hydraulics/circuit/circuit_problem.hpp"
#include "hydraulics/circuit/circuit_sample.hpp"
#include "runtime/random.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace placedpar {

/// No generation while a link's pressure moves too slowly over the window: there is nothing to learn, and the search
/// would walk away with the noise. Slow is what is below both: the slope, and the flow into the compliance, by
/// which a soft hose is followed although its pressure rises slowly.
struct ExcitationGate {
    double slope_psi_per_s = 800; // rms; ours: keeps 9 of 10 estimates within 10 % up to the mid noise
    double flow_in3_per_s = 6.9;  // rms, C dP/dt: the same at the thesis's C of .0086
};

/// How compliances are identified.
struct IdentificationWay {
    SearchSettings search;
    std::size_t bits = hydraulics::CircuitProblem::usual_bits; // a compliance
    Coding coding = Coding::natural;
    hydraulics::UsableSamples usable;
    /// None: the thesis has no gate.
    std::optional<ExcitationGate> gate;
    std::size_t searches = 1; // from different random numbers; the spread of their answers is reported
};

/// As chapter 3 describes it: natural binary, no elite, no gate, one search over the 0.4 s of the transient.
IdentificationWay thesis_way();
/// The same "during the pressure rise" (section 3.4): on its samples only.
IdentificationWay rising_way();
/// What an engineer would want: Gray code, one elite, the first two samples after the valve opens left out, the
/// gate, 21 searches.
IdentificationWay service_way();

/// A shorter window must only be full.
std::size_t samples_for_first_generation(const IdentificationWay&);

/// What the search had to say after a sample.
struct TransientEstimate {
    std::size_t index; // of the sample in the record
    double time_s;
    bool frozen;            // by the gate: the estimate is the one before
    double error_in3_per_s; // rms over the window, of the best individual
    std::vector<double> compliance_in3_per_psi;
};

/// What one search found.
struct SearchRun {
    std::vector<TransientEstimate> estimates;
    std::uint64_t generations = 0;
};

/// One search over the samples, generation after generation, as run_traditional() but for the gate and for gaps of the
/// record, after which the window begins anew: what identify() does `searches` times. Throws UnfitRecord when there are
/// not enough samples for the first generation.
SearchRun search_transient(const hydraulics::CircuitProblem& problem,
                           std::span<const hydraulics::CircuitSample> samples, const IdentificationWay& way,
                           RandomStream random);

/// One compliance, identified.
struct LinkIdentified {
    hydraulics::Link link;
    double compliance_in3_per_psi; // the median of the searches
    double lowest, highest;        // 5 and 95 % of the searches
    double standard_error;         // of least squares on the last window: what the record's own noise leaves open
    std::optional<double> optimum; // the best of all codes on the last window, where they can be tried: 20 bits
    std::optional<double> codes_from_optimum; // median distance of the searches
    std::vector<std::string> flags;           // sentences; empty: nothing unusual
};

struct Identified {
    hydraulics::Circuit circuit;
    std::vector<LinkIdentified> links;        // in the circuit's order
    std::vector<TransientEstimate> estimates; // of the first search
    std::uint64_t generations = 0;            // of all searches
};

/// Identifies the compliances of a circuit from its samples, without any machine. The first search draws from
/// the stream (seed, "master"), as the process of that name on a simulated machine does, so that both give
/// the same answer; the others from streams of their own.
/// Throws UnfitRecord when there are not enough samples for the first generation, saying why.
Identified identify(const hydraulics::CircuitProblem& problem, const hydraulics::FlowConstants& flow,
                    std::span<const hydraulics::CircuitSample> samples, const IdentificationWay& way,
                    std::uint64_t seed);

} // namespace placedpar
