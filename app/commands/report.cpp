#include "app/command.hpp"
#include "app/options/common_options.hpp"
#include "text/nearest.hpp"
#include "text/output_file.hpp"
#include "workbench/gnuplot.hpp"
#include "workbench/study/results.hpp"
#include "workbench/study/study_file.hpp"
#include "workbench/study/study_report.hpp"

#include <CLI/CLI.hpp>

#include <array>
#include <filesystem>
#include <memory>
#include <optional>

namespace placedpar {

namespace {

struct ReportOptions {
    std::string study; ///< a file of results, or what they are called after
    std::vector<std::string> measures;
    std::string over;           ///< the axis of the plot; "": the one with most numbers
    std::string csv, svg, page; ///< files; "": not written

    std::array<std::filesystem::path, 3> outputs() const { return {csv, svg, page}; }
};

/// Where placedpar sweep puts the results of a netlist or a study unless told otherwise.
std::filesystem::path kept_results_of(const std::string& study) {
    std::string name = lower_case(study);
    return name.ends_with(".toml") || name.ends_with(".cfs") ? std::filesystem::path(study).stem().string() + ".sqlite"
                                                             : study;
}

/// Of the runs that a study asks for, where it is one.
StudySummary summary_of(StudyResults& results, const ReportOptions& options) {
    std::optional<Study> study;
    if (lower_case(options.study).ends_with(".toml"))
        study = read_study(options.study);
    return summary_of(results, options.measures, study ? &*study : nullptr);
}

void write_outputs(const StudySummary& summary, const ReportOptions& options) {
    if (!options.csv.empty())
        write_whole(options.csv, summary_csv(summary));
    if (!options.svg.empty())
        write_whole(options.svg, draw_svg(summary_plot(summary, options.over)));
    if (!options.page.empty())
        write_whole(options.page, summary_page(summary, options.over));
}

void require_report_outputs(const ReportOptions& options, const std::filesystem::path& kept) {
    require_apart(options.outputs(), kept);
    require_apart(options.outputs(), options.study);
    for (const auto& path : options.outputs())
        if (!path.empty())
            require_writable(path);
    if (!options.svg.empty() || !options.page.empty())
        require_gnuplot();
}

ExitCode report(const ReportOptions& options) {
    std::filesystem::path kept = kept_results_of(options.study);
    require_report_outputs(options, kept);
    StudyResults results(kept);
    StudySummary summary = summary_of(results, options);
    write_outputs(summary, options);
    print_out(print_summary(summary));
    return ExitCode::success;
}

Action declare_report(CLI::App& command, const std::string&) {
    auto options = std::make_shared<ReportOptions>();
    command
        .add_option("STUDY", options->study, "a study, a netlist, or the file with the results of one that was swept")
        ->required()
        ->check(not_a_name);
    command
        .add_option("--measure", options->measures,
                    "another measure than those of the sweep; as often as wanted: nothing is run again")
        ->type_name("MEASURE")
        ->allow_extra_args(false);
    add_file(command, "--over", options->over, "what the plot is drawn over", "NAME");
    add_file(command, "--csv", options->csv, "writes the table as comma-separated values");
    add_file(command, "--svg", options->svg, "draws the measures");
    add_file(command, "--page", options->page, "writes a page of HTML with both, that needs no other file");
    return [options] { return report(*options); };
}

} // namespace

extern const Command report_command{
    .name = "report",
    .about = "Shows what is known of a study: tables, plots, a page",
    .place = 23,
    .declare = declare_report,
};

} // namespace placedpar
