#pragma once

#include "gaprocs/fitness.hpp"
#include "gaprocs/objective.hpp"
#include "gaprocs/policies/coding.hpp"
#include "gaprocs/population_fitness.hpp"
#include "gaprocs/representation/coding.hpp"
#include "gaprocs/representation/genome.hpp"
#include "gaprocs/representation/representation.hpp"

#include <concepts>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

/// The numbers measured at one time, in the order that the problem defines. Samples in the order of time form a record.
using Sample = std::vector<double>;

/// The functions that a search needs of a problem with measurements. A search looks for the parameters with the least
/// error. A plain struct can have them without including this header. A problem works with natural binary and Gray code
/// if its functions are templates in the type of the genome (the string of bits). They must read the genome by
/// field(first, count). A problem may also have `coding()`, the ParameterCoding of the string; `true_parameters()`, the
/// parameters from which a simulated record was made; and the members of ErrorOfParameters
/// (gaprocs/population_fitness.hpp), which make the evaluation of a population faster.
template <typename P, typename G = Genome>
concept Searchable = requires(const P& problem, const G& genome, std::span<const double> sample) {
    { problem.bits() } -> std::convertible_to<std::size_t>;
    { problem.channels() } -> std::convertible_to<std::size_t>;
    { problem.error(genome, sample) } -> std::convertible_to<double>;
    { problem.decode(genome) } -> std::convertible_to<std::vector<double>>;
    { problem.parameter_names() } -> std::convertible_to<std::vector<std::string>>;
    { problem.parameter_units() } -> std::convertible_to<std::vector<std::string>>;
};

/// The base class of all problems, which processes find by name in a ProblemRegistry. A problem rates an individual by
/// its errors at samples of measurements, or by an objective, a number without measurements. A SearchProblem is
/// immutable, so several processes may share it.
class SearchProblem {
public:
    virtual ~SearchProblem() = default;

    /// Returns the length of the string in bits.
    virtual std::size_t bits() const = 0;
    virtual Representation representation() const { return BitString(bits()); }
    /// Returns how many numbers a sample has; 0 for a problem with an objective().
    virtual std::size_t channels() const = 0;
    /// Returns the objective of a problem that needs no measurements; nothing for a problem with measurements. If there
    /// is an objective, fitness() ignores the samples and the bias.
    virtual std::optional<Objective> objective() const { return std::nullopt; }
    /// Returns the names of the objectives if there are several; empty otherwise. A problem with several objectives has
    /// no fitness: it needs search_front() (gaprocs/front_search.hpp).
    virtual std::vector<std::string> objective_names() const { return {}; }
    /// Returns the costs of an individual, all to be minimised, and its violation of the constraints; nothing for a
    /// problem with measurements. An individual with a cost that is not a finite number is infeasible.
    virtual std::optional<Merit> merit(const Genome&) const { return std::nullopt; }
    /// Returns merit() of each individual. A problem may evaluate a whole population at once. REQUIRES: objective()
    /// returns an objective.
    virtual std::vector<Merit> merits(std::span<const Genome> population) const;
    virtual bool has_constraints() const { return false; }
    /// Returns whether the error at a sample depends on the first sample of the window (the samples of an evaluation),
    /// as in a simulation that starts there. If it does, the errors of one individual cannot be divided among
    /// processes.
    virtual bool depends_on_window() const { return false; }
    /// Returns the errors of one individual at the samples of a window, oldest first. REQUIRES: what error() requires,
    /// for each sample.
    virtual std::vector<double> errors(const Genome& genome, std::span<const Sample> window) const;
    /// Returns the error of one individual at one sample (eq. 3.8). If depends_on_window(), the sample counts as the
    /// first of a window. REQUIRES: a string of bits() bits and a sample of channels() numbers; the problem has no
    /// objective().
    virtual double error(const Genome& genome, std::span<const double> sample) const = 0;
    /// Returns the fitness of one individual: the sum of fitness_term() (`bias` - error^2) over the samples, or the
    /// fitness of the objective().
    virtual double fitness(const Genome& genome, std::span<const Sample> samples, double bias) const = 0;
    /// Sets out[i] to fitness() of individual i, bit for bit. REQUIRES: out.size() == population.size().
    virtual void fitness_of(std::span<const Genome> population, std::span<const Sample> samples, double bias,
                            std::span<double> out) const = 0;
    /// These functions return the parameters that the string codes, their names, and their units.
    virtual std::vector<double> decode(const Genome& genome) const = 0;
    virtual std::vector<std::string> parameter_names() const = 0;
    virtual std::vector<std::string> parameter_units() const = 0;
    /// Returns the true values of the parameters; empty if they are unknown.
    virtual std::vector<double> true_parameters() const { return {}; }

    /// Returns the number of bits of each field (the bits of one parameter) of the string, without unused bits between
    /// them. Empty if the problem does not state its fields.
    virtual std::vector<std::size_t> fields() const { return {}; }
    virtual Coding coding() const = 0;
    /// Returns the problem with its strings in another coding. Throws UserError if the problem cannot have this coding.
    std::shared_ptr<const SearchProblem> coded(Coding) const;

private:
    /// Does what coded() does, for a coding without unused bits.
    virtual std::shared_ptr<const SearchProblem> coded_plainly(Coding) const = 0;
};

/// Base class of problems that wrap another problem: they change some of its results, and pass on the other results.
class AdaptedProblem : public SearchProblem {
public:
    explicit AdaptedProblem(std::shared_ptr<const SearchProblem> problem) : problem_(std::move(problem)) {}

    std::size_t bits() const override { return problem_->bits(); }
    Representation representation() const override { return problem_->representation(); }
    std::size_t channels() const override { return problem_->channels(); }
    std::optional<Objective> objective() const override { return problem_->objective(); }
    std::vector<std::string> objective_names() const override { return problem_->objective_names(); }
    std::optional<Merit> merit(const Genome& genome) const override { return problem_->merit(read(genome)); }
    bool has_constraints() const override { return problem_->has_constraints(); }
    bool depends_on_window() const override { return problem_->depends_on_window(); }
    std::vector<double> errors(const Genome& genome, std::span<const Sample> window) const override {
        return problem_->errors(read(genome), window);
    }
    double error(const Genome& genome, std::span<const double> sample) const override {
        return problem_->error(read(genome), sample);
    }
    double fitness(const Genome& genome, std::span<const Sample> samples, double bias) const override {
        return problem_->fitness(read(genome), samples, bias);
    }
    void fitness_of(std::span<const Genome> population, std::span<const Sample> samples, double bias,
                    std::span<double> out) const override {
        std::vector<Genome> strings;
        for (const Genome& each : population)
            strings.push_back(read(each));
        problem_->fitness_of(strings, samples, bias, out);
    }
    std::vector<double> decode(const Genome& genome) const override { return problem_->decode(read(genome)); }
    std::vector<std::string> parameter_names() const override { return problem_->parameter_names(); }
    std::vector<std::string> parameter_units() const override { return problem_->parameter_units(); }
    std::vector<double> true_parameters() const override { return problem_->true_parameters(); }
    std::vector<std::size_t> fields() const override { return problem_->fields(); }
    Coding coding() const override { return problem_->coding(); }

protected:
    /// Converts a string of this problem to a string of the wrapped problem.
    virtual Genome read(const Genome& genome) const { return genome; }

    std::shared_ptr<const SearchProblem> problem_;
};

/// Throws the UserError of coded() for a coding that a problem cannot have.
[[noreturn]] void refuse_coding(Coding);

/// Makes a SearchProblem of a plain struct.
template <Searchable P, bool gray = false>
class SearchProblemOf final : public SearchProblem {
public:
    explicit SearchProblemOf(P problem) : problem_(std::move(problem)) {}

    std::size_t bits() const override { return problem_.bits(); }
    std::size_t channels() const override { return problem_.channels(); }
    double error(const Genome& genome, std::span<const double> sample) const override {
        return problem_.error(as_coded(genome), sample);
    }
    bool depends_on_window() const override { return ErrorAlongWindow<P>; }
    std::vector<double> errors(const Genome& genome, std::span<const Sample> window) const override {
        std::vector<double> errors;
        each_error(genome, window, [&](double error) { errors.push_back(error); });
        return errors;
    }
    double fitness(const Genome& genome, std::span<const Sample> samples, double bias) const override {
        double sum = 0;
        each_error(genome, samples, [&](double error) { sum += fitness_term(bias, error); });
        return sum;
    }
    void fitness_of(std::span<const Genome> population, std::span<const Sample> samples, double bias,
                    std::span<double> out) const override {
        if constexpr (ErrorOfParameters<P, StringRead<gray>>)
            fitness_in_lanes<gray>(problem_, population, samples, bias, out);
        else
            for (std::size_t i = 0; i < population.size(); ++i)
                out[i] = fitness(population[i], samples, bias);
    }
    std::vector<double> decode(const Genome& genome) const override { return problem_.decode(as_coded(genome)); }
    std::vector<std::string> parameter_names() const override { return problem_.parameter_names(); }
    std::vector<std::string> parameter_units() const override { return problem_.parameter_units(); }
    std::vector<double> true_parameters() const override {
        if constexpr (requires {
                          { problem_.true_parameters() } -> std::convertible_to<std::vector<double>>;
                      })
            return problem_.true_parameters();
        else
            return {};
    }

    std::vector<std::size_t> fields() const override {
        if constexpr (requires { problem_.coding().fields(); })
            return problem_.coding().fields();
        else
            return {};
    }
    Coding coding() const override { return gray ? Coding::gray : Coding::natural; }

private:
    std::shared_ptr<const SearchProblem> coded_plainly(Coding coding) const override {
        if (coding == Coding::natural)
            return std::make_shared<SearchProblemOf<P, false>>(problem_);
        if constexpr (Searchable<P, GrayCoded<Genome>>)
            if (coding == Coding::gray)
                return std::make_shared<SearchProblemOf<P, true>>(problem_);
        refuse_coding(coding);
    }

    template <class Take>
    void each_error(const Genome& genome, std::span<const Sample> window, Take take) const {
        if constexpr (ErrorAlongWindow<P>) {
            const auto parameters = problem_.parameters_of(as_coded(genome));
            auto error = problem_.template errors_along<double>(std::span(parameters.data(), parameters.size()));
            for (const Sample& sample : window)
                take(error(std::span<const double>(sample)));
        } else {
            for (const Sample& sample : window)
                take(problem_.error(as_coded(genome), std::span<const double>(sample)));
        }
    }

    static StringRead<gray> as_coded(const Genome& genome) { return StringRead<gray>(genome); }

    P problem_;
};

template <Searchable P>
std::shared_ptr<const SearchProblem> make_search_problem(P problem, Coding coding = Coding::natural) {
    SearchProblemOf<P> natural(std::move(problem));
    return natural.coded(coding);
}

} // namespace placedpar
