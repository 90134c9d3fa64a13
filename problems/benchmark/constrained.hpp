#pragma once

#include "gaprocs/policies/policy.hpp"
#include "gaprocs/representation/parameter_coding.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <tuple>
#include <vector>

namespace placedpar {

// The first six problems with constraints of Z. Michalewicz and M. Schoenauer ("Evolutionary algorithms for constrained
// parameter optimization problems", 1996), in the form of J. Liang and others ("Problem definitions and evaluation
// criteria for the CEC 2006 special session", 2006): all are minimised, and an equation h(x) = 0 is satisfied if
// |h(x)| <= 0.0001. optimum() is the best known value under this tolerance.

/// A base class of problems whose parameters have the ranges Function::ranges().
template <class Function>
struct WithinRanges {
    std::size_t bits = 30; ///< bits of each parameter
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"bits", &Function::bits, 1, 52, "bits of each parameter"});
    }
    ParameterCoding representation() const {
        std::vector<ParameterField> fields;
        for (const RealRange& range : Function::ranges())
            fields.push_back({range.low, range.high, bits});
        return ParameterCoding(std::move(fields));
    }
};

/// 13 parameters, 9 linear constraints.
struct G01 : WithinRanges<G01> {
    static constexpr std::string_view name = "g01", about = "G01: 13 parameters, 9 linear constraints";
    static std::vector<RealRange> ranges();
    double objective(std::span<const double> x) const;
    std::vector<double> constraints(std::span<const double> x) const;
    double optimum() const { return -15; }
};

/// 20 parameters, two constraints, many local optima.
struct G02 : WithinRanges<G02> {
    static constexpr std::string_view name = "g02", about = "G02: 20 parameters, many local optima, 2 constraints";
    static std::vector<RealRange> ranges();
    double objective(std::span<const double> x) const;
    std::vector<double> constraints(std::span<const double> x) const;
    double optimum() const { return -0.8036191; }
};

/// 10 parameters on a sphere.
struct G03 : WithinRanges<G03> {
    static constexpr std::string_view name = "g03", about = "G03: 10 parameters, which one equation puts on a sphere";
    static std::vector<RealRange> ranges();
    double objective(std::span<const double> x) const;
    std::vector<double> constraints(std::span<const double> x) const;
    double optimum() const { return -1.0005001; }
};

/// 5 parameters, 6 constraints.
struct G04 : WithinRanges<G04> {
    static constexpr std::string_view name = "g04", about = "G04: 5 parameters, 6 constraints";
    static std::vector<RealRange> ranges();
    double objective(std::span<const double> x) const;
    std::vector<double> constraints(std::span<const double> x) const;
    double optimum() const { return -30665.538672; }
};

/// 4 parameters, 2 linear constraints, 3 equations.
struct G05 : WithinRanges<G05> {
    static constexpr std::string_view name = "g05", about = "G05: 4 parameters, 2 constraints and 3 equations";
    static std::vector<RealRange> ranges();
    double objective(std::span<const double> x) const;
    std::vector<double> constraints(std::span<const double> x) const;
    double optimum() const { return 5126.496714; }
};

/// 2 parameters; two circles leave a narrow crescent.
struct G06 : WithinRanges<G06> {
    static constexpr std::string_view name = "g06", about = "G06: 2 parameters in a narrow crescent";
    static std::vector<RealRange> ranges();
    double objective(std::span<const double> x) const;
    std::vector<double> constraints(std::span<const double> x) const;
    double optimum() const { return -6961.813876; }
};

} // namespace placedpar
