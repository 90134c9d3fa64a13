#include "app/options/many_runs.hpp"

#include "text/counted.hpp"
#include "text/nearest.hpp"
#include "text/output_file.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <poll.h>
#include <unistd.h>

#include <iostream>
#include <utility>

namespace placedpar {

std::string print_duration(double seconds) {
    constexpr std::pair<double, const char*> units[] = {{365.25 * 86400, "year"}, {86400, "day"}, {3600, "hour"}};
    for (const auto& [length, name] : units)
        if (seconds >= 2 * length)
            return counted(static_cast<std::size_t>(seconds / length), name);
    return seconds >= 120 ? fmt::format("{:.0f} min", seconds / 60) : fmt::format("{:.0f} s", seconds);
}

std::string print_count(std::uint64_t count) {
    std::string digits = std::to_string(count);
    for (std::size_t i = digits.size(); i > 3; i -= 3)
        digits.insert(i - 3, ",");
    return digits;
}

namespace {

/// The time between two checks for a signal. A signal just before a wait does not interrupt the wait.
constexpr int often_ms = 100;

/// Waits until there is an answer or the input ends. Returns false if interrupted.
bool wait_for_answer(const Interruption& interruption) {
    pollfd answers{STDIN_FILENO, POLLIN, 0};
    while (!interruption.requested())
        if (::poll(&answers, 1, often_ms) > 0)
            return true;
    return false;
}

} // namespace

bool are_meant(const RunsAhead& ahead, const Interruption& interruption) {
    std::string many = fmt::format("{}{} runs", ahead.exact ? "" : "up to ", print_count(ahead.runs));
    if (auto seconds = ahead.seconds_a_run)
        many +=
            fmt::format(" of about {:.3g} s, {} on {}", *seconds,
                        print_duration(*seconds * static_cast<double>(ahead.runs) / static_cast<double>(ahead.at_once)),
                        counted(ahead.at_once, "core"));
    if (::isatty(STDIN_FILENO) == 0 || ::isatty(STDERR_FILENO) == 0)
        throw UserError(many + "; add --yes to start them");
    print_error(fmt::format("{}. Begin? [y/N] ", many));
    std::string answer;
    if (!wait_for_answer(interruption) || !std::getline(std::cin, answer))
        print_error("\n"); // the user typed no newline, so end the prompt's line here
    return lower_case(answer).starts_with("y");
}

} // namespace placedpar
