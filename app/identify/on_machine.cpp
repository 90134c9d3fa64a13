#include "app/identify/on_machine.hpp"

#include "app/signals.hpp"
#include "explore/netlist_run.hpp"
#include "explore/process_search.hpp"
#include "identification/identification.hpp"
#include "report/run_report.hpp"
#include "text/counted.hpp"
#include "text/output_file.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace placedpar {

using namespace hydraulics;
using namespace identification;

namespace {

constexpr std::size_t most_columns = 8; ///< largest number of searches in a table, so that its lines fit a screen

double seconds(Time time) { return in_milliseconds(time) / 1000; }

/// A sample, and the last generation that the search made with this sample.
struct SampleAnswers {
    double taken_s; ///< time of the sample in the record
    std::size_t generation;
};

std::vector<SampleAnswers> by_sample(const ProcessSearch& search, const SearchAnswers& answers,
                                     std::span<const CircuitSample> samples) {
    std::vector<SampleAnswers> rows;
    for (std::size_t i = 0; (i + 1) * search.trials <= answers.generations(); ++i)
        rows.push_back({samples[search.first - 1 + i].time_s, (i + 1) * search.trials - 1});
    return rows;
}

std::size_t width_of(const std::string& search) { return std::max<std::size_t>(search.size(), 9); }

std::string print_row(const SearchAnswers& answers, const SampleAnswers& row, std::size_t parameter) {
    const std::size_t searches = answers.searches().size(), best = answers.fittest(row.generation);
    std::string line = fmt::format("{:8.3f} {:9.3f}", row.taken_s, seconds(answers.ready(row.generation)));
    auto value = [&](std::size_t search) { return answers.of(search, row.generation).values[parameter]; };
    for (std::size_t search = 0; search < std::min(searches, most_columns); ++search)
        line += fmt::format(" {:>{}.5f}", value(search), width_of(answers.searches()[search]));
    if (searches > 1)
        line += fmt::format(" {:9.5f} {:9.5f}", value(best), answers.spread(row.generation, parameter));
    return line + "\n";
}

/// Prints the answers for one compliance after each sample.
std::string print_course(const SearchAnswers& answers, std::span<const SampleAnswers> rows, std::size_t parameter) {
    const std::vector<std::string>& names = answers.searches();
    std::string text = fmt::format("{} in in^3/psi after each sample:\n taken, s  ready, s",
                                   answers.problem().parameter_names()[parameter]);
    for (std::size_t search = 0; search < std::min(names.size(), most_columns); ++search)
        text += fmt::format(" {:>{}}", names[search], width_of(names[search]));
    if (names.size() > 1)
        text += "   fittest    spread";
    text += '\n';
    for (const SampleAnswers& row : rows)
        text += print_row(answers, row, parameter);
    return text + (names.size() > most_columns
                       ? fmt::format("the first {} of {} searches are shown\n", most_columns, names.size())
                       : "");
}

/// Prints the last answer of the simulated transputers beside the answer of the search on this computer.
std::string print_answer(const SearchAnswers& answers, const Identified& native, std::size_t parameter) {
    const std::size_t last = answers.generations() - 1, best = answers.fittest(last);
    const double here = native.estimates.back().compliance_in3_per_psi[parameter];
    const double there = answers.of(best, last).values[parameter];
    std::string text = fmt::format("{}: {:.5f} in^3/psi from the direct search, {:.5f} from ",
                                   answers.problem().parameter_names()[parameter], here, there);
    if (answers.searches().size() == 1)
        return text + fmt::format("the netlist's processes: {}\n", here == there ? "equal" : "different");
    return text + fmt::format("{}, the fittest of {} searches, which differ by up to {:.5f}\n",
                              answers.searches()[best], answers.searches().size(), answers.spread(last, parameter));
}

std::string print_time(const RunReport& report, std::span<const SampleAnswers> rows, const SearchAnswers& answers,
                       std::span<const CircuitSample> samples) {
    return fmt::format("the last answer is ready {:.3f} s after the first sample is sent; the {} cover {:.3f} s; the "
                       "run ends at {:.3f} s\n",
                       seconds(answers.ready(rows.back().generation)), counted(samples.size(), "sample"),
                       samples.back().time_s - samples.front().time_s, seconds(report.result.time));
}

boost::json::object answers_json(const SearchAnswers& answers, std::span<const SampleAnswers> rows,
                                 const RunReport& report) {
    boost::json::array all;
    for (const auto& [taken_s, generation] : rows) {
        boost::json::array found, spread;
        for (std::size_t search = 0; search < answers.searches().size(); ++search) {
            const auto& values = answers.of(search, generation).values;
            found.push_back(boost::json::array(values.begin(), values.end()));
        }
        for (std::size_t i = 0; i < answers.problem().parameter_names().size(); ++i)
            spread.push_back(answers.spread(generation, i));
        all.push_back(boost::json::object{{"taken_s", taken_s},
                                          {"ready_s", seconds(answers.ready(generation))},
                                          {"fittest", answers.searches()[answers.fittest(generation)]},
                                          {"found", std::move(found)},
                                          {"spread", std::move(spread)}});
    }
    return {{"searches", boost::json::array(answers.searches().begin(), answers.searches().end())},
            {"ended_s", seconds(report.result.time)},
            {"answers", std::move(all)}};
}

/// Returns whether a process of the kind ga.sensors sends each sample at its time in the record. Throws UserError if
/// its period differs from `period_s`.
bool has_sensors(const Network& network, double period_s) {
    auto sensors = std::ranges::find(network.processes, "ga.sensors", &ProcessInstance::kind);
    if (sensors == network.processes.end())
        return false;
    const double period_ms = std::get<double>(sensors->parameters.at("period"));
    if (std::abs(period_ms / (1000 * period_s) - 1) > sampling_tolerance)
        throw UserError(fmt::format("period = {} ms in the netlist for \"{}\", but the samples are {:.4g} ms apart",
                                    period_ms, sensors->name, 1000 * period_s));
    return true;
}

} // namespace

AnswerInTime answer_in_time(const ProcessSearch& search, const ComplianceSearch& prepared, double period_s,
                            std::uint64_t seed) {
    const bool timed = has_sensors(search.network, period_s);
    SearchAnswers answers = search.answers();
    const RunReport report = run_netlist(search.network, search.problems, {.seed = seed, .observer = &answers});
    const std::vector<SampleAnswers> rows = by_sample(search, answers, prepared.samples);
    if (report.outcome() != RunOutcome::completed || rows.empty())
        throw UserError(fmt::format("{}: the processes gave no answer: {} at {:.3f} s", search.network.source_path,
                                    name_of(report.outcome()), seconds(report.result.time)));
    const std::size_t last = rows.back().generation, best = answers.fittest(last);
    AnswerInTime found{answers.of(best, last).values, answers.searches()[best]};
    const double first_s = prepared.samples.front().time_s;
    double before_s = 0, done_s = first_s;
    for (const auto& [taken_s, generation] : rows) {
        const double ready_s = seconds(answers.ready(generation));
        done_s = timed ? first_s + ready_s - period_s : std::max(done_s, taken_s) + ready_s - before_s;
        before_s = ready_s;
        found.sample_s = taken_s;
        found.after_s = done_s - taken_s;
        found.keeps_pace = found.keeps_pace && found.after_s <= period_s;
    }
    return found;
}

ExitCode run_on_machine(const ProcessSearch& search, const Identified& native, const ComplianceSearch& prepared,
                        std::uint64_t seed, boost::json::object& json) {
    InterruptedBySignals interruption;
    SearchAnswers answers = search.answers();
    RunReport report = run_netlist(search.network, search.problems,
                                   {.seed = seed, .observer = &answers, .interruption = &interruption});
    print_out(fmt::format("\n{}\n", print_report(report, search.network)));
    if (report.outcome() != RunOutcome::completed)
        return exit_code_of(report.outcome());
    const std::vector<SampleAnswers> rows = by_sample(search, answers, prepared.samples);
    if (rows.empty()) {
        print_out("the processes gave no answer: their first generation needs more samples than the record has\n");
        return ExitCode::missed_tolerance;
    }
    const std::vector<double>& there =
        answers.of(answers.fittest(rows.back().generation), rows.back().generation).values;
    for (std::size_t i = 0; i < there.size(); ++i)
        print_out(print_course(answers, rows, i) + print_answer(answers, native, i));
    print_out(print_time(report, rows, answers, prepared.samples));
    json["by_processes"] = boost::json::array(there.begin(), there.end());
    json["on_machine"] = answers_json(answers, rows, report);
    const bool same = there == native.estimates.back().compliance_in3_per_psi;
    return same || search.searches.size() > 1 ? ExitCode::success : ExitCode::missed_tolerance;
}

} // namespace placedpar
