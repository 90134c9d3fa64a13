#include "app/command.hpp"
#include "app/options/common_options.hpp"
#include "app/options/netlist_options.hpp"
#include "app/signals.hpp"
#include "app/standard_error.hpp"
#include "explore/prediction/calibration.hpp"
#include "explore/prediction/native_netlist.hpp"
#include "explore/problems.hpp"
#include "ranks/ranks.hpp"
#include "report/manifest.hpp"
#include "text/output_file.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

namespace {

constexpr std::size_t least_repetitions = 6; // fewer measurements give no 95 % confidence interval of the median

struct CalibrateOptions {
    std::string netlist; ///< "": none
    std::vector<std::string> problems;
    std::size_t repetitions = CalibrationSettings{}.repetitions;
    std::string out = "-";
};

/// Returns the search problems to measure: those of --problem and of the netlist, or all known problems if neither
/// option is given.
std::vector<std::string> problems_to_measure(const CalibrateOptions& options) {
    std::vector<std::string> typed = options.problems, problems;
    if (!options.netlist.empty())
        std::ranges::copy(problems_of(load_network({.file = options.netlist, .set = {}, .read = {}})),
                          std::back_inserter(typed));
    for (const std::string& problem : typed) {
        const auto is_same = [&](const std::string& other) {
            return val_of_problem("error", other) == val_of_problem("error", problem);
        };
        if (std::ranges::none_of(problems, is_same))
            problems.push_back(problem);
    }
    return problems.empty() ? known_problems(1).names() : problems;
}

ExitCode measure_and_write(const CalibrateOptions& options, const std::vector<std::string>& problems, Ranks* ranks,
                           const Interruption& interruption) {
    ProgressLine line;
    const Calibration calibration =
        measure_computer({.repetitions = options.repetitions,
                          .problems = problems,
                          .progress = [&](const std::string& what) { line.show("measuring " + what); },
                          .is_interrupted = [&] { return interruption.requested(); },
                          .ranks = ranks});
    line.clear();
    if (interruption.requested())
        return exit_code_of(RunOutcome::interrupted);
    if (calibration.is_disturbed())
        print_warnings("warning: threads or ranks wait for cores that other programs use; calibrate again when no "
                       "other program is busy\n");
    write_whole(options.out, print_calibration(calibration));
    return ExitCode::success;
}

/// Returns the two ranks, the processes that mpirun started. Returns null without mpirun. If there are more than two
/// ranks, throws UserError in rank 0, and the other ranks must end silently.
std::unique_ptr<Ranks> two_ranks() {
    std::unique_ptr<Ranks> ranks = ranks_of_mpirun();
    if (ranks && ranks->count() > 2 && ranks->own() == 0)
        throw UserError(fmt::format(
            "mpirun started {} ranks, but messages are measured between two ranks: use mpirun -n 2 placedpar calibrate",
            ranks->count()));
    return ranks && ranks->count() > 1 ? std::move(ranks) : nullptr;
}

/// Checks the options, and returns the problems to measure.
std::vector<std::string> prepare(const CalibrateOptions& options) {
    require_writable(options.out);
    require_apart(std::array<std::filesystem::path, 1>{options.out}, options.netlist);
    return problems_to_measure(options);
}

ExitCode calibrate_with_ranks(const CalibrateOptions& options, Ranks& ranks, const Interruption& interruption) {
    std::vector<std::string> problems;
    const auto prepare_here = [&] {
        if (ranks.own() == 0)
            problems = prepare(options);
        return version_text();
    };
    if (ranks.count() > 2 || !all_prepared(ranks, prepare_here))
        return ExitCode::success;
    if (ranks.own() == 0)
        return measure_and_write(options, problems, &ranks, interruption);
    help_to_measure(ranks);
    return ExitCode::success;
}

ExitCode calibrate_computer(const CalibrateOptions& options) {
    const std::unique_ptr<Ranks> ranks = two_ranks();
    const InterruptedBySignals interruption;
    return ranks ? calibrate_with_ranks(options, *ranks, interruption)
                 : measure_and_write(options, prepare(options), nullptr, interruption);
}

Action declare_calibrate(Options& command, const std::string&) {
    auto options = std::make_shared<CalibrateOptions>();
    command.add("FILE", options->netlist, "a netlist whose problems are measured; without it all problems are measured")
        .check(not_a_name);
    command.add_list("--problem", options->problems, "PROBLEM",
                     "measures this problem, too, such as \"costly(work = 100)\"; may be repeated");
    add_number(command, "--repetitions", options->repetitions, least_repetitions, 10'000,
               "number of measurements for each cost; their median is written")
        .show_default();
    add_file(command, "-o,--out", options->out, "writes the costs to this file; default: standard output");
    return [options] { return calibrate_computer(*options); };
}

} // namespace

extern const Command calibrate_command{
    .name = "calibrate",
    .about = "Measures the costs of native runs on this computer, under mpirun also between ranks, and writes a "
             "file that netlists can include",
    .place = 13,
    .declare = declare_calibrate,
};

} // namespace placedpar
