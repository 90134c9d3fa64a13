#include "gaprocs/guarded_problem.hpp"

#include "gaprocs/policies/policy.hpp"

#include <fmt/format.h>

#include <utility>

namespace placedpar {

namespace {

std::string called_problem(const std::string& name) { return fmt::format("the search problem \"{}\"", name); }

class GuardedProblem final : public SearchProblem {
public:
    GuardedProblem(std::string name, std::shared_ptr<const SearchProblem> problem)
        : name_(std::move(name)), problem_(std::move(problem)) {}

    std::size_t bits() const override { return ask(&SearchProblem::bits); }
    Representation representation() const override { return ask(&SearchProblem::representation); }
    std::size_t channels() const override { return ask(&SearchProblem::channels); }
    std::optional<Objective> objective() const override { return ask(&SearchProblem::objective); }
    std::vector<std::string> objective_names() const override { return ask(&SearchProblem::objective_names); }
    std::optional<Merit> merit(const Genome& genome) const override { return ask(&SearchProblem::merit, genome); }
    bool has_constraints() const override { return ask(&SearchProblem::has_constraints); }
    bool depends_on_window() const override { return ask(&SearchProblem::depends_on_window); }
    std::vector<double> errors(const Genome& genome, std::span<const Sample> window) const override {
        return ask(&SearchProblem::errors, genome, window);
    }
    double error(const Genome& genome, std::span<const double> sample) const override {
        return ask(&SearchProblem::error, genome, sample);
    }
    double fitness(const Genome& genome, std::span<const Sample> samples, double bias) const override {
        return ask(&SearchProblem::fitness, genome, samples, bias);
    }
    void fitness_of(std::span<const Genome> population, std::span<const Sample> samples, double bias,
                    std::span<double> out) const override {
        ask(&SearchProblem::fitness_of, population, samples, bias, out);
    }
    std::vector<double> decode(const Genome& genome) const override { return ask(&SearchProblem::decode, genome); }
    std::vector<std::string> parameter_names() const override { return ask(&SearchProblem::parameter_names); }
    std::vector<std::string> parameter_units() const override { return ask(&SearchProblem::parameter_units); }
    std::vector<double> true_parameters() const override { return ask(&SearchProblem::true_parameters); }
    std::vector<std::size_t> fields() const override { return ask(&SearchProblem::fields); }
    Coding coding() const override { return ask(&SearchProblem::coding); }

private:
    std::shared_ptr<const SearchProblem> coded_plainly(Coding coding) const override {
        return std::make_shared<GuardedProblem>(name_, ask(&SearchProblem::coded, coding));
    }
    template <class Answer, class... Asked>
    Answer ask(Answer (SearchProblem::*question)(Asked...) const, const auto&... asked) const {
        return tried([&] { return called_problem(name_); }, [&] { return (*problem_.*question)(asked...); });
    }

    std::string name_;
    std::shared_ptr<const SearchProblem> problem_;
};

} // namespace

ProblemFamily guarded(const ProblemFamily& family) {
    ProblemFamily result = family;
    auto name = [described = family.description](const auto& numbers) { return described.text(numbers); };
    result.make = [make = family.make, name](const std::vector<double>& numbers) {
        auto problem = tried([&] { return called_problem(name(numbers)); }, [&] { return make(numbers); });
        return std::make_shared<GuardedProblem>(name(numbers), std::move(problem));
    };
    if (family.record)
        result.record = [record = family.record, name](const std::vector<double>& numbers) {
            auto whose = [named = called_problem(name(numbers))] { return named; };
            RecordToMake made = tried(whose, [&] { return record(numbers); });
            if (made.make)
                made.make = [whose, make = made.make] { return tried(whose, make); };
            return made;
        };
    return result;
}

} // namespace placedpar
