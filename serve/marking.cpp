#include "serve/marking.hpp"

#include "text/load_source.hpp"
#include "text/nearest.hpp"
#include "text/user_error.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/json.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <map>

namespace placedpar::serve {

namespace fs = std::filesystem;
namespace json = boost::json;

namespace {

constexpr std::chrono::milliseconds patience{50}; ///< time between two checks for an interruption

/// Returns the text of a file. Throws RefusedInput if it is not a text.
std::string text_in(const fs::path& file) {
    const LoadedSource source = load_source(file);
    if (!source.problems.empty())
        throw RefusedInput(render(source.problems));
    return source.file->text();
}

std::string job_text(const fs::path& folder, const fs::path& submission, const MarkedTask& task) {
    json::object files{{submission.filename().string(), text_in(folder / submission)}};
    for (const fs::directory_entry& each : fs::directory_iterator((folder / submission).parent_path()))
        if (each.path().extension() == ".inc" && each.is_regular_file() && !each.is_symlink())
            files[each.path().filename().string()] = text_in(each.path());
    json::object job{{"do", "exercise"}, {"main", submission.filename().string()}, {"files", std::move(files)}};
    if (task.expected)
        job["expected"] = *task.expected;
    else
        job["exercise"] = task.exercise;
    return json::serialize(job);
}

std::string text_of(const json::object& answer, const char* name) {
    const json::value* found = answer.if_contains(name);
    return found ? std::string(found->as_string()) : "";
}

/// Makes the mark from the answer to a job (serve/answer.hpp).
Mark mark_of(const fs::path& submission, const std::string& answer, const RunLimits& limits) {
    const json::object object = json::parse(answer).as_object();
    Mark mark{submission.string(), text_of(object, "result"), {}, text_of(object, "verdict")};
    if (mark.result.empty()) // the program did not run
        return {submission.string(), text_of(object, "ended"), {}, text_of(object, "refused")};
    if (mark.result == "interrupted")
        return {
            submission.string(),
            "out of time",
            {},
            fmt::format("the check took longer than {} s of this computer's time; a longer limit (--seconds) or fewer "
                        "submissions at a time (--jobs) may help",
                        limits.seconds)};
    if (mark.result == "solved")
        mark.why.clear();
    if (const json::value* time = object.if_contains("simulated_ms"))
        mark.simulated_ms = time->to_number<double>();
    return mark;
}

std::string quoted(std::string text) {
    for (std::size_t at = 0; (at = text.find('"', at)) != std::string::npos; at += 2)
        text.insert(at, 1, '"');
    return '"' + text + '"';
}

/// Marks submissions until all are marked, or until an interruption.
class Marking {
public:
    Marking(const QueueLimits& limits, const Interruption& interruption)
        : limits_(limits.run), runs_(io_, limits), interruption_(interruption) {}

    void add(std::size_t index, const fs::path& folder, const fs::path& submission, const MarkedTask& task,
             const std::function<void(std::size_t)>& progress) {
        const auto keep = [this, index, progress](const Mark& mark) {
            marks_.emplace(index, mark);
            progress(marks_.size());
        };
        try {
            const std::string job = job_text(folder, submission, task);
            runs_.add(
                submission.string(), "", false, [job] { return job; },
                [this, keep, submission](const std::string& answer) { keep(mark_of(submission, answer, limits_)); });
        } catch (const UserError& refused) {
            keep({submission.string(), "refused", {}, refused.what()});
        } catch (const fs::filesystem_error& unreadable) {
            keep({submission.string(), "refused", {}, unreadable.what()});
        }
    }

    std::vector<Mark> run(std::size_t submissions) {
        while (marks_.size() < submissions && !interruption_.requested())
            io_.run_one_for(patience);
        std::vector<Mark> marks;
        for (auto& [index, mark] : marks_)
            marks.push_back(std::move(mark));
        return marks;
    }

private:
    RunLimits limits_;
    boost::asio::io_context io_;
    std::map<std::size_t, Mark> marks_; ///< key: index of the submission
    Runs runs_;
    const Interruption& interruption_;
};

} // namespace

std::vector<fs::path> submissions_in(const fs::path& folder) {
    std::error_code error;
    std::vector<fs::path> found;
    for (fs::recursive_directory_iterator each(folder, error), end; !error && each != end; each.increment(error))
        if (lower_case(each->path().extension().string()) == ".occ" && each->is_regular_file(error) &&
            !each->is_symlink(error))
            found.push_back(each->path().lexically_relative(folder));
    if (error)
        throw UserError(
            fmt::format("{}: {}; expected a folder of programs in occam", folder.string(), error.message()));
    if (found.empty())
        throw UserError(fmt::format("{}: this folder has no submission; a submission is a program in occam, with a "
                                    "name such as mine.occ",
                                    folder.string()));
    std::ranges::sort(found);
    return found;
}

std::vector<fs::path> folders_without_submission(const fs::path& folder, const std::vector<fs::path>& submissions) {
    std::vector<fs::path> without;
    for (const fs::directory_entry& each : fs::directory_iterator(folder)) {
        const fs::path name = each.path().filename();
        const auto is_inside = [&](const fs::path& submission) { return *submission.begin() == name; };
        if (each.is_directory() && std::ranges::none_of(submissions, is_inside))
            without.push_back(name);
    }
    std::ranges::sort(without);
    return without;
}

std::vector<Mark> marks_of(const fs::path& folder, const std::vector<fs::path>& submissions, const MarkedTask& task,
                           const QueueLimits& limits, const std::function<void(std::size_t)>& progress,
                           const Interruption& interruption) {
    QueueLimits unlimited = limits;
    unlimited.most_waiting = unlimited.most_waiting_of_peer = std::numeric_limits<std::size_t>::max();
    Marking marking(unlimited, interruption);
    for (std::size_t i = 0; i < submissions.size(); ++i)
        marking.add(i, folder, submissions[i], task, progress);
    return marking.run(submissions.size());
}

std::string marks_csv(const std::vector<Mark>& marks) {
    std::string out = "file,result,simulated_ms,why\n";
    for (const Mark& each : marks)
        out += fmt::format("{},{},{},{}\n", quoted(each.file), each.result,
                           each.simulated_ms ? fmt::format("{:.6f}", *each.simulated_ms) : "", quoted(each.why));
    return out;
}

} // namespace placedpar::serve
