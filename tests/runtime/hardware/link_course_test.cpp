// Tests that a link has only one event in the queue: its next step that others can observe.

#include "runtime/hardware/link.hpp"
#include "runtime/kernel.hpp"
#include "runtime/simulation.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
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
    WireForm wire_form() const { return WireForm(20); }
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
