#include "explore/generate/statements.hpp"

#include <fmt/format.h>

namespace placedpar::generate {

namespace {

std::string indented(std::size_t level, const std::string& text) { return std::string(4 * level, ' ') + text + "\n"; }

std::string connection(const std::string& from, const std::string& to) {
    return fmt::format("connect {} to {};", from, to);
}

} // namespace

std::string within(const std::vector<std::string>& loops, const std::vector<std::string>& statements) {
    bool block = !loops.empty() && statements.size() > 1;
    std::string text;
    for (std::size_t level = 0; level < loops.size(); ++level)
        text += indented(level, loops[level] + (block && level + 1 == loops.size() ? " {" : ""));
    for (const std::string& statement : statements)
        text += indented(loops.size(), statement);
    return text + (block ? indented(loops.size() - 1, "}") : "");
}

std::string print_wires(const Topology& topology) {
    auto end = [](const WireEnd& each) { return fmt::format("t{}.link[{}]", each.at, each.link); };
    std::string text;
    for (const Wires& wires : topology.wires)
        text += within(wires.loops,
                       {connection(end(wires.from), end(wires.to) + (wires.name.empty() ? "" : " by " + wires.name))});
    return text;
}

std::string print_channels(const Topology& topology, const std::string& process, const std::string& output,
                           const std::string& input) {
    auto end = [&](const WireEnd& each, const std::string& port) {
        return fmt::format("{}{}.{}[{}]", process, each.at, port, each.port);
    };
    std::string text;
    for (const Wires& wires : topology.wires)
        if (!wires.from.port.empty())
            text += within(wires.loops, {connection(end(wires.from, output), end(wires.to, input)),
                                         connection(end(wires.to, output), end(wires.from, input))});
    return text;
}

} // namespace placedpar::generate
