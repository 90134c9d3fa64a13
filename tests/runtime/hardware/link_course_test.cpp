// Tests that a link has only one event in the queue: its next step that others can observe. Tests that the state
// between two such steps is known at once.

#include "runtime/hardware/link.hpp"
#include "runtime/kernel.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>

using namespace placedpar;
using namespace placedpar::hardware;
using namespace std::chrono_literals;

namespace {

/// Counts the events in the queue every microsecond, without its own event, and keeps the maximum.
class Onlooker final : private Event {
public:
    explicit Onlooker(Kernel& kernel) : kernel_(kernel) { kernel_.future().schedule(*this, 1us, EventQueue::timer); }
    std::size_t most() const { return most_; }

private:
    void happen() noexcept override {
        most_ = std::max(most_, kernel_.future().size());
        if (kernel_.now() < 1ms)
            kernel_.future().schedule(*this, kernel_.now() + 1us, EventQueue::timer);
    }
    Kernel& kernel_;
    std::size_t most_ = 0;
};

struct Packetful {
    std::uint32_t bytes = 20;
    WireForm wire_form() const { return WireForm(bytes); }
};

} // namespace

TEST_CASE("a busy link has one event in the queue") {
    constexpr std::size_t links = 10;
    Simulation simulation;
    auto& onlooker = simulation.add<Onlooker>();
    std::deque<Channel<Packetful>> channels;
    for (std::size_t i = 0; i < links; ++i) {
        Link& link = simulation.add<Link>();
        for (LinkDirection* direction : {&link.from_a_to_b(), &link.from_b_to_a()}) {
            auto& channel = channels.emplace_back("", *direction);
            simulation.process("sender", [out = channel.out()] {
                for (int n = 0; n < 40; ++n)
                    out.output({});
            });
            simulation.process("receiver", [in = channel.in()] {
                for (int n = 0; n < 40; ++n)
                    in.input();
            });
        }
    }
    simulation.run();
    CHECK(onlooker.most() == links);
}

// The first half of the messages has more than two billion packets. To perform each would take more than half a
// minute.
TEST_CASE("the state of a link in the middle of long messages is known without a simulation of their packets" *
          doctest::timeout(10)) {
    constexpr std::uint32_t gigabyte = 1'000'000'000;
    Simulation simulation;
    Link& link = simulation.add<Link>();
    Channel<Packetful> there("there", link.from_a_to_b()), back("back", link.from_b_to_a());
    simulation.process("sender", [&] { there.out().output({gigabyte}); });
    simulation.process("sender back", [&] { back.out().output({gigabyte + 7}); });
    simulation.process("receiver", [&] { there.in().input(); });
    simulation.process("receiver back", [&] { back.in().input(); });
    simulation.process("observer", [&] {
        wait_until(Time{500s});
        CHECK(link.from_a_to_b().bytes_carried() == 500s / 850ns + 1); // both directions begin a byte every 17 bits
        CHECK(link.from_b_to_a().bytes_carried() == 500s / 850ns + 1);
    });
    CHECK(simulation.run().ending == Ending::completed);
}
