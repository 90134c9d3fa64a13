#include "gaprocs/recoded_problem.hpp"

#include "text/user_error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

namespace placedpar {

RecodedProblem::RecodedProblem(const SearchProblem& problem, Recoding recoding)
    : AdaptedProblem(problem.coded(Coding::natural)), recoding_(std::move(recoding)) {
    recoding_.validate();
    if (auto kind = problem_->representation().kind(); kind != StringKind::binary)
        throw UserError(
            fmt::format("only binary strings have fields, but this problem's strings are {}", name_of(kind)));
    if (recoding_.problem_length() != problem_->bits())
        throw UserError(fmt::format("the fields have {} bits in all, but the problem's string has {}",
                                    recoding_.problem_length(), problem_->bits()));
    if (auto fields = problem_->fields(); !fields.empty() && fields != recoding_.problem_bits)
        throw UserError(fmt::format("the fields of this problem have {} bits, but the recoding states {} bits",
                                    fmt::join(fields, " "), fmt::join(recoding_.problem_bits, " ")));
}

std::shared_ptr<const SearchProblem> RecodedProblem::coded_plainly(Coding coding) const {
    Recoding recoding = recoding_;
    recoding.coding = coding;
    return std::make_shared<RecodedProblem>(*problem_, std::move(recoding));
}

} // namespace placedpar
