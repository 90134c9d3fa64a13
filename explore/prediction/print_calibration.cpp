#include "explore/prediction/calibration.hpp"
#include "native/group.hpp"
#include "native/rank_member.hpp"

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

double nanoseconds(Time time) { return std::chrono::duration<double, std::nano>(time).count(); }

/// Returns the time until a sleeping thread has woken. If this time exceeds a thread's patience (the time for which it
/// polls before it sleeps), the sender of a message falls asleep before the answer comes. A message there and back then
/// takes this time twice.
double waking_ns(const Calibration& c) {
    const double both = std::max(c.across_asleep.median - c.threads.across.median, 0.0);
    return both > nanoseconds(native::most_patience) ? both / 2 : both;
}

/// Returns the size of an individual in the model, in bytes, with which copying takes as long as in the measurement.
/// The model copies each byte four times, at 1.5 cycles: into and out of the task, into and out of the result.
std::int64_t string_bytes(const Calibration& c) {
    constexpr double copies = 4 * 1.5;
    return std::clamp<std::int64_t>(std::llround(static_cast<double>(cycles(c.string.median)) / copies), 1, 65536);
}

/// Returns the definition of `name`: a core, or a rank of mpirun. `sleep` is the parameter with the cost of its sleep,
/// such as "waking = 5". A message there and back within one core takes four inputs or outputs and two switches.
/// Between two cores it takes two switches, and two inputs or outputs that follow each other.
std::string print_core(const MessageCosts& c, Time patience, const std::string& sleep, const char* name) {
    const double within = (c.there_and_back.median - 2 * c.switching.median) / 4;
    const double across = c.across.median / 2 - c.switching.median;
    return fmt::format("define core (clock = {}M, channelcall = {}, crossing = {}, switching = {},\n"
                       "             patience = {}, {}) {};\n",
                       static_cast<std::int64_t>(cycles_in_a_nanosecond * 1000), cycles(within), cycles(across),
                       cycles(c.switching.median), cycles(nanoseconds(patience)), sleep, name);
}

std::string print_memory(const MessageCosts& c, const char* name) {
    const double per_second = 1024e9 / std::max(c.kilobyte.median, 1.0);
    return fmt::format("define shared_memory (byterate = {}) {};\n", std::llround(per_second), name);
}

std::string print_threads(const Calibration& c) {
    return print_core(c.threads, native::most_patience, fmt::format("waking = {}", cycles(waking_ns(c))), "this_core") +
           print_memory(c.threads, "this_memory");
}

std::string print_ranks(const Calibration& c) {
    const std::int64_t oversleeping = std::max<std::int64_t>(cycles(c.oversleeping.median), 1);
    return "\n/* the ranks of mpirun, and the network between them */\n" +
           print_core(*c.ranks, native::most_patience_of_rank, fmt::format("oversleeping = {}", oversleeping),
                      "this_rank") +
           print_memory(*c.ranks, "this_network");
}

std::string comment_on(const MessageCosts& c, const std::string& one) {
    const std::string two = one + "s that are awake";
    return fmt::format("   a switch to the next process            {}\n"
                       "   a message there and back in a {:<10}{}\n"
                       "   ... between two {:<24}{}\n"
                       "   1024 bytes from {:<24}{}\n",
                       interval(c.switching), one, interval(c.there_and_back), two, interval(c.across),
                       one + " to " + one, interval(c.kilobyte));
}

std::string print_problem(const ProblemCost& cost) {
    return fmt::format("\n/* {0}: an error {1}, breeding an individual {2} */\nval {3} {4};\nval {5} {6};\n",
                       cost.problem, interval(cost.error), interval(cost.individual),
                       val_of_problem("error", cost.problem), cycles(cost.error.median),
                       val_of_problem("individual", cost.problem), cycles(cost.individual.median));
}

} // namespace

bool Calibration::is_disturbed() const {
    return threads.across.median > 2 * nanoseconds(native::most_patience) ||
           (ranks && ranks->across.median > 2 * nanoseconds(native::most_patience_of_rank));
}

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
        "   100 cases. A cycle is {:.1g} ns.\n\n{}"
        "   a message there and back, both asleep   {}\n"
        "   an individual sent and its result       {}\n",
        c.date, c.processor, c.repetitions, 1 / cycles_in_a_nanosecond, comment_on(c.threads, "thread"),
        interval(c.across_asleep), interval(c.string));
    if (c.ranks)
        text += fmt::format("\n   Ranks of mpirun:\n{}   a pause of 20 us is longer by           {}\n",
                            comment_on(*c.ranks, "rank"), interval(c.oversleeping));
    text += "*/\n\n" + print_threads(c);
    if (c.ranks)
        text += print_ranks(c);
    text += fmt::format("\nval individual_bytes {};\n", string_bytes(c));
    for (const ProblemCost& problem : c.problems)
        text += print_problem(problem);
    return text;
}

} // namespace placedpar
