#include "netlist/complete/complete.hpp"
#include "netlist/kinds/bootable_file.hpp"
#include "netlist/kinds/device_kind.hpp"
#include "runtime/transputer/code_lines.hpp"
#include "text/load_source.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string_view>
#include <system_error>
#include <vector>

namespace placedpar {

namespace {

const DraftProcess* process_on(const Completion& c, std::size_t node) {
    for (const DraftProcess& process : c.draft.processes)
        if (process.node == node)
            return &process;
    return nullptr;
}

/// Returns the nodes at the other ends of a node's wires.
std::vector<std::size_t> neighbours(const Network& network, std::size_t node) {
    std::vector<std::size_t> result;
    for (const LinkConnection& wire : network.connections)
        for (const auto& [near, far] : {std::pair(wire.a, wire.b), std::pair(wire.b, wire.a)})
            if (near.node == node && !wire.over_bus)
                result.push_back(far.node);
    return result;
}

bool has_host(const Network& network, std::size_t node) {
    for (const std::size_t each : neighbours(network, node))
        if (network.nodes[each].kind->links == LinkRole::edge)
            return true;
    return false;
}

/// Checks that the node can execute machine code. `booted` is the node whose bootable file has the code.
void check_type(Completion& c, const Node& node, const Node& booted) {
    check_executes(c, node, {{"the file is named here", booted.boot_stated}});
}

void check_boot(Completion& c, std::size_t index) {
    Node& node = c.network.nodes[index];
    check_type(c, node, node);
    if (const DraftProcess* process = process_on(c, index))
        c.reporter.error(process->placed,
                         fmt::format("\"{}\" is booted with a file, so no process can be placed on it", node.name), "",
                         {{"the file is named here", node.boot_stated}});
    if (!has_host(c.network, index))
        c.reporter.error(node.boot_stated,
                         fmt::format("\"{}\" is booted with a file, but no host is connected to it", node.name),
                         fmt::format("connect {}.link[0] to host;", node.name));
    if (const auto known = c.compiled.find(node.boot_file); known != c.compiled.end()) {
        node.boot_bytes = known->second.bytes;
        return;
    }
    try {
        node.boot_bytes = std::make_shared<const std::vector<std::uint8_t>>(read_bootable(node.boot_file));
    } catch (const UserError& refused) {
        c.reporter.error(node.boot_stated, refused.what());
    }
}

/// Returns the table of source lines and processes for the code in a node's bootable file; null if there is none. If
/// PlacedPar has just compiled the code, it has the table; otherwise reads the file NAME.lines beside the bootable
/// file.
std::shared_ptr<const SourceFile> table_beside(Completion& c, const Node& booted) {
    if (const auto known = c.compiled.find(booted.boot_file); known != c.compiled.end())
        return known->second.lines;
    const std::filesystem::path path = std::filesystem::path(booted.boot_file).replace_extension(".lines");
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
        return nullptr;
    const LoadedSource source = load_source(path);
    for (const Diagnostic& each : source.problems)
        c.reporter.error(each.location, each.message);
    return source.problems.empty() ? source.file : nullptr;
}

/// Reads the part of the table for one node. `section` is the name of the node in the table.
void give_lines(Completion& c, const std::shared_ptr<const SourceFile>& table, Node& node, std::string_view section) {
    const auto model = transputer::model_named(node.type);
    if (!table || !model || node.code_lines)
        return;
    try {
        node.code_lines = std::make_shared<const transputer::CodeLines>(
            table->text(), section, transputer::most_negative + transputer::traits_of(*model).memory_start);
    } catch (const transputer::CodeLinesError& refused) {
        c.reporter.error({table, refused.line, refused.column}, refused.what());
    }
}

/// Marks the processors that a booted processor boots over their links, so that they execute its code. These are all
/// processors without processes to which wires lead from it, directly or through other such processors.
void reach(Completion& c, std::size_t from) {
    std::vector<std::size_t> reached{from};
    c.network.nodes[from].runs_own_code = true;
    const auto table = table_beside(c, c.network.nodes[from]);
    give_lines(c, table, c.network.nodes[from], "");
    while (!reached.empty()) {
        const std::size_t here = reached.back();
        reached.pop_back();
        for (const std::size_t each : neighbours(c.network, here)) {
            Node& node = c.network.nodes[each];
            if (node.runs_own_code || node.kind->name != "processor" || process_on(c, each) != nullptr)
                continue;
            check_type(c, node, c.network.nodes[from]);
            node.runs_own_code = true;
            give_lines(c, table, node, node.name);
            reached.push_back(each);
        }
    }
}

} // namespace

void check_executes(Completion& c, const Node& node, const std::vector<SecondPlace>& reason) {
    if (!transputer::model_named(node.type))
        c.reporter.error(node.declared,
                         fmt::format("\"{}\" is {}, which cannot execute code; T414, T425, T400, T800 and T805 can",
                                     node.name,
                                     node.kind->name == "processor" ? "a " + node.type : std::string(node.kind->noun)),
                         "", reason);
    else if (const std::int64_t bytes = node.integer("memory"); bytes < 2048 || bytes > 0xffff'ff00 || bytes % 256 != 0)
        c.reporter.error(node.declared,
                         fmt::format("\"{}\" has {} bytes of memory, but a processor that executes code needs 2K to "
                                     "just below 4096M, in steps of 256 bytes",
                                     node.name, bytes),
                         "", reason);
}

void complete_booted(Completion& c) {
    mark_code_nodes(c);
    for (std::size_t i = 0; i < c.network.nodes.size(); ++i)
        if (!c.network.nodes[i].boot_file.empty()) {
            check_boot(c, i);
            reach(c, i);
        }
}

} // namespace placedpar
