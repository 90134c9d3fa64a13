#include "node_world.hpp"

#include "runtime/channel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace placedpar::test {

void ScriptedEnd::will_give(Time at, std::vector<std::uint8_t> bytes) {
    gifts_.push_back({at, std::move(bytes)});
    if (!scheduled())
        kernel_.future().schedule(*this, at, EventQueue::timer);
}

void ScriptedEnd::happen() noexcept {
    if (!gives_)
        begin_next();
}

void ScriptedEnd::begin_next() {
    if (next_ == gifts_.size())
        return;
    if (gifts_[next_].at > kernel_.now()) {
        kernel_.future().reschedule(*this, gifts_[next_].at, EventQueue::timer);
        return;
    }
    gives_ = true;
    read_ = 0;
    out->give(static_cast<std::uint32_t>(gifts_[next_].bytes.size()));
}

void ScriptedEnd::read(std::span<std::uint8_t> to) {
    for (std::uint8_t& each : to)
        each = gifts_[next_].bytes[read_++];
}

void ScriptedEnd::given() {
    gives_ = false;
    given_at_.push_back(kernel_.now());
    ++next_;
    begin_next();
}

void ScriptedEnd::write(std::span<const std::uint8_t> bytes) {
    received_.insert(received_.end(), bytes.begin(), bytes.end());
}

void ScriptedEnd::taken() { received_at_.push_back(kernel_.now()); }

transputer::Node& NodeWorld::node(const std::string& name, const Options& options) {
    return simulation.add<transputer::Node>(name, options.model, options.memory, options.timing);
}

namespace {

/// A link with both of its lanes.
struct LinkOfBytes {
    LinkOfBytes(Kernel& kernel, transputer::ByteEnd& a, transputer::ByteEnd& b, const hardware::LinkTiming& timing)
        : link(kernel, timing), lanes(link, a, b) {}
    hardware::Link link;
    transputer::ByteLink lanes;
};

} // namespace

hardware::Link& NodeWorld::connect(transputer::ByteEnd& a, transputer::ByteEnd& b, const hardware::LinkTiming& timing) {
    return simulation.add<LinkOfBytes>(a, b, timing).link;
}

hardware::Link& NodeWorld::connect(transputer::Node& a, int link_of_a, transputer::Node& b, int link_of_b,
                                   const hardware::LinkTiming& timing) {
    hardware::Link& link = connect(a.end(link_of_a), b.end(link_of_b), timing);
    a.has_link(link);
    b.has_link(link);
    return link;
}

ScriptedEnd& NodeWorld::host(transputer::Node& node, int number, const hardware::LinkTiming& timing) {
    auto& host = simulation.add<ScriptedEnd>();
    node.has_link(connect(host, node.end(number), timing));
    return host;
}

void NodeWorld::put(transputer::Node& node, const transputer::Assembly& program) {
    node.core().copy_to_memory(transputer::NodeMemory::offset_of(program.origin), program.bytes);
}

void NodeWorld::boot(ScriptedEnd& host, std::uint32_t code, std::uint32_t workspace, Time at) {
    const transputer::Assembly loader =
        transputer::assemble(fmt::format("ldc #{:X}\ngajw\nldc #{:X}\ngcall", workspace, code));
    std::vector<std::uint8_t> bytes{static_cast<std::uint8_t>(loader.bytes.size())};
    bytes.insert(bytes.end(), loader.bytes.begin(), loader.bytes.end());
    host.will_give(at, std::move(bytes));
}

void NodeWorld::run_at_boot(transputer::Node& node, std::string_view source, std::uint32_t workspace,
                            std::uint32_t origin) {
    put(node, transputer::assemble(source, origin));
    boot(host(node), origin, workspace);
}

Time NodeWorld::run(Time limit) {
    Channel<int> never("never");
    simulation.process("waits to the end", [&] { never.in().input(); });
    return simulation.run(limit).time;
}

} // namespace placedpar::test
