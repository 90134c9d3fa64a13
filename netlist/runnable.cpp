#include "netlist/runnable.hpp"

#include "text/counted.hpp"
#include "text/diagnostic.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

namespace placedpar {

namespace {

/// Lists the processes with one unknown program, or the channels to one edge (an end of the network) without a process.
struct Missing {
    std::vector<std::string> names;
    Location first;

    void add(const std::string& name, const Location& at) {
        if (names.empty())
            first = at;
        names.push_back(name);
    }
};
using MissingByName = std::map<std::string, Missing>;

MissingByName unknown_programs(const Network& network, const Catalogue& catalogue) {
    MissingByName programs;
    for (const ProcessInstance& process : network.processes)
        if (catalogue.find(process.kind) == nullptr)
            programs[process.kind].add(process.name, process.declared);
    return programs;
}

/// Returns the channels that lead to edges without a process; key: name of the edge.
MissingByName deserted_edges(const Network& network) {
    MissingByName edges;
    for (const NetworkChannel& channel : network.channels)
        for (const auto& [inner, outer] : {std::pair(channel.from, channel.to), std::pair(channel.to, channel.from)})
            if (outer.at_edge() && !channel.end_at_code())
                edges[network.nodes[outer.node].name].add(network.processes[inner.process].name + "." + inner.port,
                                                          channel.connected);
    return edges;
}

/// Returns a text with the first six names, and the number of the other names.
std::string listed(std::vector<std::string> names) {
    constexpr std::size_t most = 6;
    auto more = names.size() - std::min(names.size(), most);
    names.resize(names.size() - more);
    return fmt::format("{}{}", fmt::join(names, ", "), more ? fmt::format(" and {} more", more) : "");
}

SecondPlace note_on_program(const std::string& program, const Missing& missing) {
    auto what = program.empty() ? "no program is given" : fmt::format("\"{}\" is the program of", program);
    return {fmt::format("{} {}{}", what, program.empty() ? "to " : "", listed(missing.names)), missing.first};
}

SecondPlace note_on_edge(const std::string& edge, const Missing& missing) {
    return {
        fmt::format("the edge \"{}\" has no process, but these channels lead to it: {}", edge, listed(missing.names)),
        missing.first};
}

/// Returns a text such as "2 programs are unknown, and 1 edge has no process".
std::string summary(std::size_t programs, std::size_t edges) {
    auto unknown = counted(programs, "program") + (programs == 1 ? " is" : " are") + " unknown";
    auto deserted = counted(edges, "edge") + (edges == 1 ? " has" : " have") + " no process";
    return programs == 0 ? deserted : edges == 0 ? unknown : unknown + ", and " + deserted;
}

/// Returns a hint: the options or statements that replace the first unknown program, and give the first edge a process.
std::string remedy(const MissingByName& programs, const MissingByName& edges) {
    std::string text;
    if (auto named = std::ranges::find_if(programs, [](const auto& each) { return !each.first.empty(); });
        named != programs.end())
        text = fmt::format("--use {}=KIND runs a kind instead of the program; the command \"kinds\" lists the kinds",
                           named->first);
    if (auto without = programs.find(""); without != programs.end())
        text += fmt::format("{}use \"KIND\" for {};", text.empty() ? "" : "; ", without->second.names.front());
    if (!edges.empty())
        text += fmt::format("{}place NAME on {}; places a process at the edge", text.empty() ? "" : "; ",
                            edges.begin()->first);
    return text;
}

} // namespace

void require_runnable(const Network& network, const Catalogue& catalogue) {
    auto programs = unknown_programs(network, catalogue), edges = deserted_edges(network);
    if (programs.empty() && edges.empty())
        return;
    Diagnostic all;
    all.message = fmt::format("the netlist can be shown, but not run: {}", summary(programs.size(), edges.size()));
    all.location = {std::make_shared<SourceFile>(network.source_path, ""), 0, 0};
    all.hint = remedy(programs, edges);
    for (const auto& [program, missing] : programs)
        all.others.push_back(note_on_program(program, missing));
    for (const auto& [edge, missing] : edges)
        all.others.push_back(note_on_edge(edge, missing));
    throw RefusedInput(render(all));
}

} // namespace placedpar
