#include "random_machine.hpp"

#include "runtime/alternation.hpp"
#include "runtime/recovery.hpp"
#include "runtime/timer.hpp"

#include <fmt/format.h>

#include <array>
#include <chrono>

namespace placedpar::test {

using namespace hardware;
using std::chrono::nanoseconds;

namespace {

LinkTiming some_timing(RandomStream& random) {
    LinkTiming timing;
    timing.bits_per_second =
        std::array<std::int64_t, 4>{5'000'000, 10'000'000, 20'000'000, 20'000'000}[random.below(4)];
    if (random.chance(0.5))
        timing.wire_delay = nanoseconds{random.below(random.chance(0.5) ? 100 : 900)};
    timing.overlapped_acknowledge = random.chance(0.75);
    return timing;
}

void pause(RandomStream& random) {
    if (random.chance(0.3))
        wait_for(nanoseconds{random.below(random.chance(0.7) ? 2'000 : 40'000)});
}

Time soon(RandomStream& random) { return now() + nanoseconds{random.below(random.chance(0.5) ? 10'000 : 300'000)}; }

} // namespace

RandomMachine::RandomMachine(std::uint64_t seed, bool every_byte)
    : random_(seed, "random machine"), limit_(nanoseconds{100'000 + random_.below(3'000'000)}) {
    for (std::uint32_t i = 0, n = 2 + random_.below(3); i < n; ++i)
        add_node();
    for (std::uint32_t i = 0, n = 1 + random_.below(4); i < n; ++i)
        add_link(every_byte);
    for (Node& node : nodes_)
        add_computing(node), add_receiver(node, node.inputs);
    simulation_.process("observer", [this] { observe(); });
    if (seed % 2 == 1)
        simulation_.trace_to(trace_);
}

void RandomMachine::Trace::carries(const std::string& direction, const AnyChannel&, Time now, Time since) {
    log.emplace_back(now.count(), "trace: carries on " + direction, since.count());
}

void RandomMachine::Trace::carried(const std::string& direction, std::uint64_t bytes, Time now, Time until) {
    log.emplace_back(now.count(), fmt::format("trace: carried {} bytes on {}", bytes, direction), until.count());
}

void RandomMachine::add_node() {
    Memory memory{.access = Cycles{1 + random_.below(4)}, .bytes_in_a_word = random_.chance(0.3) ? 2 : 4};
    std::int64_t clock = std::array{17'500'000, 20'000'000, 25'000'000}[random_.below(3)];
    auto& processor = simulation_.add<Processor>(fmt::format("t{}", nodes_.size()), clock, Cycles{0}, memory);
    nodes_.push_back({&processor, &simulation_.add<Router>(&processor)});
}

void RandomMachine::add_link(bool every_byte) {
    Link& link = simulation_.add<Link>(some_timing(random_));
    links_.push_back(&link);
    if (every_byte)
        link.from_a_to_b().simulate_every_byte(), link.from_b_to_a().simulate_every_byte();
    auto first = random_.below(static_cast<std::uint32_t>(nodes_.size()));
    Node &a = nodes_[first], &b = nodes_[(first + 1) % nodes_.size()];
    if (random_.chance(0.8))
        a.processor->has_link(link), b.processor->has_link(link);
    if (random_.chance(0.3))
        add_faults(link);
    if (random_.chance(0.2))
        lead_through_switch(link);
    if (random_.chance(0.25)) {
        auto& shared = simulation_.add<RouterLink>(link, *a.router, *b.router);
        add_packets(shared, true, a, b), add_packets(shared, false, b, a);
    } else {
        add_channel(link.from_a_to_b(), a, b);
        if (random_.chance(0.9))
            add_channel(link.from_b_to_a(), b, a);
    }
}

void RandomMachine::add_faults(Link& link) {
    has("faults");
    for (std::uint32_t i = 0, n = 1 + random_.below(3); i < n; ++i) {
        LinkFault fault{.from = nanoseconds{random_.below(1'000'000)}};
        fault.kind = std::array{LinkFault::Kind::silent, LinkFault::Kind::loses_acknowledge, LinkFault::Kind::slow,
                                LinkFault::Kind::slow}[random_.below(4)];
        fault.factor = 1 + random_.below(5);
        if (random_.chance(0.8))
            fault.until = fault.from + nanoseconds{1 + random_.below(80'000)};
        if (random_.chance(0.6))
            (random_.chance(0.5) ? fault.wire_from_a : fault.wire_from_b) = false;
        link.suffer(fault);
    }
}

/// Connected at the start; at random moments it is connected elsewhere for a while.
void RandomMachine::lead_through_switch(Link& link) {
    has("switch");
    Crossbar& sw = simulation_.add<Crossbar>(fmt::format("sw{}", links_.size()));
    sw.lead_on(link, 0, 1);
    using Kind = SwitchCommand::Kind;
    sw.obey({Kind::connect_links, 0, 1});
    sw.obey({Kind::ready});
    simulation_.process("setter", [&sw, random = stream("setter")]() mutable {
        for (;;) {
            wait_for(nanoseconds{random.below(300'000)});
            sw.obey({Kind::connect_links, 0, static_cast<std::uint8_t>(1 + random.below(2))});
            wait_for(nanoseconds{random.below(3'000)});
            sw.obey({Kind::connect_links, 0, 1});
            sw.obey({Kind::ready});
        }
    });
}

void RandomMachine::add_channel(LinkDirection& direction, Node& from, Node& to) {
    add_lane(from, to, random_.chance(0.5)).channel.put_on(direction);
}

void RandomMachine::add_packets(RouterLink& shared, bool forth, Node& from, Node& to) {
    has("packets");
    for (std::uint32_t i = 0, n = 1 + random_.below(2); i < n; ++i)
        add_lane(from, to, false).channel.put_on(simulation_.add<Route>(std::vector<Hop>{Hop{shared, forth}}));
}

RandomMachine::Lane& RandomMachine::add_lane(Node& from, Node& to, bool can_be_given_up) {
    Lane& lane = lanes_.emplace_back(fmt::format("c{}", lanes_.size()), can_be_given_up);
    if (random_.chance(0.3))
        to.inputs.push_back(&lane);
    else
        add_receiver(to, {&lane});
    simulation_.process(
        "sends " + lane.channel.name(), [this, &lane, random = stream("sender")] { send(lane, random); },
        from.processor, some_priority());
    return lane;
}

void RandomMachine::add_computing(const Node& node) {
    if (random_.chance(0.5))
        return;
    has("computing");
    simulation_.process(
        "computes on " + node.processor->name(),
        [this, random = stream("computing"), &node]() mutable {
            for (;;) {
                compute(Cycles{random.below(4'000)}, {.between_points = Cycles{1 + random.below(30)}});
                note("has computed on " + node.processor->name(), 0);
                wait_for(nanoseconds{1 + random.below(20'000)});
            }
        },
        node.processor, some_priority());
}

void RandomMachine::add_receiver(const Node& node, const std::vector<Lane*>& lanes) {
    if (!lanes.empty())
        simulation_.process(
            "receives on " + node.processor->name(),
            [this, lanes, random = stream("receiver")] { receive(lanes, random); }, node.processor, some_priority());
}

/// At random moments, what the machine says of itself.
void RandomMachine::observe() {
    RandomStream random = stream("observer");
    for (;;) {
        wait_for(nanoseconds{1 + random.below(20'000)});
        for (const Link* link : links_)
            for (const LinkDirection* direction : {&link->from_a_to_b(), &link->from_b_to_a()}) {
                note("bytes", static_cast<std::int64_t>(direction->bytes_carried()));
                note("occupied", direction->time_occupied().count());
            }
        for (const Node& node : nodes_) {
            note("busy", node.processor->time_busy().count());
            note("memory", node.processor->memory_taken_by_links().count());
        }
    }
}

void RandomMachine::send(Lane& lane, RandomStream random) {
    auto out = lane.channel.out();
    for (int number = 0;; ++number) {
        pause(random);
        std::uint32_t longest = std::array{3u, 40u, 300u}[random.below(3)];
        Letter letter{number, random.below(3), 1 + random.below(longest)};
        if (!lane.can_be_given_up || random.chance(0.6)) {
            out.output(letter);
            note("has sent on " + lane.channel.name(), number);
        } else if (!output_or_fail(out, letter, soon(random))) {
            pause(random);
            note("has given up output on " + lane.channel.name(), static_cast<std::int64_t>(reset(out)));
        }
    }
}

void RandomMachine::receive(const std::vector<Lane*>& lanes, RandomStream random) {
    for (;;) {
        pause(random);
        Lane& lane = *lanes[random.below(static_cast<std::uint32_t>(lanes.size()))];
        if (random.chance(lanes.size() > 1 ? 0.9 : 0.3))
            alternate(lanes, random);
        else if (lane.can_be_given_up && random.chance(0.8))
            receive_or_give_up(lane, random);
        else
            note("has received on " + lane.channel.name(), lane.channel.in().input().number);
    }
}

void RandomMachine::alternate(const std::vector<Lane*>& lanes, RandomStream& random) {
    std::vector<Guard> guards;
    for (Lane* lane : lanes)
        guards.push_back({Guard::input, &lane->channel});
    guards.push_back({Guard::timeout, nullptr, soon(random)});
    std::size_t chosen = select(guards);
    note("alternation", static_cast<std::int64_t>(chosen));
    if (chosen < lanes.size())
        note("has chosen on " + lanes[chosen]->channel.name(), lanes[chosen]->channel.in().input().number);
}

void RandomMachine::receive_or_give_up(Lane& lane, RandomStream& random) {
    Letter letter;
    if (input_or_fail(lane.channel.in(), letter, soon(random)))
        return note("has received in time on " + lane.channel.name(), letter.number);
    pause(random);
    note("has given up input on " + lane.channel.name(), static_cast<std::int64_t>(reset(lane.channel.in())));
}

void RandomMachine::note(const std::string& what, std::int64_t value) { log_.emplace_back(now().count(), what, value); }

} // namespace placedpar::test
