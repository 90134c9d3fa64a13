#include "explore/explain/what_if.hpp"

#include "explore/problems.hpp"
#include "explore/runs_at_once.hpp"
#include "text/paint.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace placedpar {

namespace {

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

void run(Answer& answer, const WhatIfs& what_ifs, Interruption& interruption, CriticalPath* path) {
    RunReport report =
        run_netlist(what_ifs.read(answer.change.set), known_problems(what_ifs.seed),
                    {.seed = what_ifs.seed, .until = what_ifs.until, .trace = path, .interruption = &interruption});
    answer.outcome = report.outcome();
    answer.time = report.result.time;
}

std::map<std::string, Time> time_by_part(const std::vector<PathPart>& parts) {
    std::map<std::string, Time> times;
    for (const PathShare& share : shares_of(parts))
        times[name_of(share)] = share.time;
    return times;
}

/// Returns the activity whose time on the critical path has grown most.
std::string greatest_increase(const std::vector<PathPart>& before, const std::vector<PathPart>& after) {
    std::map<std::string, Time> more = time_by_part(after);
    for (const auto& [name, time] : time_by_part(before))
        more[name] -= time;
    auto most = std::ranges::max_element(more, {}, [](const auto& each) { return each.second; });
    return fmt::format("+{:.3f} ms {}", in_milliseconds(most->second), most->first);
}

void try_out(Answer& answer, const std::vector<PathPart>& path, const WhatIfs& what_ifs, Interruption& interruption) {
    try {
        run(answer, what_ifs, interruption, nullptr);
        if (!answer.completed() || path.empty() || answer.time <= path.back().end || !differs(answer, path.back().end))
            return;
        CriticalPath changed;
        run(answer, what_ifs, interruption, &changed);
        if (!changed.too_long())
            answer.why = greatest_increase(path, changed.parts());
    } catch (const UserError& refused) {
        answer.refused = first_line(unpainted(refused.what()));
    }
}

auto rank(const Answer& answer) { return std::tuple(!answer.refused.empty(), answer.outcome, answer.time); }

} // namespace

bool differs(const Answer& answer, Time unchanged) {
    return !answer.completed() || std::chrono::abs(answer.time - unchanged) >= unchanged / 1000;
}

std::vector<Answer> try_out(const std::vector<Change>& changes, const std::vector<PathPart>& path,
                            const WhatIfs& what_ifs) {
    std::vector<Answer> answers;
    for (const Change& change : changes)
        answers.push_back({change});
    auto work = [&](std::size_t i, Interruption& interruption) { try_out(answers[i], path, what_ifs, interruption); };
    run_at_once(
        answers.size(), work, what_ifs.interruption, [&](std::size_t done) { what_ifs.progress(done, answers.size()); },
        what_ifs.at_once);
    std::erase_if(answers, [](const Answer& answer) {
        return answer.refused.empty() && answer.outcome == RunOutcome::interrupted;
    });
    std::ranges::stable_sort(answers, {}, rank);
    return answers;
}

} // namespace placedpar
