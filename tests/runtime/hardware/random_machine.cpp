#include "random_machine.hpp"

#include "runtime/hardware/bus_programs.hpp"
#include "runtime/hardware/link_adapter.hpp"
#include "runtime/hardware/workstation.hpp"
#include "runtime/timer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

namespace placedpar::test {

using namespace hardware;

namespace {

std::int64_t some_speed(RandomStream& random) {
    if (random.chance(0.4))
        return std::array{5'000'000, 10'000'000, 20'000'000}[random.below(3)];
    return random.chance(0.5) ? 8'000 + random.below(200'000) : 100 + random.below(8'000);
}

} // namespace

RandomMachine::RandomMachine(std::uint64_t seed, bool every_byte)
    : random_(seed, "random machine"), bits_per_second_(some_speed(random_)),
      pace_(bits_per_second_, random_.chance(0.6)),
      most_rounds_(std::array{0u, 0u, 1u, 3u, 25u, 25u, 25u}[random_.below(7)]), quiet_(random_.chance(0.4)),
      limit_(most_rounds_ == 0 ? duration_of(2'000 + random_.below(20'000), bits_per_second_) : Time::max()) {
    for (std::uint32_t i = 0, n = 2 + random_.below(3); i < n; ++i)
        add_node();
    for (std::uint32_t i = 0, n = also(0.7) ? 2 + random_.below(3) : 1; i < n; ++i)
        add_link(every_byte);
    for (const auto* nodes : {&nodes_, &hosts_})
        for (const Node& node : *nodes)
            add_receiver(node, node.inputs);
    if (also(0.7))
        start("observer", nullptr, [this](RandomProgram& p) { p.repeat(400, [this](auto&) { observe(now()); }); });
    if (bits_per_second_ < 10'000)
        has("slow links");
    if (seed % 2 == 1)
        simulation_.trace_to(log_);
}

RunResult RandomMachine::run() {
    return simulation_.run(limit_, [this] { observe(Time::max()); });
}

bool RandomMachine::lanes_are_whole() const { return std::ranges::all_of(lanes_, &Lane::is_whole); }

void RandomMachine::start(const std::string& name, Executive* executive, std::function<void(RandomProgram&)> body) {
    int rounds =
        most_rounds_ == 0 ? std::numeric_limits<int>::max() : 1 + static_cast<int>(random_.below(most_rounds_));
    RandomProgram program(RandomStream(random_(), name), pace_, rounds, log_);
    Priority priority = random_.chance(0.5) ? Priority::high : Priority::low;
    simulation_.process(
        name, [body, program]() mutable { body(program); }, executive, priority);
}

void RandomMachine::add_node() {
    Memory memory{.access = Cycles{1 + random_.below(4)}, .bytes_in_a_word = random_.chance(0.3) ? 2 : 4};
    std::int64_t clock = std::array{17'500'000, 20'000'000, 25'000'000}[random_.below(3)];
    auto& processor = simulation_.add<Processor>(fmt::format("t{}", nodes_.size()), clock, Cycles{0}, memory);
    auto& router = simulation_.add<Router>(&processor);
    if (random_.chance(0.3))
        return void(nodes_.push_back({nullptr, nullptr, &router}));
    nodes_.push_back({&processor, &processor, &router});
    if (also(0.7))
        add_computing(processor);
}

LinkTiming RandomMachine::some_timing() {
    LinkTiming timing{.bits_per_second = bits_per_second_ / (random_.chance(0.2) ? 2 : 1),
                      .overlapped_acknowledge = random_.chance(0.65)};
    if (random_.chance(0.5))
        timing.wire_delay = pace_.less_than(random_.chance(0.5) ? 3 : 60, random_);
    return timing;
}

void RandomMachine::add_link(bool every_byte) {
    Link& link = simulation_.add<Link>(some_timing());
    links_.push_back(&link);
    if (every_byte)
        link.from_a_to_b().simulate_every_byte(), link.from_b_to_a().simulate_every_byte();
    if (random_.chance(0.3))
        add_faults(link);
    if (also(0.3))
        lead_through_switch(link);
    auto first = random_.below(static_cast<std::uint32_t>(nodes_.size()));
    Node &a = nodes_[first], &b = nodes_[(first + 1) % nodes_.size()];
    if (random_.chance(0.3))
        return add_adapter(link, a, random_.chance(0.5));
    for (Node* node : {&a, &b})
        if (node->processor && random_.chance(0.8))
            node->processor->has_link(link);
    if (random_.chance(0.75))
        return add_channels(link, a, b);
    auto& shared = simulation_.add<RouterLink>(link, *a.router, *b.router);
    add_packets(shared, true, a, b), add_packets(shared, false, b, a);
}

void RandomMachine::add_faults(Link& link) {
    has("faults");
    for (std::uint32_t i = 0, n = 1 + random_.below(3); i < n; ++i) {
        LinkFault fault{.from = pace_.less_than(6'000, random_)};
        fault.kind = std::array{LinkFault::Kind::silent, LinkFault::Kind::loses_acknowledge, LinkFault::Kind::slow,
                                LinkFault::Kind::slow}[random_.below(4)];
        fault.factor = 1 + random_.below(5);
        if (random_.chance(0.8))
            fault.until = fault.from + pace_.bits(1) + pace_.less_than(1'200, random_);
        if (random_.chance(0.6))
            (random_.chance(0.5) ? fault.wire_from_a : fault.wire_from_b) = false;
        effects_.push_back(&link.suffer(fault));
    }
}

/// Leads the link through a switch. The link is connected at the start; at random times its connection is changed for a
/// while.
void RandomMachine::lead_through_switch(Link& link) {
    has("switch");
    Crossbar& sw = simulation_.add<Crossbar>(fmt::format("sw{}", links_.size()));
    sw.lead_on(link, 0, 1);
    using Kind = SwitchCommand::Kind;
    sw.obey({Kind::connect_links, 0, 1});
    sw.obey({Kind::ready});
    auto set = [this, &sw](RandomStream& random) {
        sw.obey({Kind::connect_links, 0, static_cast<std::uint8_t>(1 + random.below(2))});
        wait_for(pace_.less_than(60, random));
        sw.obey({Kind::connect_links, 0, 1});
        sw.obey({Kind::ready});
    };
    start("setter", nullptr, [set](RandomProgram& p) { p.repeat(6'000, set); });
}

void RandomMachine::add_channels(Link& link, Node& a, Node& b) {
    add_lane(a, b, random_.chance(0.6)).channel.put_on(link.from_a_to_b());
    if (random_.chance(0.8))
        add_lane(b, a, random_.chance(0.6)).channel.put_on(link.from_b_to_a());
}

void RandomMachine::add_packets(RouterLink& shared, bool forth, Node& from, Node& to) {
    has("packets");
    for (std::uint32_t i = 0, n = 1 + random_.below(2); i < n; ++i)
        add_lane(from, to, false).channel.put_on(simulation_.add<Route>(std::vector<Hop>{Hop{shared, forth}}));
}

/// Adds an adapter. Its host is a Sun, or a master whose programs take only the bus's time.
void RandomMachine::add_adapter(Link& link, Node& transputer, bool at_a) {
    has("adapter");
    std::string name = fmt::format("host{}", hosts_.size());
    Executive* sun = random_.chance(0.5) ? &simulation_.add<Workstation>(name) : nullptr;
    BusProgram program = random_.chance(0.5) ? bus_programs::sun_3_280 : bus_programs::bbk_v2;
    program.most_polls = 1 + random_.below(40);
    auto& bus = simulation_.add<VmeBus>(name + ".bus");
    auto& master = simulation_.add<VmeMaster>(name, bus, VmePlace{}, program);
    auto& adapter =
        simulation_.add<LinkAdapter>(name + ".adapter", link, at_a ? LinkAdapter::End::a : LinkAdapter::End::b);
    auto& driver = simulation_.add<AdapterProgram>(master, adapter);
    if (transputer.processor)
        transputer.processor->has_link(link);
    Node& host = hosts_.emplace_back(Node{sun, nullptr, nullptr});
    add_lane(host, transputer, random_.chance(0.7)).channel.put_on(driver.to_link());
    add_lane(transputer, host, random_.chance(0.7)).channel.put_on(driver.from_link());
}

Lane& RandomMachine::add_lane(Node& from, Node& to, bool can_be_given_up) {
    Lane& lane = lanes_.emplace_back(fmt::format("c{}", lanes_.size()), can_be_given_up);
    if (also(0.4))
        to.inputs.push_back(&lane);
    else if (random_.chance(0.9)) // otherwise no process ever receives
        add_receiver(to, {&lane});
    start("sends on " + lane.channel.name(), from.executive, [&lane](RandomProgram& p) { p.send(lane); });
    if (can_be_given_up && also(0.5))
        add_failures(lane);
    return lane;
}

void RandomMachine::add_failures(Lane& lane) {
    lane.failures_are_told = true;
    for (Channel<int>* fails : {&lane.output_fails, &lane.input_fails})
        start("tells that " + fails->name(), nullptr,
              [fails](RandomProgram& p) { p.repeat(300, [fails](auto&) { fails->out().output(0); }); });
}

void RandomMachine::add_receiver(const Node& node, const std::vector<Lane*>& lanes) {
    if (!lanes.empty())
        start("receives on " + lanes.front()->channel.name(), node.executive,
              [lanes](RandomProgram& p) { p.receive(lanes); });
}

void RandomMachine::add_computing(Processor& processor) {
    has("computing");
    auto compute_and_note = [this, &processor](RandomStream& random) {
        Cycles work{random.below(4'000)};
        compute(work, {.between_points = Cycles{1 + random.below(30)}});
        log_.note(now(), "has computed on " + processor.name(), 0);
    };
    start("computes on " + processor.name(), &processor,
          [compute_and_note](RandomProgram& p) { p.repeat(400, compute_and_note); });
}

/// Logs the machine's statistics.
void RandomMachine::observe(Time at) {
    for (const Link* link : links_)
        for (const LinkDirection* direction : {&link->from_a_to_b(), &link->from_b_to_a()}) {
            log_.note(at, "bytes", static_cast<std::int64_t>(direction->bytes_carried()));
            log_.note(at, "occupied", direction->time_occupied().count());
        }
    for (const FaultEffect* effect : effects_)
        if (effect->first) {
            log_.note(at, "lost", static_cast<std::int64_t>(effect->bytes_lost + effect->acknowledges_lost));
            log_.note(at, "first struck", effect->first->at.count());
        }
    for (const Node& node : nodes_)
        if (node.processor) {
            log_.note(at, "busy", node.processor->time_busy().count());
            log_.note(at, "memory", node.processor->memory_taken_by_links().count());
        }
}

} // namespace placedpar::test
