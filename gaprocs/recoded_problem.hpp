#pragma once

#include "gaprocs/recoding.hpp"
#include "gaprocs/search_problem.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace placedpar {

/// Adapts a problem to a search that breeds other strings than the problem reads: strings with fewer bits, or relative
/// to a bias point that moves.
class RecodedProblem final : public SearchProblem {
public:
    /// Uses `problem` in natural binary. Throws as Recoding::validate() and SearchProblem::coded(). Throws UserError if
    /// the problem's strings are not binary, if Recoding::problem_bits do not add up to their length, or if the problem
    /// states other fields.
    RecodedProblem(const SearchProblem& problem, Recoding recoding);

    /// Sets the bias point, Recoding::around. REQUIRES: `around` is a string of the problem.
    void move_to(Genome around) { recoding_.around = std::move(around); }
    /// Returns the problem's string for a bred string.
    Genome to_problem(const Genome& bred) const { return recoding_.to_problem(bred); }

    std::size_t bits() const override { return recoding_.length(); }
    std::size_t channels() const override { return problem_->channels(); }
    std::optional<Objective> objective() const override { return problem_->objective(); }
    std::vector<std::string> objective_names() const override { return problem_->objective_names(); }
    std::optional<Merit> merit(const Genome& genome) const override { return problem_->merit(to_problem(genome)); }
    bool has_constraints() const override { return problem_->has_constraints(); }
    double error(const Genome& genome, std::span<const double> sample) const override {
        return problem_->error(to_problem(genome), sample);
    }
    bool depends_on_window() const override { return problem_->depends_on_window(); }
    std::vector<double> errors(const Genome& genome, std::span<const Sample> window) const override {
        return problem_->errors(to_problem(genome), window);
    }
    double fitness(const Genome& genome, std::span<const Sample> samples, double bias) const override {
        return problem_->fitness(to_problem(genome), samples, bias);
    }
    void fitness_of(std::span<const Genome> population, std::span<const Sample> samples, double bias,
                    std::span<double> out) const override {
        problem_->fitness_of(recoding_.to_problem(population), samples, bias, out);
    }
    std::vector<double> decode(const Genome& genome) const override { return problem_->decode(to_problem(genome)); }
    std::vector<std::string> parameter_names() const override { return problem_->parameter_names(); }
    std::vector<std::string> parameter_units() const override { return problem_->parameter_units(); }
    std::vector<double> true_parameters() const override { return problem_->true_parameters(); }
    std::vector<std::size_t> fields() const override { return recoding_.bits; }
    Coding coding() const override { return recoding_.coding; }

private:
    std::shared_ptr<const SearchProblem> coded_plainly(Coding) const override;

    std::shared_ptr<const SearchProblem> problem_; ///< the problem in natural binary
    Recoding recoding_;
};

} // namespace placedpar
