#include "netlist/node_type.hpp"

#include <cctype>
#include <map>
#include <string_view>

namespace placedpar {

namespace {

using Types = std::map<std::string, NodeType, std::less<>>;

constexpr std::int64_t kilobyte = 1024, megabyte = 1024 * 1024;

/// The databook names the T800, T805 and T425 as overlapping acknowledges, the T414 as not. Taken from there: the T801,
/// T400, T222 and T225 are of the former's generation, the T212 and M212 of the T414's.
bool overlaps_acknowledges(std::string_view chip) { return chip != "T414" && chip != "T212" && chip != "M212"; }

NodeType transputer(const std::string& name, std::int64_t memory, int links) {
    NodeType type;
    type.preset.type = name;
    type.preset.memory_bytes = memory;
    type.preset.overlapped_acknowledge = overlaps_acknowledges(name);
    type.links = links;
    return type;
}

NodeType device(const std::string& name, NodeKind kind, int links) {
    NodeType type;
    type.preset.type = name;
    type.preset.kind = kind;
    type.links = links;
    return type;
}

void add_transputers(Types& types) {
    struct Chip {
        const char* name;
        std::int64_t memory; ///< on the chip
        int links;
    };
    // M212: two links for the network, two of the four lead to its disk ports.
    static constexpr Chip chips[] = {{"T805", 4 * kilobyte, 4}, {"T801", 4 * kilobyte, 4}, {"T800", 4 * kilobyte, 4},
                                     {"T425", 4 * kilobyte, 4}, {"T414", 2 * kilobyte, 4}, {"T400", 2 * kilobyte, 2},
                                     {"T225", 4 * kilobyte, 4}, {"T222", 4 * kilobyte, 4}, {"T212", 2 * kilobyte, 4},
                                     {"M212", 2 * kilobyte, 2}};
    for (const auto& chip : chips) {
        auto type = transputer(chip.name, chip.memory, chip.links);
        std::string lower(1, static_cast<char>(std::tolower(chip.name[0])));
        lower += chip.name + 1;
        types.emplace(chip.name, type);
        types.emplace(lower, type);
    }
}

void add_modules(Types& types) {
    struct Module {
        const char* name;
        const char* chip;
        std::int64_t memory;
    };
    static constexpr Module modules[] = {
        {"B401", "T800", 32 * kilobyte}, {"B402", "T212", 8 * kilobyte}, {"B403", "T800", 1 * megabyte},
        {"B404", "T800", 2 * megabyte},  {"B405", "T800", 8 * megabyte}, {"B411", "T800", 1 * megabyte},
        {"B416", "T222", 64 * kilobyte}, {"B417", "T800", 4 * megabyte},
    };
    for (const auto& module : modules)
        types.emplace(module.name, transputer(module.chip, module.memory, 4));
}

void add_devices(Types& types) {
    NodeType processor;
    processor.needs_type = true;
    types.emplace("processor", processor);
    types.emplace("edge", device("edge", NodeKind::edge, 0));
    types.emplace("workstation", device("workstation", NodeKind::workstation, most_workstation_links));
    types.emplace("C004", device("C004", NodeKind::c004, 32));
    for (const auto* name : {"C011", "C012", "VME", "busmaster"}) {
        auto type = device(name, NodeKind::workstation, 0);
        type.refusal = "link adapters, the VMEbus and bus masters come with the bus, which is not there yet";
        types.emplace(name, type);
    }
}

const Types& types() {
    static const Types all = [] {
        Types result;
        add_transputers(result);
        add_modules(result);
        add_devices(result);
        return result;
    }();
    return all;
}

} // namespace

const NodeType* predefined_node_type(std::string_view name) {
    auto found = types().find(name);
    return found == types().end() ? nullptr : &found->second;
}

std::vector<std::string> predefined_node_type_names() {
    std::vector<std::string> names;
    for (const auto& [name, type] : types())
        names.push_back(name);
    return names;
}

} // namespace placedpar
