#include "app/netlist_commands.hpp"

#include "app/common_options.hpp"
#include "app/exit_code.hpp"
#include "netlist/kinds/device_kind.hpp"
#include "netlist/print/print.hpp"
#include "text/output_file.hpp"
#include "text/standard_output.hpp"
#include "workbench/manifest.hpp"
#include "workbench/netlist_run.hpp"
#include "workbench/overrides.hpp"
#include "workbench/perfetto_trace.hpp"
#include "workbench/run_report.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

namespace {

/// What the command line may say.
struct Options {
    std::string file, format = "cfs", json, trace;
    std::vector<std::string> set;
    std::uint64_t seed = 1;
    std::string typed;
};

ExitCode run(const Options& options) {
    Manifest manifest{options.typed, options.seed, overrides_of(options.set)};
    const std::filesystem::path outputs[] = {options.json, options.trace};
    require_apart(outputs, options.file);
    for (const auto& path : outputs)
        if (!path.empty())
            require_writable(path);
    Network network = load_network(options.file, manifest.overrides);
    for (const std::string& included : network.included_paths)
        require_apart(outputs, included);
    std::optional<OutputFile> timeline;
    std::optional<PerfettoTrace> trace;
    if (!options.trace.empty())
        trace.emplace(timeline.emplace(options.trace));
    RunReport report = run_netlist(network, options.seed, Time::max(), trace ? &*trace : nullptr);
    print_out(print_report(report, network));
    if (!options.json.empty())
        write_whole(options.json, print_pretty(report_json(report, network, manifest)));
    if (trace)
        trace->finish();
    return exit_code_of(report.result.ending);
}

ExitCode check(const Options& options) {
    Network network = load_network(options.file, overrides_of(options.set));
    print_out(fmt::format("{}: {} processors, {} connections, {} processes, {} channels; hash {:016x}\n",
                          network.source_path, count_nodes(network, "processor"), network.connections.size(),
                          network.processes.size(), network.channels.size(), network.hash));
    return ExitCode::success;
}

ExitCode show(const Options& options) {
    Network network = load_network(options.file, overrides_of(options.set));
    print_out(options.format == "cfs"   ? print_cfs(network)
              : options.format == "dot" ? print_dot(network)
                                        : print_json(network));
    return ExitCode::success;
}

void add_netlist_arguments(CLI::App& command, Options& options) {
    command.add_option("FILE", options.file, "the netlist")->required();
    command.add_option("--set", options.set, "NAME=VALUE: gives a val of the netlist another value")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
}

} // namespace

void declare_netlist_commands(CLI::App& app, ChosenCommand& chosen, const std::string& command_line) {
    auto options = std::make_shared<Options>();
    options->typed = command_line;
    auto add = [&](const char* name, const char* about, ExitCode (*command)(const Options&)) {
        auto* sub = app.add_subcommand(name, about);
        sub->callback([&chosen, options, command] { chosen = [options, command] { return command(*options); }; });
        add_netlist_arguments(*sub, *options);
        return sub;
    };
    auto* run_command = add("run", "Runs a netlist and reports what it computed and what it cost", run);
    add_seed(*run_command, options->seed);
    add_file(*run_command, "--json", options->json, "writes the report for machines");
    add_file(*run_command, "--trace", options->trace, "writes a timeline that ui.perfetto.dev shows");

    add("check", "Reads and checks a netlist", check);

    add("show", "Prints the elaborated network", show)
        ->add_option("--format", options->format, "the netlist language, Graphviz, or JSON")
        ->check(CLI::IsMember({"cfs", "dot", "json"}))
        ->capture_default_str();
}

} // namespace placedpar
