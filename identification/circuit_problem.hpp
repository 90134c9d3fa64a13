#pragma once

#include "gaprocs/representation/parameter_coding.hpp"
#include "hydraulics/circuit/circuit_error.hpp"

#include <boost/container/static_vector.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace placedpar {

/// The problem that a genetic algorithm solves to find all compliances of a circuit together (thesis 3.1 and 3.2). A
/// circuit is the part of the main valve through which links share oil, with one junction per link. The string codes
/// one compliance for each junction, in the circuit's order. A compliance has `bits` bits for a value from 0 to 0.1
/// in^3/psi. A sample has the measured values of all junctions (LinkSample), one junction after the other.
class CircuitProblem {
public:
    /// The upper end of the searched range; thesis 3.1.1: 0.1 > C > 0.0.
    static constexpr double largest_in3_per_psi = 0.1;
    /// The number of bits for one compliance; thesis 3.2 has 20 bits for two compliances.
    static constexpr std::size_t usual_bits = 10;

    /// One compliance per junction, in in^3/psi.
    template <typename T>
    using CompliancesOf = boost::container::static_vector<T, hydraulics::all_links.size()>;
    using Compliances = CompliancesOf<double>;

    /// Throws std::invalid_argument if the circuit has no junction or more than 4. Also throws what ParameterCoding
    /// throws.
    CircuitProblem(hydraulics::Circuit circuit, hydraulics::FlowConstants flow, std::size_t bits = usual_bits)
        : CircuitProblem(circuit, flow, bits, hydraulics::printed_inlet_flow(circuit.size())) {}
    CircuitProblem(hydraulics::Circuit circuit, hydraulics::FlowConstants flow, std::size_t bits,
                   hydraulics::InletFlow form);

    std::size_t bits() const { return coding_.bits(); }
    std::size_t channels() const { return circuit_.size() * hydraulics::LinkSample::channels; }
    const hydraulics::Circuit& circuit() const { return circuit_; }
    hydraulics::InletFlow inlet_flow() const { return form_; }
    const ParameterCoding& coding() const { return coding_; }
    /// Returns the range and bits of the first junction's compliance in the string. All junctions have the same range
    /// and bits.
    const ParameterField& field() const { return coding_.field(0); }

    template <BinaryString G>
    Compliances parameters_of(const G& genome) const {
        return compliances_of<double>(genome);
    }
    template <std::size_t width, bool gray>
    CompliancesOf<Lanes<width>> parameters_of_several(const StringsInLanes<width, gray>& strings) const {
        return compliances_of<Lanes<width>>(strings);
    }
    /// Returns the terms of the equations that depend only on the sample. A search computes them once for all strings.
    hydraulics::CircuitTerms prepared(std::span<const double> sample) const;
    /// Returns the error of the flow balances with these compliances. If T is `Lanes`, a class of several doubles,
    /// returns the errors of several strings at once.
    template <typename T>
    T error_of(std::span<const T> compliances, const hydraulics::CircuitTerms& prepared) const {
        return hydraulics::circuit_error_in3_per_s<T>(circuit_, compliances, prepared, flow_, form_);
    }
    template <typename T>
    T error_of(std::span<const T> compliances, std::span<const double> sample) const {
        return error_of(compliances, prepared(sample));
    }

    template <BinaryString G>
    std::vector<double> decode(const G& genome) const {
        return coding_.decode(genome);
    }
    template <BinaryString G>
    double error(const G& genome, std::span<const double> sample) const {
        Compliances compliances = parameters_of(genome);
        return error_of<double>(std::span(compliances.data(), compliances.size()), sample);
    }

    /// Returns "C_BUi" and so on, in the circuit's order.
    std::vector<std::string> parameter_names() const;
    std::vector<std::string> parameter_units() const;

private:
    template <typename T, typename Strings>
    CompliancesOf<T> compliances_of(const Strings& strings) const {
        CompliancesOf<T> compliances;
        for (std::size_t j = 0; j < circuit_.size(); ++j)
            compliances.push_back(coding_.value(strings, j));
        return compliances;
    }

    hydraulics::Circuit circuit_;
    hydraulics::FlowConstants flow_;
    ParameterCoding coding_;
    hydraulics::InletFlow form_;
};

} // namespace placedpar
