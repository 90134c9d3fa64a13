#include "app/command.hpp"
#include "app/options/common_options.hpp"
#include "app/options/native_options.hpp"
#include "app/options/netlist_options.hpp"
#include "app/recorders.hpp"
#include "app/signals.hpp"
#include "app/standard_error.hpp"
#include "explore/explain/answers.hpp"
#include "explore/load.hpp"
#include "explore/prediction/native_netlist.hpp"
#include "explore/problems.hpp"
#include "ranks/ranks.hpp"
#include "report/manifest.hpp"
#include "report/search_log.hpp"
#include "text/nearest.hpp"
#include "text/output_file.hpp"
#include "text/paint.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <memory>
#include <utility>

namespace placedpar {

namespace {

struct ExplainOptions {
    NetlistOptions netlist;
    std::string json; ///< a file; "": not written
    RecordedFiles recorded;
    Time until = Time::max();
    std::uint64_t seed = 1;
    bool no_what_if = false;

    Manifest manifest(const std::string& typed) const {
        return {typed, seed, overrides_of(netlist.set), read_options_of(netlist.read), until};
    }
    std::array<std::filesystem::path, 3> outputs() const { return {json, recorded.trace, recorded.page}; }
};

/// Throws UserError for formats that cannot show a critical path: value change dumps and drawings.
void require_path_format(const std::filesystem::path& path) {
    require_trace_format(path);
    if (std::string ending = lower_case(path.extension().string()); ending == ".vcd" || ending == ".svg")
        throw UserError(fmt::format(
            "{}: a timeline with the critical path can be written only as .json, for ui.perfetto.dev", path.string()));
}

/// The objects that receive the events of a run, to explain its time.
struct Listeners {
    Listeners(const Network& network, const RecordedFiles& files)
        : recorders(network, files, &path), searches(log_of(network)) {}

    CriticalPath path;
    Recorders recorders;
    GenerationLog searches;
};

Explanation run_explained(const Network& network, const ExplainOptions& options, Listeners& listeners,
                          Interruption& interruption) {
    RunReport report = run_netlist(network, known_problems(options.seed),
                                   {.seed = options.seed,
                                    .until = options.until,
                                    .trace = listeners.recorders.sink(),
                                    .observer = &listeners.searches,
                                    .interruption = &interruption});
    return explanation_of(std::move(report), listeners.path);
}

void require_outputs(const ExplainOptions& options) {
    if (!options.recorded.trace.empty())
        require_path_format(options.recorded.trace);
    require_apart(options.outputs(), options.netlist.file);
    for (const auto& path : options.outputs())
        if (!path.empty())
            require_writable(path);
}

void write_output(const Explanation& explanation, const Network& network, const ExplainOptions& options) {
    if (!options.json.empty())
        write_whole(options.json, print_pretty(explanation_json(explanation, network)));
}

void try_changes(Explanation& explanation, const Network& network, const ExplainOptions& options,
                 const Interruption& interruption) {
    ProgressLine line;
    auto progress = [&](std::size_t done, std::size_t all) {
        line.show(fmt::format("what if: {} of {} runs", done, all));
    };
    TypedNetlist netlist = parse_netlist(options.netlist, [](const std::string&) {});
    add_answers(explanation, network,
                {std::move(netlist.parsed), std::move(netlist.set), options.seed, options.until, progress},
                interruption);
}

/// Returns the exit code of the run. If an interruption left changes of the network untried, returns the exit code of
/// an interruption.
ExitCode exit_code_of(const Explanation& explanation) {
    return explanation.left_out > 0 ? exit_code_of(RunOutcome::interrupted)
                                    : exit_code_of(explanation.report.outcome());
}

/// Returns a table of the predicted times of native runs on several numbers of threads, and of ranks if the calibration
/// describes ranks.
std::string print_predictions(const ExplainOptions& options, const Interruption& interruption) {
    NetlistOptions stated = options.netlist;
    stated.calibration.clear();
    const Network network =
        load_network(parse_netlist(stated, [](const std::string&) {}).parsed, overrides_of(stated.set),
                     known_kinds(known_problems(0)), [](const std::string&) {});
    using enum PredictedPlaces::Kind;
    std::string text;
    for (const auto& [kind, noun] : {std::pair(threads, "threads"), std::pair(ranks, "ranks")}) {
        if (!describes(kind, options.netlist.calibration))
            continue;
        text += painted(Paint::heading, fmt::format("\n{:>7}  predicted time\n", noun));
        for (const auto& [places, time] :
             predict_times(network, kind, options.netlist.calibration, options.seed, interruption))
            text += fmt::format("{:>7}  {:>14}\n", places, to_string(time));
    }
    return text;
}

ExitCode explain(const ExplainOptions& options, const std::string& typed) {
    if (left_to_rank_zero("explain"))
        return ExitCode::success;
    require_outputs(options);
    Network network = load_network(options.netlist);
    for (const std::string& input : paths_of_inputs(network))
        require_apart(options.outputs(), input);
    Listeners listeners(network, options.recorded);
    InterruptedBySignals interruption;
    Explanation explanation = run_explained(network, options, listeners, interruption);
    if (!options.no_what_if)
        try_changes(explanation, network, options, interruption);
    print_out(print_explanation(explanation, network));
    if (!options.netlist.calibration.empty())
        print_out(print_predictions(options, interruption));
    write_output(explanation, network, options);
    listeners.recorders.finish({network, explanation.report, options.manifest(typed), listeners.searches},
                               explanation.path);
    return exit_code_of(explanation);
}

Action declare_explain(Options& command, const std::string& typed) {
    auto options = std::make_shared<ExplainOptions>();
    add_netlist(command, options->netlist);
    add_predict(command, options->netlist);
    add_threads(command, options->netlist.threads);
    add_seed(command, options->seed);
    command.add("--until", options->until, "stops the run at this simulated time");
    add_file(command, "--json", options->json, "writes the explanation as JSON");
    add_file(command, "--trace", options->recorded.trace,
             "writes a timeline with the critical path, for ui.perfetto.dev (.json)");
    add_file(command, "--page", options->recorded.page,
             "writes an HTML page that shows the run, with the critical path as a line");
    command.add_flag(
        "--no-what-if", options->no_what_if,
        "leaves out the additional runs, which measure how much time each change of the machine would save");
    return [options, typed] { return explain(*options, typed); };
}

} // namespace

extern const Command explain_command{
    .name = "explain",
    .about = "Says why a run of a netlist takes so long, and what would make it faster",
    .place = 20,
    .declare = declare_explain,
};

} // namespace placedpar
