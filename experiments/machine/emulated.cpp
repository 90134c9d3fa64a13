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
#include <span>
#include <vector>

// Figures of transputers that execute their own code. A program in the transputer's instructions measures each by its
// clock, or the times at which its instructions begin are noted.

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

/// A T800 without wires that executes a program.
class EmulatedProgram final : private transputer::LinkEngines, private Core::Watcher {
public:
    /// `priority`: of the program, 0 high, 1 low.
    EmulatedProgram(const std::string& source, int priority, Word origin = code_on_chip)
        : program_(transputer::assemble(source, origin, Model::t800)),
          core_(Model::t800, 0x40000, {.clock_hz = emulated_hertz}, *this) {
        core_.copy_to_memory(NodeMemory::offset_of(origin), program_.bytes);
        transputer::Registers registers;
        registers.instruction = origin;
        registers.workspace = workspace_on_chip;
        core_.set_registers(registers, priority);
    }

    /// Calls a function whenever the instruction at a label begins.
    void watch(const std::string& label, std::function<void()> f) {
        watched_[program_[label]] = std::move(f);
        core_.watch(this);
    }
    void run(Time limit = std::chrono::seconds{1}) {
        while (now() < limit && core_.stopped() == transputer::Stopped::nothing)
            if (core_.run(core_.half_cycle_at(limit), false) == Core::Pause::idle) {
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

/// The latencies of interrupts, in cycles, from the tick of the clock that ends a wait to the first instruction.
struct Latencies {
    double typical, longest;
};

/// Measures the latencies at which a process of high priority interrupts a program that is executed again and again.
Latencies latencies_beside(const std::string& program) {
    EmulatedProgram t800(fmt::format(R"(
           ldc 0; sttimer
  started: ldc low - here; ldpi                  -- a process of low priority, at W - 40
     here: stl -41; ldlp -40; adc 1; runp
     wait: ldl 1; adc 7; stl 1; ldc 0; ldl 1; ldc 31; and; shl    -- takes a varying time
           ldtimer; adc 9; ldl 1; ldc 15; and; add; stl 2; ldl 2   -- a varying number of ticks later
           tin                                                     -- waits for the tick after this time
    woken: j wait
      low: {}
           j low
)",
                                     program),
                         0);
    Time clock_began{};
    std::vector<std::int64_t> cycles;
    t800.watch("started", [&] { clock_began = t800.now(); });
    t800.watch("woken", [&] {
        const Time tick = clock_began + (t800.word(2) + 1) * hardware::Processor::high_tick;
        cycles.push_back((t800.now() - tick) / emulated_cycle);
    });
    t800.run(std::chrono::milliseconds{50});
    std::ranges::sort(cycles);
    return {static_cast<double>(cycles.at(cycles.size() / 2)), static_cast<double>(cycles.back())};
}

/// Instructions of one cycle.
constexpr const char* constants = "ldc 0; ldc 1; ldc 2; ldc 3; ldc 4; ldc 5; ldc 6; ldc 7; ldc 8; ldc 9; ldc 10";
constexpr const char* divisions = "ldc 60; ldc 7; div; ldc 0; ldc 0";
/// Operations on reals in the sequences that compilers emit: a root, a quotient, a remainder.
constexpr const char* operations_on_reals = R"(
           ldc 7; stl 0; ldlp 0; fpi32tor64; fpusqrtfirst; fpusqrtstep; fpusqrtstep; fpusqrtlast; ldlp 2; fpstnldb
           ldlp 0; fpi32tor64; ldlp 0; fpi32tor64; fpdiv; ldlp 2; fpstnldb
           ldlp 0; fpi32tor64; ldlp 0; fpi32tor64; fpremfirst; eqc 0; cj whole
     more: fpremstep; cj more
    whole: ldlp 2; fpstnldb
)";

// Turns

/// Returns the time from the moment at which a process becomes ready until it begins, in timeslice periods, while
/// `others` processes that became ready just before compute. They become ready after `delay` turns of a loop.
double wait_beside(int others, int delay) {
    std::string starts;
    for (int i = 0; i < others; ++i)
        starts += fmt::format("ldc computes - s{0}; ldlp -{1}; startp\ns{0}:\n", i, 40 + 20 * i);
    EmulatedProgram t800(fmt::format(R"(
           ldc {}; stl 2; ldc 0; stl 1
    delay: ldlp 1; ldc over - delay; lend
     over: {}
           ldc asks - last; ldlp -20; startp
     last: stopp
 computes: j computes
     asks: stopp
)",
                                     delay, starts),
                         1);
    Time ready{}, began{};
    t800.watch("last", [&] { ready = t800.now(); });
    t800.watch("asks", [&] { began = t800.now(); });
    while (began == Time{})
        t800.run(t800.now() + hardware::Processor::timeslice);
    return static_cast<double>((began - ready).count()) / static_cast<double>(hardware::Processor::timeslice.count());
}

/// Returns the shortest and the longest wait, over delays of up to one period.
std::pair<double, double> waits_beside(int others) {
    std::vector<double> periods;
    for (int delay = 1; delay < 1600; delay += 110) // 12 cycles each, so up to 19,200 of the 20,480 of a period
        periods.push_back(wait_beside(others, delay));
    for (int delay = 1680; delay < 1720; delay += 4) // around the end of the period
        periods.push_back(wait_beside(others, delay));
    const auto [least, most] = std::ranges::minmax(periods);
    return {least, most};
}

// Memory

/// Returns the cycles of instructions, with those of a loop, by the clock of low priority.
double cycles_of_turn(const std::string& body, Word origin = code_on_chip) {
    constexpr int turns = 20'000;
    EmulatedProgram t800(fmt::format(R"(
           ldc 0; sttimer; ldc 0; stl 1; ldc {}; stl 2; ldtimer; stl 3
     turn: {}
           ldlp 1; ldc over - turn; lend
     over: ldtimer; ldl 3; diff; stl 4; stopp
)",
                                     turns, body),
                         1, origin);
    t800.run(std::chrono::seconds{10});
    constexpr double cycles_of_tick = static_cast<double>(hardware::Processor::low_tick / emulated_cycle);
    return static_cast<double>(t800.word(4)) * cycles_of_tick / turns;
}

/// Returns the rate at which `move` copies, in Mbyte/s: that of what a longer block takes longer.
double move_rate(const std::string& source, const std::string& target) {
    const auto cycles = [&](int bytes) {
        return cycles_of_turn(fmt::format("{}; {}; ldc {}; move; ldc 0; ldc 0", source, target, bytes));
    };
    return 512 * (emulated_hertz / 1e6) / (cycles(1024) - cycles(512));
}

// Communication

/// P. Welch's COMMSTIME as INMOS's compiler makes it: four processes pass a number round, one of them in parallel.
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
    return static_cast<double>(t800.word(5)) * static_cast<double>(hardware::Processor::low_tick / emulated_cycle) /
           10'000;
}

/// Gives a transputer the bytes that boot it, over a link.
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

/// Outputs a message over link 1, inputs one over it, or does both in parallel. Notes the ticks in word 1.
std::string exchange_of(bool outputs, bool inputs) {
    const std::string out = fmt::format("ldl 4; mint; ldnlp 1; ldc {}; out", message_bytes);
    const std::string in = fmt::format("ldl 4; mint; ldnlp 5; ldc {}; in", message_bytes);
    const std::string begin = "ajw 100; ldc 0; sttimer; mint; ldc #10000; bsub; stl 4; ldtimer; stl 3\n";
    const std::string end = "ldtimer; ldl 3; diff; stl 5; stopp\n";
    if (!outputs || !inputs)
        return begin + (outputs ? out : in) + "\n" + end;
    return begin +
           fmt::format(R"(
           ldc 2; stl 1; ldc joined - next; ldpi
     next: stl 0; ldl 4; ldc #80000; bsub; stl -36; ldc other - started; ldlp -40; startp
  started: {}; ldlp 0; endp
    other: {}; ldlp 40; endp
   joined: )",
                       out, in) +
           end;
}

/// Measures how fast two booted transputers exchange messages over a link.
class EmulatedLink {
public:
    EmulatedLink(Model model, std::int64_t bits_per_second, bool both_ways)
        : timing_{.bits_per_second = bits_per_second, .overlapped_acknowledge = model != Model::t414} {
        for (const bool sends : {true, false})
            add(model, exchange_of(sends || both_ways, !sends || both_ways));
        auto& link = simulation_.add<hardware::Link>(timing_, "a", "b");
        lanes_.emplace_back(link, nodes_[0]->end(1), nodes_[1]->end(1));
        for (transputer::Node* const node : nodes_)
            node->has_link(link);
    }

    /// Returns the rate of a direction, as the clock of the second transputer says.
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

/// A published figure.
struct PublishedFigure {
    const char* row;
    const char* source;
    const char* unit;
    double figure, tolerance;
    Origin origin;
    int decimals = 0;
};

Cell beside(const PublishedFigure& published, double measured) {
    Cell cell = judged_cell(published.row, "measured", published.unit, published.figure, measured, published.tolerance,
                            published.decimals);
    cell.source = published.source;
    cell.origin = published.origin;
    return cell;
}

constexpr const char* cycle_table = "T4 notebook (pahihu/t4)";
constexpr const char* slices_1_3 = "databook, 1.3: 1 to 2 periods of 1.024 ms";
constexpr const char* waits_1_3 = "databook, 1.3: 2n - 2 periods with n - 1 others";

Comparison compare_emulated_scheduler() {
    using enum Origin;
    Comparison result{.name = "the scheduler, by programs in the transputer's instructions",
                      .against = "publ.",
                      .judged = true,
                      .names_origins = true};
    result.add(beside({"code: interrupt, typical", cycle_table, "cycles", 19, 0, constant},
                      latencies_beside(constants).typical));
    result.add(beside({"code: interrupt of divisions, longest", cycle_table, "cycles", 58, 0, outcome},
                      latencies_beside(divisions).longest));
    Cell reals = at_most(78, beside({"code: interrupt of floating point, longest", "commonly stated: at most 78",
                                     "cycles", 78, 0, outcome},
                                    latencies_beside(operations_on_reals).longest));
    result.add(reals);
    const auto [shortest, longest] = waits_beside(1);
    result.add(beside({"code: turn beside another, shortest", slices_1_3, "periods", 1, 0.05, outcome, 2}, shortest));
    result.add(beside({"code: turn beside another, longest", slices_1_3, "periods", 2, 0.05, outcome, 2}, longest));
    result.add(beside({"code: wait beside 3 others, longest", waits_1_3, "periods", 6, 0.2, outcome, 2},
                      waits_beside(3).second));
    result.add(beside({"code: wait beside 7 others, longest", waits_1_3, "periods", 14, 0.2, outcome, 2},
                      waits_beside(7).second));
    return result;
}

Comparison compare_emulated_memory() {
    using enum Origin;
    Comparison result{.name = "memory and processes, by programs in the transputer's instructions",
                      .against = "publ.",
                      .judged = true,
                      .names_origins = true};
    result.add(
        beside({"code: move on the chip", "T4 notebook (pahihu/t4): 2 cycles a word", "Mbyte/s", 40, 0.1, constant, 2},
               move_rate("ldlp -700", "ldlp -400")));
    result.add(beside({"code: move outside of the chip", "T800 databook, block move", "Mbyte/s", 13.3, 0.1, outcome, 2},
                      move_rate("mint; ldc #20000; bsub", "mint; ldc #30000; bsub")));
    const std::string sixteen = "ldc 0; ldc 1; ldc 2; ldc 3; ldc 4; ldc 5; ldc 6; ldc 7; ldc 8; ldc 9; ldc 10; ldc 11; "
                                "ldc 12; ldc 13; ldc 14; ldc 15; ";
    const auto four_words = [&](Word origin) {
        return cycles_of_turn(sixteen + sixteen, origin) - cycles_of_turn(sixteen, origin);
    };
    result.add(beside({"code: a word of code outside of the chip, beyond one on it", "calibrated with one program",
                       "cycles", 1, 0.05, calibrated, 2},
                      (four_words(code_outside) - four_words(code_on_chip)) / 4));
    Cell commstime_cell =
        compared_cell("code: a loop of COMMSTIME", "measured", "cycles", 301, cycles_of_commstime(), 0);
    commstime_cell.source = "a published measurement";
    result.add(commstime_cell);
    result.notes =
        "The loop of COMMSTIME is shorter than on a real T800 because a switch between processes takes no time "
        "of its own here,\nand because only the process that comes second to a channel pays for the word.\n";
    return result;
}

struct EmulatedRate {
    PublishedFigure published;
    Model model;
    std::int64_t bits_per_second;
    bool both_ways;
};

Comparison compare_emulated_links(const ReplayContext& context, Fingerprint& fingerprint) {
    constexpr const char* table = "databook, table 8.1";
    constexpr std::int64_t mega = 1'000'000;
    using enum Origin;
    static const std::vector<EmulatedRate> rates{
        {{"code: 5 Mbit/s, one way", table, "Kbyte/s", 450, 13.5, outcome}, Model::t800, 5 * mega, false},
        {{"code: 5 Mbit/s, both ways", table, "Kbyte/s", 670, 20.1, fitted}, Model::t800, 5 * mega, true},
        {{"code: 10 Mbit/s, one way", table, "Kbyte/s", 910, 27.3, outcome}, Model::t800, 10 * mega, false},
        {{"code: 10 Mbit/s, both ways", table, "Kbyte/s", 1250, 37.5, fitted}, Model::t800, 10 * mega, true},
        {{"code: 20 Mbit/s, one way", table, "Kbyte/s", 1740, 52.2, fitted}, Model::t800, 20 * mega, false},
        {{"code: 20 Mbit/s, both ways", table, "Kbyte/s", 2350, 70.5, fitted}, Model::t800, 20 * mega, true},
        {{"code: T414, 20 Mbit/s, one way", "databook: \"about .8 Mbyte/s\"", "Kbyte/s", 800, 50, outcome},
         Model::t414,
         20 * mega,
         false},
    };
    Comparison result{.name = "links, by out and in of two booted transputers",
                      .against = "publ.",
                      .judged = true,
                      .names_origins = true};
    for (const EmulatedRate& rate : rates) {
        context.progress(rate.published.row);
        EmulatedLink link(rate.model, rate.bits_per_second, rate.both_ways);
        result.add(beside(rate.published, link.kbytes_per_s() * (rate.both_ways ? 2 : 1)));
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
    context.progress("emulated transputer");
    Fingerprint fingerprint;
    Replay replay{.comparisons = {compare_emulated_scheduler(), compare_emulated_memory(),
                                  compare_emulated_links(context, fingerprint)}};
    replay.constant_table = constants_of_emulation();
    replay.fingerprint = fingerprint.value();
    return replay;
}

} // namespace

extern const Experiment emulated_experiment{
    .name = "emulated",
    .about = "transputers that execute their own code, beside the databook",
    .chapter = "machine",
    .number = 5,
    .run = replay_emulated,
};

} // namespace placedpar
