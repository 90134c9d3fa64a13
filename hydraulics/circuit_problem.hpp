#pragma once

#include "hydraulics/circuit_error.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

/// Identification of the pump-side compliances of all links of a circuit at once (thesis 3.1 and 3.2), as a
/// search problem. The string is one natural binary number n of `bits` bits for each junction, in the circuit's
/// order; C = largest * n / 2^bits (eq. 1.5). A sample is the LinkSamples of the junctions, end to end.
class CircuitProblem {
public:
    /// Thesis 3.1.1: 0.1 > C > 0.0.
    static constexpr double largest_in3_per_psi = 0.1;

    /// Throws std::invalid_argument unless 1 <= bits <= 32 and the circuit has 1 to 4 junctions.
    CircuitProblem(Circuit circuit, FlowConstants flow, std::size_t bits = 10)
        : CircuitProblem(circuit, flow, bits, printed_inlet_flow(circuit.size())) {}
    CircuitProblem(Circuit circuit, FlowConstants flow, std::size_t bits, InletFlow form);

    std::size_t bits() const { return circuit_.size() * bits_; }
    std::size_t channels() const { return circuit_.size() * LinkSample::channels; }
    const Circuit& circuit() const { return circuit_; }
    InletFlow inlet_flow() const { return form_; }
    std::size_t bits_per_compliance() const { return bits_; }
    /// From one code to the next.
    double resolution_in3_per_psi() const { return compliance_in3_per_psi(1); }

    double compliance_in3_per_psi(std::uint64_t code) const {
        return largest_in3_per_psi * static_cast<double>(code) / static_cast<double>(std::uint64_t{1} << bits_);
    }
    template <typename Genome>
    std::vector<double> decode(const Genome& genome) const {
        std::vector<double> compliances;
        for (std::size_t j = 0; j < circuit_.size(); ++j)
            compliances.push_back(compliance_in3_per_psi(genome.field(j * bits_, bits_)));
        return compliances;
    }
    template <typename Genome>
    double error(const Genome& genome, std::span<const double> sample) const {
        std::array<double, all_links.size()> compliances{};
        std::array<LinkSample, all_links.size()> links{};
        for (std::size_t j = 0; j < circuit_.size(); ++j) {
            compliances[j] = compliance_in3_per_psi(genome.field(j * bits_, bits_));
            links[j] = LinkSample::from(sample.subspan(j * LinkSample::channels));
        }
        return circuit_error_in3_per_s<double>(circuit_, std::span<const double>(compliances), links, flow_, form_);
    }

    /// "C_BUi", ... in the circuit's order.
    std::vector<std::string> parameter_names() const;
    std::vector<std::string> parameter_units() const;

private:
    Circuit circuit_;
    FlowConstants flow_;
    std::size_t bits_;
    InletFlow form_;
};

} // namespace placedpar
