#include "explore/exercise/student_run.hpp"

#include "explore/problems.hpp"
#include "iserver/terminal.hpp"
#include "text/counted.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string_view>
#include <vector>

namespace placedpar {

namespace {

constexpr std::chrono::seconds longest_run{10};
constexpr std::size_t most_output = 65536;
constexpr std::uint64_t other_orders = 20; ///< number of process orders in which a solution is tried, besides the
                                           ///< usual one

StudentRun::End end_of(const RunReport& report, bool too_much) {
    if (too_much)
        return StudentRun::End::too_much_output;
    if (std::ranges::any_of(report.programs, &ProgramUse::failed))
        return StudentRun::End::failed;
    switch (report.result.ending) {
    case Ending::completed: return StudentRun::End::completed;
    case Ending::stuck: return StudentRun::End::deadlock;
    case Ending::time_limit: return StudentRun::End::too_long;
    case Ending::interrupted: break;
    }
    return StudentRun::End::interrupted;
}

std::string_view without_last_blanks(std::string_view text) {
    return text.substr(0, text.find_last_not_of(" \t\r") + 1);
}

/// Returns the lines without blanks at their ends. Leaves out empty lines at the end of the text.
std::vector<std::string_view> printed_lines(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.push_back(without_last_blanks(text.substr(0, end)));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    while (!lines.empty() && lines.back().empty())
        lines.pop_back();
    return lines;
}

/// Describes how the output differs from the expected output; "" if they are equal.
std::string difference(const std::string& output, const std::string& expected) {
    const auto printed = printed_lines(output), wanted = printed_lines(expected);
    const auto [at, other] = std::ranges::mismatch(wanted, printed);
    const auto line = at - wanted.begin() + 1;
    if (at != wanted.end() && other != printed.end())
        return fmt::format("line {} of the output is wrong\n  expected: \"{}\"\n  printed:  \"{}\"", line, *at, *other);
    if (at != wanted.end())
        return fmt::format("line {} of the output is missing\n  expected: \"{}\"", line, *at);
    if (other != printed.end())
        return fmt::format("the output has more than {}\n  printed in line {}: \"{}\"", counted(wanted.size(), "line"),
                           line, *other);
    return "";
}

} // namespace

StudentRun run_student_program(const Network& network, std::optional<std::uint64_t> shuffle,
                               Interruption& interruption) {
    StudentRun result;
    bool too_much = false;
    const auto print = [&](std::string_view text) {
        result.output += text;
        if (result.output.size() > most_output && !too_much) {
            too_much = true;
            interruption.request();
        }
    };
    Network served = network;
    served.host.terminal = [&print] { return std::make_shared<iserver::ScriptedTerminal>("", print); };
    const RunReport report = run_netlist(served, known_problems(1),
                                         {.until = longest_run, .shuffle = shuffle, .interruption = &interruption});
    result.end = end_of(report, too_much);
    result.time = report.result.time;
    if (!report.programs.empty())
        result.state = report.programs.front().state;
    return result;
}

std::string what_is_wrong(const StudentRun& made, const std::string& expected) {
    const std::string printed = fmt::format("after {} of output", counted(printed_lines(made.output).size(), "line"));
    switch (made.end) {
    case StudentRun::End::completed: return difference(made.output, expected);
    case StudentRun::End::failed: return fmt::format("the program {}, {}", made.state, printed);
    case StudentRun::End::deadlock:
        return fmt::format("the program is in a deadlock at {}, {}: its processes wait for each other, or for a "
                           "process that has ended",
                           to_string(made.time), printed);
    case StudentRun::End::too_long:
        return fmt::format("the program has not ended after {} s of simulated time, {}", longest_run.count(), printed);
    case StudentRun::End::too_much_output:
        return fmt::format("the program prints more than {} bytes, but the expected output has {}", most_output,
                           expected.size());
    case StudentRun::End::interrupted: break;
    }
    return "";
}

std::string SolutionVerdict::text() const {
    return wrong.empty() ? fmt::format("solved; also with {} other orders of its processes", other_orders)
                         : "not solved: " + wrong;
}

const char* name_of(StudentRun::End end, const std::string& wrong) {
    switch (end) {
    case StudentRun::End::completed: return wrong.empty() ? "solved" : "wrong output";
    case StudentRun::End::failed: return "failed";
    case StudentRun::End::deadlock: return "deadlock";
    case StudentRun::End::too_long: return "too long";
    case StudentRun::End::too_much_output: return "too much output";
    case StudentRun::End::interrupted: break;
    }
    return "interrupted";
}

namespace {

std::string only_in_order(std::uint64_t order, const std::string& wrong) {
    return fmt::format(
        "the program is right in the usual order of its processes, but not in every order\nwith --shuffle {}, {}",
        order, wrong);
}

} // namespace

SolutionVerdict check_solution(const Network& network, const Exercise& exercise, Interruption& interruption) {
    Time usual{};
    for (std::uint64_t order = 0; order <= other_orders; ++order) {
        const StudentRun made =
            run_student_program(network, order == 0 ? std::nullopt : std::optional(order), interruption);
        usual = order == 0 ? made.time : usual;
        std::string wrong = what_is_wrong(made, exercise.expected);
        if (order > 0 && !wrong.empty())
            wrong = only_in_order(order, wrong);
        if (!wrong.empty() || made.end == StudentRun::End::interrupted)
            return {made.end, wrong, usual};
    }
    return {StudentRun::End::completed, "", usual};
}

} // namespace placedpar
