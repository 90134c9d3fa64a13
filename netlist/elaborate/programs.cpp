#include "netlist/elaborate/elaborator.hpp"
#include "netlist/kinds/file_kinds.hpp"
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

/// Returns a hint: the name nearest to `wanted`, or a list of all names.
std::string choice(const std::string& wanted, const std::vector<std::string>& names, const std::string& if_none) {
    auto guess = did_you_mean(wanted, names);
    return !guess.empty() ? guess : names.empty() ? if_none : fmt::format("the kinds are {}", fmt::join(names, ", "));
}

void refuse_option(Reporter& reporter, const std::string& program, const std::string& kind, std::size_t column,
                   const std::string& message, const std::string& hint) {
    auto source = std::make_shared<SourceFile>("--use", program + "=" + kind);
    reporter.error({source, 1, column}, message, hint);
}

} // namespace

void Elaborator::check_option(const std::string& program, const std::string& kind,
                              const std::set<std::string>& programs) {
    if (!programs.contains(program))
        refuse_option(reporter_, program, kind, 1, fmt::format("the netlist uses no program \"{}\"", program),
                      choice(program, {programs.begin(), programs.end()}, "the netlist uses no program"));
    if (catalogue_.find(kind) == nullptr)
        refuse_option(reporter_, program, kind, program.size() + 2, fmt::format("unknown process kind \"{}\"", kind),
                      choice(kind, catalogue_.kind_names(), "this program has no kinds"));
}

void Elaborator::use(const ProgramKinds& kinds) {
    take_default(draft_);
    for (auto programs = programs_in(draft_); const auto& [program, kind] : kinds)
        check_option(program, kind, programs);
    for (auto& process : draft_.processes)
        if (auto told = kinds.find(process.kind); told != kinds.end())
            process.kind = told->second;
}

void Elaborator::read_files(const std::vector<std::filesystem::path>& folders) {
    FileKinds* const files = catalogue_.files();
    if (!files)
        return;
    std::map<std::pair<std::string, const SourceFile*>, std::string> known;
    for (DraftProcess& process : draft_.processes) {
        if (!files->is_file(process.kind) || catalogue_.find(process.kind))
            continue;
        const Location at = process.used.value_or(draft_.default_used);
        const auto [found, is_new] = known.try_emplace({process.kind, at.file.get()});
        if (is_new)
            found->second = files->read(process.kind, at, folders, reporter_);
        if (!found->second.empty())
            process.kind = found->second;
    }
}

} // namespace placedpar
