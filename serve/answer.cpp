#include "serve/answer.hpp"

#include "explore/check/check_file.hpp"
#include "explore/exercise/student_run.hpp"
#include "explore/explain/answers.hpp"
#include "explore/occam_program.hpp"
#include "explore/problems.hpp"
#include "iserver/terminal.hpp"
#include "observe/page/run_page.hpp"
#include "observe/trace/trace_fork.hpp"
#include "occam/configuration/configuration.hpp"
#include "report/run_report.hpp"
#include "report/search_log.hpp"
#include "serve/job_text.hpp"
#include "text/paint.hpp"
#include "text/texts_in_memory.hpp"
#include "text/user_error.hpp"
#include "text/utf8.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace placedpar::serve {

namespace json = boost::json;

namespace {

constexpr std::size_t most_output_bytes = 256u << 10, largest_page_bytes = 8u << 20; ///< values of our choice

struct Loaded {
    ParsedNetlist parsed;
    Network network;
};

/// Reads the job's netlist. For a program in occam, makes a netlist with one transputer.
Loaded load(const Job& job, std::string& warnings) {
    const WarningSink warn = [&warnings](const std::string& text) { warnings += unpainted(text); };
    ParsedNetlist parsed(job.main, {.make_netlist = netlist_maker({})});
    Network network = load_network(parsed, {}, known_kinds(known_problems(0)), warn);
    return {std::move(parsed), std::move(network)};
}

/// Collects what programs write to the screen, and ends the run if they write too much.
class Screen {
public:
    explicit Screen(Interruption& interruption) : interruption_(interruption) {}

    std::function<std::shared_ptr<iserver::Terminal>()> terminal(const std::string& keys) {
        return [this, keys] {
            return std::make_shared<iserver::ScriptedTerminal>(keys, [this](std::string_view text) { print(text); });
        };
    }
    const std::string& output() const { return output_; }

private:
    void print(std::string_view text) {
        output_ += text.substr(0, most_output_bytes - std::min(output_.size(), most_output_bytes));
        if (output_.size() == most_output_bytes)
            interruption_.request();
    }

    Interruption& interruption_;
    std::string output_;
};

/// Returns the host for another run with changed settings. This host presses the same keys as the host of the first
/// run, and discards the output to the screen.
HostServices silent_host(const std::string& keys) {
    HostServices host;
    host.terminal = [keys] { return std::make_shared<iserver::ScriptedTerminal>(keys, [](std::string_view) {}); };
    return host;
}

std::string listings_of(const RunReport& report) {
    std::string all;
    for (const ProgramUse& program : report.programs)
        if (!program.listing.empty())
            all += fmt::format("{}{}\n{}", all.empty() ? "" : "\n", program.name, program.listing);
    return all.empty() ? "no listing: no processor has executed a program in occam\n" : all;
}

void add_page(json::object& answer, RunPage& page, const PageContent& content, std::span<const PathPart> path) {
    std::string html = page.html(content, path);
    if (html.size() > largest_page_bytes)
        answer["page_missing"] = fmt::format("the page of this run has {} Mbyte, but at most {} Mbyte can be shown "
                                             "here; \"placedpar run --page\" writes larger pages",
                                             html.size() >> 20, largest_page_bytes >> 20);
    else
        answer["page"] = std::move(html);
}

/// Runs the network. For the task "explain", also finds out why the run takes so long.
void run(const Job& job, Loaded& loaded, Interruption& interruption, json::object& answer) {
    const Network& network = loaded.network;
    Screen screen(interruption);
    loaded.network.host.terminal = screen.terminal(job.keys);
    loaded.network.host.lists_code = job.task == "listing";
    CriticalPath path;
    RunPage page(network, {});
    TraceFork fork({&path, &page.sink()});
    GenerationLog searches = log_of(network);
    RunReport report =
        run_netlist(network, known_problems(job.seed),
                    {.seed = job.seed, .trace = &fork, .observer = &searches, .interruption = &interruption});
    answer["ended"] = name_of(report.outcome());
    answer["output"] = screen.output();
    answer["report"] = print_report(report, network, searches);
    if (job.task == "listing")
        answer["listing"] = listings_of(report);
    const Manifest manifest{"placedpar serve", job.seed, {}};
    Explanation explanation = explanation_of(std::move(report), path);
    if (job.task == "explain") {
        add_answers(
            explanation, network,
            {loaded.parsed, {}, job.seed, Time::max(), [](std::size_t, std::size_t) {}, silent_host(job.keys), 1},
            interruption);
        answer["explanation"] = print_explanation(explanation, network);
    }
    add_page(answer, page, {network, explanation.report, manifest, searches}, explanation.path);
}

void check_exercise(const Job& job, const Loaded& loaded, Interruption& interruption, json::object& answer) {
    const Exercise exercise = job.expected ? Exercise{"", "", *job.expected} : exercise_of(job.exercise);
    const SolutionVerdict verdict = check_solution(loaded.network, exercise, interruption);
    const bool interrupted = verdict.end == StudentRun::End::interrupted;
    answer["ended"] = interrupted ? "interrupted" : verdict.wrong.empty() ? "solved" : "not solved";
    answer["verdict"] = interrupted ? "the check took too long" : verdict.text();
    answer["result"] = name_of(verdict.end, verdict.wrong);
    if (verdict.end == StudentRun::End::completed)
        answer["simulated_ms"] = std::chrono::duration<double, std::milli>(verdict.time).count();
}

json::array faults_of(const std::string& main) {
    CheckOptions options;
    options.read.make_netlist = occam::netlist_of_configuration;
    json::array faults;
    const CheckedFile checked = check_file(main, known_kinds(known_problems(0)), options);
    for (const Diagnostic& each : checked.diagnostics)
        faults.push_back(diagnostic_json(each, checked.names));
    return faults;
}

json::object answered(const Job& job, Interruption& interruption) {
    TextsInMemory files;
    for (const auto& [name, text] : job.files)
        files.put(name, text);
    const ReadsFromMemory reading(files);
    json::object answer;
    if (job.task == "check") {
        answer["faults"] = faults_of(job.main);
        return answer;
    }
    std::string warnings;
    try {
        Loaded loaded = load(job, warnings);
        if (job.task == "exercise")
            check_exercise(job, loaded, interruption, answer);
        else
            run(job, loaded, interruption, answer);
    } catch (const UserError& refused) {
        answer["ended"] = "refused";
        answer["refused"] = unpainted(refused.what());
        answer["faults"] = faults_of(job.main);
    }
    answer["warnings"] = warnings;
    return answer;
}

/// Returns the answer to a job that an error ended before it had an answer.
std::string failed_answer(const char* ended, const std::string& reason) {
    return json::serialize(json::object{{"ended", ended}, {"refused", reason}});
}

/// Reads the job. Runs nothing yet, so that errors of a run are not taken for errors of the job.
std::optional<Job> job_in(const std::string& text, std::string& wrong) {
    try {
        return job_of(text);
    } catch (const std::invalid_argument& error) {
        wrong = fmt::format("this is not a job: {}", error.what());
        return std::nullopt;
    }
}

} // namespace

std::string answer_of(const std::string& text, std::uint64_t megabytes, Interruption& interruption) {
    try {
        std::string wrong;
        const std::optional<Job> job = job_in(text, wrong);
        if (!job)
            return failed_answer("refused", wrong);
        return as_json(json::serialize(answered(*job, interruption))); // a program may print any bytes
    } catch (const std::bad_alloc&) {
        return failed_answer("refused", fmt::format("the run needs more memory than its limit of {} Mbyte", megabytes));
    } catch (const std::exception& failed) { // for example, a process of the run has failed
        return failed_answer("failed", unpainted(failed.what()));
    }
}

} // namespace placedpar::serve
