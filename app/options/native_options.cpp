#include "app/options/native_options.hpp"

#include "app/options/common_options.hpp"
#include "app/recorders.hpp"
#include "app/standard_error.hpp"
#include "explore/problems.hpp"
#include "explore/workers.hpp"
#include "gaprocs/processes/sent_events.hpp"
#include "native/native_run.hpp"
#include "native/native_trace.hpp"
#include "native/placement.hpp"
#include "native/rank_run.hpp"
#include "netlist/print/print.hpp"
#include "ranks/ranks.hpp"
#include "report/manifest.hpp"
#include "text/number.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace placedpar {

namespace {

constexpr double slowest_pace = 1e-6, fastest_pace = 1e6;

/// The process kinds of one thread. Each thread has its own problems, because a problem may cache results.
struct KindsOfThread {
    KindsOfThread(std::uint64_t seed, SearchObserver* observer, Checkpoints* checkpoints)
        : problems(known_problems(seed)), catalogue(known_kinds(problems, observer, checkpoints)) {}
    ProblemRegistry problems;
    Catalogue catalogue;
};

std::string not_a_pace(const std::string& text) {
    const std::optional<double> number = parse_number<double>(text);
    return number && *number >= slowest_pace && *number <= fastest_pace
               ? ""
               : fmt::format("\"{}\" is not a number from {} to {}", text, slowest_pace, fastest_pace);
}

std::size_t threads_of(const NativeOptions& options, const Network& network) {
    const std::size_t useful = std::max<std::size_t>(native::most_places(network), 1);
    return std::min(options.threads == 0 ? count_cores() : options.threads, useful);
}

/// Returns the computing time of each node in a simulated run. With these times, nodes with much work can be put on
/// different ranks.
std::vector<Time> simulated_loads(const Network& network, std::uint64_t seed, Interruption& interruption) {
    const RunReport report = run_netlist(network, known_problems(seed), {.seed = seed, .interruption = &interruption});
    std::vector<Time> loads(network.nodes.size());
    for (const ProcessorUse& use : report.processors)
        if (const auto node = std::ranges::find(network.nodes, use.name, &Node::name); node != network.nodes.end())
            loads[static_cast<std::size_t>(node - network.nodes.begin())] = use.busy;
    return loads;
}

void refuse_without_native(const NativeOptions& options, bool predicts) {
    const std::pair<bool, const char*> of_native_runs[] = {{options.threads != 0 && !predicts, "--threads"},
                                                           {!options.map.empty(), "--map"},
                                                           {options.pace != 0, "--pace"}};
    for (const auto& [is_typed, name] : of_native_runs)
        if (is_typed)
            throw UserError(fmt::format("{} is for native runs: give --native, too", name));
}

} // namespace

void add_native(Options& command, NativeOptions& options) {
    command.add_flag("--native", options.is_native,
                     "runs the processes on threads of this computer, and measures their times by its clock");
    add_threads(command, options.threads);
    command
        .add("--map", options.map,
             "distributes processors over the threads of a native run: in turn (modulo), or by the loads that a "
             "simulated run measures first (balance)")
        .one_of({"modulo", "balance"});
    command
        .add("--pace", options.pace,
             "slows a native run down: each computation takes its time on the netlist's processor, divided by this "
             "number")
        .type("FACTOR")
        .check(not_a_pace);
}

void add_threads(Options& command, std::size_t& threads) {
    add_number(command, "--threads", threads, 1, native::most_threads,
               "number of threads of a native run; by default one for each core");
}

void refuse_with_native(const NativeOptions& options, bool predicts,
                        const std::vector<std::pair<bool, const char*>>& typed) {
    if (options.is_native && predicts)
        throw UserError("--predict simulates a native run: leave out --native, or --predict");
    if (!options.is_native)
        refuse_without_native(options, predicts);
    else
        for (const auto& [is_typed, name] : typed)
            if (is_typed)
                throw UserError(fmt::format("{}: only simulated runs have this option: leave out --native", name));
}

RunReport run_natively(const Network& network, const NativeOptions& options, const RunSettings& run,
                       NativeTrace* trace) {
    std::optional<OneEventAtATime> in_turns;
    if (run.observer)
        in_turns.emplace(*run.observer);
    NativeSettings settings;
    settings.seed = run.seed;
    settings.threads = threads_of(options, network);
    settings.pace = options.pace;
    settings.trace = trace;
    if (options.map == "balance")
        settings.loads = [&] { return simulated_loads(network, run.seed, *run.interruption); };
    settings.make_catalogue = [&]() -> std::shared_ptr<const Catalogue> {
        const auto kinds = std::make_shared<KindsOfThread>(run.seed, in_turns ? &*in_turns : nullptr, run.checkpoints);
        return {kinds, &kinds->catalogue};
    };
    settings.is_interrupted = [&run] { return run.interruption->requested(); };
    return run_natively(network, settings);
}

void write_recorded(const RecordedFiles& files, const NativeTrace& trace, const PageContent& run) {
    const Network places = with_places(run.network, run.report);
    Recorders recorders(places, files);
    trace.replay(run.network, *recorders.sink());
    print_warnings(trace.warning());
    recorders.finish({places, run.report, run.manifest, run.searches});
}

std::unique_ptr<Ranks> ranks_of(const NativeOptions& options) {
    std::unique_ptr<Ranks> ranks = options.is_native ? ranks_of_mpirun() : nullptr;
    return ranks && ranks->count() > 1 ? std::move(ranks) : nullptr;
}

bool load_in_all(Ranks& ranks, const NativeOptions& options, std::uint64_t seed,
                 const std::function<LoadedRun()>& load) {
    return all_prepared(ranks, [&] {
        const LoadedRun loaded = load();
        if (options.threads > 1)
            throw UserError(fmt::format("--threads {}: each rank of mpirun runs its processes on one thread: leave out "
                                        "--threads, and start more ranks",
                                        options.threads));
        return fmt::format("{} {} {} {} {} {} {}", version_text(), hex(network_hash(canonical_form(loaded.network))),
                           seed, options.map, options.pace, loaded.checkpoints, loaded.is_recorded);
    });
}

std::optional<RunReport> run_on_ranks(const Network& network, const NativeOptions& options, const RunSettings& run,
                                      Ranks& ranks, NativeTrace* trace) {
    std::optional<SentEvents> sent;
    std::optional<SentCheckpoints> sent_checkpoints;
    RankRunSettings settings;
    settings.seed = run.seed;
    settings.pace = options.pace;
    settings.trace = trace;
    if (options.map == "balance")
        settings.loads = [&] { return simulated_loads(network, run.seed, *run.interruption); };
    settings.make_catalogue = [&](const std::function<void(MessageBytes)>& send) -> std::shared_ptr<const Catalogue> {
        SearchObserver* observer = run.observer;
        Checkpoints* checkpoints = run.checkpoints;
        if (ranks.own() > 0)
            observer = &sent.emplace(send);
        if (ranks.own() > 0 && checkpoints)
            checkpoints = &sent_checkpoints.emplace(*checkpoints, send);
        const auto kinds = std::make_shared<KindsOfThread>(run.seed, observer, checkpoints);
        return {kinds, &kinds->catalogue};
    };
    settings.receive_note = [&](std::span<const std::uint8_t> event) {
        tell_event(event, run.observer, run.checkpoints);
    };
    settings.is_interrupted = [&run] { return run.interruption->requested(); };
    return run_on_ranks(network, settings, ranks);
}

} // namespace placedpar
