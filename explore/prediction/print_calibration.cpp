#include "explore/prediction/calibration.hpp"
#include "native/group.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <iterator>

namespace placedpar {

namespace {

std::int64_t cycles(double nanoseconds) { return std::llround(std::max(nanoseconds, 0.0) * cycles_in_a_nanosecond); }

std::string interval(const MeasuredCost& cost) {
    return fmt::format("{:.4g} ns ({:.4g} to {:.4g})", cost.median, cost.low, cost.high);
}

double patience_ns() { return std::chrono::duration<double, std::nano>(native::most_patience).count(); }

/// Returns the time until a thread has woken. If it is longer than the patience of a thread, the sender of a message
/// falls asleep before the answer comes, and the message there and back waits twice.
double waking_ns(const Calibration& c) {
    const double both = std::max(c.across_asleep.median - c.across.median, 0.0);
    return both > patience_ns() ? both / 2 : both;
}

/// Returns the bytes of an individual whose copies in the model take as long as was measured. The model copies them
/// four times, at 1.5 cycles a byte: into and out of the task, into and out of the result.
std::int64_t string_bytes(const Calibration& c) {
    constexpr double copies = 4 * 1.5;
    return std::clamp<std::int64_t>(std::llround(static_cast<double>(cycles(c.string.median)) / copies), 1, 65536);
}

/// Returns the declaration of the cores. A message there and back in a thread is four inputs or outputs and two
/// switches; between threads, two switches and two inputs or outputs one after the other.
std::string print_core(const Calibration& c) {
    const double in_thread = (c.there_and_back.median - 2 * c.switching.median) / 4;
    const double across = c.across.median / 2 - c.switching.median;
    return fmt::format("define core (clock = {}M, channelcall = {}, crossing = {}, switching = {},\n"
                       "             patience = {}, waking = {}) this_core;\n",
                       static_cast<std::int64_t>(cycles_in_a_nanosecond * 1000), cycles(in_thread), cycles(across),
                       cycles(c.switching.median), cycles(patience_ns()), cycles(waking_ns(c)));
}

std::string print_memory(const Calibration& c) {
    const double per_second = 1024e9 / std::max(c.kilobyte.median, 1.0);
    return fmt::format("define shared_memory (byterate = {}) this_memory;\n", std::llround(per_second));
}

std::string print_problem(const ProblemCost& cost) {
    return fmt::format("\n/* {0}: an error {1}, breeding an individual {2} */\nval {3} {4};\nval {5} {6};\n",
                       cost.problem, interval(cost.error), interval(cost.individual),
                       val_of_problem("error", cost.problem), cycles(cost.error.median),
                       val_of_problem("individual", cost.problem), cycles(cost.individual.median));
}

} // namespace

bool Calibration::is_disturbed() const { return across.median > 2 * patience_ns(); }

std::string val_of_problem(const std::string& what, const std::string& problem) {
    std::string name = what + "_";
    for (const char c : problem)
        if (std::isalnum(static_cast<unsigned char>(c)))
            name += c;
        else if (c == '.')
            name += "_point_";
        else if (name.back() != '_' && c != ')')
            name += '_';
    return name;
}

std::string print_calibration(const Calibration& c) {
    std::string text = fmt::format(
        "/* What native runs cost on this computer, measured by placedpar calibrate on {}.\n"
        "   Processor: {}.\n"
        "   Each cost is the median of {} measurements, with the interval that encloses the true median in 95 of\n"
        "   100 cases. A cycle is {:.1g} ns.\n\n"
        "   a switch to the next process            {}\n"
        "   a message there and back in a thread    {}\n"
        "   ... between two threads that are awake  {}\n"
        "   ... between two threads that sleep      {}\n"
        "   1024 bytes from thread to thread        {}\n"
        "   an individual sent and its result       {} */\n\n",
        c.date, c.processor, c.repetitions, 1 / cycles_in_a_nanosecond, interval(c.switching),
        interval(c.there_and_back), interval(c.across), interval(c.across_asleep), interval(c.kilobyte),
        interval(c.string));
    text += print_core(c) + print_memory(c);
    text += fmt::format("val individual_bytes {};\n", string_bytes(c));
    for (const ProblemCost& problem : c.problems)
        text += print_problem(problem);
    return text;
}

} // namespace placedpar
