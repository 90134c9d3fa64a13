#include "app/command.hpp"
#include "app/options/common_options.hpp"
#include "app/options/netlist_options.hpp"
#include "explore/study/results.hpp"
#include "explore/study/study_file.hpp"
#include "explore/study/study_report.hpp"
#include "explore/study/summary_cells.hpp"
#include "picture/gnuplot.hpp"
#include "runtime/kernel.hpp"
#include "text/nearest.hpp"
#include "text/output_file.hpp"
#include "text/user_error.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>

namespace placedpar {

namespace {

struct ReportOptions {
    std::string study; ///< a file of results, or the study or netlist that gives the file its name
    std::vector<std::string> measures, relative_to;
    std::string over;           ///< axis of the plot; "": the axis with the most numbers
    std::string csv, svg, page; ///< files; "": not written
    bool runs = false;          ///< whether the CSV has a row for each run

    std::array<std::filesystem::path, 3> outputs() const { return {csv, svg, page}; }
};

/// Returns where `placedpar sweep` stores the results of a netlist or a study by default.
std::filesystem::path kept_results_of(const std::string& study) {
    std::string name = lower_case(study);
    return name.ends_with(".toml") || name.ends_with(".cfs") ? std::filesystem::path(study).stem().string() + ".sqlite"
                                                             : study;
}

/// Summarises the runs of the study. If the user gave a file of results instead of a study, summarises all runs in the
/// file.
StudySummary summary_of(StudyResults& results, const ReportOptions& options) {
    std::optional<Study> study;
    if (lower_case(options.study).ends_with(".toml"))
        study = read_study(options.study);
    const Overrides typed = overrides_of(options.relative_to, "--relative-to");
    const Overrides& relative_to = typed.empty() && study ? study->relative_to : typed;
    return summary_of(results, options.measures, study ? &*study : nullptr, relative_to);
}

void require_reference_line(const StudySummary& summary) {
    if (!summary.relative_to.empty() && !summary.has_some(summary.relative_to))
        throw UserError(there_is_no_reference(summary.relative_to, summary.names()));
}

void write_outputs(const StudySummary& summary, const ReportOptions& options) {
    if (!options.csv.empty())
        write_whole(options.csv, options.runs ? runs_csv(summary) : summary_csv(summary));
    if (!options.svg.empty())
        write_whole(options.svg, draw_svg(summary_plot(summary, options.over)));
    if (!options.page.empty())
        write_whole(options.page, summary_page(summary, options.over));
}

void require_report_outputs(const ReportOptions& options, const std::filesystem::path& kept) {
    require_apart(options.outputs(), kept);
    require_apart(options.outputs(), options.study);
    if (options.runs && options.csv.empty())
        throw UserError("--runs writes a row for each run as comma-separated values: add --csv FILE");
    for (const auto& path : options.outputs())
        if (!path.empty())
            require_writable(path);
    if (!options.svg.empty() || !options.page.empty())
        require_gnuplot();
    else if (!options.over.empty())
        throw UserError("--over names the horizontal axis of a plot, but no plot is drawn: add --svg or "
                        "--page");
}

/// Throws UserError for a measure that no run has, if at least one run completed.
void require_measured(const StudySummary& summary, StudyResults& results) {
    std::optional<StudyFigures> figures;
    results.for_each([&](const StudyRun&, const StudyOutcome& outcome) {
        if (!figures && outcome.ended == name_of(RunOutcome::completed))
            figures = outcome.figures;
    });
    for (std::size_t i = 0; figures && i < summary.measures.size(); ++i)
        if (std::ranges::none_of(summary.lines, [&](const StudyLine& line) {
                return line.cells[i].runs > 0 || line.without.contains(summary.measures[i]);
            }))
            throw UserError(there_is_no_measure(StudyMeasure{summary.measures[i]}, *figures));
}

ExitCode report(const ReportOptions& options) {
    std::filesystem::path kept = kept_results_of(options.study);
    require_report_outputs(options, kept);
    StudyResults results(kept);
    StudySummary summary = summary_of(results, options);
    require_reference_line(summary);
    if (!options.measures.empty())
        require_measured(summary, results);
    write_outputs(summary, options);
    print_out(print_summary(summary) + print_rank_tests(summary));
    return ExitCode::success;
}

Action declare_report(Options& command, const std::string&) {
    auto options = std::make_shared<ReportOptions>();
    command.add("STUDY", options->study, "a results file (.sqlite), or the study or netlist whose sweep made this file")
        .required()
        .check(not_a_named_file);
    command.add_list("--measure", options->measures, "MEASURE",
                     "a measure to show instead of the sweep's measures; no new runs are needed; may be repeated");
    command.add_list("--relative-to", options->relative_to, "NAME=VALUE",
                     "divides each figure by the figure of the run with this setting, all else equal; may be repeated");
    add_file(command, "--over", options->over, "the setting on the plot's horizontal axis", "NAME");
    add_file(command, "--csv", options->csv, "writes the table as comma-separated values");
    command.add_flag("--runs", options->runs, "with --csv: writes a row for each run, with its settings and seed");
    add_file(command, "--svg", options->svg, "draws the measures as SVG");
    add_file(command, "--page", options->page, "writes one self-contained HTML page with tables and plots");
    return [options] { return report(*options); };
}

} // namespace

extern const Command report_command{
    .name = "report",
    .about = "Shows a study's results as tables, plots or a page",
    .place = 23,
    .declare = declare_report,
};

} // namespace placedpar
