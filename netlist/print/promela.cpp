#include "netlist/print/promela.hpp"

#include "netlist/kinds/own_code.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <vector>

namespace placedpar {

namespace {

constexpr std::size_t most_processes = 254; ///< Spin's limit of 255 processes, minus one for `init`

std::vector<std::string> kinds_in_promela(const Catalogue& catalogue) {
    std::vector<std::string> names;
    for (const auto& [name, kind] : catalogue.kinds())
        if (kind.promela)
            names.push_back(name);
    return names;
}

const ProcessKind& kind_with_statements(const ProcessInstance& process, const Catalogue& catalogue) {
    const ProcessKind* kind = catalogue.find(process.kind);
    if (!kind || !kind->promela)
        throw UserError(
            fmt::format("\"{}\" is a {}, which has no Promela model of its communications; these kinds have one: {}",
                        process.name, process.kind.empty() ? "process without a kind" : process.kind,
                        fmt::join(kinds_in_promela(catalogue), ", ")));
    return *kind;
}

/// Returns a Promela identifier for the process: "fork[1]" becomes p3_fork_1_. The process's number makes the
/// identifier unique and different from Promela's keywords.
std::string identifier(const Network& network, std::size_t process) {
    std::string name = fmt::format("p{}_{}", process, network.processes[process].name);
    std::ranges::replace_if(
        name, [](unsigned char character) { return std::isalnum(character) == 0; }, '_');
    return name;
}

std::string indented(const std::string& statements) {
    std::string out;
    std::istringstream lines(statements);
    std::size_t depth = 1;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("}") || line == "fi" || line == "od")
            --depth;
        bool option = line.starts_with("::");
        out += std::string(4 * (option ? depth - 1 : depth), ' ') + line + "\n";
        if (line.ends_with("{") || line == "if" || line == "do")
            ++depth;
    }
    return out;
}

std::string proctype(const Network& network, std::size_t process, const Catalogue& catalogue) {
    const ProcessInstance& self = network.processes[process];
    const ProcessKind& kind = kind_with_statements(self, catalogue);
    std::string statements = ask_kind(kind, self, "for its statements in Promela",
                                      [&] { return kind.promela(PromelaProcess(network, process)); });
    return fmt::format("\n/* {}, a {} */\nproctype {}() {{\n    int i;\n    byte m;\n{}}}\n", self.name, self.kind,
                       identifier(network, process), indented(statements));
}

std::string legend(const Network& network) {
    std::string out;
    for (std::size_t i = 0; i < network.channels.size(); ++i)
        out += fmt::format("/* c[{}]: {} */\n", i, network.channels[i].name);
    return out + fmt::format("/* c[{}]: no message ever passes; used for closed guards */\n", network.channels.size());
}

/// Refuses processors that execute machine code, for which there is no model.
void refuse_code(const Network& network) {
    for (const Node& node : network.nodes)
        if (node.runs_own_code)
            throw UserError(fmt::format("\"{}\" executes its own code, which has no Promela model", node.name));
}

/// Refuses broadcasts. The outputs of a broadcast wait for each other. A model without these waits might have no
/// deadlock although the machine deadlocks.
void refuse_broadcasts(const Network& network) {
    for (const NetworkChannel& channel : network.channels)
        if (std::size_t bus = channel.placement.broadcast_on; bus != nowhere)
            throw UserError(fmt::format("the channel \"{}\" is broadcast on \"{}\", and Promela cannot model "
                                        "outputs that wait for outputs of other channels",
                                        channel.name, network.nodes[bus].name));
}

} // namespace

std::string print_promela(const Network& network, const Catalogue& catalogue) {
    if (network.processes.size() > most_processes)
        throw UserError(fmt::format("{} processes are too many for Spin, which allows at most {}",
                                    network.processes.size(), most_processes));
    refuse_code(network);
    refuse_broadcasts(network);
    std::string out = legend(network) + fmt::format("chan c[{}] = [0] of {{ byte }};\n", network.channels.size() + 1);
    std::string start;
    for (std::size_t process = 0; process < network.processes.size(); ++process) {
        out += proctype(network, process, catalogue);
        start += fmt::format("        run {}();\n", identifier(network, process));
    }
    return out + "\ninit {\n    atomic {\n" + start + "    }\n}\n";
}

} // namespace placedpar
