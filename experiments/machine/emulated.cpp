#include "experiments/kit/experiment.hpp"
#include "runtime/fingerprint.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"
#include "runtime/transputer/assembler.hpp"
#include "runtime/transputer/byte_lane.hpp"
#include "runtime/transputer/node.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <list>
#include <map>
#include <optional>
#include <span>
#include <vector>

// This experiment measures transputers that execute their own code. Times are measured in one of two ways: a program
// reads the transputer's clock, or a watcher notes when instructions begin.

namespace placedpar {

namespace {

using transputer::Assembly;
using transputer::Core;
using transputer::Model;
using transputer::NodeMemory;
using transputer::Word;

constexpr std::int64_t emulated_hertz = 20'000'000;
constexpr Time emulated_cycle = duration_of(1, emulated_hertz);
constexpr Word code_on_chip = transputer::most_negative + 0x80, code_outside = transputer::most_negative + 0x10000,
               workspace_on_chip = transputer::most_negative + 0xE00;

/// A T800 that executes a program and has no wires.
class EmulatedProgram final : private transputer::LinkEngines, private Core::Watcher {
public:
    /// `priority` is the priority of the program: 0 is high, 1 is low.
    EmulatedProgram(const std::string& source, int priority, Word origin = code_on_chip)
        : program_(transputer::assemble(source, origin, Model::t800)),
          core_(Model::t800, 0x40000, {.clock_hz = emulated_hertz}, *this) {
        core_.copy_to_memory(NodeMemory::offset_of(origin), program_.bytes);
        transputer::Registers registers;
        registers.instruction = origin;
        registers.workspace = workspace_on_chip;
        core_.set_registers(registers, priority);
    }

    /// Registers a function that is called whenever the instruction at the label begins.
    void watch(const std::string& label, std::function<void()> f) {
        watched_[program_[label]] = std::move(f);
        core_.watch(this);
    }
    void run(Time limit = std::chrono::seconds{1}) {
        while (now() < limit && core_.stopped() == transputer::Stopped::nothing)
            if (core_.run(core_.half_cycle_at(limit)) == Core::Pause::idle) {
                if (core_.next_timer() == Time::max())
                    return;
                core_.pass_idle_time(std::max(core_.next_timer(), now()));
            }
    }
    Time now() const { return core_.local_time(); }
    /// Returns a word of the program's workspace.
    std::int64_t word(int number) const {
        const Word offset = NodeMemory::offset_of(workspace_on_chip) + 4 * static_cast<Word>(number);
        return static_cast<std::int32_t>(core_.memory().word(offset));
    }

private:
    void begin_transfer(int, Word, Word) override {}
    bool byte_waits(int) override { return false; }
    void reset(int) override {}
    void begins(Word at) override {
        if (const auto found = watched_.find(at); found != watched_.end())
            found->second();
    }
    void executed(Word, transputer::HalfCycles) override {}

    Assembly program_;
    Core core_;
    std::map<Word, std::function<void()>> watched_;
};

// Interrupts

/// In this program, a process of high priority waits for ticks of its clock. When it continues, it interrupts a program
/// of low priority.
constexpr const char* interrupts = R"(
           ldc 0; sttimer
  started: ldc low - here; ldpi                                    -- a process of low priority, at W - 40
     here: stl -41; ldlp -40; adc 1; runp
     wait: ldl 1; adc 7; stl 1; ldc 0; ldl 1; ldc 31; and; shl    -- takes a varying time
           ldtimer; adc 9; ldl 1; ldc 15; and; add; stl 2; ldl 2   -- a varying number of ticks later
           tin                                                     -- waits for the tick after this time
    woken: j wait
      low: {}
           j low
)";

/// Returns the latencies of many interrupts of a program, in cycles and in ascending order. A latency is the time from
/// the tick that ends a wait to the first instruction after the wait.
std::vector<std::int64_t> latencies_beside(const char* low_program) {
    EmulatedProgram t800(fmt::format(interrupts, low_program), 0);
    Time clock_began{};
    std::vector<std::int64_t> cycles;
    t800.watch("started", [&] { clock_began = t800.now(); });
    t800.watch("woken", [&] {
        const Time tick = clock_began + (t800.word(2) + 1) * hardware::Processor::high_tick;
        cycles.push_back((t800.now() - tick) / emulated_cycle);
    });
    t800.run(std::chrono::milliseconds{50});
    std::ranges::sort(cycles);
    return cycles;
}

constexpr const char* of_one_cycle = "ldc 0; ldc 1; ldc 2; ldc 3; ldc 4; ldc 5; ldc 6; ldc 7; ldc 8; ldc 9; ldc 10";
constexpr const char* divisions = "ldc 60; ldc 7; div; ldc 0; ldc 0";
/// Operations on reals in the sequences that compilers emit: a root, a quotient, a remainder.
constexpr const char* operations_on_reals = R"(
           ldc 7; stl 0; ldlp 0; fpi32tor64; fpusqrtfirst; fpusqrtstep; fpusqrtstep; fpusqrtlast; ldlp 2; fpstnldb
           ldlp 0; fpi32tor64; ldlp 0; fpi32tor64; fpdiv; ldlp 2; fpstnldb
           ldlp 0; fpi32tor64; ldlp 0; fpi32tor64; fpremfirst; eqc 0; cj whole
     more: fpremstep; cj more
    whole: ldlp 2; fpstnldb
)";

double typical_latency_beside(const char* program) {
    const auto cycles = latencies_beside(program);
    return static_cast<double>(cycles.at(cycles.size() / 2));
}

double longest_latency_beside(const char* program) { return static_cast<double>(latencies_beside(program).back()); }

// Turns

/// In this program, processes that compute become ready after a delay. Then the process `asks` becomes ready, and has
/// to wait behind them for its turn.
constexpr const char* turns = R"(
           ldc {}; stl 2; ldc 0; stl 1
    delay: ldlp 1; ldc over - delay; lend
     over: {}
           ldc asks - last; ldlp -20; startp
     last: stopp
 computes: j computes
     asks: stopp
)";

/// Returns how long a process waits, from the moment at which it becomes ready until it begins, in timeslice periods.
/// `others` processes that compute become ready after `delay` turns of a loop, just before this process.
double wait_beside(int others, int delay) {
    std::string starts;
    for (int i = 0; i < others; ++i)
        starts += fmt::format("ldc computes - s{0}; ldlp -{1}; startp\ns{0}:\n", i, 40 + 20 * i);
    EmulatedProgram t800(fmt::format(turns, delay, starts), 1);
    Time ready{}, began{};
    t800.watch("last", [&] { ready = t800.now(); });
    t800.watch("asks", [&] { began = t800.now(); });
    while (began == Time{})
        t800.run(t800.now() + hardware::Processor::timeslice);
    return static_cast<double>((began - ready).count()) / static_cast<double>(hardware::Processor::timeslice.count());
}

/// Returns the results of wait_beside() for many delays of up to a timeslice period, in ascending order.
std::vector<double> waits_beside(int others) {
    std::vector<double> periods;
    for (int delay = 1; delay < 1720; delay += delay < 1680 ? 110 : 4) // a turn takes 12 cycles; a timeslice period has
                                                                       // 20,480
        periods.push_back(wait_beside(others, delay));
    std::ranges::sort(periods);
    return periods;
}

// Memory

/// This program reads the clock before and after many turns of a loop.
constexpr const char* timed_loop = R"(
           ldc 0; sttimer; ldc 0; stl 1; ldc {}; stl 2; ldtimer; stl 3
     turn: {}
           ldlp 1; ldc over - turn; lend
     over: ldtimer; ldl 3; diff; stl 4; stopp
)";

/// Returns the cycles of one turn of a loop, from the ticks of the low-priority clock between two readings.
double cycles_for_each(int turns_of_loop, std::int64_t ticks) {
    return static_cast<double>(ticks * (hardware::Processor::low_tick / emulated_cycle)) / turns_of_loop;
}

/// Returns the cycles that one turn of a loop takes: the cycles of the given instructions and of the loop itself.
double cycles_of_turn(const std::string& body, Word origin = code_on_chip) {
    constexpr int turns_of_loop = 20'000;
    EmulatedProgram t800(fmt::format(timed_loop, turns_of_loop, body), 1, origin);
    t800.run(std::chrono::seconds{10});
    return cycles_for_each(turns_of_loop, t800.word(4));
}

/// Returns the rate at which the instruction `move` copies, in Mbyte/s. The rate follows from the difference between
/// the times for 1024 and 512 bytes, so that fixed costs cancel.
double move_rate(const char* source, const char* target) {
    const auto cycles = [&](int bytes) {
        return cycles_of_turn(fmt::format("{}; {}; ldc {}; move; ldc 0; ldc 0", source, target, bytes));
    };
    return 512 * (emulated_hertz / 1e6) / (cycles(1024) - cycles(512));
}

/// Returns the additional cycles for a word of code that is fetched from external memory.
double cycles_of_fetching() {
    const std::string words = "ldc 0; ldc 1; ldc 2; ldc 3; ldc 4; ldc 5; ldc 6; ldc 7; "
                              "ldc 8; ldc 9; ldc 10; ldc 11; ldc 12; ldc 13; ldc 14; ldc 15; ";
    const auto four_words = [&](Word origin) {
        return cycles_of_turn(words + words, origin) - cycles_of_turn(words, origin);
    };
    return (four_words(code_outside) - four_words(code_on_chip)) / 4;
}

// Communication

/// P. Welch's program COMMSTIME, as compiled by INMOS's compiler. It measures the time of a communication. Four
/// processes pass a number round, and one of them makes two outputs in parallel.
constexpr const char* commstime = R"(
           ldc 0; sttimer; mint; stl 3; mint; stl 5; mint; stl 4; mint; stl 2      -- channels a, b, c, d
           ldc delta - one; ldlp -8; startp
      one: ldc succ - two; ldlp -18; startp
      two: ldc consumer - three; ldlp -31; startp
    three: ajw -2; ldlp 5; ldc 0; outword                          -- a ! 0
   prefix: ldlp 1; ldlp 7; ldc 4; in; ldlp 5; ldl 1; outword       -- b ? x; a ! x
           j prefix
    delta: ldlp 2; ldlp 11; ldc 4; in                              -- a ? x
           ldc 2; stl 1; ldc joined - next; ldpi                   -- PAR
     next: stl 0; ldc other - started; ldlp -5; startp
  started: ajw -1; ldlp 13; ldl 3; outword; ldlp 1; endp           -- c ! x
    other: ldlp 15; ldl 7; outword; ldlp 5; endp                   -- d ! x
   joined: j delta
     succ: ldlp 1; ldlp 22; ldc 4; in; ldlp 23; ldl 1; adc 1; outword
           j succ                                                  -- c ? x; b ! x + 1
 consumer: ldc 0; stl 1; ldc 10000; stl 2; ldtimer; stl 3
     each: ldlp 0; ldlp 33; ldc 4; in                              -- d ? x
           ldlp 1; ldc end - each; lend
      end: ldtimer; ldl 3; diff; stl 36; stopp                     -- W + 5 of the first process
)";

double cycles_of_commstime() {
    EmulatedProgram t800(commstime, 1);
    t800.run();
    return cycles_for_each(10'000, t800.word(5));
}

/// Boots a transputer: sends it the bytes of its program over a link.
class BootBytes final : public transputer::ByteEnd {
public:
    explicit BootBytes(const Assembly& program) : bytes_{static_cast<std::uint8_t>(program.bytes.size())} {
        bytes_.insert(bytes_.end(), program.bytes.begin(), program.bytes.end());
    }
    void give() { out->give(static_cast<std::uint32_t>(bytes_.size())); }

private:
    void read(std::span<std::uint8_t> to) override {
        for (std::uint8_t& byte : to)
            byte = bytes_[read_++];
    }
    void given() override {}
    void write(std::span<const std::uint8_t>) override {}
    void taken() override {}
    void byte_waits() override {}

    std::vector<std::uint8_t> bytes_;
    std::size_t read_ = 0;
};

constexpr int message_bytes = 400'000;
constexpr const char* in_parallel = R"(
           ldc 2; stl 1; ldc joined - next; ldpi
     next: stl 0; ldl 4; ldc #80000; bsub; stl -36; ldc other - started; ldlp -40; startp
  started: {}; ldlp 0; endp
    other: {}; ldlp 40; endp
   joined: ldc 0
)";

/// Returns a program that outputs a message over link 1, inputs a message over link 1, or does both in parallel. In
/// word 5 of its workspace, the program stores the ticks that the exchange takes.
std::string exchange_of(bool outputs, bool inputs) {
    const std::string out = fmt::format("ldl 4; mint; ldnlp 1; ldc {}; out", message_bytes);
    const std::string in = fmt::format("ldl 4; mint; ldnlp 5; ldc {}; in", message_bytes);
    return "ajw 100; ldc 0; sttimer; mint; ldc #10000; bsub; stl 4; ldtimer; stl 3\n" +
           (!inputs    ? out
            : !outputs ? in
                       : fmt::format(in_parallel, out, in)) +
           "\n ldtimer; ldl 3; diff; stl 5; stopp\n";
}

/// Measures how fast two booted transputers exchange messages over a link.
class EmulatedLink {
public:
    EmulatedLink(Model model, std::int64_t bits_per_second, bool exchanges)
        : timing_{.bits_per_second = bits_per_second, .overlapped_acknowledge = model != Model::t414} {
        for (const bool sends : {true, false})
            add(model, exchange_of(sends || exchanges, !sends || exchanges));
        auto& link = simulation_.add<hardware::Link>(timing_, "a", "b");
        lanes_.emplace_back(link, nodes_[0]->end(1), nodes_[1]->end(1));
        for (transputer::Node* const node : nodes_)
            node->has_link(link);
    }

    /// Returns the rate of one direction, as measured by the clock of the second transputer.
    double kbytes_per_s() {
        simulation_.process("boots", [this] {
            for (BootBytes& each : boots_)
                each.give();
            wait_for(std::chrono::seconds{3});
        });
        fingerprint_ = simulation_.run().fingerprint;
        const Core& core = nodes_[1]->core();
        const Word workspace =
            transputer::traits_of(core.model()).memory_start + ((static_cast<Word>(code_bytes_) + 3) & ~Word{3}) + 400;
        const double ticks = core.memory().word(workspace + 20);
        return message_bytes / (ticks * in_milliseconds(hardware::Processor::low_tick));
    }
    std::uint64_t fingerprint() const { return fingerprint_; }

private:
    void add(Model model, const std::string& source) {
        auto& node = simulation_.add<transputer::Node>(fmt::format("t[{}]", nodes_.size()), model, 0x200000,
                                                       transputer::CoreTiming{.clock_hz = emulated_hertz});
        const Assembly program = transputer::assemble(source, code_on_chip, model);
        code_bytes_ = program.bytes.size();
        auto& link = simulation_.add<hardware::Link>(hardware::LinkTiming{}, "host", "a");
        lanes_.emplace_back(link, boots_.emplace_back(program), node.end(0));
        node.has_link(link);
        nodes_.push_back(&node);
    }

    hardware::LinkTiming timing_;
    Simulation simulation_;
    std::vector<transputer::Node*> nodes_;
    std::list<BootBytes> boots_;
    std::list<transputer::ByteLink> lanes_;
    std::size_t code_bytes_ = 0;
    std::uint64_t fingerprint_ = 0;
};

// Comparisons

/// A published figure, and how it is measured.
struct PublishedFigure {
    const char* row;
    const char* source;
    const char* unit;
    double figure;
    std::optional<double> tolerance; ///< nullopt: the figure is printed but not judged
    Origin origin;
    int decimals;
    double (*measure)();
};

constexpr const char* cycle_table = "T4 notebook (pahihu/t4)";
constexpr const char* of_slices = "databook, 1.3: 1 to 2 periods of 1.024 ms";
constexpr const char* of_waits = "databook, 1.3: 2n - 2 periods with n - 1 others";

const PublishedFigure scheduler_figures[] = {
    {"code: interrupt, typical", cycle_table, "cycles", 19, 0, Origin::constant, 0,
     [] { return typical_latency_beside(of_one_cycle); }},
    {"code: interrupt of divisions, longest", cycle_table, "cycles", 58, 0, Origin::outcome, 0,
     [] { return longest_latency_beside(divisions); }},
    {"code: turn beside another, shortest", of_slices, "periods", 1, 0.05, Origin::outcome, 2,
     [] { return waits_beside(1).front(); }},
    {"code: turn beside another, longest", of_slices, "periods", 2, 0.05, Origin::outcome, 2,
     [] { return waits_beside(1).back(); }},
    {"code: wait beside 3 others, longest", of_waits, "periods", 6, 0.2, Origin::outcome, 2,
     [] { return waits_beside(3).back(); }},
    {"code: wait beside 7 others, longest", of_waits, "periods", 14, 0.2, Origin::outcome, 2,
     [] { return waits_beside(7).back(); }},
};

const PublishedFigure memory_figures[] = {
    {"code: move on the chip", "T4 notebook (pahihu/t4): 2 cycles a word", "Mbyte/s", 40, 0.1, Origin::constant, 2,
     [] { return move_rate("ldlp -700", "ldlp -400"); }},
    {"code: move outside of the chip", "T800 databook, block move", "Mbyte/s", 13.3, 0.1, Origin::outcome, 2,
     [] { return move_rate("mint; ldc #20000; bsub", "mint; ldc #30000; bsub"); }},
    {"code: fetching a word outside of the chip", "calibrated with one program", "cycles", 1, 0.05, Origin::calibrated,
     2, cycles_of_fetching},
    {"code: a loop of COMMSTIME", "published; a switch takes no time here", "cycles", 301, std::nullopt,
     Origin::outcome, 0, cycles_of_commstime},
};

/// A published rate of a link, in Kbyte/s. With both directions in use, the rate is the sum of both.
struct PublishedRate {
    const char* row;
    const char* source;
    double kbytes_per_s, tolerance;
    Origin origin;
    Model model;
    std::int64_t mbits_per_second;
    bool exchanges;
};

constexpr const char* table_8_1 = "databook, table 8.1";

constexpr PublishedRate published_rates[] = {
    {"code: 5 Mbit/s, one way", table_8_1, 450, 13.5, Origin::outcome, Model::t800, 5, false},
    {"code: 5 Mbit/s, both ways", table_8_1, 670, 20.1, Origin::fitted, Model::t800, 5, true},
    {"code: 10 Mbit/s, one way", table_8_1, 910, 27.3, Origin::outcome, Model::t800, 10, false},
    {"code: 10 Mbit/s, both ways", table_8_1, 1250, 37.5, Origin::fitted, Model::t800, 10, true},
    {"code: 20 Mbit/s, one way", table_8_1, 1740, 52.2, Origin::fitted, Model::t800, 20, false},
    {"code: 20 Mbit/s, both ways", table_8_1, 2350, 70.5, Origin::fitted, Model::t800, 20, true},
    {"code: T414, 20 Mbit/s, one way", "databook: \"about .8 Mbyte/s\"", 800, 50, Origin::outcome, Model::t414, 20,
     false},
};

Comparison emulated_comparison(const char* name) {
    return {.name = name, .against = "publ.", .judged = true, .names_origins = true};
}

Comparison compare_figures(const char* name, std::span<const PublishedFigure> figures, const ReplayContext& context) {
    Comparison result = emulated_comparison(name);
    for (const PublishedFigure& each : figures) {
        context.progress(each.row);
        Cell cell =
            cell_of(each.row, "measured", each.unit, each.figure, each.measure(), each.tolerance, each.decimals);
        cell.source = each.source;
        cell.origin = each.origin;
        result.add(cell);
    }
    return result;
}

/// Judges the longest interrupt latency of a program that computes with reals. The published figure is an upper bound,
/// which compiled code does not reach.
Cell latency_beside_reals() {
    Cell cell = at_most(78, compared_cell("code: interrupt of floating point, longest", "measured", "cycles", 78,
                                          longest_latency_beside(operations_on_reals), 0));
    cell.source = "commonly stated: at most 78";
    return cell;
}

Comparison compare_rates(const ReplayContext& context, Fingerprint& fingerprint) {
    Comparison result = emulated_comparison("links, by out and in of two booted transputers");
    for (const PublishedRate& each : published_rates) {
        context.progress(each.row);
        EmulatedLink link(each.model, each.mbits_per_second * 1'000'000, each.exchanges);
        Cell cell = judged_cell(each.row, "measured", "Kbyte/s", each.kbytes_per_s,
                                link.kbytes_per_s() * (each.exchanges ? 2 : 1), each.tolerance, 0);
        cell.source = each.source;
        cell.origin = each.origin;
        result.add(cell);
        fingerprint.mix(link.fingerprint());
    }
    return result;
}

std::vector<hardware::Constant> constants_of_emulation() {
    constexpr std::string_view group = "emulated transputer";
    using enum hardware::Provenance;
    return {
        {group, "an interrupt", 19, "cycles", published, "T4 notebook (pahihu/t4), typical"},
        {group, "return from an interrupt", 17, "cycles", ours, "no source was found"},
        {group, "outbyte or outword that comes first", 21, "cycles", ours, "23 less the 2 cycles of the word"},
        {group, "fetching a word of code outside of the chip", 1, "cycles", calibrated,
         "one program; half of memorycycles - 1"},
    };
}

Replay replay_emulated(const ReplayContext& context) {
    Fingerprint fingerprint;
    Comparison scheduler = compare_figures("the scheduler", scheduler_figures, context);
    scheduler.add(latency_beside_reals());
    Comparison memory = compare_figures("memory and processes", memory_figures, context);
    memory.notes = "The loop of COMMSTIME is shorter than on a real T800: here a switch between processes takes no "
                   "time\nof its own, and the transfer of a word takes time only for the second of the two processes "
                   "at a channel.\n";
    Replay replay{.comparisons = {scheduler, memory, compare_rates(context, fingerprint)}};
    replay.constant_table = constants_of_emulation();
    replay.fingerprint = fingerprint.value();
    return replay;
}

} // namespace

extern const Experiment emulated_experiment{
    .name = "emulated",
    .about = "transputers that execute their own code, compared with the databook",
    .chapter = "machine",
    .number = 5,
    .run = replay_emulated,
};

} // namespace placedpar
