#pragma once

#include "hydraulics/circuit/circuit_problem.hpp"
#include "hydraulics/circuit/circuit_sample.hpp"
#include "identification/identified.hpp"

#include <cstdint>
#include <span>

namespace placedpar::identification {

/// Identifies the compliances of a circuit from its samples, without any simulated transputers. The first search draws
/// from the random stream (seed, "master"), as the process of that name in a netlist does, so that both give the same
/// answer; the others have streams of their own.
/// Throws UnfitRecord when there are not enough samples for the first generation, saying why.
Identified identify(const hydraulics::CircuitProblem& problem, const hydraulics::FlowConstants& flow,
                    std::span<const hydraulics::CircuitSample> samples, const IdentificationWay& way,
                    std::uint64_t seed);

} // namespace placedpar::identification
