#include "app/command.hpp"
#include "app/options/common_options.hpp"
#include "app/options/netlist_options.hpp"
#include "app/signals.hpp"
#include "app/standard_error.hpp"
#include "explore/compare/comparison.hpp"
#include "ranks/ranks.hpp"
#include "text/nearest.hpp"
#include "text/number.hpp"
#include "text/output_file.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <optional>

namespace placedpar {

namespace {

struct CompareOptions {
    std::string a, b;
    std::vector<std::string> set, set_b;
    ReadOptionsTyped read;
    std::uint64_t seed = 1;
    std::optional<double> tolerance;
};

bool is_report(const std::string& file) { return lower_case(file).ends_with(".json"); }

/// Throws UserError for an option without effect. Options for netlists have no effect on a report, because it contains
/// the settings of its run.
void require_effect(const CompareOptions& options, const Options& command) {
    if (is_report(options.b) && command.is_given("--set-b"))
        throw UserError(fmt::format("--set-b has no effect on {}: a report states the settings of its run; give a "
                                    "netlist as B",
                                    options.b));
    for (const char* name : {"--set", "--seed", "-I", "--use", "--fault"})
        if (is_report(options.a) && is_report(options.b) && command.is_given(name))
            throw UserError(fmt::format("{} has no effect on {} and {}: a report states the settings of its run; give "
                                        "a netlist as A or B",
                                        name, options.a, options.b));
}

std::string not_a_percentage(const std::string& text) {
    const auto percent = parse_number<double>(text);
    return percent && std::isfinite(*percent) && *percent >= 0
               ? ""
               : fmt::format("\"{}\" is not a percentage: expected a number of at least 0", text);
}

/// Reads a report of a run, or a netlist with the options of the command.
ComparedRun compared_run(const CompareOptions& options, const std::string& file, Overrides set) {
    if (is_report(file))
        return run_of_report(file, print_warnings);
    std::string name = file;
    for (const auto& [setting, value] : set)
        name += fmt::format(" --set {}={}", setting, value);
    return {name, ParsedNetlist(file, read_options_of(options.read)), std::move(set), options.seed};
}

Overrides settings_of_b(const CompareOptions& options) {
    Overrides set = overrides_of(options.set_b, "--set-b");
    set.merge(overrides_of(options.set));
    return set;
}

bool is_within_tolerance(const NetlistComparison& compared, double percent) {
    return std::abs(in_milliseconds(compared.difference())) <=
           percent / 100 * in_milliseconds(compared.report_a.result.time);
}

ExitCode exit_code_of(const NetlistComparison& compared, std::optional<double> tolerance) {
    for (const RunReport* report : {&compared.report_a, &compared.report_b})
        if (const ExitCode code = exit_code_of(report->outcome()); code != ExitCode::success)
            return code;
    return tolerance && !is_within_tolerance(compared, *tolerance) ? ExitCode::missed_tolerance : ExitCode::success;
}

ExitCode compare(const CompareOptions& options) {
    if (left_to_rank_zero("compare"))
        return ExitCode::success;
    const ComparedRun a = compared_run(options, options.a, overrides_of(options.set)),
                      b = compared_run(options, options.b, settings_of_b(options));
    InterruptedBySignals interruption;
    ProgressLine line;
    const NetlistComparison compared = compare_runs(a, b, interruption, [&](std::size_t done, std::size_t all) {
        line.show(fmt::format("one difference at a time: {} of {} runs", done, all));
    });
    line.clear();
    print_out(print_compared(compared));
    return interruption.requested() ? ExitCode::interrupted : exit_code_of(compared, options.tolerance);
}

Action declare_compare(Options& command, const std::string&) {
    auto options = std::make_shared<CompareOptions>();
    const char* about = "a netlist, or a report (.json) that placedpar run --json wrote and that names its netlist";
    command.add("A", options->a, about).required().check(not_a_name);
    command.add("B", options->b, about).required().check(not_a_name);
    add_set(command, options->set, "sets a val, an attribute or a parameter in netlists A and B; may be repeated");
    command.add_list("--set-b", options->set_b, "NAME=VALUE", "sets a value in netlist B only; may be repeated");
    add_read_options(command, options->read);
    add_seed(command, options->seed);
    command
        .add("--tolerance", options->tolerance,
             "ends with exit code 3 if the times differ by more than this share of A's time")
        .type("PERCENT")
        .check(not_a_percentage);
    return [options, command] {
        require_effect(*options, command);
        return compare(*options);
    };
}

} // namespace

extern const Command compare_command{
    .name = "compare",
    .about = "Says what differs between two netlists or two runs, and which difference changes the time",
    .place = 15,
    .declare = declare_compare,
};

} // namespace placedpar
