// This program simulates a torus of T800s and a hypercube in which messages pass in both directions of every link all
// the time. It measures nanoseconds per byte, host seconds per simulated second, events per message, and the memory of
// a process. Each end of a link has a sending and a receiving process. A transputer has four links, so hypercubes of
// more than four dimensions cannot be built.

#include "bench/measure.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/simulation.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <utility>
#include <vector>

using namespace placedpar;
using namespace placedpar::bench;
using namespace placedpar::hardware;

namespace {

struct Message {
    static constexpr std::uint32_t bytes = 256;
    WireForm wire_form() const { return WireForm(bytes); }
};

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

Pairs torus(std::size_t side) {
    Pairs links;
    for (std::size_t row = 0; row < side; ++row)
        for (std::size_t column = 0; column < side; ++column) {
            links.emplace_back(row * side + column, row * side + (column + 1) % side);
            links.emplace_back(row * side + column, (row + 1) % side * side + column);
        }
    return links;
}

Pairs hypercube(std::size_t dimensions) {
    Pairs links;
    for (std::size_t node = 0; node < std::size_t{1} << dimensions; ++node)
        for (std::size_t d = 0; d < dimensions; ++d)
            if (std::size_t partner = node ^ std::size_t{1} << d; node < partner)
                links.emplace_back(node, partner);
    return links;
}

/// Processes that send and receive in both directions of all links.
class BusyMachine {
public:
    BusyMachine(std::size_t nodes, const Pairs& links, long messages) : messages_(messages) {
        for (std::size_t i = 0; i < nodes; ++i)
            processors_.push_back(&simulation_.add<Processor>(""));
        for (auto [a, b] : links) {
            Link& link = simulation_.add<Link>();
            processors_[a]->has_link(link), processors_[b]->has_link(link);
            stream(link.from_a_to_b(), *processors_[a], *processors_[b]);
            stream(link.from_b_to_a(), *processors_[b], *processors_[a]);
        }
    }
    RunResult run() {
        return simulation_.run(Time::max(), [this] { memory_ = resident_bytes(); });
    }
    double messages() const { return static_cast<double>(channels_.size()) * static_cast<double>(messages_); }
    double bytes() const { return messages() * Message::bytes; }
    double processes() const { return 2 * static_cast<double>(channels_.size()); }
    double memory() const { return memory_; }

private:
    void stream(LinkDirection& direction, Processor& from, Processor& to) {
        Channel<Message>& channel = channels_.emplace_back("", direction);
        simulation_.process(
            "",
            [out = channel.out(), n = messages_] {
                for (long i = 0; i < n; ++i)
                    out.output({});
            },
            &from);
        simulation_.process(
            "",
            [in = channel.in(), n = messages_] {
                for (long i = 0; i < n; ++i)
                    in.input();
            },
            &to);
    }

    Simulation simulation_;
    std::deque<Channel<Message>> channels_;
    std::vector<Processor*> processors_;
    long messages_;
    double memory_ = 0;
};

void measure(const std::string& what, std::size_t nodes, const Pairs& links, long messages) {
    double before = resident_bytes();
    Stopwatch watch;
    BusyMachine machine(nodes, links, messages);
    double setting_up = watch.seconds();
    RunResult result = machine.run();
    double took = watch.seconds();
    double simulated = std::chrono::duration<double>(result.time).count();
    fmt::print("{:<22} {:6.2f} ns/byte   {:8.1f} s per simulated s   {:6.2f} s in all   {:4.1f} events/message   "
               "{:5.0f} bytes/process   {:5.2f} Gbyte   fingerprint {:016x}\n",
               what, 1e9 * (took - setting_up) / machine.bytes(), (took - setting_up) / simulated, took,
               static_cast<double>(result.events) / machine.messages(),
               (machine.memory() - before) / machine.processes(), machine.memory() * 1e-9, result.fingerprint);
}

} // namespace

int main(int argc, char** argv) {
    const char* usage =
        "torus [SIDE OF THE TORUS, usually 32] [DIMENSIONS OF THE HYPERCUBE, usually 10] [MESSAGES on each "
        "direction of a link, usually 100]";
    auto side = static_cast<std::size_t>(argument(argc, argv, 1, 32, usage));
    auto dimensions = static_cast<std::size_t>(argument(argc, argv, 2, 10, usage));
    long messages = argument(argc, argv, 3, 100, usage);
    measure(fmt::format("torus of {}", side * side), side * side, torus(side), messages);
    std::size_t nodes = std::size_t{1} << dimensions;
    measure(fmt::format("hypercube of {}", nodes), nodes, hypercube(dimensions), messages);
}
