// Tests links that move bytes by counts, which may differ at the two ends, against the bit model. Tries all pairs of
// counts from 1 to 8, with either end first.

#include "bit_model.hpp"

#include "runtime/channel.hpp"
#include "runtime/event.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/kernel.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"
#include "tests/sanitized.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace placedpar;
using namespace placedpar::hardware;
using namespace placedpar::test;
using namespace std::chrono_literals;

namespace {

/// One end of a direction. It makes one transfer after another, with a pause before each. An event or a process makes
/// the first call. A transfer without a pause begins within the call that reports the end of the previous transfer.
class CountingEnd : public ByteUser, private Event {
public:
    using Transfers = std::vector<Traffic::Transfer>;
    CountingEnd(Kernel& kernel, LinkDirection& direction, const Transfers& transfers)
        : direction_(direction), kernel_(kernel), transfers_(transfers) {}
    virtual ~CountingEnd() = default;

    void begin_in_event() { pause(); }
    /// Begins the first transfer. REQUIRES: called by a process.
    void begin_in_process() {
        if (is_done())
            return;
        wait_for(std::chrono::nanoseconds{transfers_[0].pause});
        act();
    }
    /// Returns the times at which its transfers ended, in nanoseconds.
    const std::vector<std::int64_t>& ended() const { return ended_; }

protected:
    const Traffic::Transfer& transfer() const { return transfers_[ended_.size()]; }
    std::int64_t now_in_ns() const {
        CHECK(kernel_.now() % 1ns == Time{0});
        return kernel_.now() / 1ns;
    }
    /// Begins the next transfer.
    virtual void act() noexcept = 0;
    void has_ended() {
        CHECK(!is_done());
        ended_.push_back(now_in_ns());
        pause();
    }
    LinkDirection& direction_;

private:
    bool is_done() const { return ended_.size() == transfers_.size(); }
    void pause() {
        if (is_done())
            return;
        Time pause = std::chrono::nanoseconds{transfer().pause};
        if (pause == Time{0} && !ended_.empty())
            act();
        else
            kernel_.future().schedule(*this, kernel_.now() + pause, EventQueue::timer);
    }
    void happen() noexcept override { act(); }

    Kernel& kernel_;
    Transfers transfers_;
    std::vector<std::int64_t> ended_;
};

class Giver final : public CountingEnd {
public:
    using CountingEnd::CountingEnd;

private:
    void act() noexcept override { direction_.give(transfer().bytes); }
    void sent() override { has_ended(); }
    void taken() override { FAIL_CHECK("a sender is told that its bytes were taken"); }
    void byte_waits() override { FAIL_CHECK("a sender is told that a byte waits"); }
};

class Taker final : public CountingEnd {
public:
    using CountingEnd::CountingEnd;
    const std::vector<std::int64_t>& byte_waited() const { return byte_waited_; }

private:
    void act() noexcept override {
        alternates_ = transfer().alternates && !direction_.byte_waits();
        if (!alternates_)
            direction_.take(transfer().bytes);
    }
    void taken() override { has_ended(); }
    void byte_waits() override {
        CHECK(direction_.byte_waits());
        byte_waited_.push_back(now_in_ns());
        if (alternates_)
            act();
    }
    void sent() override { FAIL_CHECK("a receiver is told that its bytes were sent"); }

    bool alternates_ = false; ///< the receiver waits for a byte to arrive before it asks for the byte
    std::vector<std::int64_t> byte_waited_;
};

enum class Begins { in_event, in_process };

/// The observable behaviour of one direction.
struct CountedCourse {
    Course course;
    std::vector<std::int64_t> byte_waited;
    bool byte_waits; ///< at the end of the run
    bool operator==(const CountedCourse&) const = default;
};
using CountedCourses = std::array<CountedCourse, 2>;

CountedCourses count_on_runtime(const LinkTiming& timing, const std::array<Traffic, 2>& traffic, Begins begins,
                                bool every_byte) {
    Simulation simulation;
    Link& link = simulation.add<Link>(timing);
    std::array<LinkDirection*, 2> directions = {&link.from_a_to_b(), &link.from_b_to_a()};
    std::array<Giver*, 2> givers;
    std::array<Taker*, 2> takers;
    for (std::size_t d : {0u, 1u}) {
        if (every_byte)
            directions[d]->simulate_every_byte();
        givers[d] = &simulation.add<Giver>(*directions[d], traffic[d].given);
        takers[d] = &simulation.add<Taker>(*directions[d], traffic[d].taken);
        directions[d]->move_by_counts(*givers[d], *takers[d]);
        for (CountingEnd* end : std::initializer_list<CountingEnd*>{givers[d], takers[d]})
            if (begins == Begins::in_event)
                end->begin_in_event();
            else
                simulation.process("begins", [end] { end->begin_in_process(); });
    }
    simulation.process("lets the run go on", [] { wait_until(1ms); });
    CHECK(simulation.run().ending == Ending::completed);
    CountedCourses courses;
    for (std::size_t d : {0u, 1u}) {
        courses[d] = {{givers[d]->ended(), takers[d]->ended()}, takers[d]->byte_waited(), directions[d]->byte_waits()};
        std::uint64_t taken = 0;
        for (const Traffic::Transfer& transfer : traffic[d].taken)
            taken += transfer.bytes;
        CHECK(directions[d]->bytes_carried() == taken + std::uint64_t{directions[d]->byte_waits()});
    }
    return courses;
}

CountedCourses count_in_model(const LinkTiming& timing, const std::array<Traffic, 2>& traffic) {
    BitModel model(timing, traffic);
    std::array<Course, 2> course = model.run_until_quiet(1'000'000);
    CountedCourses courses;
    for (std::size_t d : {0u, 1u})
        courses[d] = {course[d], model.byte_waited(d), model.byte_waits(d)};
    return courses;
}

/// The pauses before the first and before later transfers at each end, in nanoseconds.
struct Pauses {
    std::int64_t giver_first, taker_first, giver = 0, taker = 0;
};

/// Returns transfers of m bytes against transfers of n bytes, until both ends finish a transfer together or 24 bytes
/// have passed. At least one more byte is never taken.
Traffic counts(std::uint32_t m, std::uint32_t n, const Pauses& pauses, bool alternates) {
    std::uint32_t takes = (std::min(std::lcm(m, n), 24u) + n - 1) / n, gives = takes * n / m + 1;
    Traffic traffic;
    for (std::uint32_t i = 0; i < gives; ++i)
        traffic.given.push_back({.pause = i == 0 ? pauses.giver_first : pauses.giver, .bytes = m});
    for (std::uint32_t i = 0; i < takes; ++i)
        traffic.taken.push_back(
            {.pause = i == 0 ? pauses.taker_first : pauses.taker, .bytes = n, .alternates = alternates});
    return traffic;
}

/// The starting times of the two ends. At 20 Mbit/s over a wire of 35 ns, a byte arrives 585 ns after its start. It is
/// noticed after 295 ns; without overlapped acknowledges, after 845 ns.
constexpr std::array orders{
    Pauses{300, 0}, // the receiver begins first
    Pauses{0, 0},   // both begin together
    Pauses{0, 20},  // nothing has reached the receiver yet
    Pauses{0, 185}, // the first byte is on the wire
    Pauses{0, 295}, // the byte is just noticed, with overlap
    Pauses{0, 435}, // the byte has been noticed, with overlap
    Pauses{0, 585}, // the byte just arrives
    Pauses{0, 700}, // the byte has arrived, but without overlap it is not noticed yet
    Pauses{0, 900}, // the byte has been noticed, and waits
};

enum class Busy { from_a, from_b, both };

LinkTiming at(std::int64_t bits_per_second, bool overlapped) {
    return {.bits_per_second = bits_per_second, .wire_delay = 35ns, .overlapped_acknowledge = overlapped};
}

void compare_all_pairs(const LinkTiming& timing, const Pauses& pauses, Busy busy, bool alternates,
                       Begins begins = Begins::in_event) {
    Pauses later = pauses; // pauses of the other direction
    later.giver_first += 131;
    later.taker_first += 131;
    CAPTURE(timing.overlapped_acknowledge);
    CAPTURE(alternates);
    CAPTURE(pauses.giver_first);
    CAPTURE(pauses.taker_first);
    CAPTURE(static_cast<int>(busy));
    for (std::uint32_t m = 1; m <= 8; ++m)
        for (std::uint32_t n = 1; n <= 8; ++n) {
            CAPTURE(m);
            CAPTURE(n);
            std::array<Traffic, 2> traffic;
            if (busy != Busy::from_b)
                traffic[0] = counts(m, n, pauses, alternates);
            if (busy != Busy::from_a)
                traffic[1] = counts(n, m, later, alternates);
            CountedCourses expected = count_in_model(timing, traffic);
            REQUIRE(expected[busy == Busy::from_b].byte_waits);
            REQUIRE(count_on_runtime(timing, traffic, begins, true) == expected);
            REQUIRE(count_on_runtime(timing, traffic, begins, false) == expected);
        }
}

} // namespace

TEST_CASE("bytes by counts, all pairs from 1 to 8 with either end first, take the time of a circuit of bits") {
    EveryNth some(40);
    for (bool overlapped : {true, false})
        for (bool alternates : {false, true})
            for (Busy busy : {Busy::from_a, Busy::from_b, Busy::both})
                for (const Pauses& pauses : orders)
                    if (!some.passes_over())
                        compare_all_pairs(at(20'000'000, overlapped), pauses, busy, alternates);
}

// At 10 Mbit/s an acknowledge and a byte may need the same wire. If both directions are busy, only the receivers pause.
// Otherwise a simultaneous give and take would compete for a wire, and the order of their events would decide.
TEST_CASE("bytes by counts with pauses between the transfers take the time of a circuit of bits") {
    EveryNth some(40);
    for (bool overlapped : {true, false})
        for (bool alternates : {false, true}) {
            LinkTiming timing = at(10'000'000, overlapped);
            for (const Pauses& pauses : {Pauses{0, 0, 0, 0}, Pauses{0, 0, 0, 700}, Pauses{0, 0, 0, 2000}})
                for (Busy busy : {Busy::from_a, Busy::both})
                    if (!some.passes_over())
                        compare_all_pairs(timing, pauses, busy, alternates);
            for (const Pauses& pauses : {Pauses{0, 0, 1800, 0}, Pauses{0, 0, 230, 370}})
                if (!some.passes_over())
                    compare_all_pairs(timing, pauses, Busy::from_a, alternates);
        }
}

TEST_CASE("transfers by counts that processes begin take the time of a circuit of bits") {
    EveryNth some(40);
    for (const Pauses& pauses : orders)
        if (!some.passes_over())
            compare_all_pairs(at(20'000'000, true), pauses, Busy::both, false, Begins::in_process);
}

TEST_CASE("a direction that moves bytes by counts carries no messages, and a direction with messages no counts") {
    struct User final : ByteUser {
    } user;
    struct Byte {
        WireForm wire_form() const { return WireForm(1); }
    };
    Simulation simulation;
    Link& link = simulation.add<Link>();
    link.from_a_to_b().move_by_counts(user, user);
    Channel<Byte> counted("counted", link.from_a_to_b()), carried("carried", link.from_b_to_a());
    simulation.process("outputs", [&] {
        CHECK_THROWS_WITH_AS(counted.out().output({}), doctest::Contains("give() and take()"), std::logic_error);
        carried.out().output({});
        CHECK_THROWS_AS(link.from_b_to_a().move_by_counts(user, user), std::logic_error);
    });
    simulation.process("inputs", [&] { carried.in().input(); });
    CHECK(simulation.run().ending == Ending::completed);
}

TEST_CASE("an empty transfer by counts is refused, and a transfer before the end of the previous one") {
    struct User final : ByteUser {
    } user;
    Simulation simulation;
    LinkDirection& direction = simulation.add<Link>().from_a_to_b();
    direction.move_by_counts(user, user);
    simulation.process("both ends", [&] {
        CHECK_THROWS_AS(direction.give(0), std::logic_error);
        CHECK_THROWS_AS(direction.take(0), std::logic_error);
        direction.give(2);
        CHECK_THROWS_WITH_AS(direction.give(1), doctest::Contains("a -> b"), std::logic_error);
        direction.take(3);
        CHECK_THROWS_WITH_AS(direction.take(1), doctest::Contains("a -> b"), std::logic_error);
        wait_until(1ms);
        direction.give(1); // two bytes were sent
        wait_until(2ms);
        direction.take(1); // three bytes were taken
        direction.give(1);
    });
    CHECK(simulation.run().ending == Ending::completed);
    CHECK(direction.bytes_carried() == 4);
}

TEST_CASE("a long transfer that begins in sent() costs as few events as the one before it") {
    struct Ends final : ByteUser {
        explicit Ends(LinkDirection& d) : direction(d) {}
        void sent() override {
            if (!std::exchange(again, true))
                direction.give(100'000'000);
        }
        void taken() override {
            if (!std::exchange(taken_again, true))
                direction.take(100'000'000);
        }
        LinkDirection& direction;
        bool again = false, taken_again = false;
    };
    Simulation simulation;
    LinkDirection& direction = simulation.add<Link>().from_a_to_b();
    Ends ends(direction);
    direction.move_by_counts(ends, ends);
    simulation.process("begins", [&] {
        direction.give(100'000'000);
        direction.take(100'000'000);
        wait_until(Time{200s});
    });
    const RunResult result = simulation.run();
    CHECK(result.ending == Ending::completed);
    CHECK(direction.bytes_carried() == 200'000'000);
    CHECK(result.events < 20);
}

TEST_CASE("the effects of faults on bytes by counts are recorded under the name of the direction") {
    struct Sender final : ByteUser {
        void sent() override { FAIL_CHECK("a byte was lost, and its sender goes on"); }
    } sender;
    Simulation simulation;
    Link& link = simulation.add<Link>();
    const FaultEffect& effect = link.suffer({.kind = LinkFault::Kind::silent});
    link.from_a_to_b().move_by_counts(sender, sender);
    simulation.process("gives", [&] {
        link.from_a_to_b().give(3);
        wait_until(1ms);
    });
    simulation.run();
    REQUIRE(effect.first);
    CHECK(effect.first->channel == "a -> b");
    CHECK(effect.bytes_lost == 1);
}

TEST_CASE("a watcher is told before an end changes a link by counts, while the link is still as it was") {
    struct Watcher final : LinkEngineWatcher {
        explicit Watcher(Link& l) : link(l) {}
        void link_will_change() override { was_still.push_back(link.is_still()); }
        Link& link;
        std::vector<bool> was_still;
    };
    struct User final : ByteUser {};
    Simulation simulation;
    auto& link = simulation.add<Link>();
    Watcher watcher(link);
    LinkEngineMemory memory{.watcher = &watcher};
    LinkDirection& direction = link.from_a_to_b();
    direction.move_messages_of(memory);
    User user;
    direction.move_by_counts(user, user);
    simulation.process("uses the link", [&] {
        const auto expect = [&](std::vector<bool> was_still, bool is_still_now) {
            CHECK_EQ(std::exchange(watcher.was_still, {}), was_still);
            CHECK_EQ(link.is_still(), is_still_now);
        };
        wait_for(1us);
        CHECK(link.is_still());
        direction.give(2);
        expect({true}, false);
        wait_for(100us);
        expect({}, true); // the first byte waits
        direction.take(2);
        expect({true}, false);
        wait_for(100us);
        expect({}, true);
        direction.take(1);
        expect({true}, true); // nothing is under way
        direction.reset_taking();
        expect({true}, true);
        direction.give(1);
        wait_for(2us);
        expect({true}, true);
        direction.reset_giving();
        expect({true}, true);
    });
    simulation.run();
}
