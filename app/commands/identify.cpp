#include "app/command.hpp"
#include "app/identify/many_records.hpp"
#include "app/identify/on_machine.hpp"
#include "app/identify/record_pieces.hpp"
#include "app/options/identify_options.hpp"
#include "app/signals.hpp"
#include "app/standard_error.hpp"
#include "explore/identify/identify_record.hpp"
#include "explore/process_search.hpp"
#include "report/manifest.hpp"
#include "text/output_file.hpp"
#include "text/standard_streams.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

namespace {

/// Throws UserError if --on names a netlist, but simulated transputers cannot make the search that --way selects.
void require_way_of_netlist(const IdentifyOptions& options) {
    if (!options.netlist.empty() && options.way != "thesis")
        throw UserError(fmt::format("--on works only with --way thesis, whose search a netlist can run; {} runs on "
                                    "this computer",
                                    shown_way(options)));
}

void require_files(const IdentifyOptions& options) {
    const std::filesystem::path output[] = {options.json, options.trend};
    std::vector<std::string> inputs = options.records;
    inputs.insert(inputs.end(), {options.machine, options.netlist, options.columns_from});
    if (std::ranges::count_if(inputs, is_standard_stream) > 1)
        throw UserError("standard input can be read only once: at most one of RECORD, --machine, --columns-from and "
                        "--on can be \"-\"");
    for (const std::string& input : inputs)
        require_apart(output, input);
    for (const std::filesystem::path& file : output)
        if (!file.empty())
            require_writable(file);
}

/// Throws UserError if the options do not fit the number of records.
void require_number_of_records(const IdentifyOptions& options) {
    const bool many = options.records.size() > 1;
    if (many && options.side == "outlet")
        throw UserError(fmt::format("{} records are given, but --side outlet takes one record; several records need "
                                    "--side inlet and --way service, which shows their trend",
                                    options.records.size()));
    if (many && options.way != "service")
        throw UserError(fmt::format("{} records are given, but --way {} takes one record; several records need --way "
                                    "service, which shows their trend",
                                    options.records.size(), options.way));
    if (!many && !options.trend.empty())
        throw UserError(
            "--trend needs at least two records; expected placedpar identify FIRST SECOND ... --trend FILE");
}

/// Identifies as --way thesis does, first on this computer and then by the simulated processes of the netlist, and
/// compares both answers.
ExitCode identify_on_machine(const IdentifyOptions& options, const RecordInput& input, const IdentifyOutput& output) {
    const ThesisAnswer answer = identify_by_thesis(options, input, output);
    const ProcessSearch processes =
        search_by_processes({options.netlist, overrides_of(options.set),
                             ParsedNetlist(options.netlist, read_options_of(options.read)), options.json},
                            answer.prepared, answer.way, print_warnings);
    output.print(answer.text);
    const ExitCode ended = run_on_machine(processes, answer.identified, answer.prepared, options.seed, output.json);
    const bool doubted = options.strict && answer.identified.flagged();
    return ended == ExitCode::success && doubted ? ExitCode::missed_tolerance : ended;
}

/// Returns the record's file as input. The progress line is cleared before each warning.
RecordInput input_of(const IdentifyOptions& options, ProgressLine& line, const Interruption& interruption) {
    const auto warn = [&line](const std::string& warnings) {
        line.clear();
        print_warnings(warnings);
    };
    return {[&options, warn](const hydraulics::RecordNeeds& needs) { return load_record(options.record, needs, warn); },
            [&options, warn, &interruption](hydraulics::RecordNeeds needs) {
                return std::make_unique<RecordPieces>(options.record, std::move(needs), warn,
                                                      [&interruption] { return interruption.requested(); });
            }};
}

ExitCode exit_code_of(IdentifyEnd end, bool strict) {
    if (end == IdentifyEnd::interrupted)
        return ExitCode::interrupted;
    return strict && end == IdentifyEnd::doubtful ? ExitCode::missed_tolerance : ExitCode::success;
}

ExitCode identify(const IdentifyOptions& options, boost::json::object& json) {
    ProgressLine line;
    const auto print = [&line](const std::string& text) {
        line.clear();
        print_out(text);
    };
    const IdentifyOutput output{json, !options.json.empty(), print, print_warnings,
                                [&line](const std::string& what) { line.show(what); }};
    Interruption ignored;
    if (!options.netlist.empty())
        return identify_on_machine(options, input_of(options, line, ignored), output);
    if (options.way != "service")
        return exit_code_of(identify_record(options, input_of(options, line, ignored), output), options.strict);
    InterruptedBySignals interruption;
    return exit_code_of(identify_record(options, input_of(options, line, interruption), output), options.strict);
}

ExitCode identify_file(IdentifyOptions options, const std::string& command_line) try {
    settle_way(options);
    require_way_of_netlist(options);
    require_files(options);
    require_number_of_records(options);
    boost::json::object json{
        {"version", version}, {"commit", commit}, {"command", command_line}, {"seed", options.seed}};
    const ExitCode code = options.records.size() > 1 ? identify_trend(options, json) : identify(options, json);
    if (!options.json.empty())
        write_whole(options.json, print_pretty(json));
    return code;
} catch (const hydraulics::UnfitRecord& unfit) {
    throw RefusedInput(fmt::format("{}: error: {}\n", shown_input(options.record), unfit.what()));
}

Action declare_identify(Options& command, const std::string& typed) {
    auto options = std::make_shared<IdentifyOptions>();
    declare_identify_options(command, *options);
    return [options, typed] {
        options->record = options->records.front();
        return identify_file(*options, typed);
    };
}

} // namespace

extern const Command identify_command{
    .name = "identify",
    .about = "Identifies hydraulic compliances from a record of a motion",
    .place = 70,
    .declare = declare_identify,
};

} // namespace placedpar
