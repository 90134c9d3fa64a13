#include "explore/check/check_file.hpp"

#include "explore/check/languages.hpp"
#include "explore/occam_check.hpp"
#include "explore/occam_program.hpp"
#include "netlist/kinds/device_kind.hpp"
#include "netlist/language/names_in_text.hpp"
#include "occam/configuration/configuration.hpp"
#include "text/counted.hpp"
#include "text/load_source.hpp"
#include "text/nearest.hpp"
#include "text/program_name.hpp"
#include "text/refused_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

namespace placedpar {

namespace {

std::string summary_of(const Network& network) {
    return fmt::format("{}: {}, {}, {}, {}; hash {:016x}\n", network.source_path,
                       counted(count_processors(network), "processor"), counted(network.count_wires(), "connection"),
                       counted(network.processes.size(), "process", "processes"),
                       counted(network.channels.size(), "channel"), network.hash);
}

/// Says how the user can use a program without errors. `main` is null if the file has no procedure.
std::string use_of(const occam::Declaration* main) {
    if (!main)
        return "the file has no procedure";
    return can_be_run(*main) ? fmt::format("PROC {} would be run", main->name)
                             : fmt::format("only a netlist can use PROC {}, because of its parameters", main->name);
}

/// Adds what only the compiler refuses.
void add_refusals(CheckedFile& checked, const std::shared_ptr<const SourceFile>& file, const CheckOptions& options) {
    try {
        require_compilable(file, options.read.include_folders, options.program);
    } catch (const RefusedText& refused) {
        std::ranges::copy(refused.diagnostics(), std::back_inserter(checked.diagnostics));
    }
}

CheckedFile check_program(const std::filesystem::path& path, const CheckOptions& options) {
    LoadedSource source = load_input(path);
    if (has_errors(source.problems))
        return {.language = "occam", .diagnostics = std::move(source.problems)};
    OccamCheck program = check_occam_source(source.file, options.read.include_folders, options.program);
    CheckedFile checked{
        .language = "occam", .diagnostics = std::move(program.diagnostics), .not_shown = std::move(program.not_shown)};
    for (const auto& file : program.program->files)
        if (file != source.file && !file->path().starts_with('<'))
            checked.included.push_back(file->path());
    if (!program.failed)
        checked.summary = fmt::format("{}: no errors; {}\n", path.string(), use_of(program.main));
    if (!program.failed && program.main && can_be_run(*program.main))
        add_refusals(checked, source.file, options);
    return checked;
}

} // namespace

Diagnostic fault_of_whole(const std::filesystem::path& path, std::string message, std::string hint) {
    auto file = std::make_shared<const SourceFile>(path.string(), "");
    return {Severity::error, std::move(message), {std::move(file), 0, 0}, std::move(hint), {}};
}

CheckedFile check_netlist(const std::filesystem::path& path, const Catalogue& catalogue, const Overrides& set,
                          const ReadOptions& read) {
    ReadResult result = read_netlist(path, catalogue, set, read);
    CheckedFile checked{
        .language = "netlist", .diagnostics = std::move(result.diagnostics), .not_shown = std::move(result.not_shown)};
    checked.names = occam::is_configuration(path) ? NamesOf::occam : NamesOf::netlist;
    if (!result.network) {
        checked.included = read_syntax(load_input(path).file, read.include_folders).included;
        return checked;
    }
    checked.included = result.network->included_paths;
    checked.summary = summary_of(*result.network);
    if (result.network->nodes.empty() && result.network->processes.empty())
        checked.diagnostics.push_back(fault_of_whole(
            result.network->source_path, "the netlist is empty",
            fmt::format("a netlist declares processors and processes; {} generate writes an example", program_name())));
    return checked;
}

bool is_study(const std::filesystem::path& path) { return lower_case(path.extension().string()) == ".toml"; }

CheckedFile check_file(const std::filesystem::path& path, const Catalogue& catalogue, const CheckOptions& options) {
    CheckedFile checked = is_occam(path)   ? check_program(path, options)
                          : is_study(path) ? check_study(path, catalogue)
                                           : check_netlist(path, catalogue, options.set, options.read);
    if (checked.failed())
        checked.summary.clear();
    return checked;
}

} // namespace placedpar
