#include "hydraulics/circuit/circuit_problem.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace placedpar::hydraulics {

namespace {

Circuit checked(Circuit circuit) {
    if (circuit.empty() || circuit.size() > all_links.size())
        throw std::invalid_argument(fmt::format("a circuit of {} junctions, expected 1 to 4", circuit.size()));
    return circuit;
}

} // namespace

CircuitProblem::CircuitProblem(Circuit circuit, FlowConstants flow, std::size_t bits, InletFlow form)
    : circuit_(checked(std::move(circuit))), flow_(flow), coding_(circuit_.size(), {0, largest_in3_per_psi, bits}),
      form_(form) {}

std::vector<std::string> CircuitProblem::parameter_names() const {
    std::vector<std::string> names;
    for (const Junction& junction : circuit_)
        names.push_back(fmt::format("C_{}i", symbol_of(junction.link)));
    return names;
}

std::vector<std::string> CircuitProblem::parameter_units() const {
    return std::vector<std::string>(circuit_.size(), "in^3/psi");
}

} // namespace placedpar::hydraulics
