#pragma once

#include "gaprocs/recoding.hpp"
#include "gaprocs/search_problem.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace placedpar {

/// Adapts a problem to a search whose strings differ from the strings that the problem reads, such as the coarse and
/// the fine search of a pair. The bred strings may have fewer bits, or may be relative to a bias point, a string that
/// moves from generation to generation.
class RecodedProblem final : public AdaptedProblem {
public:
    /// Makes `problem` read its strings in natural binary. Throws what Recoding::validate() and SearchProblem::coded()
    /// throw. Throws UserError if the problem's strings are not binary, if Recoding::problem_bits do not add up to
    /// their length, or if the problem's own fields differ from Recoding::problem_bits.
    RecodedProblem(const SearchProblem& problem, Recoding recoding);

    /// Sets the bias point, Recoding::around. REQUIRES: the problem can read the string `around`.
    void move_to(Genome around) { recoding_.around = std::move(around); }
    /// Converts a bred string to the string that the problem reads.
    Genome to_problem(const Genome& bred) const { return recoding_.to_problem(bred); }

    std::size_t bits() const override { return recoding_.length(); }
    Representation representation() const override { return BitString(bits()); }
    void fitness_of(std::span<const Genome> population, std::span<const Sample> samples, double bias,
                    std::span<double> out) const override {
        problem_->fitness_of(recoding_.to_problem(population), samples, bias, out);
    }
    std::vector<std::size_t> fields() const override { return recoding_.bits; }
    Coding coding() const override { return recoding_.coding; }

private:
    std::shared_ptr<const SearchProblem> coded_plainly(Coding) const override;
    Genome read(const Genome& bred) const override { return to_problem(bred); }

    Recoding recoding_;
};

} // namespace placedpar
