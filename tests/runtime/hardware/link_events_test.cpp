// Counts the kernel's events for each message on a link.

#include "runtime/hardware/link.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/simulation.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <deque>

using namespace placedpar;
using namespace placedpar::hardware;

namespace {

struct Payload {
    std::uint32_t bytes;
    WireForm wire_form() const { return WireForm(bytes); }
};

constexpr int messages = 100;

/// Two processes that send messages of this length over a direction, one after another.
class Stream {
public:
    Stream(Simulation& simulation, LinkDirection& direction, std::uint32_t bytes, Executive* from, Executive* to)
        : channel_("", direction) {
        auto send = [this, bytes] {
            for (int i = 0; i < messages; ++i)
                channel_.out().output(Payload{bytes});
        };
        auto receive = [this] {
            for (int i = 0; i < messages; ++i)
                channel_.in().input();
        };
        simulation.process("sender", send, from);
        simulation.process("receiver", receive, to);
    }

private:
    Channel<Payload> channel_;
};

/// Returns the number of events for each message on a link. Nothing else delays the two processes.
double events_a_message(std::uint32_t bytes, bool both_ways, bool every_byte = false) {
    Simulation simulation;
    Link& link = simulation.add<Link>();
    std::deque<Stream> streams;
    for (LinkDirection* direction : {&link.from_a_to_b(), &link.from_b_to_a()}) {
        if (every_byte)
            direction->simulate_every_byte();
        if (direction == &link.from_a_to_b() || both_ways)
            streams.emplace_back(simulation, *direction, bytes, nullptr, nullptr);
    }
    return static_cast<double>(simulation.run().events) / (messages * static_cast<double>(streams.size()));
}

} // namespace

TEST_CASE("a message makes a handful of events, whatever its length") {
    for (bool both_ways : {false, true})
        for (std::uint32_t bytes : {16u, 256u, 4096u}) {
            CAPTURE(both_ways);
            CAPTURE(bytes);
            CHECK(events_a_message(bytes, both_ways) < 3.1);
        }
    CHECK(events_a_message(256, true, true) > 256);
}

TEST_CASE("a message between processors that are busy in all directions makes seven events") {
    constexpr std::size_t side = 4;
    Simulation simulation;
    std::deque<Stream> streams;
    std::deque<Processor*> processors;
    for (std::size_t i = 0; i < side * side; ++i)
        processors.push_back(&simulation.add<Processor>(""));
    auto connect = [&](std::size_t a, std::size_t b) {
        Link& link = simulation.add<Link>();
        processors[a]->has_link(link), processors[b]->has_link(link);
        streams.emplace_back(simulation, link.from_a_to_b(), 256, processors[a], processors[b]);
        streams.emplace_back(simulation, link.from_b_to_a(), 256, processors[b], processors[a]);
    };
    for (std::size_t row = 0; row < side; ++row)
        for (std::size_t column = 0; column < side; ++column) {
            connect(row * side + column, row * side + (column + 1) % side);
            connect(row * side + column, (row + 1) % side * side + column);
        }
    auto events = static_cast<double>(simulation.run().events);
    CHECK(events / (messages * static_cast<double>(streams.size())) < 7.0);
}
