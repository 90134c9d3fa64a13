#include "occam/check/checker.hpp"

#include <algorithm>
#include <string_view>
#include <utility>
#include <variant>

namespace placedpar::occam {

namespace {

/// Returns a noun for the declared thing, such as "variable"; "" if there is no warning when the name is not used.
std::string_view kind_of_name(const Declaration& declaration) {
    struct Visitor {
        const Declaration& declaration;
        std::string_view operator()(const Variable&) const {
            const Type::Kind kind = innermost(*declaration.type).kind;
            return kind == Type::Kind::channel ? "channel" : kind == Type::Kind::timer ? "timer" : "variable";
        }
        std::string_view operator()(const Abbreviation& abbreviation) const {
            return abbreviation.is_value ? "constant" : "abbreviation";
        }
        std::string_view operator()(const Retyping&) const { return "abbreviation"; }
        std::string_view operator()(const Parameter&) const { return "parameter"; }
        std::string_view operator()(const Procedure&) const { return "procedure"; }
        std::string_view operator()(const Function&) const { return "function"; }
        std::string_view operator()(const ReplicatorIndex&) const { return ""; }
        std::string_view operator()(const Protocol&) const { return ""; }
        std::string_view operator()(const DataType&) const { return ""; }
        std::string_view operator()(const Placement&) const { return ""; }
        std::string_view operator()(const Use&) const { return ""; }
        std::string_view operator()(const Predefined&) const { return ""; }
        std::string_view operator()(const ConfigurationPart&) const { return ""; }
    };
    return std::visit(Visitor{declaration}, declaration.form);
}

} // namespace

/// Warns of names in the main file that are not used. Names outside of all procedures, and the parameters of these
/// procedures, are left out, since other files may use them.
void Checker::warn_of_unused() {
    std::ranges::sort(declared_, {}, [](const Declaration* each) { return std::pair(each->at.line, each->at.column); });
    for (const Declaration* const each : declared_) {
        const std::string_view kind = kind_of_name(*each);
        const std::size_t least_depth = std::holds_alternative<Parameter>(each->form) ? 2 : 1;
        if (each->at.file == 0 && !kind.empty() && depths_.at(each) >= least_depth && !used_.contains(each))
            reporter_.warning(program_.location(each->at),
                              "the " + std::string(kind) + " \"" + each->name + "\" is never used", "leave it out");
    }
}

} // namespace placedpar::occam
