// This program measures the simulation of a link: nanoseconds of processor time per byte of long messages, with the
// closed form and with every byte simulated, one way and both ways. A byte is an event.

#include "runtime/hardware/link.hpp"
#include "bench/measure.hpp"
#include "runtime/simulation.hpp"

#include <fmt/format.h>

#include <cstdint>

using namespace placedpar;
using namespace placedpar::bench;
using namespace placedpar::hardware;

namespace {

struct Block {
    std::uint32_t bytes;
    WireForm wire_form() const { return WireForm(bytes); }
};

struct Figures {
    double nanoseconds_per_byte, bytes_per_process;
    std::uint64_t fingerprint;
};

Figures carry(bool every_byte, bool both_ways, long messages) {
    constexpr std::uint32_t bytes = 256;
    double before = resident_bytes(), after = 0;
    Simulation simulation;
    Link& link = simulation.add<Link>();
    Channel<Block> there("there", link.from_a_to_b()), back("back", link.from_b_to_a());
    for (Channel<Block>* channel : {&there, &back})
        if (channel == &there || both_ways) {
            simulation.process("sender", [=] {
                for (long i = 0; i < messages; ++i)
                    channel->out().output(Block{bytes});
            });
            simulation.process("receiver", [=] {
                for (long i = 0; i < messages; ++i)
                    channel->in().input();
            });
        }
    if (every_byte) {
        link.from_a_to_b().simulate_every_byte();
        link.from_b_to_a().simulate_every_byte();
    }
    Stopwatch watch;
    RunResult result = simulation.run(Time::max(), [&] { after = resident_bytes(); });
    double carried = static_cast<double>(messages) * bytes * (both_ways ? 2 : 1);
    return {watch.nanoseconds() / carried, (after - before) / (both_ways ? 4 : 2), result.fingerprint};
}

void measure(const char* what, bool every_byte, bool both_ways, long messages) {
    carry(every_byte, both_ways, 1); // warm-up
    in_a_thread_of_its_own([=] {
        Figures figures = carry(every_byte, both_ways, messages);
        fmt::print("{:<28} {:7.2f} ns/byte   {:8.0f} bytes/process   fingerprint {:016x}\n", what,
                   figures.nanoseconds_per_byte, figures.bytes_per_process, figures.fingerprint);
    });
}

} // namespace

int main(int argc, char** argv) {
    long messages = argument(argc, argv, 1, 10'000, "link [MESSAGES of 256 bytes]");
    measure("one way, closed form", false, false, messages);
    measure("one way, every byte", true, false, messages);
    measure("both ways, closed form", false, true, messages);
    measure("both ways, every byte", true, true, messages);
}
