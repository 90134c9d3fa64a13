// Tests faults and changes of speed that begin or end at every nanosecond of a message of three bytes. Compares the
// runtime's link with the bit model. The start of a packet decides whether a fault affects the packet, so a picosecond
// before and after each start are also tried.

#include "bit_model.hpp"

#include "runtime/hardware/link.hpp"
#include "runtime/recovery.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"
#include "tests/sanitized.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

using namespace placedpar;
using namespace placedpar::hardware;
using namespace placedpar::test;

namespace {

struct SoManyBytes {
    std::uint32_t count = 0;
    WireForm wire_form() const { return WireForm(count); }
};

constexpr std::int64_t patience = 30'000; ///< nanoseconds until the processes give up; nothing more happens by then

Time in_ns(std::int64_t nanoseconds) { return std::chrono::nanoseconds{nanoseconds}; }
std::int64_t ns_of(Time t) {
    CHECK(t.count() % 1000 == 0);
    return t.count() / 1000;
}

/// The outcome of an exchange: the ends of the messages, and the effect of the fault.
struct Fate {
    std::array<Course, 2> course;
    std::array<std::uint64_t, 2> acknowledged{}, taken{}; ///< bytes of messages that were given up
    std::uint64_t bytes_lost = 0, acknowledges_lost = 0;
    std::optional<std::int64_t> first_struck, last_lost; ///< nanoseconds
    bool operator==(const Fate&) const = default;
};

/// One message in each direction. A message whose first part has no bytes is left out.
struct TwoMessages {
    LinkTiming timing;
    std::array<Traffic::Message, 2> messages;
    bool has_message(std::size_t d) const { return messages[d].parts[0] > 0; }
    std::array<Traffic, 2> traffic() const {
        std::array<Traffic, 2> both;
        for (std::size_t d : {0u, 1u})
            if (has_message(d))
                both[d].messages.push_back(messages[d]);
        return both;
    }
};

Fate fate_of(BitModel model, const LinkFault& fault) {
    Fate fate;
    fate.course = model.run_until_quiet(patience);
    for (std::size_t d : {0u, 1u}) {
        if (fate.course[d].output_ended.empty())
            fate.acknowledged[d] = model.bytes_acknowledged(d);
        if (fate.course[d].input_ended.empty())
            fate.taken[d] = model.bytes_arrived(d);
    }
    for (const auto& packet : model.packets()) {
        Time began = in_ns(packet.began);
        if (packet.lost || (fault.kind == LinkFault::Kind::slow && fault.from <= began && began < fault.until))
            fate.first_struck = fate.first_struck.value_or(packet.began);
        if (packet.lost) {
            ++(packet.acknowledge ? fate.acknowledges_lost : fate.bytes_lost);
            fate.last_lost = packet.began;
        }
    }
    return fate;
}

void add_processes(Simulation& simulation, Channel<SoManyBytes>& channel, const Traffic::Message& message,
                   std::size_t d, Fate& fate) {
    simulation.process("sender", [&, d] {
        wait_for(in_ns(message.sender_pause));
        if (output_or_fail(channel.out(), {message.parts[0]}, in_ns(patience)))
            fate.course[d].output_ended.push_back(ns_of(now()));
        else
            fate.acknowledged[d] = reset(channel.out());
    });
    simulation.process("receiver", [&, d] {
        wait_for(in_ns(message.receiver_pause));
        SoManyBytes received;
        if (input_or_fail(channel.in(), received, in_ns(patience)))
            fate.course[d].input_ended.push_back(ns_of(now()));
        else
            fate.taken[d] = reset(channel.in());
    });
}

/// Sends the messages over the runtime's link.
Fate fate_on_runtime(const TwoMessages& exchange, const LinkFault& fault, bool every_byte) {
    Simulation simulation;
    Link& link = simulation.add<Link>(exchange.timing);
    const FaultEffect& effect = link.suffer(fault);
    LinkDirection* directions[2] = {&link.from_a_to_b(), &link.from_b_to_a()};
    std::array<Channel<SoManyBytes>, 2> channels = {Channel<SoManyBytes>("there"), Channel<SoManyBytes>("back")};
    Fate fate;
    for (std::size_t d : {0u, 1u}) {
        if (every_byte)
            directions[d]->simulate_every_byte();
        channels[d].put_on(*directions[d]);
        if (exchange.has_message(d))
            add_processes(simulation, channels[d], exchange.messages[d], d, fate);
    }
    CHECK(simulation.run().ending == Ending::completed);
    fate.bytes_lost = effect.bytes_lost;
    fate.acknowledges_lost = effect.acknowledges_lost;
    if (effect.first)
        fate.first_struck = ns_of(effect.first->at);
    if (effect.last)
        fate.last_lost = ns_of(effect.last->at);
    return fate;
}

/// Moves one edge of a fault, which is its beginning or its end, through the time of an exchange.
class MovingEdge {
public:
    MovingEdge(const TwoMessages& exchange, const LinkFault& fault, Time LinkFault::*edge)
        : exchange_(exchange), fault_(fault), edge_(edge),
          ahead_(exchange.timing, exchange.traffic(),
                 edge == &LinkFault::from ? std::vector<LinkFault>{} : std::vector{fault}) {}

    /// Checks that runtime and model agree for an edge at each nanosecond from `first` to `last`. REQUIRES: if the edge
    /// is the end of a fault, the fault begins before `first`.
    void pass(std::int64_t first, std::int64_t last) {
        if (first > 0)
            ahead_.run_until(first - 1);
        first_ = first;
        for (std::int64_t t = first; t <= last; ++t) {
            fault_.*edge_ = in_ns(t);
            BitModel model = ahead_; // the edge makes no difference before this time
            model.suffer({fault_});
            fates_.push_back(fate_of(model, fault_));
            check(fates_.back());
            ahead_.run_until(t);
        }
    }

    /// Checks the runtime with the edge a picosecond before and after the start of each packet. With the edge before,
    /// the outcome must be that of an edge at the start. With the edge after, it must be that of an edge a nanosecond
    /// later. REQUIRES: pass() was called.
    void check_picoseconds() {
        for (const auto& packet : ahead_.packets()) {
            if (packet.began < first_ || packet.began >= last())
                continue;
            if (packet.began > first_) {
                fault_.*edge_ = in_ns(packet.began) - Time{1};
                check(fate_at(packet.began));
            }
            fault_.*edge_ = in_ns(packet.began) + Time{1};
            check(fate_at(packet.began + 1));
        }
    }

    /// Returns the times of the edge after which the outcome changes.
    std::vector<std::int64_t> changes() const {
        std::vector<std::int64_t> all;
        for (std::int64_t t = first_; t < last(); ++t)
            if (fate_at(t) != fate_at(t + 1))
                all.push_back(t);
        return all;
    }
    /// Returns the starts of packets that the fault would affect with its edge at this start.
    std::vector<std::int64_t> starts() const {
        std::vector<std::int64_t> all;
        for (const auto& packet : ahead_.packets()) {
            bool on_wire = packet.wire == 0 ? fault_.wire_from_a : fault_.wire_from_b;
            bool is_struck = fault_.kind == LinkFault::Kind::slow ||
                             (on_wire && (packet.acknowledge || fault_.kind == LinkFault::Kind::silent));
            if (is_struck && packet.began >= first_ && packet.began < last())
                all.push_back(packet.began);
        }
        all.erase(std::unique(all.begin(), all.end()), all.end()); // both wires may begin a packet
        return all;
    }

private:
    std::int64_t last() const { return first_ + static_cast<std::int64_t>(fates_.size()) - 1; }
    const Fate& fate_at(std::int64_t t) const { return fates_[static_cast<std::size_t>(t - first_)]; }
    void check(const Fate& expected) const {
        CAPTURE((fault_.*edge_).count());
        REQUIRE(fate_on_runtime(exchange_, fault_, true) == expected);
        REQUIRE(fate_on_runtime(exchange_, fault_, false) == expected);
    }

    const TwoMessages& exchange_;
    LinkFault fault_;
    Time LinkFault::*edge_;
    BitModel ahead_; ///< has run up to the edge
    std::int64_t first_ = 0;
    std::vector<Fate> fates_; ///< for each nanosecond from first_ on
};

/// Returns exchanges of three bytes in one direction, and in both. Without overlapped acknowledges the wires are idle
/// half of the time; twice the speed then halves the number of times to try.
std::vector<TwoMessages> exchanges() {
    constexpr std::uint32_t most = sanitized ? 1 : 3;
    std::vector<TwoMessages> all;
    for (bool overlapped : {true, false})
        for (std::uint32_t bytes_back : {0u, most}) {
            if (sanitized && !(overlapped && bytes_back > 0))
                continue;
            LinkTiming timing{.bits_per_second = overlapped ? 20'000'000 : 40'000'000,
                              .wire_delay = in_ns(35),
                              .overlapped_acknowledge = overlapped};
            all.push_back({timing, {{{0, 0, {most}}, {130, 130, {bytes_back}}}}});
        }
    return all;
}

/// Calls `f` with each exchange and its packets without a fault.
template <typename F>
void with_each_exchange(F f) {
    for (const TwoMessages& exchange : exchanges()) {
        CAPTURE(exchange.timing.overlapped_acknowledge);
        CAPTURE(exchange.has_message(1));
        BitModel undisturbed(exchange.timing, exchange.traffic());
        undisturbed.run_until_quiet(patience);
        f(exchange, undisturbed.packets());
    }
}

void check_beginnings(const LinkFault& fault) {
    with_each_exchange([&](const TwoMessages& exchange, const std::vector<BitModel::Packet>& packets) {
        MovingEdge edge(exchange, fault, &LinkFault::from);
        edge.pass(0, packets.back().began + 2);
        CHECK(!edge.starts().empty());
        CHECK(edge.changes() == edge.starts());
        edge.check_picoseconds();
    });
}

} // namespace

TEST_CASE("a link that falls silent at any moment of a message acts as a circuit of bits") {
    check_beginnings({.wire_from_b = false});
    check_beginnings({.wire_from_a = false});
}

TEST_CASE("a link that loses an acknowledge from any moment of a message on acts as a circuit of bits") {
    check_beginnings({.kind = LinkFault::Kind::loses_acknowledge});
}

TEST_CASE("a link that slows down at any moment of a message acts as a circuit of bits") {
    check_beginnings({.kind = LinkFault::Kind::slow, .factor = 2});
}

TEST_CASE("a silence that ends at any moment before the next packet acts as on a circuit of bits") {
    for (bool wire_from_a : {true, false})
        with_each_exchange([&](const TwoMessages& exchange, std::vector<BitModel::Packet> packets) {
            std::erase_if(packets, [&](const auto& packet) { return (packet.wire == 0) != wire_from_a; });
            for (std::size_t i = 0; i + 1 < packets.size(); ++i) {
                std::int64_t began = packets[i].began, next = packets[i + 1].began;
                LinkFault fault{.from = in_ns(began + 1), .wire_from_a = wire_from_a, .wire_from_b = !wire_from_a};
                MovingEdge edge(exchange, fault, &LinkFault::until);
                edge.pass(began + 2, next + 3);
                CHECK(edge.changes() == std::vector{next});
                edge.check_picoseconds();
            }
        });
}

TEST_CASE("a slow link that becomes fast at any moment of a message acts as a circuit of bits") {
    with_each_exchange([&](const TwoMessages& exchange, const std::vector<BitModel::Packet>& packets) {
        MovingEdge edge(exchange, {.kind = LinkFault::Kind::slow, .factor = 2}, &LinkFault::until);
        edge.pass(1, 2 * packets.back().began + 2);
        auto changes = edge.changes(), starts = edge.starts();
        CHECK(!changes.empty());
        CHECK(std::ranges::includes(starts, changes)); // a slow acknowledge may have no effect
        edge.check_picoseconds();
    });
}
