#include "random_network.hpp"

#include "runtime/random.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <utility>

namespace placedpar::test {

namespace {

using namespace std::chrono_literals;

constexpr std::uint32_t soft_channels = 0x100, process_bytes = 0x100, shared_area = 0x3000;

/// Writes the program of one node.
class NodeProgram {
public:
    NodeProgram(RandomStream& random, std::uint32_t data, bool reals) : random_(random), data_(data), reals_(reals) {}

    /// An end of a link that a process uses: so many bytes.
    struct End {
        int channel; ///< 0 to 3 outputs, 4 to 7 inputs
        std::uint32_t bytes;
    };

    void add_ends(const std::vector<End>& ends, unsigned scale) {
        for (std::size_t i = 0; i < ends.size();) {
            const bool two_inputs = i + 1 < ends.size() && ends[i].channel >= 4 && ends[i + 1].channel >= 4;
            if (two_inputs && random_.chance(0.6)) {
                begin_process();
                alternate({ends[i], ends[i + 1]});
                end_process();
                i += 2;
            } else if (i + 1 < ends.size() && random_.chance(0.2)) {
                begin_process();
                use({ends[i], ends[i + 1]}, scale);
                end_process();
                i += 2;
            } else {
                begin_process();
                if (ends[i].channel >= 4 && random_.chance(0.35))
                    alternate({ends[i]});
                else
                    use({ends[i]}, scale);
                end_process();
                ++i;
            }
        }
    }

    void add_soft_pair(unsigned scale) {
        const std::uint32_t channel = soft_channels + 4 * soft_++;
        const std::uint32_t messages = 1 + random_.below(8 * scale), bytes = 1 + random_.below(40);
        for (const bool output : {true, false}) {
            begin_process();
            for (std::uint32_t i = 0; i < messages; ++i) {
                work();
                transfer(output, from_start(channel), bytes);
            }
            end_process();
        }
    }

    void add_busy(unsigned scale) {
        begin_process();
        for (std::uint32_t i = 2 + random_.below(10 * scale); i > 0; --i)
            work();
        end_process();
    }

    /// Returns the whole program: it begins with a process that starts all others.
    std::string source() {
        std::string main = "ldc 0\nsttimer\n";
        for (std::uint32_t i = 0; i < soft_; ++i)
            main += fmt::format("mint\nldc #{:X}\nstnl 0\n", from_start(soft_channels + 4 * i));
        for (std::uint32_t i = 0; i < processes_; ++i)
            main += fmt::format("ldc p{}\nldc #{:X}\nstnl -1\nldc #{:X}\nrunp\n", i, workspace(i),
                                workspace(i) + !random_.chance(0.3));
        // Hardly any node sends bytes to one that its host has not booted yet.
        const bool waits = random_.chance(0.95);
        return (waits ? "ldc 0\nsttimer\nldc 3\ntin\n" : "") + main + "stopp\n" + text_;
    }
    std::uint32_t main_workspace() const { return workspace(15); }

private:
    std::uint32_t workspace(std::uint32_t process) const { return from_start(data_ + process * process_bytes + 0x40); }
    std::uint32_t buffer() const { return workspace(processes_) + 0x50; }
    void emit(const std::string& lines) { text_ += lines + "\n"; }
    std::string label(const char* kind) { return fmt::format("{}{}", kind, labels_++); }

    void begin_process() { emit(fmt::format("p{}:", processes_)); }
    void end_process() {
        note_time();
        emit("stopp");
        ++processes_;
    }

    void note_time() { emit("ldtimer\nldl 2\nldc 31\nprod\nsum\nstl 2"); }

    void compute() {
        const std::string begin = label("l"), end = label("e");
        emit(fmt::format("ldc {}\nstl 1\n{}: ldl 3\nldc 17\nsum\nstl 3\nldl 1\nadc -1\nstl 1\nldl 1\ncj {}\nj {}\n{}:",
                         1 + random_.below(random_.chance(0.05) ? 3000 : 60), begin, end, begin, end));
    }
    void count() {
        const std::string begin = label("l"), end = label("e");
        emit(fmt::format("ldc 0\nstl 4\nldc {}\nstl 5\n{}: ldl 3\nldl 2\nxor\nstl 3\nldlp 4\nldc {} - {}\nlend\n{}:",
                         1 + random_.below(50), begin, end, begin, end));
    }
    void work_in_reals() {
        emit(fmt::format("ldlp 6\nfpldnlsn\nldlp 7\nfpldnlsn\n{}\nldl 2\nldc {}\nsum\nstl 3\nldlp 6\nfpstnlsn",
                         random_.chance(0.5) ? "fpdiv" : "fpadd", random_.below(100)));
    }
    void move() {
        emit(fmt::format("ldc #{:X}\nldc #{:X}\nldc {}\nmove", from_start(shared_area + random_.below(800)),
                         from_start(shared_area + 0x400 + random_.below(800)), random_.below(220)));
    }
    void wait() {
        emit(fmt::format("ldtimer\nadc {}\ntin", random_.below(3)));
        note_time();
    }

    void work() {
        switch (random_.below(8)) {
        case 0: return wait();
        case 1: return count();
        case 2: return reals_ ? work_in_reals() : move();
        case 3: return move();
        case 4: return emit("ldc 1000003\nldl 3\nldc 1\nor\ndiv\nstl 3");
        case 5: return compute();
        case 6: return note_time();
        default: return;
        }
    }

    void transfer(bool output, std::uint32_t channel, std::uint32_t bytes) {
        if (output && bytes == 4 && random_.chance(0.5))
            emit(fmt::format("ldc #{:X}\nldl 2\noutword", channel));
        else if (output && bytes == 1 && random_.chance(0.5))
            emit(fmt::format("ldc #{:X}\nldl 2\noutbyte", channel));
        else
            emit(fmt::format("{}ldc #{:X}\nldc #{:X}\nldc {}\n{}",
                             output ? fmt::format("ldl 2\nldc #{:X}\nstnl 0\n", buffer()) : "", buffer(), channel,
                             bytes, output ? "out" : "in"));
        if (!output)
            emit(fmt::format("ldc #{:X}\nldnl 0\nldl 2\nsum\nstl 2", buffer()));
        note_time();
    }

    std::uint32_t channel_word(const End& end) const { return from_start(4 * static_cast<std::uint32_t>(end.channel)); }

    /// Uses the ends in turn, in parts of random length, with work between.
    void use(std::vector<End> ends, unsigned) {
        while (!ends.empty()) {
            const std::size_t which = random_.below(static_cast<std::uint32_t>(ends.size()));
            End& end = ends[which];
            const std::uint32_t most = random_.chance(0.3) ? 64 : random_.chance(0.5) ? 12 : 4;
            const std::uint32_t bytes = std::min(end.bytes, 1 + random_.below(most));
            if (random_.chance(0.5))
                work();
            transfer(end.channel < 4, channel_word(end), bytes);
            end.bytes -= bytes;
            if (end.bytes == 0)
                ends.erase(ends.begin() + static_cast<std::ptrdiff_t>(which));
        }
    }

    /// Inputs from any of the channels that is ready, a few bytes at a time, perhaps with a time-out.
    void alternate(const std::vector<End>& ends) {
        const bool timer = random_.chance(0.5), dist_first = random_.chance(0.3);
        const std::uint32_t bytes = 1 + random_.below(8);
        std::uint32_t turns = random_.below(4) * timer;
        for (const End& end : ends)
            turns += end.bytes / bytes;
        const std::string begin = label("a"), base = label("b"), end = label("e"), quit = label("q"), late = label("t");
        emit(fmt::format("ldc {}\nstl 10\n{}:", turns + 1, begin));
        if (random_.chance(0.5))
            work();
        if (timer)
            emit(fmt::format("ldtimer\nadc {}\nstl 11\ntalt\nldl 11\nldc 1\nenbt",
                             random_.below(random_.chance(0.5) ? 3 : 30)));
        else
            emit("alt");
        for (const End& each : ends)
            emit(fmt::format("ldc #{:X}\nldc 1\nenbc", channel_word(each)));
        emit(timer ? "taltwt" : "altwt");
        const std::string dist = fmt::format("ldl 11\nldc 1\nldc {} - {}\ndist", late, base);
        if (timer && dist_first)
            emit(dist);
        for (std::size_t i = 0; i < ends.size(); ++i)
            emit(fmt::format("ldc #{:X}\nldc 1\nldc {}x{} - {}\ndisc", channel_word(ends[i]), base, i, base));
        if (timer && !dist_first)
            emit(dist);
        emit(fmt::format("altend\n{}:", base));
        for (std::size_t i = 0; i < ends.size(); ++i) {
            emit(fmt::format("{}x{}:", base, i));
            transfer(false, channel_word(ends[i]), bytes);
            emit(fmt::format("j {}", end));
        }
        emit(fmt::format("{}:", late));
        work();
        emit(fmt::format("{}:", end));
        note_time();
        emit(fmt::format("ldl 10\nadc -1\nstl 10\nldl 10\ncj {}\nj {}\n{}:", quit, begin, quit));
    }

    RandomStream& random_;
    std::uint32_t data_;
    bool reals_;
    std::uint32_t processes_ = 0, soft_ = 0, labels_ = 0;
    std::string text_;
};

hardware::LinkTiming random_wire_timing(RandomStream& random) {
    hardware::LinkTiming timing;
    constexpr std::int64_t speeds[] = {5'000'000, 10'000'000, 20'000'000};
    timing.bits_per_second = speeds[random.below(3)];
    timing.wire_delay = random.chance(0.3) ? Time{std::chrono::nanoseconds{random.below(400)}} : Time{};
    timing.overlapped_acknowledge = random.chance(0.8);
    return timing;
}

NodeWorld::Options random_node_options(RandomStream& random) {
    NodeWorld::Options options;
    options.model = random.chance(0.7) ? transputer::Model::t800 : transputer::Model::t425;
    options.memory = 32768;
    constexpr std::int64_t clocks[] = {20'000'000, 25'000'000, 30'000'000};
    options.timing.clock_hz = random.chance(0.6) ? clocks[0] : clocks[random.below(3)];
    options.timing.memory_cycles = static_cast<int>(random.chance(0.7) ? 3 + random.below(3) : 3 + random.below(20));
    options.timing.switch_cycles = random.chance(0.2) ? 4 : 0;
    return options;
}

Time random_moment(RandomStream& random) { return std::chrono::nanoseconds{random.below(1'500'000)}; }

/// Lets links of some networks lose packets or become slow, and transputers halt or be analysed.
void add_failures(RandomNetwork& network, std::uint64_t seed) {
    RandomStream random(seed, "failures");
    using Kind = hardware::LinkFault::Kind;
    constexpr Kind kinds[] = {Kind::silent, Kind::loses_acknowledge, Kind::slow};
    if (random.chance(0.25))
        for (RandomNetwork::Wire& wire : network.wires)
            if (random.chance(0.6)) {
                const Time from = random_moment(random);
                wire.faults.push_back({.kind = kinds[random.below(3)],
                                       .from = from,
                                       .until = from + Time{1} + random_moment(random) / 4,
                                       .wire_from_a = random.chance(0.7),
                                       .wire_from_b = random.chance(0.7),
                                       .factor = 1 + random.below(4)});
            }
    if (random.chance(0.2))
        for (RandomNetwork::Booted& node : network.nodes)
            if (random.chance(0.5))
                (random.chance(0.5) ? node.halt_at : node.analyse_at) = random_moment(random);
}

} // namespace

RandomNetwork random_network(std::uint64_t seed, unsigned scale) {
    RandomStream random(seed, "network");
    RandomNetwork network;
    const std::size_t count = 2 + random.below(3);
    std::vector<std::vector<NodeProgram::End>> ends(count);
    std::vector<int> next_link(count, 1);
    // Simultaneous events are likely if all links have the same timing, and all nodes are equal.
    const bool alike = random.chance(0.5);
    const hardware::LinkTiming timing = random_wire_timing(random);
    const NodeWorld::Options options = random_node_options(random);
    for (std::size_t a = 0; a < count; ++a)
        for (std::size_t b = a; b < count; ++b) {
            if (a == b ? !random.chance(0.05) : !random.chance(0.8))
                continue;
            if (next_link[a] > 3 - (a == b) || next_link[b] > 3)
                continue;
            const int of_a = next_link[a]++, of_b = next_link[b]++;
            network.wires.push_back({a, b, of_a, of_b, alike ? timing : random_wire_timing(random), {}});
            for (const bool there : {true, false}) {
                if (random.chance(0.15))
                    continue;
                const std::uint32_t bytes = 1 + random.below(100 * scale);
                const int from = there ? of_a : of_b, to = there ? of_b : of_a;
                ends[there ? a : b].push_back({from, bytes});
                ends[there ? b : a].push_back({4 + to, random.chance(0.9) ? bytes : 1 + random.below(100)});
            }
        }
    for (std::size_t i = 0; i < count; ++i) {
        RandomNetwork::Booted node;
        node.options = alike ? options : random_node_options(random);
        node.boot_at = random.chance(0.5) ? Time{0} : Time{std::chrono::nanoseconds{random.below(50'000)}};
        const bool data_outside = random.chance(0.3);
        NodeProgram program(random, data_outside ? 0x2000 : 0x200, node.options.model == transputer::Model::t800);
        if (random.chance(0.5)) {
            node.from_host.resize(1 + random.below(50), 7);
            std::iota(node.from_host.begin(), node.from_host.end(), std::uint8_t{1});
            node.from_host_at = std::chrono::microseconds{random.below(300)};
            ends[i].push_back({4, static_cast<std::uint32_t>(node.from_host.size())});
        }
        if (random.chance(0.5))
            ends[i].push_back({0, 1 + random.below(30)});
        for (std::size_t k = ends[i].size(); k > 1; --k)
            std::swap(ends[i][k - 1], ends[i][random.below(static_cast<std::uint32_t>(k))]);
        program.add_ends(ends[i], scale);
        if (random.chance(0.5))
            program.add_soft_pair(scale);
        for (std::uint32_t busy = random.below(3); busy > 0; --busy)
            program.add_busy(scale);
        node.source = program.source();
        // Code that is too long for the gap before the data comes behind them.
        const std::size_t code_bytes = transputer::assemble(node.source, from_start(0x4000)).bytes.size();
        node.origin = from_start(data_outside && code_bytes < 0x1e00 ? 0x200 : 0x4000);
        node.workspace = program.main_workspace();
        network.nodes.push_back(std::move(node));
    }
    add_failures(network, seed);
    return network;
}

namespace {

std::vector<std::size_t> order_of_making(std::size_t count, RandomStream& random, bool shuffles) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = count; shuffles && i > 1; --i)
        std::swap(order[i - 1], order[random.below(static_cast<std::uint32_t>(i))]);
    return order;
}

} // namespace

std::vector<NodeOutcome> run_network(const RandomNetwork& network, const WayToRun& way) {
    NodeWorld world;
    RandomStream random(way.order, "order");
    const bool shuffles = way.order != 0;
    std::vector<transputer::Node*> nodes(network.nodes.size());
    for (const std::size_t i : order_of_making(nodes.size(), random, shuffles)) {
        nodes[i] = &world.node(fmt::format("n{}", i), network.nodes[i].options);
        NodeWorld::put(*nodes[i], transputer::assemble(network.nodes[i].source, network.nodes[i].origin));
        if (way.instruction_by_instruction)
            nodes[i]->run_instruction_by_instruction();
        if (way.ahead_by)
            nodes[i]->run_ahead_by(*way.ahead_by);
        if (network.nodes[i].halt_at)
            nodes[i]->halt_at(*network.nodes[i].halt_at);
        if (network.nodes[i].analyse_at)
            nodes[i]->analyse_at(*network.nodes[i].analyse_at);
    }
    // Hosts come among the links.
    std::vector<ScriptedEnd*> hosts(nodes.size());
    for (const std::size_t i : order_of_making(network.wires.size() + nodes.size(), random, shuffles)) {
        if (i < nodes.size()) {
            const RandomNetwork::Booted& booted = network.nodes[i];
            hosts[i] = &world.host(*nodes[i]);
            world.boot(*hosts[i], booted.origin, booted.workspace, booted.boot_at);
            if (!booted.from_host.empty())
                hosts[i]->will_give(booted.from_host_at, booted.from_host);
            continue;
        }
        const RandomNetwork::Wire& wire = network.wires[i - nodes.size()];
        const bool turned = shuffles && random.chance(0.5);
        hardware::Link& link =
            turned ? world.connect(*nodes[wire.b], wire.link_of_b, *nodes[wire.a], wire.link_of_a, wire.timing)
                   : world.connect(*nodes[wire.a], wire.link_of_a, *nodes[wire.b], wire.link_of_b, wire.timing);
        for (hardware::LinkFault fault : wire.faults) {
            if (turned)
                std::swap(fault.wire_from_a, fault.wire_from_b);
            link.suffer(fault);
        }
        if (way.every_byte) {
            link.from_a_to_b().simulate_every_byte();
            link.from_b_to_a().simulate_every_byte();
        }
    }
    if (shuffles)
        world.simulation.shuffle(way.order);
    if (way.trace)
        world.simulation.trace_to(*way.trace);
    world.run(way.until);
    std::vector<NodeOutcome> outcomes;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        transputer::Core& core = nodes[i]->core();
        way.at_end(*nodes[i]);
        const auto memory = core.memory().bytes(0, core.memory().size());
        outcomes.push_back({core.registers(),
                            {memory.begin(), memory.end()},
                            hosts[i]->received(),
                            hosts[i]->received_at(),
                            core.instructions(),
                            core.busy(),
                            core.local_time(),
                            nodes[i]->time_busy(),
                            nodes[i]->memory_taken_by_links()});
    }
    return outcomes;
}

std::string difference_of(const std::vector<NodeOutcome>& all, const std::vector<NodeOutcome>& others) {
    for (std::size_t i = 0; i < all.size(); ++i) {
        const NodeOutcome &a = all[i], &b = others[i];
        if (a.memory != b.memory) {
            const auto at = std::ranges::mismatch(a.memory, b.memory).in1 - a.memory.begin();
            return fmt::format("node {}: memory differs from offset #{:X} on", i, at);
        }
        if (a.instructions != b.instructions)
            return fmt::format("node {}: {} and {} instructions", i, a.instructions, b.instructions);
        if (a.local_time != b.local_time)
            return fmt::format("node {}: ends at {} and {} ps", i, a.local_time.count(), b.local_time.count());
        if (a.busy != b.busy || a.time_busy != b.time_busy)
            return fmt::format("node {}: busy for {} and {} half cycles", i, a.busy, b.busy);
        if (a.taken_by_links != b.taken_by_links)
            return fmt::format("node {}: links take {} and {} ps", i, a.taken_by_links.count(),
                               b.taken_by_links.count());
        const auto registers = [](const transputer::Registers& r) {
            return fmt::format("Iptr #{:X} Wptr #{:X} A #{:X} B #{:X} C #{:X}", r.instruction, r.workspace, r.a, r.b,
                               r.c);
        };
        if (registers(a.registers) != registers(b.registers))
            return fmt::format("node {}: {} and {}", i, registers(a.registers), registers(b.registers));
        if (a.host_received != b.host_received || a.host_received_at != b.host_received_at)
            return fmt::format("node {}: the host receives other bytes, or at another time", i);
    }
    return "";
}

} // namespace placedpar::test
