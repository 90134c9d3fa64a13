#include "app/command.hpp"
#include "app/options/common_options.hpp"
#include "app/options/netlist_options.hpp"
#include "app/signals.hpp"
#include "app/standard_error.hpp"
#include "explore/prediction/calibration.hpp"
#include "explore/prediction/native_netlist.hpp"
#include "explore/problems.hpp"
#include "ranks/ranks.hpp"
#include "text/output_file.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

namespace placedpar {

namespace {

constexpr std::size_t least_repetitions = 6; // with fewer, a median has no interval of 95 %

struct CalibrateOptions {
    std::string netlist; ///< "": none
    std::vector<std::string> problems;
    std::size_t repetitions = CalibrationSettings{}.repetitions;
    std::string out = "-";
};

/// Returns the problems of --problem and of the netlist; all that the program knows if neither is given.
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

ExitCode calibrate_computer(const CalibrateOptions& options) {
    if (left_to_rank_zero("calibrate"))
        return ExitCode::success;
    require_writable(options.out);
    require_apart(std::array<std::filesystem::path, 1>{options.out}, options.netlist);
    InterruptedBySignals interruption;
    ProgressLine line;
    const Calibration calibration =
        measure_computer({.repetitions = options.repetitions,
                          .problems = problems_to_measure(options),
                          .progress = [&](const std::string& what) { line.show("measuring " + what); },
                          .is_interrupted = [&] { return interruption.requested(); }});
    line.clear();
    if (interruption.requested())
        return exit_code_of(Ending::interrupted);
    if (calibration.is_disturbed())
        print_warnings("warning: threads wait for cores that other programs use; calibrate again when the computer is "
                       "quiet\n");
    write_whole(options.out, print_calibration(calibration));
    return ExitCode::success;
}

Action declare_calibrate(Options& command, const std::string&) {
    auto options = std::make_shared<CalibrateOptions>();
    command.add("FILE", options->netlist, "a netlist, whose problems are measured; default: all problems")
        .check(not_a_name);
    command.add_list("--problem", options->problems, "PROBLEM",
                     "measures this problem, too, such as \"costly(work = 100)\"; may be repeated");
    add_number(command, "--repetitions", options->repetitions, least_repetitions, 10'000,
               "number of measurements of each cost, whose median is written")
        .show_default();
    add_file(command, "-o,--out", options->out, "writes the include to this file; default: standard output");
    return [options] { return calibrate_computer(*options); };
}

} // namespace

extern const Command calibrate_command{
    .name = "calibrate",
    .about = "Measures what native runs cost on this computer, and writes it as an include for netlists",
    .place = 13,
    .declare = declare_calibrate,
};

} // namespace placedpar
