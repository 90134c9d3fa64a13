#include "app/command.hpp"
#include "app/common_options.hpp"
#include "app/identify_command.hpp"
#include "app/kinds_command.hpp"
#include "app/manifest.hpp"
#include "app/monitor/monitor_command.hpp"
#include "app/netlist_run.hpp"
#include "app/output_file.hpp"
#include "app/overrides.hpp"
#include "app/perfetto_trace.hpp"
#include "app/record_command.hpp"
#include "app/refused_input.hpp"
#include "app/replay_command.hpp"
#include "app/run_report.hpp"
#include "app/standard_output.hpp"
#include "hydraulics/parameters.hpp"
#include "netlist/print.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace placedpar {
namespace {

/// What the command line may say, of all commands.
struct Options {
    std::string file, format = "cfs", json, trace, kind, experiment, plots;
    std::vector<std::string> set;
    std::uint64_t seed = 1;
    std::string command; ///< as typed
};

ExitCode run(const Options& options) {
    Manifest manifest{options.command, options.seed, overrides_of(options.set)};
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
                          network.source_path, std::ranges::count(network.nodes, NodeKind::processor, &Node::kind),
                          network.connections.size(), network.processes.size(), network.channels.size(), network.hash));
    return ExitCode::success;
}

ExitCode show(const Options& options) {
    Network network = load_network(options.file, overrides_of(options.set));
    print_out(options.format == "cfs"   ? print_cfs(network)
              : options.format == "dot" ? print_dot(network)
                                        : print_json(network));
    return ExitCode::success;
}

ExitCode kinds(const Options& options) {
    print_out(options.kind.empty() ? print_kinds() : print_kind(options.kind));
    return ExitCode::success;
}

ExitCode parameters(const Options&) {
    print_out(excavator_text());
    return ExitCode::success;
}

void add_netlist_arguments(CLI::App& command, Options& options) {
    command.add_option("FILE", options.file, "the netlist")->required();
    command.add_option("--set", options.set, "NAME=VALUE: gives a val of the netlist another value")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
}

/// Declares the commands; the one that was typed is put into `chosen`.
void declare_commands(CLI::App& app, Options& options, ChosenCommand& chosen) {
    auto add = [&](const char* name, const char* about, ExitCode (*command)(const Options&)) {
        auto* sub = app.add_subcommand(name, about);
        sub->callback([&chosen, &options, command] { chosen = [&options, command] { return command(options); }; });
        return sub;
    };
    auto* run_command = add("run", "Runs a netlist and reports what it computed and what it cost", run);
    add_netlist_arguments(*run_command, options);
    add_seed(*run_command, options.seed);
    add_file(*run_command, "--json", options.json, "writes the report for machines");
    add_file(*run_command, "--trace", options.trace, "writes a timeline that ui.perfetto.dev shows");

    add_netlist_arguments(*add("check", "Reads and checks a netlist", check), options);

    auto* show_command = add("show", "Prints the elaborated network", show);
    add_netlist_arguments(*show_command, options);
    show_command->add_option("--format", options.format, "the netlist language, Graphviz, or JSON")
        ->check(CLI::IsMember({"cfs", "dot", "json"}))
        ->capture_default_str();

    add("kinds", "Lists the process kinds that a netlist can use", kinds)
        ->add_option("NAME", options.kind, "everything about this kind");

    auto* replay_sub =
        add("replay", "Runs an experiment of the thesis beside the thesis's figures", [](const Options& o) {
            return replay(o.experiment, o.seed, {o.json, o.plots}, o.command);
        });
    replay_sub->add_option("EXPERIMENT", options.experiment, "one of those below")->required();
    add_seed(*replay_sub, options.seed);
    add_file(*replay_sub, "--json", options.json, "writes the cells for machines");
    add_file(*replay_sub, "--plots", options.plots, "writes the experiment's plots, SVG", "FOLDER");
    replay_sub->footer("experiments:\n" + list_experiments());

    declare_identify(app, chosen, options.command);
    declare_record(app, chosen);
    add("parameters", "Prints the constants of the excavator, as a file for --machine", parameters);
    monitor::declare(app, chosen);
}

bool is_command(const CLI::App& app, std::string_view name) {
    return std::ranges::any_of(app.get_subcommands({}), [&](const CLI::App* each) { return each->get_name() == name; });
}

/// What the command line asks for. Throws what the command throws.
int execute(CLI::App& app, const ChosenCommand& chosen, int argc, char** argv) {
    if (argc > 1 && argv[1][0] != '-' && !is_command(app, argv[1]))
        throw std::runtime_error(
            fmt::format("there is no command \"{}\"; say placedpar --help for those there are", argv[1]));
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        std::ostringstream help, wrong;
        bool asked_for_help = app.exit(error, help, wrong) == 0;
        print_out(help.str());
        fmt::print(stderr, "{}", wrong.str());
        return static_cast<int>(asked_for_help ? ExitCode::success : ExitCode::bad_input);
    }
    return static_cast<int>(chosen());
}

int main(int argc, char** argv) {
    CLI::App app{"PlacedPar simulates transputer networks and the CSP processes placed on them."};
    app.name("placedpar");
    app.set_version_flag("--version", std::string("placedpar ") + version);
    app.require_subcommand(1);
    app.footer("exit codes: 0 success, 1 wrong use or bad input, 2 deadlock, 3 a comparison missed its tolerance,\n"
               "            130 interrupted");
    Options options;
    ChosenCommand chosen;
    declare_commands(app, options, chosen);
    for (int i = 0; i < argc; ++i)
        options.command += (i ? " " : "") + std::string(i ? argv[i] : "placedpar");
    try {
        return execute(app, chosen, argc, argv);
    } catch (const RefusedInput& refused) {
        fmt::print(stderr, "{}", refused.what());
    } catch (const std::exception& error) {
        fmt::print(stderr, "placedpar: {}\n", error.what());
    }
    return static_cast<int>(ExitCode::bad_input);
}

} // namespace
} // namespace placedpar

int main(int argc, char** argv) { return placedpar::main(argc, argv); }
