#include "occam/configuration/netlist_writer.hpp"

#include "netlist/language/parser.hpp"
#include "netlist/network/names.hpp"
#include "netlist/print/text.hpp"
#include "occam/check/checker.hpp"
#include "occam/network/kind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

namespace placedpar::occam {

namespace {

std::string size_text(std::int64_t bytes) {
    constexpr std::int64_t kilo = 1024, mega = kilo * kilo;
    if (bytes > 0 && bytes % mega == 0)
        return fmt::format("{}M", bytes / mega);
    return bytes > 0 && bytes % kilo == 0 ? fmt::format("{}K", bytes / kilo) : std::to_string(bytes);
}

/// Returns whether the name is predefined in netlists, such as the name of a type.
bool has_meaning(const std::string& name) {
    static constexpr std::array<std::string_view, 10> words = {
        "host", "edge", "node", "processor", "PROCESSOR", "workstation", "highprocess", "lowprocess", "HIGH", "LOW"};
    const bool is_type = name.size() == 4 && (name[0] == 'T' || name[0] == 't') &&
                         std::ranges::all_of(name.substr(1), [](char c) { return c >= '0' && c <= '9'; });
    return is_reserved(name) || is_type || std::ranges::find(words, name) != words.end();
}

bool declares(const std::vector<DeclarationBox>& declarations, const Declaration& procedure) {
    return std::ranges::any_of(declarations, [&](const DeclarationBox& each) { return each.get() == &procedure; });
}

} // namespace

MadeNetlist NetlistWriter::write() {
    write_nodes();
    write_wires();
    write_processes();
    write_channels();
    write_placements();
    made_.text = std::make_shared<const SourceFile>(program_.files.front()->path(), std::move(text_));
    return std::move(made_);
}

void NetlistWriter::put(std::string_view text, const Place& place) {
    made_.origins.push_back({text_.size(), program_.location(place)});
    text_ += text;
}

/// Returns the name in the netlist: `wanted` or, if this name is already in use, a similar name.
std::string NetlistWriter::new_name(const std::string& wanted) {
    std::string name = netlist_name(wanted);
    for (int number = 2; has_meaning(name) || !names_.insert(name).second; ++number)
        name = fmt::format("{}_{}", netlist_name(wanted), number);
    return name;
}

void NetlistWriter::write_nodes() {
    elements_[{0, 0}] = "host";
    for (std::size_t object = 1; object < configured_.objects.size(); ++object) {
        const Object& each = configured_.objects[object];
        const Type::Kind kind = innermost(*each.type).kind;
        if (kind == Type::Kind::node)
            write_nodes_of(object);
        for (std::size_t i = 0; kind == Type::Kind::edge && i < count_of_elements(*each.type); ++i) {
            const std::string name = new_name(flat_name({object, i}));
            put(fmt::format("edge {};\n", name), each.at);
            elements_[{object, i}] = name;
        }
    }
}

/// Returns a name for an array element that is declared as a single node: "t_2" for t[2].
std::string NetlistWriter::flat_name(const Element& element) const {
    std::string name = configured_.objects[element.object].name;
    for (const std::int64_t subscript : subscripts_of(configured_, element))
        name += fmt::format("_{}", subscript);
    return name;
}

/// Returns whether all nodes of an array are processors of one type with equal memory.
bool NetlistWriter::are_nodes_alike(std::size_t object, std::size_t count) const {
    const NodeState& first = configured_.nodes.at({object, 0});
    bool are_alike = !first.type.empty();
    for (std::size_t i = 1; i < count; ++i) {
        const NodeState& other = configured_.nodes.at({object, i});
        are_alike &= other.type == first.type && other.memory_bytes == first.memory_bytes;
    }
    return are_alike;
}

/// Declares the processors of an array: as an array if all are alike, otherwise one by one.
void NetlistWriter::write_nodes_of(std::size_t object) {
    const Object& each = configured_.objects[object];
    const std::size_t count = count_of_elements(*each.type);
    const bool are_alike = are_nodes_alike(object, count);
    std::string dimensions;
    for (const Type* type = each.type; type->kind == Type::Kind::array; type = type->element)
        dimensions += fmt::format("[{}]", type->count.value_or(0));
    const std::string common = are_alike ? new_name(each.name) : "";
    for (std::size_t i = 0; i < count; ++i) {
        const Element element{object, i};
        const NodeState& state = configured_.nodes.at(element);
        if (state.type.empty())
            continue;
        elements_[element] =
            are_alike ? element_name(common, subscripts_of(configured_, element)) : new_name(flat_name(element));
        if (are_alike && i > 0)
            continue;
        put(state.type + " (memory = ", state.type_at);
        put(size_text(state.memory_bytes), state.memory_at);
        put(fmt::format(") {}{};\n", are_alike ? common : elements_[element], are_alike ? dimensions : ""), each.at);
    }
}

void NetlistWriter::write_end(const WireEnd& end) {
    put(elements_.at(end.element), end.at);
    if (!end.is_edge)
        put(fmt::format(".link[{}]", end.link), end.link_at);
}

void NetlistWriter::write_wires() {
    for (const WrittenWire& wire : configured_.wires) {
        put("connect ", wire.a.at);
        write_end(wire.a);
        put(" to ", wire.a.at);
        write_end(wire.b);
        put(";\n");
    }
}

void NetlistWriter::write_processes() {
    std::vector<std::pair<const Declaration*, std::vector<std::size_t>>> by_procedure;
    std::map<const Declaration*, std::size_t> known;
    for (std::size_t i = 0; i < configured_.processes.size(); ++i) {
        const Declaration* const procedure = configured_.processes[i].procedure;
        const auto [found, is_new] = known.emplace(procedure, by_procedure.size());
        if (is_new)
            by_procedure.push_back({procedure, {}});
        by_procedure[found->second].second.push_back(i);
    }
    processes_.resize(configured_.processes.size());
    for (const auto& [procedure, processes] : by_procedure)
        write_kind(*procedure, processes);
}

/// Declares the processes that execute a procedure: a single process, or an array of processes.
void NetlistWriter::write_kind(const Declaration& procedure, const std::vector<std::size_t>& processes) {
    const std::string name = new_name(procedure.name);
    const bool is_array = processes.size() > 1;
    const Place& at = configured_.processes[processes.front()].at;
    put(fmt::format("process {}{};\n", name, is_array ? fmt::format("[{}]", processes.size()) : ""), at);
    put(fmt::format("use {} for {};\n", print_constant(fmt::format("{}#{}", path_of(procedure, at), procedure.name)),
                    name),
        at);
    for (std::size_t i = 0; i < processes.size(); ++i) {
        processes_[processes[i]] = is_array ? fmt::format("{}[{}]", name, i) : name;
        write_values(processes[i]);
    }
}

void NetlistWriter::write_values(std::size_t process) {
    const PlacedProcess& placed = configured_.processes[process];
    if (placed.values.empty() && !placed.high_priority)
        return;
    put(processes_[process] + " (", placed.at);
    bool is_first = !placed.high_priority;
    if (placed.high_priority)
        put("priority = HIGH");
    for (const WrittenValue& each : placed.values) {
        put(std::exchange(is_first, false) ? "" : ", ");
        put(fmt::format("{} = {}", each.name, each.value), each.at);
    }
    put(");\n", placed.at);
}

void NetlistWriter::put_port(const ChannelEnd& end) {
    const PlacedProcess& process = configured_.processes[end.process];
    const PortDescription& port = configured_.kinds.at(process.procedure).ports[end.port];
    put(fmt::format("{}.{}{}", processes_[end.process], port.name,
                    end.element ? fmt::format("[{}]", *end.element) : ""),
        end.at);
}

void NetlistWriter::write_channels() {
    for (const Element& channel : configured_.channel_order) {
        const ChannelState& state = configured_.channels.at(channel);
        if (!state.output || !state.input)
            continue;
        put("connect ", state.output->at);
        put_port(*state.output);
        put(" to ", state.input->at);
        put_port(*state.input);
        put(";\n");
    }
}

void NetlistWriter::write_placements() {
    for (std::size_t i = 0; i < configured_.processes.size(); ++i) {
        const PlacedProcess& process = configured_.processes[i];
        put(fmt::format("place {} on ", processes_[i]), process.at);
        put(elements_.at(process.node) + ";\n", process.node_at);
    }
    for (const Element& channel : configured_.channel_order)
        write_channel_placement(configured_.channels.at(channel));
}

/// Places a channel on a link. A channel to the host needs no statement: in a netlist, an unconnected port for the host
/// leads to the host.
void NetlistWriter::write_channel_placement(const ChannelState& state) {
    const std::optional<WireEnd>& link = state.leaves ? state.leaves : state.arrives;
    if (!link)
        return;
    const ChannelEnd& end = state.leaves && state.output ? *state.output : *state.input;
    const PortDescription& port = configured_.kinds.at(configured_.processes[end.process].procedure).ports[end.port];
    if (state.leads_to_host && port.to_host)
        return;
    put("place ", state.placed_at.line > 0 ? state.placed_at : link->at);
    put_port(end);
    put(" on ", link->at);
    write_end(*link);
    put(";\n");
}

/// Returns the path of the file that declares a procedure, relative to the file that uses it.
std::string NetlistWriter::path_of(const Declaration& procedure, const Place& used_at) {
    std::uint32_t file = 0;
    for (const std::unique_ptr<Unit>& unit : program_.units)
        if (declares(unit->declarations, procedure))
            file = unit->file;
    const std::filesystem::path path = program_.files[file]->path();
    const std::filesystem::path folder = std::filesystem::path(program_.files[used_at.file]->path()).parent_path();
    if (path.string().starts_with('<'))
        reporter_.error(
            program_.location(used_at),
            fmt::format("\"{}\" belongs to a library, so it cannot be a process of a configuration", procedure.name),
            "write a PROC that calls it");
    const std::filesystem::path relative = folder.empty() ? path : path.lexically_relative(folder);
    return (relative.empty() ? std::filesystem::absolute(path) : relative).generic_string();
}

} // namespace placedpar::occam
