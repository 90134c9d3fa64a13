#pragma once

#include "gaprocs/policies/policy.hpp"
#include "gaprocs/representation/parameter_coding.hpp"
#include "gaprocs/search_problem.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace placedpar {

/// How the fitness counts the prediction error e at a sample, for a constant B (the bias): B - e, as printed in thesis
/// eq. 1.7; B - |e|; or B - e^2, as in eq. 4.1 and 5.1. The fitness is the sum over all samples.
enum class FitnessForm : unsigned char { as_printed, absolute, square };

/// The search for the coefficients of the plant of thesis eq. 1.3, which has the input u and the output y,
///
///     y(k) = a1 y(k-1) + a2 y(k-2) + b0 (u(k) + b1 u(k-1)),
///
/// A string is a1 | a2 | b0 | b1, each coefficient in 10 bits, between -5 and 5 (eq. 1.4 to 1.6). The input acts one
/// sample later than in eq. 1.3, as in chapter 5. The objective is the sum of the fitness terms over `window`, or 0 if
/// the sum is negative.
struct CoefficientsProblem {
    std::vector<Sample> window; ///< measured outputs and inputs, as plant_record() returns them
    FitnessForm form;
    double bias;

    ParameterCoding representation() const;
    std::vector<std::string> parameter_names() const { return {"a1", "a2", "b0", "b1"}; }
    double objective(std::span<const double> coefficients) const;
};

/// Makes the CoefficientsProblem that a netlist names with its numbers: "coefficients", "coefficients(form = 0, noise =
/// 0.3)".
struct Coefficients {
    static constexpr std::string_view name = "coefficients",
                                      about = "the coefficients of a second-order plant (thesis 1.3, 1.4)";
    std::size_t form = 2, samples = 30, record = 1;
    double bias = 10, noise = 0;

    static constexpr auto numbers() {
        return std::tuple(
            PolicyNumber{
                "form", &Coefficients::form, 0, 2,
                "term of the fitness for an error e: 0: B - e, as printed in equation 1.7; 1: B - |e|; 2: B - e^2"},
            PolicyNumber{"bias", &Coefficients::bias, 0, 1e6, "B of the fitness"},
            PolicyNumber{"samples", &Coefficients::samples, 1, 1000, "length of the window"},
            PolicyNumber{"noise", &Coefficients::noise, 0, 1e3, "standard deviation of the white noise (5.8)"},
            PolicyNumber{"record", &Coefficients::record, 1, 1e6,
                         "number of the record; each record has its own input and noise"});
    }
    CoefficientsProblem problem() const;
};

} // namespace placedpar
