// Tests the times of links against the bit model, and the closed form against a simulation of every byte.

#include "bit_model.hpp"

#include "runtime/alternation.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/random.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"
#include "tests/sanitized.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

using namespace placedpar;
using namespace placedpar::hardware;
using namespace placedpar::test;

namespace {

struct Parts {
    std::vector<std::uint32_t> bytes;
    WireForm wire_form() const {
        switch (bytes.size()) {
        case 1: return WireForm(bytes[0]);
        case 2: return WireForm(bytes[0], bytes[1]);
        case 3: return WireForm(bytes[0], bytes[1], bytes[2]);
        default: return WireForm(bytes[0], bytes[1], bytes[2], bytes[3]);
        }
    }
};

std::int64_t now_in_nanoseconds() {
    CHECK(now().count() % 1000 == 0);
    return now().count() / 1000;
}

struct Outcome {
    std::array<Course, 2> course;
    std::uint64_t fingerprint;
    bool completed;
    Time end;
    std::vector<FaultEffect> effects;
};

/// Sends the traffic over the runtime's link.
Outcome run_on_runtime(const LinkTiming& timing, const std::array<Traffic, 2>& traffic, bool every_byte,
                       const std::vector<LinkFault>& faults = {}) {
    Simulation simulation;
    Link& link = simulation.add<Link>(timing);
    std::vector<const FaultEffect*> effects;
    for (const LinkFault& fault : faults)
        effects.push_back(&link.suffer(fault));
    LinkDirection* directions[2] = {&link.from_a_to_b(), &link.from_b_to_a()};
    Channel<Parts> channels[2] = {Channel<Parts>("there"), Channel<Parts>("back")};
    std::array<Course, 2> course;
    for (std::size_t d : {0u, 1u}) {
        if (every_byte)
            directions[d]->simulate_every_byte();
        channels[d].put_on(*directions[d]);
        simulation.process(fmt::format("sender {}", d), [&, d] {
            for (const auto& message : traffic[d].messages) {
                wait_for(std::chrono::nanoseconds{message.sender_pause});
                channels[d].out().output(Parts{message.parts});
                course[d].output_ended.push_back(now_in_nanoseconds());
            }
        });
        simulation.process(fmt::format("receiver {}", d), [&, d] {
            for (const auto& message : traffic[d].messages) {
                wait_for(std::chrono::nanoseconds{message.receiver_pause});
                Parts parts;
                if (message.alternates)
                    alt(on(channels[d].in(), [&](const Parts& it) { parts = it; }));
                else
                    parts = channels[d].in().input();
                CHECK(parts.bytes == message.parts);
                course[d].input_ended.push_back(now_in_nanoseconds());
            }
        });
    }
    RunResult result = simulation.run();
    Outcome outcome{course, result.fingerprint, result.ending == Ending::completed, result.time, {}};
    for (const FaultEffect* effect : effects)
        outcome.effects.push_back(*effect);
    return outcome;
}

/// Returns a random pause. The residues keep pauses of a sender and a receiver from ending at the same nanosecond. They
/// differ by one or two from the grid on which bits and bytes begin.
std::int64_t random_pause(RandomStream& random, std::int64_t residue) {
    if (random.chance(0.4))
        return 0;
    return 25 * random.below(random.chance(0.5) ? 40 : 800) + residue;
}

Traffic random_traffic(RandomStream& random, std::int64_t residue, std::uint32_t longest) {
    Traffic traffic;
    std::uint32_t messages = random.below(7);
    for (std::uint32_t i = 0; i < messages; ++i) {
        Traffic::Message message{random_pause(random, residue), random_pause(random, residue + 1), {}};
        std::uint32_t parts = 1 + random.below(random.chance(0.5) ? 1 : 4);
        for (std::uint32_t part = 0; part < parts; ++part)
            message.parts.push_back(1 + random.below(random.chance(0.5) ? 3 : longest));
        message.alternates = random.chance(0.4);
        traffic.messages.push_back(message);
    }
    return traffic;
}

LinkTiming random_timing(RandomStream& random) {
    LinkTiming timing;
    timing.bits_per_second = std::array<std::int64_t, 3>{5'000'000, 10'000'000, 20'000'000}[random.below(3)];
    if (random.chance(0.5))
        timing.wire_delay = std::chrono::nanoseconds{random.below(400)};
    timing.overlapped_acknowledge = random.chance(0.75);
    return timing;
}

} // namespace

TEST_CASE("random traffic over a link takes the time of a circuit of bits, to the picosecond") {
    for (std::uint64_t seed : test::seeds(300)) {
        INFO(test::replay(seed));
        RandomStream random(seed, "link against bits");
        LinkTiming timing = random_timing(random);
        std::array<Traffic, 2> traffic = {random_traffic(random, 3, 20), random_traffic(random, 7, 20)};
        auto expected = BitModel(timing, traffic).run(10'000'000);
        for (bool every_byte : {true, false}) {
            CAPTURE(every_byte);
            Outcome outcome = run_on_runtime(timing, traffic, every_byte);
            REQUIRE(outcome.completed);
            for (std::size_t d : {0u, 1u}) {
                REQUIRE(outcome.course[d].output_ended == expected[d].output_ended);
                REQUIRE(outcome.course[d].input_ended == expected[d].input_ended);
            }
        }
    }
}

TEST_CASE("the closed form gives the times and the order of the single bytes, to the picosecond") {
    for (std::uint64_t seed : test::seeds(2000)) {
        INFO(test::replay(seed));
        RandomStream random(seed, "closed form against bytes");
        LinkTiming timing = random_timing(random);
        std::array<Traffic, 2> traffic = {random_traffic(random, 0, 200), random_traffic(random, 0, 200)};
        Outcome bytes = run_on_runtime(timing, traffic, true);
        Outcome closed = run_on_runtime(timing, traffic, false);
        REQUIRE(bytes.completed);
        REQUIRE(closed.course == bytes.course);
        REQUIRE(closed.fingerprint == bytes.fingerprint);
    }
}

namespace {

/// Returns one to three random faults that begin within this many nanoseconds.
std::vector<LinkFault> random_faults(RandomStream& random, std::uint32_t nanoseconds) {
    std::vector<LinkFault> faults(1 + random.below(3));
    for (LinkFault& fault : faults) {
        fault.kind = std::array{LinkFault::Kind::silent, LinkFault::Kind::loses_acknowledge,
                                LinkFault::Kind::slow}[random.below(3)];
        fault.from = std::chrono::nanoseconds{random.chance(0.1) ? 0 : random.below(nanoseconds)};
        if (fault.kind != LinkFault::Kind::loses_acknowledge && random.chance(0.6))
            fault.until = fault.from + std::chrono::nanoseconds{1 + random.below(20'000)};
        if (fault.kind == LinkFault::Kind::slow)
            fault.factor = std::array{1, 2, 4, 5}[random.below(4)]; // factors that give whole nanoseconds
        else if (random.chance(0.6))
            (random.chance(0.5) ? fault.wire_from_a : fault.wire_from_b) = false;
    }
    return faults;
}

bool same(const std::vector<FaultEffect>& x, const std::vector<FaultEffect>& y) {
    return std::ranges::equal(x, y, [](const FaultEffect& a, const FaultEffect& b) {
        bool same_hit = a.first.has_value() == b.first.has_value() &&
                        (!a.first || (a.first->at == b.first->at && a.first->byte == b.first->byte &&
                                      a.first->acknowledge == b.first->acknowledge));
        return same_hit && a.bytes_lost == b.bytes_lost && a.acknowledges_lost == b.acknowledges_lost;
    });
}

} // namespace

TEST_CASE("random traffic over a link with faults goes as far and takes the time as on a circuit of bits") {
    constexpr std::size_t courses = test::sanitized ? 40 : 200;
    std::size_t stuck = 0;
    for (std::uint64_t seed : test::seeds(courses)) {
        INFO(test::replay(seed));
        RandomStream random(seed, "faulty link against bits");
        LinkTiming timing = random_timing(random);
        std::array<Traffic, 2> traffic = {random_traffic(random, 3, 20), random_traffic(random, 7, 20)};
        std::vector<LinkFault> faults = random_faults(random, 60'000);
        Outcome bytes = run_on_runtime(timing, traffic, true, faults);
        auto expected = BitModel(timing, traffic, faults).run_until(bytes.end.count() / 1000 + 30'000);
        REQUIRE(bytes.course == expected);
        REQUIRE(run_on_runtime(timing, traffic, false, faults).course == expected);
        stuck += !bytes.completed;
    }
    if (test::all_seeds()) {
        CHECK(stuck > courses / 4);
        CHECK(stuck < courses * 19 / 20);
    }
}

TEST_CASE("the closed form gives the times of the single bytes on a link with faults") {
    for (std::uint64_t seed : test::seeds(3000)) {
        INFO(test::replay(seed));
        RandomStream random(seed, "closed form against bytes, with faults");
        LinkTiming timing = random_timing(random);
        std::array<Traffic, 2> traffic = {random_traffic(random, 0, 200), random_traffic(random, 0, 200)};
        std::vector<LinkFault> faults = random_faults(random, random.chance(0.5) ? 50'000 : 500'000);
        Outcome bytes = run_on_runtime(timing, traffic, true, faults);
        Outcome closed = run_on_runtime(timing, traffic, false, faults);
        REQUIRE(closed.course == bytes.course);
        REQUIRE(closed.fingerprint == bytes.fingerprint);
        REQUIRE(same(closed.effects, bytes.effects));
    }
}
