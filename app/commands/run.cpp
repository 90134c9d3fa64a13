#include "app/command.hpp"
#include "app/options/booted_options.hpp"
#include "app/options/common_options.hpp"
#include "app/options/many_runs.hpp"
#include "app/options/native_options.hpp"
#include "app/options/netlist_options.hpp"
#include "app/recorders.hpp"
#include "app/signals.hpp"
#include "app/standard_error.hpp"
#include "app/watch.hpp"
#include "explore/checkpoint_file.hpp"
#include "explore/problems.hpp"
#include "iserver/offered_board.hpp"
#include "native/native_trace.hpp"
#include "picture/gnuplot.hpp"
#include "ranks/ranks.hpp"
#include "report/convergence.hpp"
#include "report/manifest.hpp"
#include "report/run_report.hpp"
#include "report/search_log.hpp"
#include "report/search_report.hpp"
#include "text/counted.hpp"
#include "text/output_file.hpp"
#include "text/paint.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace placedpar {

namespace {

struct RunOptions {
    NetlistOptions netlist;
    BootedOptions booted;
    NativeOptions native;
    std::string json, log, convergence, checkpoint; ///< files; "": not written
    std::uint64_t checkpoint_every = 10;            ///< number of generations
    RecordedFiles recorded;
    Time until = Time::max();
    std::uint64_t seed = 1;
    std::optional<std::uint64_t> shuffle = {};
    std::size_t seeds = 1; ///< number of consecutive seeds, beginning with `seed`
    bool watch = false, yes = false;
    bool listing = false, step = false, analyse = false; ///< reports about transputers that execute their own code
    std::string offer;                           ///< address at which the host's link is offered to another program;
                                                 ///< "": not offered
    std::shared_ptr<Ranks> ranks;                ///< ranks of a native run; null without mpirun
    std::shared_ptr<CheckpointFile> checkpoints; ///< null without --checkpoint
    std::shared_ptr<NativeTrace> native_trace;   ///< null unless a native run is recorded

    std::array<std::filesystem::path, 6> outputs() const {
        return {json, recorded.trace, recorded.page, log, convergence, checkpoint};
    }
    bool is_recorded() const { return !recorded.trace.empty() || !recorded.page.empty(); }
    bool wants_generations() const { return watch || !log.empty() || !convergence.empty(); }
    Manifest manifest(const std::string& typed) const {
        return {typed, seed, overrides_of(netlist.set), read_options_of(netlist.read), until, shuffle};
    }
};

/// The report and the searches of one seed.
struct FinishedRun {
    RunReport report;
    SeededLog searches;
};

void require_outputs(const RunOptions& options) {
    require_seeds(options.seed, options.seeds);
    auto outputs = options.outputs();
    if (options.seeds > 1 && !options.recorded.trace.empty())
        throw UserError(fmt::format("--trace: a timeline shows one run, but --seeds asks for {} runs", options.seeds));
    if (options.seeds > 1 && !options.recorded.page.empty())
        throw UserError(fmt::format("--page: a page shows one run, but --seeds asks for {} runs", options.seeds));
    if (options.seeds > 1 && !options.checkpoint.empty())
        throw UserError(fmt::format("--checkpoint: a file holds the searches of one run, but --seeds asks for {} runs",
                                    options.seeds));
    if (options.seeds > 1 && !options.offer.empty())
        throw UserError(fmt::format(
            "--offer: another program can be the host of one run only, but --seeds asks for {} runs", options.seeds));
    if (options.recorded.window.is_part() && !options.is_recorded())
        throw UserError(
            "--trace-from and --trace-until limit what --trace or --page shows: give --trace or --page, too");
    if (!options.recorded.trace.empty())
        require_trace_format(options.recorded.trace);
    if (!options.convergence.empty())
        require_gnuplot();
    require_apart(outputs, options.netlist.file);
    for (const auto& path : outputs)
        if (!path.empty())
            require_writable(path);
}

/// Throws UserError if the run is native, but an option is only for simulated runs, or the other way round.
void require_native(const RunOptions& options) {
    refuse_with_native(options.native, !options.netlist.calibration.empty(),
                       {{options.until != Time::max(), "--until"},
                        {options.seeds > 1, "--seeds"},
                        {options.shuffle.has_value(), "--shuffle"},
                        {options.listing, "--listing"},
                        {options.analyse, "--analyse"},
                        {options.step, "--step"},
                        {!options.offer.empty(), "--offer"}});
}

/// Throws UserError if an option cannot be used with this network.
void require_fit(const Network& network, const RunOptions& options) {
    for (const std::string& input : paths_of_inputs(network))
        require_apart(options.outputs(), input);
    if (options.wants_generations())
        require_searches(network);
    if (std::ranges::any_of(network.nodes, &Node::runs_own_code))
        return;
    for (const auto& [given, name] :
         {std::pair(options.listing, "--listing"), {options.analyse, "--analyse"}, {options.step, "--step"}})
        if (given)
            throw UserError(fmt::format("{} has no effect: no transputer of {} executes code of its own", name,
                                        network.source_path));
}

std::shared_ptr<CheckpointFile> checkpoints_of(const Network& network, const RunOptions& options) {
    if (options.checkpoint.empty())
        return nullptr;
    return std::make_shared<CheckpointFile>(options.checkpoint, network, options.seed, options.checkpoint_every);
}

RunReport run_observed(const Network& network, const RunOptions& options, std::uint64_t seed, TraceSink* trace,
                       Interruption& interruption, SearchObserver* observer) {
    const RunSettings settings{.seed = seed,
                               .until = options.until,
                               .shuffle = options.shuffle,
                               .trace = trace,
                               .observer = observer,
                               .checkpoints = options.checkpoints.get(),
                               .interruption = &interruption};
    if (options.ranks)
        return *run_on_ranks(network, options.native, settings, *options.ranks, options.native_trace.get());
    return options.native.is_native ? run_natively(network, options.native, settings, options.native_trace.get())
                                    : run_netlist(network, known_problems(seed), settings);
}

FinishedRun run_seed(const Network& network, const RunOptions& options, std::uint64_t seed, TraceSink* trace,
                     Interruption& interruption) {
    SeededLog searches{seed, log_of(network)};
    if (options.checkpoints)
        searches.log.continue_from(*options.checkpoints);
    if (!options.watch)
        return {run_observed(network, options, seed, trace, interruption, &searches.log), std::move(searches)};
    Watch watch(searches.log, fmt::format("{}, seed {}", network.source_path, seed));
    RunReport report = run_observed(network, options, seed, trace, interruption, &watch);
    watch.finish();
    return {std::move(report), std::move(searches)};
}

/// If there are very many runs, asks the user to confirm them after the first run, which shows how long a run takes.
bool others_are_meant(const RunOptions& options, std::chrono::steady_clock::time_point begun,
                      const Interruption& interruption) {
    if (options.seeds <= most_unasked || options.yes)
        return true;
    std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begun;
    return are_meant({options.seeds, true, 1, taken.count()}, interruption);
}

/// Runs the network with one seed after another until a run is interrupted. Returns no runs if the user does not
/// confirm them.
std::vector<FinishedRun> run_seeds(const Network& network, const RunOptions& options, TraceSink* trace,
                                   Interruption& interruption) {
    std::optional<ProgressLine> progress; // not with --watch, whose curve the line would disturb
    if (options.seeds > 1 && !options.watch)
        progress.emplace();
    std::vector<FinishedRun> runs;
    const auto begun = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i == 0 || (i < options.seeds && !interruption.requested()); ++i) {
        if (progress)
            progress->show(fmt::format("seed {} of {}", i + 1, options.seeds));
        runs.push_back(run_seed(network, options, options.seed + i, trace, interruption));
        if (i == 0 && !others_are_meant(options, begun, interruption) && !interruption.requested())
            return {};
    }
    return runs;
}

std::vector<SeededLog> logs_of(std::vector<FinishedRun>& runs) {
    std::vector<SeededLog> logs;
    for (FinishedRun& run : runs)
        logs.push_back(std::move(run.searches));
    return logs;
}

std::string print_run(std::uint64_t seed, const RunReport& report) {
    const RunResult& result = report.result;
    return fmt::format("{:>20}  {:016x}  {:>16}  {}\n", seed, result.fingerprint, to_string(result.time),
                       name_of(report.outcome()));
}

/// Describes the number of seeds that were run, and whether the runs were interrupted.
std::string print_seeds(std::size_t begun, std::size_t asked) {
    return begun == asked ? counted(asked, "seed")
                          : fmt::format("{} of {}, then interrupted", begun, counted(asked, "seed"));
}

std::string print_runs(const Network& network, std::span<const FinishedRun> runs, std::span<const SeededLog> logs,
                       std::size_t asked) {
    std::string out = fmt::format("{}: {}\n", network.source_path, print_seeds(runs.size(), asked));
    out +=
        painted(Paint::heading, fmt::format("\n{:>20}  {:<16}  {:>16}  {}\n", "seed", "fingerprint", "time", "ended"));
    for (std::size_t i = 0; i < runs.size(); ++i)
        out += print_run(logs[i].seed, runs[i].report);
    return out + print_searches(logs);
}

boost::json::object runs_json(const Network& network, std::span<const FinishedRun> runs,
                              std::span<const SeededLog> logs, Manifest manifest) {
    boost::json::array all;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        manifest.seed = logs[i].seed;
        all.push_back(report_json(runs[i].report, network, manifest, logs[i].log));
    }
    if (all.size() == 1)
        return all.front().as_object();
    return {{"runs", std::move(all)}};
}

void write_files(const Network& network, std::span<const FinishedRun> runs, std::span<const SeededLog> logs,
                 const RunOptions& options, const Manifest& manifest) {
    if (!options.json.empty())
        write_whole(options.json, print_pretty(runs_json(network, runs, logs, manifest)));
    if (!options.log.empty())
        write_whole(options.log, log_csv(logs));
    if (!options.convergence.empty())
        write_whole(options.convergence, draw_svg(convergence_plot(network.source_path, logs)));
}

/// Returns the exit code of the first run that is not a success. If fewer runs were made than `asked`, an interruption
/// came between two runs. `unread` is true if the runs were interrupted because the reader of a program's output has
/// gone. Such an interruption counts as a success.
ExitCode exit_code_of(std::span<const FinishedRun> runs, std::size_t asked, bool unread) {
    const ExitCode interrupted = unread ? ExitCode::success : ExitCode::interrupted;
    for (const FinishedRun& run : runs)
        if (ExitCode code = exit_code_of(run.report.outcome()); code != ExitCode::success)
            return code == ExitCode::interrupted ? interrupted : code;
    return runs.size() == asked ? ExitCode::success : interrupted;
}

/// If the option --offer is given, waits until another program connects to the host's link of the network. That program
/// then boots and serves the transputers. Returns false after an interruption.
bool offer_link(Network& network, const RunOptions& options, const Interruption& interruption,
                std::optional<iserver::OfferedBoard>& board) {
    if (options.offer.empty())
        return true;
    if (!has_bootable_file(network))
        throw UserError("--offer: the netlist boots no transputer, so it has no link to a host");
    std::signal(SIGPIPE, SIG_IGN); // if the program closes the link, the run ends with a report
    board.emplace(options.offer, [&interruption] { return interruption.requested(); });
    network.host.board = &*board;
    print_error(fmt::format("placedpar: the host's link is offered at {}\n", board->name()));
    return board->wait_for_program();
}

void write_recorded(const PageContent& run, const RunOptions& options, std::optional<Recorders>& recorders) {
    if (recorders)
        recorders->finish(run);
    else if (options.native_trace)
        write_recorded(options.recorded, *options.native_trace, run);
}

/// Executes the part of a native run that belongs to this rank, one of the processes that mpirun started. A rank above
/// 0 writes nothing.
ExitCode help_rank_zero(const Network& network, const RunOptions& options) {
    InterruptedBySignals interruption;
    const RunSettings settings{
        .seed = options.seed, .checkpoints = options.checkpoints.get(), .interruption = &interruption};
    run_on_ranks(network, options.native, settings, *options.ranks, options.native_trace.get());
    return ExitCode::success;
}

/// Checks the options, and loads the network and the checkpoint of an earlier run. Returns nullopt in a rank of mpirun
/// that must end silently, because rank 0 reports an error.
std::optional<Network> load(RunOptions& options, const Options& command) {
    std::optional<Network> network;
    const auto load_here = [&]() -> LoadedRun {
        if (!options.ranks || options.ranks->own() == 0)
            require_outputs(options);
        require_native(options);
        if (options.native.is_native && options.is_recorded())
            options.native_trace = std::make_shared<NativeTrace>(options.recorded.window.until);
        network = options.netlist.calibration.empty() ? load_network(command, options.netlist, options.booted)
                                                      : load_network(options.netlist);
        require_fit(*network, options);
        options.checkpoints = checkpoints_of(*network, options);
        return {*network, options.checkpoints ? options.checkpoints->digest() : "", options.is_recorded()};
    };
    if (!options.ranks)
        load_here();
    else if (!load_in_all(*options.ranks, options.native, options.seed, load_here))
        network.reset();
    return network;
}

void say_begin(const RunOptions& options) {
    if (options.checkpoints && options.checkpoints->begin() > 0)
        print_error(fmt::format("placedpar: continues from {1}, after generation {0}\n", options.checkpoints->begin(),
                                options.checkpoint));
}

ExitCode run(RunOptions options, const Options& command, const std::string& typed) {
    Manifest manifest = options.manifest(typed);
    if (!options.native.is_native && left_to_rank_zero("run"))
        return ExitCode::success;
    options.ranks = ranks_of(options.native);
    if (options.ranks && options.ranks->own() > 0)
        options.netlist.warn = [](const std::string&) {}; // rank 0 prints the same warnings
    std::optional<Network> loaded = load(options, command);
    if (!loaded)
        return ExitCode::success;
    if (options.ranks && options.ranks->own() > 0)
        return help_rank_zero(*loaded, options);
    say_begin(options);
    Network& network = *loaded;
    InterruptedBySignals interruption;
    network.host.lists_code = options.listing;
    network.host.analyses = options.analyse;
    network.host.steps = options.step ? &std::cin : nullptr;
    bool unread = false;
    network.host.terminal = terminal_for(
        options.booted, [&interruption] { return interruption.requested(); },
        [&] {
            unread = true;
            interruption.request();
        },
        !options.step);
    std::optional<iserver::OfferedBoard> board;
    if (!offer_link(network, options, interruption, board))
        return ExitCode::interrupted;
    std::optional<Recorders> recorders; // set for a simulated run
    if (!options.native.is_native)
        recorders.emplace(network, options.recorded);
    std::vector<FinishedRun> runs = run_seeds(network, options, recorders ? recorders->sink() : nullptr, interruption);
    if (runs.empty())
        return ExitCode::success;
    std::vector<SeededLog> logs = logs_of(runs);
    print_out(options.seeds == 1 ? print_report(runs.front().report, network, logs.front().log)
                                 : print_runs(network, runs, logs, options.seeds));
    for (const ProgramUse& program : runs.front().report.programs)
        for (const std::string* text : {&program.listing, &program.analysis})
            if (!text->empty())
                print_out(fmt::format("\n{}\n{}", program.name, *text));
    write_files(network, runs, logs, options, manifest);
    write_recorded({network, runs.front().report, manifest, logs.front().log}, options, recorders);
    return exit_code_of(runs, options.seeds, unread);
}

void add_searches(Options& command, RunOptions& options) {
    add_count(command, "--seeds", options.seeds,
              "number of runs, with consecutive seeds from --seed on; the report compares their "
              "searches")
        .check(not_at_least_one)
        .show_default();
    add_file(command, "--log", options.log, "writes every generation of every search as comma-separated values");
    add_file(command, "--convergence", options.convergence,
             "draws best fitness, mean fitness and diversity over the generations as SVG; with --seeds medians "
             "and quartiles");
    command.add_flag("--yes", options.yes, "starts any number of runs without asking");
    Option checkpoint =
        add_file(command, "--checkpoint", options.checkpoint,
                 "keeps the populations of all searches in this file, and continues from it if it exists");
    add_count(command, "--checkpoint-every", options.checkpoint_every, "number of generations between two checkpoints")
        .check(not_at_least_one)
        .show_default()
        .needs(checkpoint);
    command.add_flag(
        "--watch", options.watch,
        "shows best fitness, mean fitness and diversity during the run: a curve on a terminal, else lines of text");
}

void add_trace(Options& command, RunOptions& options) {
    Option trace = add_file(command, "--trace", options.recorded.trace,
                            "writes a timeline for ui.perfetto.dev (.json) or GTKWave (.vcd), or draws it (.svg)");
    command.add("--trace-from", options.recorded.window.from, "begins the timeline or page at this time of the run");
    command.add("--trace-until", options.recorded.window.until, "ends the timeline or page at this time of the run");
    add_count(command, "--trace-limit", options.recorded.window.most_entries,
              "ends the timeline after this number of slices and messages")
        .show_default()
        .needs(trace);
}

Action declare_run(Options& command, const std::string& typed) {
    auto options = std::make_shared<RunOptions>();
    add_netlist(command, options->netlist);
    add_seed(command, options->seed);
    command.add("--shuffle", options->shuffle, "runs ready processes in a random order that this seed determines")
        .type("SEED")
        .check(not_a_whole_number);
    command.add("--until", options->until, "stops the run at this simulated time");
    add_file(command, "--json", options->json, "writes the report as JSON");
    add_searches(command, *options);
    add_file(command, "--page", options->recorded.page, "writes one self-contained HTML page that shows the run");
    add_trace(command, *options);
    add_native(command, options->native);
    add_predict(command, options->netlist);
    add_booted(command, options->booted);
    command.add_flag("--listing", options->listing,
                     "prints the code that booted transputers executed, with its cycles");
    command.add_flag("--analyse", options->analyse,
                     "prints the state of booted transputers at the end: registers, queues, processes that wait");
    command.add_flag("--step", options->step,
                     "executes a booted program step by step, controlled by commands from standard input: s, c, b, r, "
                     "w, q, m, l, quit");
    command
        .add("--offer", options->offer,
             "offers the host's link to another program, such as \"placedpar send\", instead of sending FILE; WHERE is "
             "tcp:PORT, tcp:ADDRESS:PORT, or pty for a pseudo terminal")
        .type("WHERE")
        .check(not_a_name);
    return [options, command, typed] {
        options->netlist.threads = options->native.threads;
        return run(*options, command, typed);
    };
}

} // namespace

extern const Command run_command{
    .name = "run",
    .about = "Simulates a netlist, or runs it natively, and reports results and times",
    .place = 10,
    .declare = declare_run,
};

} // namespace placedpar
