#include "app/command.hpp"
#include "app/options/common_options.hpp"
#include "app/options/netlist_options.hpp"
#include "app/options/time_option.hpp"
#include "app/signals.hpp"
#include "app/standard_error.hpp"
#include "text/output_file.hpp"
#include "workbench/manifest.hpp"
#include "workbench/problems.hpp"
#include "workbench/run_report.hpp"
#include "workbench/trace/trace_file.hpp"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <optional>
#include <span>

namespace placedpar {

namespace {

struct RunOptions {
    NetlistOptions netlist;
    std::string json, trace; ///< files; "": not written
    TraceWindow traced;
    Time until = Time::max();
    std::uint64_t seed = 1;
};

void require_outputs(std::span<const std::filesystem::path> outputs, const RunOptions& options) {
    require_apart(outputs, options.netlist.file);
    for (const auto& path : outputs)
        if (!path.empty())
            require_writable(path);
}

RunReport run_network(const Network& network, const RunOptions& options, TraceSink* trace) {
    InterruptedBySignals interruption;
    return run_netlist(network, known_problems(options.seed),
                       {.seed = options.seed, .until = options.until, .trace = trace, .interruption = &interruption});
}

ExitCode run(const RunOptions& options, const std::string& typed) {
    Manifest manifest{typed, options.seed, overrides_of(options.netlist.set), read_options_of(options.netlist.read),
                      options.until};
    const std::filesystem::path outputs[] = {options.json, options.trace};
    if (!options.trace.empty())
        require_trace_format(options.trace);
    require_outputs(outputs, options);
    Network network = load_network(options.netlist);
    for (const std::string& included : network.included_paths)
        require_apart(outputs, included);
    std::optional<TraceFile> trace;
    if (!options.trace.empty())
        trace.emplace(options.trace, network, options.traced);
    RunReport report = run_network(network, options, trace ? &trace->sink() : nullptr);
    print_out(print_report(report, network));
    if (!options.json.empty())
        write_whole(options.json, print_pretty(report_json(report, network, manifest)));
    if (trace)
        print_warnings(trace->finish(report.result));
    return exit_code_of(report.result.ending);
}

void add_trace(CLI::App& command, RunOptions& options) {
    CLI::Option* trace = add_file(command, "--trace", options.trace,
                                  "writes a timeline, by its ending for ui.perfetto.dev (.json) or GTKWave (.vcd)");
    add_time(command, "--trace-from", options.traced.from, "begins the timeline at this moment of the machine's time")
        ->needs(trace);
    add_time(command, "--trace-until", options.traced.until, "ends the timeline at this moment")->needs(trace);
    add_count(command, "--trace-limit", options.traced.most_entries,
              "ends the timeline when it has so many slices and messages")
        ->needs(trace);
}

Action declare_run(CLI::App& command, const std::string& typed) {
    auto options = std::make_shared<RunOptions>();
    add_netlist(command, options->netlist);
    add_seed(command, options->seed);
    add_time(command, "--until", options->until, "stops the run at this moment of the machine's time");
    add_file(command, "--json", options->json, "writes the report for machines");
    add_trace(command, *options);
    return [options, typed] { return run(*options, typed); };
}

} // namespace

extern const Command run_command{
    .name = "run",
    .about = "Runs a netlist and reports what it computed and what it cost",
    .place = 1,
    .declare = declare_run,
};

} // namespace placedpar
