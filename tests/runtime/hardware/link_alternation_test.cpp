// Tests random programs that alternate over links. No message is lost, repeated or out of order, and no run deadlocks.

#include "runtime/alternation.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/random.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <deque>
#include <numeric>

using namespace placedpar;
using namespace placedpar::hardware;

namespace {

/// A message of at least one byte, with a number.
struct Numbered {
    int number = 0;
    std::uint32_t bytes = 1;
    WireForm wire_form() const { return bytes > 2 ? WireForm(bytes - 2, 2) : WireForm(bytes); }
};

/// Runs senders, each on its own link, and one receiver that takes their messages in any order. On the same processors,
/// other processes compute, or send over the links in the opposite direction. Priorities are random.
class Program {
public:
    explicit Program(std::uint64_t seed, bool every_byte) : random_(seed, "alternation over links") {
        std::size_t senders = 1 + random_.below(3);
        bool placed = random_.chance(0.5);
        Processor* receiver = placed ? &simulation_.add<Processor>("receiver") : nullptr;
        for (std::size_t i = 0; i < senders; ++i)
            add_sender(i, receiver, every_byte);
        left_ = sent_;
        simulation_.process(
            "receiver", [this] { receive_all(); }, receiver, some_priority());
        add_computing(receiver);
    }
    RunResult run() { return simulation_.run(); }
    const std::vector<Time>& times() const { return times_; }

private:
    Priority some_priority() { return random_.chance(0.5) ? Priority::high : Priority::low; }

    void add_sender(std::size_t i, Processor* receiver, bool every_byte) {
        Link& link = simulation_.add<Link>(LinkTiming{.wire_delay = std::chrono::nanoseconds{random_.below(200)}});
        bool forth = random_.chance(0.5);
        auto& direction = forth ? link.from_a_to_b() : link.from_b_to_a();
        auto& back = forth ? link.from_b_to_a() : link.from_a_to_b();
        if (every_byte)
            direction.simulate_every_byte(), back.simulate_every_byte();
        channels_.emplace_back(fmt::format("link {}", i)).put_on(direction);
        inputs_.push_back(channels_.back().in());
        sent_.push_back(1 + static_cast<int>(random_.below(6)));
        received_.push_back(0);
        Processor* t800 = receiver ? &simulation_.add<Processor>(fmt::format("sender {}", i)) : nullptr;
        if (receiver && random_.chance(0.5)) // the link engines take memory cycles from computing processes
            receiver->has_link(link), t800->has_link(link);
        simulation_.process(
            fmt::format("sender {}", i), [this, i] { send_all(i); }, t800, some_priority());
        if (random_.chance(0.5))
            add_traffic(back, receiver, t800);
        add_computing(t800);
    }

    /// Adds traffic from `from` to `to` in the opposite direction.
    void add_traffic(Carrier& direction, Processor* from, Processor* to) {
        channels_back_.emplace_back("back").put_on(direction);
        auto out = channels_back_.back().out();
        auto in = channels_back_.back().in();
        std::uint32_t bytes = 1 + random_.below(60);
        simulation_.process(
            "sends back",
            [out, bytes] {
                out.output({1, bytes}), out.output({2, bytes});
            },
            from, some_priority());
        simulation_.process(
            "receives back", [in] { CHECK(in.input().number + in.input().number == 3); }, to, some_priority());
    }

    void add_computing(Processor* t800) {
        auto cycles = Cycles{random_.below(30'000)};
        if (t800 && random_.chance(0.5))
            simulation_.process(
                "computes", [cycles] { compute(cycles), wait_for(std::chrono::microseconds{3}), compute(cycles); },
                t800, some_priority());
    }

    void send_all(std::size_t sender) {
        RandomStream random(random_.below(1'000'000), "sender");
        for (int number = 0; number < sent_[sender]; ++number) {
            pause(random);
            channels_[sender].out().output({number, random.chance(0.6) ? 1 : 1 + random.below(40)});
        }
    }

    void receive_all() {
        while (std::accumulate(left_.begin(), left_.end(), 0) > 0) {
            pause(random_);
            if (random_.chance(0.3))
                take_from(some_sender());
            else
                alternate();
            times_.push_back(now());
        }
    }
    /// Returns a random sender that has messages left.
    std::size_t some_sender() {
        std::size_t sender = random_.below(static_cast<std::uint32_t>(left_.size()));
        while (left_[sender] == 0)
            sender = (sender + 1) % left_.size();
        return sender;
    }
    void alternate() {
        std::vector<Guard> guards;
        for (auto& channel : channels_)
            guards.push_back({Guard::input, &channel});
        if (random_.chance(0.3))
            guards.push_back({Guard::timeout, nullptr, now() + std::chrono::nanoseconds{random_.below(3000)}});
        else if (random_.chance(0.3))
            guards.push_back({Guard::skip});
        if (std::size_t chosen = select(guards); chosen < channels_.size())
            take_from(chosen);
    }
    void take_from(std::size_t sender) {
        CHECK(inputs_[sender].input().number == received_[sender]++);
        --left_[sender];
    }
    void pause(RandomStream& random) {
        if (random.chance(0.6))
            wait_for(std::chrono::nanoseconds{random.below(4000)});
    }

    Simulation simulation_;
    RandomStream random_;
    std::deque<Channel<Numbered>> channels_, channels_back_;
    std::vector<Input<Numbered>> inputs_;
    std::vector<int> sent_, left_, received_;
    std::vector<Time> times_;
};

} // namespace

TEST_CASE("random programs that alternate over links complete, with all messages in order") {
    for (std::uint64_t seed : test::seeds(2000)) {
        INFO(test::replay(seed));
        Program bytes(seed, true), closed(seed, false);
        auto result = bytes.run();
        REQUIRE(result.ending == Ending::completed);
        REQUIRE(closed.run().fingerprint == result.fingerprint);
        REQUIRE(closed.times() == bytes.times());
    }
}

TEST_CASE("a message of one byte that an alternation has taken does not end the next input") {
    Simulation simulation;
    Link& link = simulation.add<Link>();
    Channel<Numbered> channel("channel", link.from_a_to_b());
    std::vector<int> received;
    simulation.process("sender", [&] {
        for (int number : {1, 2})
            channel.out().output({number});
    });
    simulation.process("receiver", [&] {
        alt(on(channel.in(), [&](Numbered message) { received.push_back(message.number); }));
        received.push_back(channel.in().input().number);
    });
    CHECK(simulation.run().ending == Ending::completed);
    CHECK(received == std::vector{1, 2});
}
