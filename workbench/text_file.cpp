#include "workbench/text_file.hpp"

#include "hydraulics/data/record_table.hpp"
#include "text/load_source.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

using namespace hydraulics;

namespace {

constexpr std::size_t most_shown = 20;

using File = std::shared_ptr<const SourceFile>;

std::string render_faults(const std::vector<Diagnostic>& faults, const File& file, Severity severity) {
    std::vector<Diagnostic> diagnostics;
    for (const Diagnostic& fault : faults)
        if (fault.severity == severity)
            diagnostics.emplace_back(fault).location.file = file;
    std::size_t more = diagnostics.size() - std::min(diagnostics.size(), most_shown);
    diagnostics.resize(diagnostics.size() - more);
    return render(diagnostics) + (more ? fmt::format("{}: and {} more like these\n", file->path(), more) : "");
}

/// Warns of the faults, or throws when one of them refuses the text.
void report(const std::vector<Diagnostic>& faults, const File& file) {
    fmt::print(stderr, "{}", render_faults(faults, file, Severity::warning));
    if (has_errors(faults))
        throw RefusedInput(render_faults(faults, file, Severity::error));
}

File load_text(const std::filesystem::path& path) {
    LoadedSource loaded = load_source(path);
    report(loaded.problems, loaded.file);
    return loaded.file;
}

} // namespace

Record load_record(const std::filesystem::path& path, std::vector<Diagnostic>* warnings) {
    File file = load_text(path);
    ReadRecord read = read_record(file->text());
    report(read.faults, file);
    if (warnings)
        *warnings = std::move(read.faults);
    return std::move(*read.record);
}

Parameters load_machine(const std::filesystem::path& path) {
    Parameters machine = Parameters::excavator();
    if (path.empty())
        return machine;
    File file = load_text(path);
    std::vector<Diagnostic> faults;
    machine.read(file->text(), faults);
    report(faults, file);
    return machine;
}

} // namespace placedpar
