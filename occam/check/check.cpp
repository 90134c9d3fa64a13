#include "occam/check/check.hpp"

#include "occam/check/checker.hpp"
#include "occam/check/usage.hpp"

#include <variant>

namespace placedpar::occam {

void Checker::check_units() {
    for (const std::unique_ptr<Unit>& unit : program_.units) {
        declare(unit->declarations);
        names_.leave(0);
    }
    declare(program_.routines);
    names_.leave(0);
}

void Checker::check_program() {
    check_units();
    declare(program_.declarations);
    names_.leave(0);
    if (!reporter_.failed())
        warn_of_unused();
}

void check(Program& program, const SourceOptions& options, Reporter& reporter, const ChangeDeclaration& change) {
    try {
        Checker(program, reporter, change).check_program();
        if (!reporter.failed() && (options.usage_checks || options.alias_checks))
            UsageCheck(program, options.usage_checks, options.alias_checks, reporter).check_program();
    } catch (const GiveUp&) {
        return; // the last diagnostic states the reason
    }
}

const Declaration* main_procedure(const Program& program) {
    const Declaration* last = nullptr;
    for (const DeclarationBox& declaration : program.declarations) {
        if (std::holds_alternative<Procedure>(declaration->form))
            last = declaration.get();
    }
    return last;
}

} // namespace placedpar::occam
