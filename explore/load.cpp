#include "explore/load.hpp"

#include "explore/problems.hpp"
#include "hydraulics/data/parameters.hpp"
#include "hydraulics/data/record_table.hpp"
#include "text/diagnostic.hpp"
#include "text/load_source.hpp"
#include "text/repeated_faults.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

namespace {

using File = std::shared_ptr<const SourceFile>;

std::string render_faults(const std::vector<Diagnostic>& faults, const File& file, Severity severity) {
    std::vector<Diagnostic> diagnostics;
    for (const Diagnostic& fault : faults)
        if (fault.severity == severity)
            diagnostics.emplace_back(fault).location.file = file;
    std::size_t more = diagnostics.size() - std::min(diagnostics.size(), most_faults_shown);
    diagnostics.resize(diagnostics.size() - more);
    return render(diagnostics) + not_shown(more, severity);
}

/// Passes on warnings, and throws RefusedInput if one of the faults is an error.
void report(const std::vector<Diagnostic>& faults, const File& file, const WarningSink& warn) {
    if (std::string warnings = render_faults(faults, file, Severity::warning); !warnings.empty())
        warn(warnings);
    if (has_errors(faults))
        throw RefusedInput(render_faults(faults, file, Severity::error));
}

} // namespace

std::shared_ptr<const SourceFile> load_text(const std::filesystem::path& path) {
    LoadedSource loaded = load_input(path);
    if (has_errors(loaded.problems))
        throw RefusedInput(render(loaded.problems));
    return loaded.file;
}

Network load_network(const std::filesystem::path& path, const Overrides& overrides, const ProblemRegistry& problems,
                     const WarningSink& warn, const ReadOptions& options) {
    return load_network(ParsedNetlist(path, options), overrides, known_kinds(problems), warn);
}

Network load_network(const ParsedNetlist& netlist, const Overrides& overrides, const Catalogue& catalogue,
                     const WarningSink& warn) {
    ReadResult read = netlist.read(catalogue, overrides);
    if (!read.network)
        throw RefusedInput(render(read));
    if (!read.diagnostics.empty())
        warn(render(read));
    if (read.network->nodes.empty() && read.network->processes.empty())
        throw RefusedInput(fmt::format("{}: error: the netlist is empty\nhint: a netlist declares processors and "
                                       "processes; placedpar generate writes an example\n",
                                       read.network->source_path));
    return std::move(*read.network);
}

LoadedRecord load_record(const std::filesystem::path& path, const hydraulics::RecordNeeds& needs,
                         const WarningSink& warn) {
    File file = load_text(path);
    hydraulics::ReadRecord read = hydraulics::read_record(file->text(), needs);
    read.faults = RepeatedFaults().take(std::move(read.faults));
    report(read.faults, file, warn);
    return {std::move(*read.record), std::move(read.faults)};
}

hydraulics::Parameters load_machine(const std::filesystem::path& path, const WarningSink& warn) {
    auto machine = hydraulics::Parameters::excavator();
    if (path.empty())
        return machine;
    File file = load_text(path);
    std::vector<Diagnostic> faults;
    machine.read(file->text(), faults);
    report(faults, file, warn);
    return machine;
}

} // namespace placedpar
