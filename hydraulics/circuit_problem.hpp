#pragma once

#include "hydraulics/circuit_error.hpp"
#include "hydraulics/parameter_coding.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

/// Identification of the pump-side compliances of all links of a circuit at once (thesis 3.1 and 3.2), as a
/// search problem. The string is one whole number of `bits` bits for each junction, in the circuit's order, over
/// 0 ... largest. A sample is the LinkSamples of the junctions, end to end.
class CircuitProblem {
public:
    /// Thesis 3.1.1: 0.1 > C > 0.0.
    static constexpr double largest_in3_per_psi = 0.1;

    /// Throws std::invalid_argument unless 1 <= bits <= 32 and the circuit has 1 to 4 junctions.
    CircuitProblem(Circuit circuit, FlowConstants flow, std::size_t bits = 10)
        : CircuitProblem(circuit, flow, bits, printed_inlet_flow(circuit.size())) {}
    CircuitProblem(Circuit circuit, FlowConstants flow, std::size_t bits, InletFlow form);

    std::size_t bits() const { return coding_.bits(); }
    std::size_t channels() const { return circuit_.size() * LinkSample::channels; }
    const Circuit& circuit() const { return circuit_; }
    InletFlow inlet_flow() const { return form_; }
    std::size_t bits_per_compliance() const { return coding_.field(0).bits; }
    /// From one code to the next.
    double resolution_in3_per_psi() const { return coding_.field(0).resolution(); }

    double compliance_in3_per_psi(std::uint64_t code) const { return coding_.field(0).value(code); }
    std::size_t parameters() const { return circuit_.size(); }
    template <BinaryString G>
    double parameter(const G& genome, std::size_t junction) const {
        return coding_.value(genome, junction);
    }
    template <BinaryString G>
    std::vector<double> decode(const G& genome) const {
        return coding_.decode(genome);
    }

    /// The error of one set of compliances, or of each of arrays of them; one entry for each junction.
    template <typename T>
    T error_of(std::span<const T> compliances, std::span<const double> sample) const {
        std::array<LinkSample, all_links.size()> links{};
        for (std::size_t j = 0; j < circuit_.size(); ++j)
            links[j] = LinkSample::from(sample.subspan(j * LinkSample::channels));
        return circuit_error_in3_per_s<T>(circuit_, compliances, links, flow_, form_);
    }
    template <BinaryString G>
    double error(const G& genome, std::span<const double> sample) const {
        std::array<double, all_links.size()> compliances{};
        for (std::size_t j = 0; j < circuit_.size(); ++j)
            compliances[j] = coding_.value(genome, j);
        return error_of<double>(compliances, sample);
    }

    /// "C_BUi", ... in the circuit's order.
    std::vector<std::string> parameter_names() const;
    std::vector<std::string> parameter_units() const;

private:
    Circuit circuit_;
    FlowConstants flow_;
    ParameterCoding coding_;
    InletFlow form_;
};

} // namespace placedpar
