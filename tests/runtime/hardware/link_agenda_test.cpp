// The agenda of a link beside events of its steps' own: they are taken in the same order, and of a link never more than
// one stands in the future.

#include "runtime/hardware/link.hpp"
#include "runtime/hardware/link_agenda.hpp"
#include "runtime/kernel.hpp"
#include "runtime/random.hpp"
#include "runtime/simulation.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

using namespace placedpar;
using namespace placedpar::hardware;
using namespace std::chrono_literals;
using placedpar::test::replay;
using placedpar::test::seeds;

namespace {

constexpr std::array all_steps{LinkStep::acknowledge_is_due, LinkStep::wire_is_free,
                               LinkStep::byte_is_due,        LinkStep::first_byte_arrives,
                               LinkStep::last_byte_arrives,  LinkStep::later_last_byte_arrives,
                               LinkStep::sending_ends};

/// By the order of an instant: requests, starts, arrivals; in each by direction, where the wire comes first.
std::tuple<Time, int, std::size_t, int> key(Time at, LinkStep step, std::size_t direction) {
    int kind = step == LinkStep::acknowledge_is_due ? 0 : step <= LinkStep::byte_is_due ? 1 : 2;
    return {at, kind, direction, static_cast<int>(step)};
}

/// Enters and drops steps at random, from within steps as well, and notes what is taken.
class RandomWalker final : public LinkWalker {
public:
    RandomWalker(Kernel& kernel, std::uint64_t seed) : agenda_(kernel, *this), random_(seed, "steps") {}

    void act(Time now) {
        now_ = now;
        for (std::uint32_t i = random_.below(4); i > 0; --i) {
            LinkStep step = all_steps[random_.below(all_steps.size())];
            std::size_t direction = random_.below(2);
            auto& expected = expected_[direction][static_cast<std::size_t>(step)];
            expected = random_.chance(0.3) ? std::nullopt : std::optional(now + Time{random_.below(4)});
            if (expected)
                agenda_.enter(step, direction, *expected);
            else
                agenda_.drop(step, direction);
        }
    }
    void settle() { agenda_.settle(); }
    bool is_as_expected() const { return is_as_expected_; }
    bool has_nothing() const {
        return std::ranges::all_of(expected_, [](const auto& steps) {
            return std::ranges::all_of(steps, [](const auto& at) { return !at; });
        });
    }

private:
    void take(LinkStep step, std::size_t direction) override {
        auto& expected = expected_[direction][static_cast<std::size_t>(step)];
        is_as_expected_ = is_as_expected_ && expected && is_first(key(*expected, step, direction));
        Time now = expected.value_or(now_);
        expected.reset();
        act(now);
    }
    void plan() override {}
    bool is_first(const std::tuple<Time, int, std::size_t, int>& taken) const {
        for (std::size_t direction : {0u, 1u})
            for (LinkStep step : all_steps)
                if (auto at = expected_[direction][static_cast<std::size_t>(step)])
                    if (key(*at, step, direction) < taken)
                        return false;
        return true;
    }

    LinkAgenda agenda_;
    RandomStream random_;
    Time now_{};
    std::array<std::array<std::optional<Time>, all_steps.size()>, 2> expected_;
    bool is_as_expected_ = true;
};

/// Looks at the future every microsecond: the most events that it saw there, its own left out.
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

TEST_CASE("the steps of a link are taken in their order, whatever is put off, dropped or entered meanwhile") {
    for (std::uint64_t seed : seeds(200)) {
        INFO(replay(seed));
        Kernel kernel;
        RandomWalker walker(kernel, seed);
        int taken = 0;
        for (Time now{}; now < Time{200}; now += Time{3}) {
            walker.act(now);
            walker.settle();
            for (; !kernel.future().empty() && kernel.future().next_time() < now + Time{3}; ++taken)
                kernel.future().happen_next();
        }
        CHECK(walker.is_as_expected());
        CHECK(taken > 20);
        CHECK(walker.has_nothing() == kernel.future().empty());
    }
}

TEST_CASE("of a busy link one event stands in the future") {
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
