#include "app/command.hpp"
#include "app/options/common_options.hpp"
#include "app/signals.hpp"
#include "app/standard_error.hpp"
#include "explore/exercise/course.hpp"
#include "serve/marking.hpp"
#include "text/counted.hpp"
#include "text/load_source.hpp"
#include "text/output_file.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace placedpar {

namespace {

struct MarkOptions {
    std::string folder, exercise, expected, csv;
    serve::QueueLimits limits;
};

serve::MarkedTask task_of(const MarkOptions& options) {
    if (options.exercise.empty() == options.expected.empty())
        throw UserError("name one task: either an exercise of the course, such as --exercise 3.2, or a file with "
                        "the expected output of another task, --expected FILE");
    if (!options.expected.empty()) {
        const LoadedSource expected = load_source(options.expected);
        if (!expected.problems.empty())
            throw RefusedInput(render(expected.problems));
        return {"", expected.file->text()};
    }
    return {exercise_of(options.exercise).number, std::nullopt};
}

/// Prints a line for each submission, with the first line of its explanation, and the number of submissions with each
/// result.
std::string print_marks(const std::vector<serve::Mark>& marks) {
    std::size_t width = 4;
    std::map<std::string, std::size_t> counts;
    for (const serve::Mark& each : marks) {
        width = std::max(width, each.file.size());
        ++counts[each.result];
    }
    std::string out = fmt::format("{:<{}}  {:<17}  {:>12}\n", "file", width, "result", "time [ms]");
    for (const serve::Mark& each : marks)
        out += fmt::format("{:<{}}  {:<17}  {:>12}  {}\n", each.file, width, each.result,
                           each.simulated_ms ? fmt::format("{:.3f}", *each.simulated_ms) : "",
                           each.why.substr(0, each.why.find('\n')));
    out += fmt::format("\n{}:", counted(marks.size(), "mark"));
    for (const auto& [result, count] : counts)
        out += fmt::format(" {} {}{}", count, result, result == counts.rbegin()->first ? "" : ",");
    return out + "\n";
}

ExitCode mark(const MarkOptions& options) {
    const serve::MarkedTask task = task_of(options);
    const auto submissions = serve::submissions_in(options.folder);
    if (!options.csv.empty())
        require_writable(options.csv);
    InterruptedBySignals interruption;
    ProgressLine progress;
    const auto show = [&](std::size_t marked) {
        progress.show(fmt::format("{} of {} marked", marked, submissions.size()));
    };
    auto marks = serve::marks_of(options.folder, submissions, task, options.limits, show, interruption);
    progress.clear();
    const std::size_t marked = marks.size();
    for (const auto& name : serve::folders_without_submission(options.folder, submissions))
        marks.push_back({name.string(), "nothing submitted", {}, ""});
    print_out(print_marks(marks));
    if (interruption.requested()) {
        print_error(fmt::format("interrupted: {} of {} submissions are marked{}\n", marked, submissions.size(),
                                options.csv.empty() ? "" : ", and no file was written"));
        return ExitCode::interrupted;
    }
    if (!options.csv.empty())
        write_whole(options.csv, serve::marks_csv(marks));
    return ExitCode::success;
}

Action declare_mark(Options& command, const std::string&) {
    auto options = std::make_shared<MarkOptions>();
    command.add("FOLDER", options->folder, "folder with programs in occam (.occ); its subfolders are searched, too")
        .required();
    command.add("--exercise", options->exercise, "number of an exercise of the course").type("NUMBER");
    add_file(command, "--expected", options->expected, "file with the expected output of another task");
    add_file(command, "--csv", options->csv, "writes the marks to this file as comma-separated values");
    add_jobs(command, options->limits.at_once,
             "number of submissions that are checked at a time; default: number of cores");
    add_number(command, "--seconds", options->limits.run.seconds, 1, 3600, "seconds that a submission may take")
        .show_default();
    add_number(command, "--memory", options->limits.run.megabytes, 256, 1 << 20, "Mbyte that a submission may take")
        .show_default();
    return [options] { return mark(*options); };
}

} // namespace

extern const Command mark_command{
    .name = "mark",
    .about = "Checks all solutions of an exercise in a folder: output, deadlocks in other orders of execution, time",
    .place = 56,
    .declare = declare_mark,
};

} // namespace placedpar
