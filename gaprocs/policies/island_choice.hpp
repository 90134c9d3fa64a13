#pragma once

#include "gaprocs/policies/error_matrix.hpp"
#include "gaprocs/policies/policy.hpp"

#include <cstddef>
#include <functional>
#include <string_view>
#include <tuple>

namespace placedpar {

class RandomStream;

// In active error analysis (thesis 5.3.2), islands evaluate individuals over windows of different lengths. w_i is the
// window of island i, its newest samples, and A_j the best individual of island j. Each policy below is one way to
// choose the island whose best individual is the answer. Most policies compare the ratios Sw_i / SA_i (eq. 5.7), and
// choose the first island among equals. Sw_i is the sum of row i of an ErrorMatrix, SA_i the sum of column i. Row i and
// column j of this matrix hold Error(w_i, A_j) / Error(w_j, A_j). REQUIRES of every policy: at least one island, and
// the requirements of ErrorMatrix.
//
// The rule of the thesis, "choose the island with the greatest ratio", cannot do what the thesis says. Windows are
// nested: the ten newest samples are among the thirty newest. So with squared errors, Error(w_i, A_j) never decreases
// when w_i grows. If w_1 >= w_2 >= ... >= w_n, and no error is 0:
//   each term of Sw_i falls with i:   Sw_1 >= Sw_2 >= ... >= Sw_n, which always contradicts eq. 5.5;
//   terms are at least 1 in row 1 and column n, at most 1 in row n and column 1:  SA_1 <= n <= SA_n, Sw_n <= n <= Sw_1;
//   hence Sw_1 / SA_1 >= 1 >= Sw_n / SA_n: the shortest window is never preferred to the longest.
// The proof does not hold for a problem whose errors come from a simulation that starts at the beginning of each
// window.

/// Chooses the island with the greatest Sw_i / SA_i, exactly as eq. 5.3, 5.4 and 5.7 are printed, with the squared
/// errors of eq. 5.1.
struct PrintedChoice {
    static constexpr std::string_view
        name = "printed",
        about = "greatest ratio Sw/SA (eq. 5.7) as printed, with squared errors; nearly always chooses the longest "
                "window, and never prefers the shortest window to the longest if errors do not depend on the window",
        source = "thesis eq. 5.1 and 5.3 to 5.7";
    std::size_t operator()(const ErrorsOfBest& bests, RandomStream&) const;
};

/// Chooses as PrintedChoice does, but with the sums of eq. 5.2, in which errors of opposite signs cancel.
struct PlainSumChoice {
    static constexpr std::string_view name = "plain",
                                      about = "greatest ratio Sw/SA, with errors summed with their signs",
                                      source = "thesis eq. 5.2 to 5.7, to the letter";
    std::size_t operator()(const ErrorsOfBest& bests, RandomStream&) const;
};

/// Chooses as PrintedChoice does, but with mean squared errors instead of sums. So a window does not have a greater
/// error just because it is longer.
struct MeansChoice {
    static constexpr std::string_view name = "means",
                                      about = "greatest ratio Sw/SA, with means of squared errors instead of sums",
                                      source = "an interpretation of thesis eq. 5.3 and 5.4";
    std::size_t operator()(const ErrorsOfBest& bests, RandomStream&) const;
};

/// Chooses as PrintedChoice does, but divides Error(w_i, A_j) by Error(w_i, A_i) instead of Error(w_j, A_j). So each
/// term of Sw_i compares the best individual of one island with the best individual of island i, in the same window.
/// Sums and means of squared errors give the same choice.
struct RowChoice {
    static constexpr std::string_view name = "row",
                                      about = "greatest ratio Sw/SA, with each error divided by the error of the row's "
                                              "own island; sums and means give the same choice",
                                      source = "an interpretation of thesis eq. 5.3 and 5.4";
    std::size_t operator()(const ErrorsOfBest& bests, RandomStream&) const;
};

/// Always chooses `island`; islands are numbered from 0.
struct FixedChoice {
    static constexpr std::string_view name = "fixed", about = "always the same island, counted from 0",
                                      source = "a control for comparisons, not in the thesis";
    std::size_t island = 0;
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"island", &FixedChoice::island, 0, 1e6, "from 0"});
    }
    /// Returns `island`. Throws what IslandChoice::validate_for() throws.
    std::size_t operator()(const ErrorsOfBest& bests, RandomStream&) const;
};

/// Chooses an island at random: a baseline for the other policies. Draws one random number.
struct RandomChoice {
    static constexpr std::string_view name = "random", about = "an island drawn at random each time",
                                      source = "a control for comparisons, not in the thesis";
    std::size_t operator()(const ErrorsOfBest& bests, RandomStream& random) const;
};

/// A user-defined struct with the same call operator as the policies above. The returned island is checked.
class OwnChoice : public OwnPolicy {
public:
    template <class Policy>
    explicit OwnChoice(Policy policy) : OwnPolicy(policy), choose_(std::move(policy)) {}
    std::size_t operator()(const ErrorsOfBest& bests, RandomStream& random) const;

private:
    std::function<std::size_t(const ErrorsOfBest&, RandomStream&)> choose_;
};

/// The policy that chooses the island whose best individual is the answer of all islands.
class IslandChoice : public OneOf<IslandChoice, PrintedChoice, PlainSumChoice, MeansChoice, RowChoice, FixedChoice,
                                  RandomChoice, OwnChoice> {
public:
    using OneOf::OneOf;
    static constexpr std::string_view
        noun = "choice",
        about = "which island's best individual is the answer, among islands with windows of different lengths";

    /// Throws UserError if the policy is FixedChoice and its island does not exist.
    void validate_for(std::size_t islands) const;
    std::size_t operator()(const ErrorsOfBest& bests, RandomStream& random) const;
};

} // namespace placedpar
