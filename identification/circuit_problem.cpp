#include "identification/circuit_problem.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace placedpar {

namespace {

hydraulics::Circuit checked(hydraulics::Circuit circuit) {
    if (circuit.empty() || circuit.size() > hydraulics::all_links.size())
        throw std::invalid_argument(fmt::format("a circuit has 1 to 4 junctions, not {}", circuit.size()));
    return circuit;
}

} // namespace

CircuitProblem::CircuitProblem(hydraulics::Circuit circuit, hydraulics::FlowConstants flow, std::size_t bits,
                               hydraulics::InletFlow form)
    : circuit_(checked(std::move(circuit))), flow_(flow), coding_(circuit_.size(), {0, largest_in3_per_psi, bits}),
      form_(form) {}

hydraulics::CircuitTerms CircuitProblem::prepared(std::span<const double> sample) const {
    hydraulics::CircuitTerms terms;
    for (std::size_t j = 0; j < circuit_.size(); ++j) {
        auto link = hydraulics::LinkSample::from(sample.subspan(j * hydraulics::LinkSample::channels));
        terms.push_back(hydraulics::terms_of(link, flow_));
    }
    return terms;
}

std::vector<std::string> CircuitProblem::parameter_names() const {
    std::vector<std::string> names;
    for (const hydraulics::Junction& junction : circuit_)
        names.push_back(hydraulics::compliance_name(junction));
    return names;
}

std::vector<std::string> CircuitProblem::parameter_units() const {
    return std::vector<std::string>(circuit_.size(), "in^3/psi");
}

} // namespace placedpar
