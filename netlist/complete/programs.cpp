#include "netlist/complete/complete.hpp"
#include "text/nearest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <set>

namespace placedpar {

namespace {

void take_default(Draft& draft) {
    for (auto& process : draft.processes)
        if (process.kind.empty())
            process.kind = draft.default_kind;
}

std::set<std::string> programs_in(const Draft& draft) {
    std::set<std::string> programs;
    std::ranges::transform(draft.processes, std::inserter(programs, programs.end()), &DraftProcess::kind);
    programs.erase("");
    return programs;
}

/// The nearest of those there are, or all of them.
std::string choice(const std::string& wanted, const std::vector<std::string>& names, const std::string& if_none) {
    auto guess = did_you_mean(wanted, names);
    return !guess.empty() ? guess : names.empty() ? if_none : fmt::format("there are {}", fmt::join(names, ", "));
}

void refuse_option(Completion& c, const std::string& program, const std::string& kind, std::size_t column,
                   const std::string& message, const std::string& hint) {
    auto source = std::make_shared<SourceFile>("--use", program + "=" + kind);
    c.reporter.error({source, 1, column}, message, hint);
}

void check_option(Completion& c, const std::string& program, const std::string& kind,
                  const std::set<std::string>& programs) {
    if (!programs.contains(program))
        refuse_option(c, program, kind, 1, fmt::format("the netlist uses no program \"{}\"", program),
                      choice(program, {programs.begin(), programs.end()}, "it uses none at all"));
    if (c.catalogue.find(kind) == nullptr)
        refuse_option(c, program, kind, program.size() + 2, fmt::format("there is no process kind \"{}\"", kind),
                      choice(kind, c.catalogue.kind_names(), "there is none at all"));
}

void take_kinds(Completion& c) {
    for (auto& process : c.draft.processes)
        if (auto told = c.programs.find(process.kind); told != c.programs.end())
            process.kind = told->second;
}

} // namespace

void complete_programs(Completion& c) {
    take_default(c.draft);
    for (auto programs = programs_in(c.draft); const auto& [program, kind] : c.programs)
        check_option(c, program, kind, programs);
    take_kinds(c);
}

} // namespace placedpar
