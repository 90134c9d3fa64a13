// How fast emulated transputers execute code. The first programs run on one processor without links: a sieve, a loop of
// reals, COMMSTIME by `in` and `out`, and a program that overwrites its own code. The last rows are processors that
// compute and exchange 100 bytes with their neighbours each millisecond. A row says how many simulated seconds of a
// T800-20 pass in a second of the host's processor, summed over the processors.

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
    core.run(static_cast<HalfCycles>(seconds * 40e6), false);
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
    for (const Node* const node : nodes)
        fingerprint.mix(node->core().instructions());
    report_speed(fmt::format("{} processors in a ring", processors).c_str(), seconds * processors, watch.seconds(),
                 fingerprint.value());
}

} // namespace

int main(int argc, char** argv) {
    const double seconds = static_cast<double>(argument(argc, argv, 1, 2000, "transputer [MILLISECONDS]")) / 1000;
    measure_alone("sieve", sieve, 10 * seconds);
    measure_alone("square roots", reals, 5 * seconds);
    measure_alone("COMMSTIME", comstime, 5 * seconds);
    measure_alone("code that overwrites itself", changing, seconds);
    measure_ring(3, seconds);
    measure_ring(16, seconds / 4);
}
