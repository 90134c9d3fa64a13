#include "gaprocs/search_problem.hpp"

#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace placedpar {

namespace {

/// A problem whose strings have don't-care bits between every two neighbouring bits of the original string.
class StuffedProblem final : public SearchProblem {
public:
    /// REQUIRES: the strings of `plain` are binary.
    StuffedProblem(std::shared_ptr<const SearchProblem> plain, Coding coding)
        : plain_(std::move(plain)), coding_(coding) {}

    std::size_t bits() const override { return stuffed_bits(plain_->bits(), coding_.dont_care()); }
    std::size_t channels() const override { return plain_->channels(); }
    std::optional<Objective> objective() const override { return plain_->objective(); }
    std::vector<std::string> objective_names() const override { return plain_->objective_names(); }
    std::optional<Merit> merit(const Genome& genome) const override { return plain_->merit(read(genome)); }
    bool has_constraints() const override { return plain_->has_constraints(); }
    double error(const Genome& genome, std::span<const double> sample) const override {
        return plain_->error(read(genome), sample);
    }
    bool depends_on_window() const override { return plain_->depends_on_window(); }
    std::vector<double> errors(const Genome& genome, std::span<const Sample> window) const override {
        return plain_->errors(read(genome), window);
    }
    double fitness(const Genome& genome, std::span<const Sample> samples, double bias) const override {
        return plain_->fitness(read(genome), samples, bias);
    }
    void fitness_of(std::span<const Genome> population, std::span<const Sample> samples, double bias,
                    std::span<double> out) const override {
        std::vector<Genome> strings;
        std::ranges::transform(population, std::back_inserter(strings), [&](const Genome& each) { return read(each); });
        plain_->fitness_of(strings, samples, bias, out);
    }
    std::vector<double> decode(const Genome& genome) const override { return plain_->decode(read(genome)); }
    std::vector<std::string> parameter_names() const override { return plain_->parameter_names(); }
    std::vector<std::string> parameter_units() const override { return plain_->parameter_units(); }
    std::vector<double> true_parameters() const override { return plain_->true_parameters(); }
    std::vector<std::size_t> fields() const override { return plain_->fields(); }
    Coding coding() const override { return coding_; }

private:
    std::shared_ptr<const SearchProblem> coded_plainly(Coding coding) const override { return plain_->coded(coding); }
    Genome read(const Genome& genome) const { return unstuffed(genome, coding_.dont_care()); }

    std::shared_ptr<const SearchProblem> plain_;
    Coding coding_;
};

} // namespace

std::vector<double> SearchProblem::errors(const Genome& genome, std::span<const Sample> window) const {
    std::vector<double> errors;
    for (const Sample& sample : window)
        errors.push_back(error(genome, sample));
    return errors;
}

std::vector<Merit> SearchProblem::merits(std::span<const Genome> population) const {
    std::vector<Merit> merits;
    for (const Genome& each : population)
        merits.push_back(merit(each).value());
    return merits;
}

std::shared_ptr<const SearchProblem> SearchProblem::coded(Coding coding) const {
    auto plain = coded_plainly(coding.plain());
    if (coding.dont_care() == 0)
        return plain;
    if (plain->representation().kind() != StringKind::binary)
        throw UserError(fmt::format("don't-care bits need binary strings, but this problem's strings are {}",
                                    name_of(plain->representation().kind())));
    return std::make_shared<StuffedProblem>(std::move(plain), coding);
}

void refuse_coding(Coding coding) {
    if (coding == Coding::real)
        throw UserError("the coding \"real\" has no meaning for this problem, which has no real numbers to breed");
    throw UserError(fmt::format(
        "the coding \"{}\" has no meaning for this problem, which does not divide its binary string into fields",
        coding.text()));
}

} // namespace placedpar
