// How long the simulation of a link takes: nanoseconds of processor time per byte of long messages, with the closed
// form and with every byte simulated, one way and both ways.

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

void carry(const char* what, bool every_byte, bool both_ways, long messages) {
    constexpr std::uint32_t bytes = 256;
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
    RunResult result = simulation.run();
    double carried = static_cast<double>(messages) * bytes * (both_ways ? 2 : 1);
    fmt::print("{:<28} {:7.2f} ns/byte   fingerprint {:016x}\n", what, watch.nanoseconds() / carried,
               result.fingerprint);
}

} // namespace

int main(int argc, char** argv) {
    long messages = argument(argc, argv, 1, 10'000, "link [MESSAGES of 256 bytes]");
    carry("one way, closed form", false, false, messages);
    carry("one way, every byte", true, false, messages);
    carry("both ways, closed form", false, true, messages);
    carry("both ways, every byte", true, true, messages);
}
