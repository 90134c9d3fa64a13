// This program measures how fast emulated transputers execute code. The first programs run on one processor without
// links: a sieve, a program like Dhrystone, a loop of reals, COMMSTIME by `in` and `out`, and a program that overwrites
// its own code. The last rows are processors that compute and exchange 100 bytes with their neighbours each
// millisecond. A row shows how many simulated seconds of a T800-20 pass in a second of the host's processor, summed
// over the processors.

#include "bench/measure.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"
#include "runtime/transputer/assembler.hpp"
#include "runtime/transputer/node.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <deque>
#include <span>
#include <string>
#include <vector>

using namespace placedpar;
using namespace placedpar::bench;
using namespace placedpar::transputer;

namespace {

constexpr Word start = most_negative + 0x70, workspace = most_negative + 0x800;

/// A core without wires.
class NoLinks final : public LinkEngines {
public:
    void begin_transfer(int, Word, Word) override {}
    bool byte_waits(int) override { return false; }
    void reset(int) override {}
};

// Counts the odd primes up to 16,383 with flags in external memory, as the BYTE benchmark does: 1899 each time.
const char* const sieve = R"(
           mint; ldc 8192; bsub; stl 4
     once: ldc 0; stl 3; ldc 0; stl 6; ldc 8191; stl 7
     fill: ldc 1; ldl 6; ldl 4; bsub; sb
           ldlp 6; ldc filled - fill; lend
   filled: ldc 0; stl 6; ldc 8191; stl 7
     each: ldl 6; ldl 4; bsub; lb; cj next
           ldl 6; ldl 6; add; adc 3; stl 1
           ldl 6; ldl 1; add; stl 2
   strike: ldl 2; ldc 8190; gt; eqc 0; cj struck
           ldc 0; ldl 2; ldl 4; bsub; sb
           ldl 2; ldl 1; add; stl 2; j strike
   struck: ldl 3; adc 1; stl 3
     next: ldlp 6; ldc all - each; lend
      all: j once
)";

// A program of ours with the mix of Dhrystone: records that are copied and changed through pointers, strings that are
// compared, elements of arrays, procedures with parameters, decisions, and a little arithmetic. Records and arrays are
// in external memory. Word 16 counts the turns, and word 17 the strings that were equal.
const char* const dhrystone_of_ours = R"(
           ajw 8; ldc 0; stl 16; ldc 0; stl 17
           mint; ldc #2000; bsub; stl 10           -- the first record, which points to the second
           mint; ldc #2100; bsub; stl 11
           mint; ldc #3000; bsub; stl 12           -- arrays of 50 words, and of 50 rows of 50
           mint; ldc #3100; bsub; stl 13
           ldl 11; ldl 10; stnl 0; ldl 10; ldl 11; stnl 0
           ldc 0; ldl 10; stnl 1; ldc 2; ldl 10; stnl 2; ldc 40; ldl 10; stnl 3
     turn: ldl 16; adc 1; stl 16
           ldc 2; stl 1; ldc 3; stl 2
           ldpi second; ldpi first; call compare   -- differ near their ends
           cj equal; j unequal
    equal: ldl 17; adc 1; stl 17
  unequal: ldl 1; ldl 2; gt; eqc 0; cj after       -- while word 1 < word 2
           ldc 5; ldl 1; mul; ldl 2; sub; stl 3
           ldlp 3; ldl 2; ldl 1; call plus_two
           ldl 1; adc 1; stl 1; j unequal
    after: ldl 3; ldl 1; ldl 12; call elements
           ldl 10; call records
           ldc 65; stl 4
  letters: ldl 4; ldc 66; gt; eqc 0; cj counted    -- for 'A' to 'B'
           ldc 67; ldl 4; call same_letter; cj no
           ldlp 5; ldc 0; call decide
       no: ldl 4; adc 1; stl 4; j letters
  counted: ldl 2; ldl 1; mul; stl 6
           ldl 6; ldl 3; div; stl 7
           ldl 6; ldl 3; sub; ldc 7; prod; ldl 7; sub; stl 2
           ldlp 1; call last_one
           j turn
 plus_two: ldl 1; adc 2; ldl 2; add; ldl 3; stnl 0; ret          -- (value, value, VAR result)
  compare: ajw -1                                                -- (string, string): 1 if they differ
     each: ldl 2; lb; stl 0; ldl 3; lb; ldl 0; diff; cj same
           ldc 1; ajw 1; ret
     same: ldl 0; cj ended
           ldl 2; adc 1; stl 2; ldl 3; adc 1; stl 3; j each
    ended: ldc 0; ajw 1; ret
 elements: ajw -3                                                -- (array, index, value)
           ldl 5; adc 5; stl 0
           ldl 6; ldl 0; ldl 4; wsub; stnl 0
           ldl 0; ldl 4; wsub; ldnl 0; ldl 0; adc 1; ldl 4; wsub; stnl 0
           ldl 0; ldl 0; adc 30; ldl 4; wsub; stnl 0
           ldl 0; stl 1; ldc 2; stl 2
      row: ldl 0; ldl 0; ldc 50; prod; ldl 1; add; ldl 4; ldnlp 64; wsub; stnl 0
           ldlp 1; ldc rows - row; lend
     rows: ldc 5; ajw 3; ret
  records: ajw -2                                                -- (pointer)
           ldl 3; ldnl 0; stl 0; ldl 3; ldl 0; ldc 48; move
           ldc 5; ldl 3; stnl 3; ldl 3; ldnl 3; ldl 0; stnl 3
           ldl 3; ldnl 0; ldl 0; stnl 0
           ldl 0; ldnlp 0; call next_record
           ldl 0; ldnl 1; cj first_kind
           ldl 0; ldl 3; ldc 48; move; j recorded
first_kind: ldc 6; ldl 0; stnl 3
           ldl 0; ldnlp 2; ldl 3; ldnl 2; call decide
           ldl 0; ldnlp 3; ldc 10; ldl 0; ldnl 3; call plus_two
 recorded: ajw 2; ret
next_record: ldl 1; cj nothing
           ldl 1; ldnl 0; ldl 1; stnl 0
  nothing: ldlp 0; ldnlp 2; ldc 10; ldl 1; ldnl 3; call plus_two; ret
   decide: ajw -1                                                -- (kind, VAR result)
           ldl 2; ldl 3; cj given
           ldl 2; eqc 2; cj other
           ldc 1; ldl 3; stnl 0; j decided
    other: ldl 2; eqc 0; cj decided
           ldc 0; ldl 3; stnl 0; j decided
    given: ldl 2; stl 0
  decided: ajw 1; ret
same_letter: ajw -2; ldl 3; stl 0; ldl 0; stl 1; ldl 1; ldl 4; diff; eqc 0; ajw 2; ret
 last_one: ldl 1; ldnl 0; adc 10; stl 2; ldl 2; adc -1; ldl 1; stnl 0; ret
    first: .byte "A PROGRAM LIKE DHRYSTONE, TEXT 1", 0
   second: .byte "A PROGRAM LIKE DHRYSTONE, TEXT 2", 0
)";

// Sums the square roots of 1, 2, 3, ... in double length.
const char* const reals = R"(
           fpldzerodb; ldlp 2; fpstnldb; ldc 1; stl 1
     loop: ldlp 1; fpi32tor64; fpusqrtfirst; fpusqrtstep; fpusqrtstep; fpusqrtstep; fpusqrtlast
           ldlp 2; fpldnldb; fpadd; ldlp 2; fpstnldb
           ldl 1; adc 1; stl 1; j loop
)";

// P. Welch's COMMSTIME with sequential output: prefix, delta, successor, consumer.
const char* const comstime = R"(
           mint; stl 3; mint; stl 5; mint; stl 4; mint; stl 2      -- channels a, b, c, d
           ldc delta - one; ldlp -8; startp
      one: ldc succ - two; ldlp -18; startp
      two: ldc consumer - three; ldlp -31; startp
    three: ajw -2; ldlp 5; ldc 0; outword                          -- a ! 0
   prefix: ldlp 1; ldlp 7; ldc 4; in; ldlp 5; ldl 1; outword       -- b ? x; a ! x
           j prefix
    delta: ldlp 1; ldlp 11; ldc 4; in                              -- a ? x
           ldlp 12; ldl 1; outword; ldlp 10; ldl 1; outword        -- c ! x; d ! x
           j delta
     succ: ldlp 1; ldlp 22; ldc 4; in; ldlp 23; ldl 1; adc 1; outword
           j succ                                                  -- c ? x; b ! x + 1
 consumer: ldlp 1; ldlp 33; ldc 4; in; ldl 2; adc 1; stl 2         -- d ? x
           j consumer
)";

// Overwrites an operand in its loop.
const char* const changing = R"(
     loop: ldl 1; adc 1; stl 1
           ldc #40; ldl 1; ldc 7; and; or; ldc here - at; ldpi
       at: sb
     here: ldc 0; ldl 2; add; stl 2; j loop
)";

/// Computes for a millisecond, then sends 100 bytes over link 2 and receives 100 bytes over link 3, in parallel.
const char* const exchanging = R"(
           ajw 300; ldc 0; sttimer
     turn: ldc 0; stl 6; ldc 700; stl 7
     work: ldl 6; ldl 5; add; stl 5; ldlp 6; ldc worked - work; lend
   worked: ldc 2; stl 1; ldc joined - next; ldpi
     next: stl 0; ldc sender - started; ldlp -40; startp
  started: ajw -20; ldlp 120; mint; ldnlp 7; ldc 100; in; ldlp 20; endp
   sender: ldlp 100; mint; ldnlp 2; ldc 100; out; ldlp 40; endp
   joined: j turn
)";

void load(Core& core, const char* source) {
    const Assembly program = assemble(source, start, core.model());
    core.copy_to_memory(NodeMemory::offset_of(start), program.bytes);
    Registers registers;
    registers.instruction = start;
    registers.workspace = workspace;
    core.set_registers(registers, 1);
}

void report_speed(const char* what, double simulated, double host, std::uint64_t fingerprint) {
    fmt::print("{:<34} {:7.1f} simulated seconds a second   fingerprint {:016x}\n", what, simulated / host,
               fingerprint);
}

void measure_alone(const char* what, const char* source, double seconds) {
    NoLinks links;
    Core core(Model::t800, 65'536, {}, links);
    load(core, source);
    Stopwatch watch;
    core.run(static_cast<HalfCycles>(seconds * 40e6));
    if (core.stopped() != Stopped::nothing) {
        fmt::print("{}: {}\n", what, core.why_stopped());
        std::exit(1);
    }
    Fingerprint fingerprint;
    for (Word offset = 0; offset < 65'536; offset += 4)
        fingerprint.mix(core.memory().word(offset));
    fingerprint.mix(core.instructions());
    report_speed(what, seconds, watch.seconds(), fingerprint.value());
}

/// Boots one transputer with a packet of code.
class Booter final : public ByteEnd {
public:
    explicit Booter(const Assembly& program) : packet_{static_cast<std::uint8_t>(program.bytes.size())} {
        packet_.insert(packet_.end(), program.bytes.begin(), program.bytes.end());
    }
    void boot() { out->give(static_cast<std::uint32_t>(packet_.size())); }

private:
    void read(std::span<std::uint8_t> to) override {
        for (std::uint8_t& byte : to)
            byte = packet_[read_++];
    }
    void given() override {}
    void write(std::span<const std::uint8_t>) override {}
    void taken() override {}
    void byte_waits() override {}

    std::vector<std::uint8_t> packet_;
    std::size_t read_ = 0;
};

/// Runs a ring of processors, each of which has a host of its own.
void measure_ring(int processors, double seconds) {
    Simulation simulation;
    std::deque<Node*> nodes;
    std::deque<ByteLink> lanes;
    for (int i = 0; i < processors; ++i)
        nodes.push_back(&simulation.add<Node>(fmt::format("t[{}]", i), Model::t800, 65'536, CoreTiming{}));
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        auto& link = simulation.add<hardware::Link>(hardware::LinkTiming{}, "a", "b");
        Node &from = *nodes[i], &to = *nodes[(i + 1) % nodes.size()];
        lanes.emplace_back(link, from.end(2), to.end(3));
        from.has_link(link);
        to.has_link(link);
    }
    const Assembly program = assemble(exchanging, start, Model::t800);
    std::deque<Booter> booters;
    for (Node* const node : nodes) {
        auto& link = simulation.add<hardware::Link>(hardware::LinkTiming{}, "host", "a");
        lanes.emplace_back(link, booters.emplace_back(program), node->end(0));
        node->has_link(link);
    }
    simulation.process("clock", [&booters, seconds] {
        for (Booter& each : booters)
            each.boot();
        wait_for(Time{static_cast<std::int64_t>(seconds * 1e12)});
    });
    Stopwatch watch;
    simulation.run();
    Fingerprint fingerprint;
    for (Node* const node : nodes)
        fingerprint.mix(node->core().instructions());
    report_speed(fmt::format("{} processors in a ring", processors).c_str(), seconds * processors, watch.seconds(),
                 fingerprint.value());
}

} // namespace

int main(int argc, char** argv) {
    const double seconds = static_cast<double>(argument(argc, argv, 1, 2000, "transputer [MILLISECONDS]")) / 1000;
    measure_alone("sieve", sieve, 10 * seconds);
    measure_alone("like Dhrystone", dhrystone_of_ours, 10 * seconds);
    measure_alone("square roots", reals, 5 * seconds);
    measure_alone("COMMSTIME", comstime, 5 * seconds);
    measure_alone("code that overwrites itself", changing, seconds);
    measure_ring(3, seconds);
    measure_ring(16, seconds / 4);
}
