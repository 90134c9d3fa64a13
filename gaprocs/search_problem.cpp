#include "gaprocs/search_problem.hpp"

#include "text/user_error.hpp"

#include <fmt/format.h>

namespace placedpar {

namespace {

/// A problem with longer strings than the original problem: don't-care bits lie between every two neighbouring bits of
/// the original string.
class StuffedProblem final : public AdaptedProblem {
public:
    /// REQUIRES: the strings of `plain` are binary.
    StuffedProblem(std::shared_ptr<const SearchProblem> plain, Coding coding)
        : AdaptedProblem(std::move(plain)), coding_(coding) {}

    std::size_t bits() const override { return stuffed_bits(problem_->bits(), coding_.dont_care()); }
    Representation representation() const override { return BitString(bits()); }
    Coding coding() const override { return coding_; }

private:
    std::shared_ptr<const SearchProblem> coded_plainly(Coding coding) const override { return problem_->coded(coding); }
    Genome read(const Genome& genome) const override { return unstuffed(genome, coding_.dont_care()); }

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
        throw UserError("the coding \"real\" has no meaning for this problem, which has no real numbers to breed; "
                        "choose \"natural\"");
    throw UserError(fmt::format(
        "the coding \"{}\" has no meaning for this problem, which does not divide its binary string into fields; "
        "choose \"natural\"",
        coding.text()));
}

} // namespace placedpar
