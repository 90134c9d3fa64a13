#include "gaprocs/guarded_problem.hpp"

#include "runtime/user_code.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <utility>

namespace placedpar {

namespace {

template <class Work>
auto tried(const std::string& name, Work work) {
    try {
        return work();
    } catch (...) {
        throw UserError(fmt::format("the search problem \"{}\": {}", name, what_was_thrown()));
    }
}

class GuardedProblem final : public SearchProblem {
public:
    GuardedProblem(std::string name, std::shared_ptr<const SearchProblem> problem)
        : name_(std::move(name)), problem_(std::move(problem)) {}

    std::size_t bits() const override { return problem_->bits(); }
    Representation representation() const override { return problem_->representation(); }
    std::size_t channels() const override { return problem_->channels(); }
    std::optional<Objective> objective() const override { return problem_->objective(); }
    bool depends_on_window() const override { return problem_->depends_on_window(); }
    std::vector<double> errors(const Genome& genome, std::span<const Sample> window) const override {
        return tried(name_, [&] { return problem_->errors(genome, window); });
    }
    double error(const Genome& genome, std::span<const double> sample) const override {
        return tried(name_, [&] { return problem_->error(genome, sample); });
    }
    double fitness(const Genome& genome, std::span<const Sample> samples, double bias) const override {
        return tried(name_, [&] { return problem_->fitness(genome, samples, bias); });
    }
    void fitness_of(std::span<const Genome> population, std::span<const Sample> samples, double bias,
                    std::span<double> out) const override {
        tried(name_, [&] { problem_->fitness_of(population, samples, bias, out); });
    }
    std::vector<double> decode(const Genome& genome) const override {
        return tried(name_, [&] { return problem_->decode(genome); });
    }
    std::vector<std::string> parameter_names() const override { return problem_->parameter_names(); }
    std::vector<std::string> parameter_units() const override { return problem_->parameter_units(); }
    std::vector<double> true_parameters() const override { return problem_->true_parameters(); }
    std::vector<std::size_t> fields() const override { return problem_->fields(); }
    Coding coding() const override { return problem_->coding(); }

private:
    std::shared_ptr<const SearchProblem> coded_plainly(Coding coding) const override {
        return std::make_shared<GuardedProblem>(name_, problem_->coded(coding));
    }

    std::string name_;
    std::shared_ptr<const SearchProblem> problem_;
};

} // namespace

ProblemFamily guarded(const ProblemFamily& family) {
    ProblemFamily result = family;
    result.make = [family](const std::vector<double>& numbers) {
        std::string name = family.description.text(numbers);
        auto problem = tried(name, [&] { return family.make(numbers); });
        return std::make_shared<GuardedProblem>(std::move(name), std::move(problem));
    };
    return result;
}

} // namespace placedpar
