#include "hydraulics/circuit_problem.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace placedpar {

CircuitProblem::CircuitProblem(Circuit circuit, FlowConstants flow, std::size_t bits, InletFlow form)
    : circuit_(std::move(circuit)), flow_(flow), bits_(bits), form_(form) {
    if (circuit_.empty() || circuit_.size() > all_links.size())
        throw std::invalid_argument(fmt::format("a circuit of {} junctions, expected 1 to 4", circuit_.size()));
    if (bits_ < 1 || bits_ > 32)
        throw std::invalid_argument(fmt::format("{} bits for a compliance, expected 1 to 32", bits_));
}

std::vector<std::string> CircuitProblem::parameter_names() const {
    std::vector<std::string> names;
    for (const Junction& junction : circuit_)
        names.push_back(fmt::format("C_{}i", symbol_of(junction.link)));
    return names;
}

std::vector<std::string> CircuitProblem::parameter_units() const {
    return std::vector<std::string>(circuit_.size(), "in^3/psi");
}

} // namespace placedpar
