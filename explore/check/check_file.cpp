#include "explore/check/check_file.hpp"

#include "explore/occam_check.hpp"
#include "explore/occam_program.hpp"
#include "explore/study/study_file.hpp"
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
#include <optional>
#include <utility>

namespace placedpar {

namespace {

Diagnostic fault_of_whole(const std::filesystem::path& path, std::string message, std::string hint = "") {
    auto file = std::make_shared<const SourceFile>(path.string(), "");
    return {Severity::error, std::move(message), {std::move(file), 0, 0}, std::move(hint), {}};
}

std::string summary_of(const Network& network) {
    return fmt::format("{}: {}, {}, {}, {}; hash {:016x}\n", network.source_path,
                       counted(count_processors(network), "processor"), counted(network.count_wires(), "connection"),
                       counted(network.processes.size(), "process", "processes"),
                       counted(network.channels.size(), "channel"), network.hash);
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

/// Says what a program without errors is for. `main` is null if there is no procedure.
std::string use_of(const occam::Declaration* main) {
    if (!main)
        return "the file has no procedure";
    return can_be_run(*main) ? fmt::format("PROC {} would be run", main->name)
                             : fmt::format("only a netlist can use PROC {}, because of its parameters", main->name);
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
    return checked;
}

/// Returns the first run of a study for which the condition holds; nothing if the condition holds for none of the first
/// runs.
std::optional<StudyRun> first_run(const Study& study) {
    constexpr std::uint64_t most_tried = 10'000;
    const StudyRuns runs(study);
    for (std::uint64_t i = 0; i < std::min(runs.count(), most_tried); ++i)
        if (auto run = runs.at(i))
            return run;
    return std::nullopt;
}

/// Reports a fault of a whole netlist in the study that names the netlist, because the netlist may not exist.
void put_in_study(Diagnostic& fault, const std::filesystem::path& study) {
    if (!fault.location.file || fault.location.line > 0)
        return;
    const std::string message = fault.location.file->path() + ": " + fault.message;
    fault.location = fault_of_whole(study, "").location;
    fault.message = message;
}

CheckedFile check_netlist_of(const Study& study, const std::filesystem::path& path, const Catalogue& catalogue) {
    ReadOptions read = study.read;
    read.make_netlist = occam::netlist_of_configuration;
    const auto run = first_run(study);
    CheckedFile checked = check_netlist(study.netlist, catalogue, run ? run->set : Overrides{}, read);
    for (Diagnostic& each : checked.diagnostics)
        put_in_study(each, path);
    checked.included.push_back(study.netlist);
    checked.summary = fmt::format("{}: {} of {}\n", path.string(), counted(study.count(), "run"), study.netlist);
    return checked;
}

CheckedFile check_study(const std::filesystem::path& path, const Catalogue& catalogue) {
    CheckedFile checked;
    try {
        checked = check_netlist_of(read_study(path.string()), path, catalogue);
    } catch (const RefusedText& refused) {
        checked.diagnostics = refused.diagnostics();
    } catch (const UserError& refused) {
        checked.diagnostics = {fault_of_whole(path, refused.what())};
    }
    checked.language = "study";
    return checked;
}

} // namespace

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
