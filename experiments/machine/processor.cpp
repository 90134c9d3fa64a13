#include "runtime/hardware/processor.hpp"
#include "experiments/kit/experiment.hpp"
#include "experiments/kit/experiment_runs.hpp"
#include "runtime/channel.hpp"
#include "runtime/fingerprint.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace placedpar {

namespace {

using hardware::Memory;
using hardware::Processor;
using std::chrono::microseconds;

constexpr std::int64_t hertz = 20'000'000;
constexpr Time cycle = duration_of(1, hertz);

struct MovedBlock {
    std::uint32_t bytes;
    WireForm wire_form() const { return WireForm(bytes); }
};

/// Simulates one processor. Each function makes the simulations for one figure.
class OneProcessor {
public:
    explicit OneProcessor(const ReplayContext& context) : context_(context) {}

    /// Returns the rate at which a soft channel copies, in Mbyte/s.
    double copying(Cycles access) {
        constexpr std::uint32_t bytes = 1'000'000;
        Simulation simulation;
        Processor& t800 = simulation.add<Processor>("t800", hertz, Cycles{0}, Memory{.access = access});
        Channel<MovedBlock> soft("soft");
        simulation.process(
            "outputs", [&] { soft.out().output({bytes}); }, &t800);
        simulation.process(
            "inputs", [&] { soft.in().input(); }, &t800);
        return bytes / (1e3 * in_milliseconds(run(simulation)));
    }

    /// Returns the time between two ticks of the clock in microseconds, as a program reads them.
    double tick(Priority priority) {
        Simulation simulation;
        Processor& t800 = simulation.add<Processor>("t800", hertz);
        std::int32_t ticks = 0;
        constexpr Time long_time = std::chrono::seconds{1};
        simulation.process(
            "reads", [&] { wait_until(long_time), ticks = Timer().read(); }, &t800, priority);
        run(simulation);
        return 1e3 * in_milliseconds(long_time) / static_cast<double>(ticks);
    }

    /// Returns the shortest and the longest turn of a process that computes, in timeslice periods. Another process
    /// becomes ready at one of many times during the turn. The turn lasts until the other process has the processor.
    std::pair<double, double> shortest_and_longest_turn() {
        std::vector<double> periods;
        for (std::int64_t start = 1; start < 20'480; start += 640)
            periods.push_back(turn_from(start * cycle));
        auto [least, most] = std::ranges::minmax(periods);
        return {least, most};
    }

    /// Returns the longest wait for the processor, in timeslice periods, of a process that becomes ready repeatedly
    /// while `others` processes compute.
    double longest_wait(int others) {
        Simulation simulation;
        Processor& t800 = simulation.add<Processor>("t800", hertz);
        for (int i = 0; i < others; ++i)
            simulation.process(
                fmt::format("computes {}", i), [] { compute(Cycles{20'000'000}); }, &t800);
        Time longest{};
        simulation.process(
            "asks",
            [&] {
                for (int i = 0; i < 20; ++i) {
                    Time ready = now() + microseconds{10 + 97 * i};
                    wait_until(ready);
                    longest = std::max(longest, now() - ready);
                }
            },
            &t800);
        run(simulation);
        return in_periods(longest);
    }

    /// Returns the longest interrupt latency, in cycles, if the instructions of the interrupted process take this many
    /// cycles.
    std::int64_t longest_latency(Cycles instruction) {
        std::int64_t longest = 0;
        for (std::int64_t moment = 10'000; moment < 10'060; ++moment) {
            Simulation simulation;
            Processor& t800 = simulation.add<Processor>("t800", hertz);
            Time began{};
            simulation.process(
                "high", [&, moment] { wait_until(moment * cycle), began = now(); }, &t800, Priority::high);
            simulation.process(
                "low", [=] { compute(39'000 * Cycles{1}, {.instruction = instruction}); }, &t800);
            run(simulation);
            longest = std::max(longest, began / cycle - moment);
        }
        return longest;
    }

    /// Returns the delay of a crossbar in one direction, in bit times. The delay is half of the time that a switch adds
    /// to a byte and its acknowledge.
    double crossbar_delay() {
        constexpr double bits_per_us = 20;
        double direct = microseconds_a_byte("0"), switched = microseconds_a_byte("1");
        return (switched - direct) / 2 * bits_per_us;
    }

    std::uint64_t fingerprint() const { return fingerprint_.value(); }

private:
    static double in_periods(Time time) {
        return static_cast<double>(time.count()) / static_cast<double>(Processor::timeslice.count());
    }

    double turn_from(Time start) {
        Simulation simulation;
        Processor& t800 = simulation.add<Processor>("t800", hertz);
        Time rival_began{};
        simulation.process(
            "computes", [=] { wait_until(start), compute(Cycles{200'000}); }, &t800);
        simulation.process(
            "rival", [&, start] { wait_until(start + cycle), rival_began = now(); }, &t800);
        run(simulation);
        return in_periods(rival_began - start);
    }

    double microseconds_a_byte(const std::string& switches) {
        RunReport report =
            run_to_the_end(context_.examples / "machine/links" / "link.cfs", {{"switches", switches}}, context_);
        fingerprint_.mix(report.result.fingerprint);
        return 1e3 / report.measured("receiver[0]", "rate");
    }

    Time run(Simulation& simulation) {
        RunResult result = simulation.run();
        fingerprint_.mix(result.fingerprint);
        return result.time;
    }

    const ReplayContext& context_;
    Fingerprint fingerprint_;
};

struct Published {
    const char* source;
    const char* unit;
    double figure;
    double tolerance;
    int decimals;
    Origin origin = Origin::constant;
};

Cell compare(const std::string& name, const Published& published, double simulated) {
    Cell cell = judged_cell(name, "value", published.unit, published.figure, simulated, published.tolerance,
                            published.decimals);
    cell.source = published.source;
    cell.origin = published.origin;
    return cell;
}

constexpr const char* ticks = "INMOS ticks.inc";
constexpr const char* slices = "databook, 1.3: 1 to 2 periods of 1.024 ms";
constexpr const char* waits = "databook, 1.3: 2n - 2 periods with n - 1 others";
constexpr const char* cycles_table = "T4 notebook (pahihu/t4)";

/// Compares the shortest and the longest turns and waits with the databook's bounds, which they must nearly reach.
void compare_turns(OneProcessor& t800, Comparison& comparison) {
    auto [shortest, longest] = t800.shortest_and_longest_turn();
    comparison.add(
        compare("turn beside another, shortest", {slices, "periods", 1, 0.05, 2, Origin::outcome}, shortest));
    comparison.add(compare("turn beside another, longest", {slices, "periods", 2, 0.05, 2, Origin::outcome}, longest));
    for (int others : {1, 3, 7})
        comparison.add(compare(fmt::format("wait beside {} other{}, longest", others, others == 1 ? "" : "s"),
                               {waits, "periods", 2.0 * others, 0.2, 2, Origin::outcome}, t800.longest_wait(others)));
}

void compare_interrupts(OneProcessor& t800, Comparison& comparison) {
    auto add = [&](const char* name, const Published& published, Cycles instruction) {
        comparison.add(compare(name, published, static_cast<double>(t800.longest_latency(instruction))));
    };
    add("interrupt, typical", {cycles_table, "cycles", 19, 0, 0}, Cycles{1});
    add("interrupt of divisions, longest", {cycles_table, "cycles", 58, 1, 0}, Cycles{39});
    add("interrupt of floating point, longest", {"commonly stated", "cycles", 78, 1, 0}, Cycles{78 - 19});
}

Comparison compare_scheduler(OneProcessor& t800) {
    Comparison comparison{.name = "the scheduler", .against = "publ.", .judged = true, .names_origins = true};
    comparison.add(compare("clock of high priority", {ticks, "us", 1, 0.001, 2}, t800.tick(Priority::high)));
    comparison.add(compare("clock of low priority", {ticks, "us", 64, 0.064, 2}, t800.tick(Priority::low)));
    compare_turns(t800, comparison);
    compare_interrupts(t800, comparison);
    return comparison;
}

Comparison compare_memory(OneProcessor& t800) {
    Comparison comparison{.name = "memory and switches", .against = "publ.", .judged = true, .names_origins = true};
    comparison.add(compare("copy outside of the chip", {"T800 databook, block move", "Mbyte/s", 13.3, 0.1, 2},
                           t800.copying(Memory::outside)));
    comparison.add(compare("copy on the chip", {"T4 notebook (pahihu/t4): 2 cycles a word", "Mbyte/s", 40, 0.1, 2},
                           t800.copying(Memory::on_chip)));
    comparison.add(compare("crossbar switch, one way", {"C004 manual", "bits", 1.75, 0.02, 2}, t800.crossbar_delay()));
    return comparison;
}

Replay replay_processor(const ReplayContext& context) {
    context.progress("processor");
    OneProcessor t800(context);
    Replay replay{.comparisons = {compare_scheduler(t800), compare_memory(t800)}};
    replay.constants =
        "the longest floating-point instruction is assumed to take 78 - 19 cycles; a division takes 39 cycles\n";
    replay.fingerprint = t800.fingerprint();
    return replay;
}

} // namespace

extern const Experiment processor_experiment{
    .name = "processor",
    .about = "a transputer's scheduler, its memory and a switch, compared with the databook",
    .chapter = "machine",
    .number = 3,
    .run = replay_processor,
};

} // namespace placedpar
