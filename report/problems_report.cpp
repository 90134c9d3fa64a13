#include "report/problems_report.hpp"

#include "report/policies_report.hpp"
#include "report/string_fields.hpp"
#include "text/counted.hpp"
#include "text/paint.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace placedpar {

namespace {

/// Returns the family of this name. Returns nothing if no family has the name.
std::optional<PolicyDescription> family_named(const ProblemRegistry& problems, std::string_view name) {
    auto families = problems.families();
    auto found = std::ranges::find(families, name, &PolicyDescription::name);
    return found == families.end() ? std::nullopt : std::optional(*found);
}

/// Returns "sphere" for "sphere(3)".
std::string base_of(const std::string& name) { return name.substr(0, name.find('(')); }

std::string record_of(const RecordedProblem& recorded) {
    return fmt::format("identified from a record of {} of {}", counted(recorded.samples(), "sample"),
                       counted(recorded.problem()->channels(), "number"));
}

std::string goal_of(const Objective& objective) {
    std::string optimum = objective.optimum ? fmt::format("; the optimum is {}", *objective.optimum) : "";
    return fmt::format("{}{}{}", objective.goal == Goal::minimise ? "minimised" : "maximised", optimum,
                       objective.optimum && !objective.unit.empty() ? " " + objective.unit : "");
}

std::string what_is_searched(const RecordedProblem& recorded) {
    auto objective = recorded.problem()->objective();
    std::string goal = objective ? goal_of(*objective) : record_of(recorded);
    if (const auto names = recorded.problem()->objective_names(); !names.empty())
        goal += fmt::format(": {}", fmt::join(names, ", "));
    return recorded.problem()->has_constraints() ? goal + "; has constraints" : goal;
}

/// A row of the table of fields: one field, or, if there are many, consecutive fields that are alike, "x_1 ... x_20".
struct FieldRow {
    StringField first;
    std::string last;

    std::string names() const { return last == first.name ? last : fmt::format("{} ... {}", first.name, last); }
};

std::vector<FieldRow> rows_of(const std::vector<StringField>& fields) {
    constexpr std::size_t few = 8;
    std::vector<FieldRow> rows;
    for (const StringField& field : fields)
        if (!rows.empty() && rows.back().first.is_like(field) && fields.size() > few)
            rows.back().last = field.name;
        else
            rows.push_back({field, field.name});
    return rows;
}

std::string print_fields(const std::vector<StringField>& fields) {
    std::string out = painted(Paint::heading, "\nfields\n");
    for (const FieldRow& row : rows_of(fields))
        out += fmt::format("  {:<16} {:>2} bits  {:.6g} .. {:.6g}{}, in steps of {:.3g}\n", row.names(), row.first.bits,
                           row.first.least, row.first.most, row.first.unit.empty() ? "" : " " + row.first.unit,
                           row.first.step());
    return out;
}

/// Returns the parameters' names with units, such as "C_BUi in^3/psi"; if there are more than four, the first two and
/// the last.
std::string print_names(const SearchProblem& problem) {
    auto names = problem.parameter_names(), units = problem.parameter_units();
    for (std::size_t i = 0; i < names.size(); ++i)
        if (!units[i].empty())
            names[i] += " " + units[i];
    if (names.size() > 4)
        names = {names[0], names[1], "...", names.back()};
    return names.empty() ? "" : fmt::format("parameters: {}\n", fmt::join(names, ", "));
}

boost::json::array fields_json(const SearchProblem& problem) {
    boost::json::array array;
    for (const StringField& field : string_fields(problem))
        array.push_back({{"name", field.name},
                         {"unit", field.unit},
                         {"bits", field.bits},
                         {"least", field.least},
                         {"most", field.most},
                         {"step", field.step()}});
    return array;
}

boost::json::value value_or_null(std::optional<double> value) {
    return value ? boost::json::value(*value) : boost::json::value();
}

/// Prints a line of two columns. A name that is too long for its column gets a separate line.
std::string in_two_columns(const std::string& name, const std::string& about) {
    constexpr std::size_t width = 42;
    return fmt::format("  {:<{}}{}{}\n", name, width + 1, name.size() > width ? fmt::format("\n{:45}", "") : "", about);
}

} // namespace

std::string print_problems(const ProblemRegistry& problems) {
    std::string out = painted(Paint::heading, "problems\n");
    for (const std::string& name : problems.names()) {
        auto family = family_named(problems, name);
        out += in_two_columns(family ? family->text() : name, family ? family->about : record_of(problems.find(name)));
    }
    for (const auto& [format, reader] : problems.readers())
        out += in_two_columns(format + ":FILE", reader.about);
    return out;
}

std::string print_problem(const ProblemRegistry& problems, const std::string& name) {
    const RecordedProblem& recorded = problems.find(name);
    std::string out = painted(Paint::heading, name) + "\n";
    auto family = family_named(problems, base_of(name));
    if (family)
        out += family->about + "\n";
    auto fields = string_fields(*recorded.problem());
    out += fmt::format("{}\nstring: {}\n", what_is_searched(recorded), counted(recorded.problem()->bits(), "bit"));
    out += fields.empty() ? print_names(*recorded.problem()) : print_fields(fields);
    return family ? out + print_numbers(*family) : out;
}

boost::json::object problem_json(const ProblemRegistry& problems, const std::string& name) {
    const RecordedProblem& recorded = problems.find(name);
    auto family = family_named(problems, base_of(name));
    auto objective = recorded.problem()->objective();
    return {{"name", name},
            {"about", family ? family->about : ""},
            {"numbers", family ? numbers_json(*family) : boost::json::array()},
            {"goal", !objective                          ? ""
                     : objective->goal == Goal::minimise ? "minimise"
                                                         : "maximise"},
            {"unit", objective ? objective->unit : ""},
            {"optimum", value_or_null(objective ? objective->optimum : std::nullopt)},
            {"samples", recorded.samples()},
            {"bits", recorded.problem()->bits()},
            {"fields", fields_json(*recorded.problem())}};
}

boost::json::array problems_json(const ProblemRegistry& problems) {
    boost::json::array array;
    for (const std::string& name : problems.names())
        array.push_back(problem_json(problems, name));
    return array;
}

} // namespace placedpar
