// Readers of the lower rooms. These are few enough to be compiled, and fuzzed for a minute, in CI.

#include "hydraulics/data/parameters.hpp"
#include "hydraulics/data/record_table.hpp"
#include "iserver/server.hpp"
#include "netlist/kinds/bootable_file.hpp"
#include "netlist/kinds/csp_kinds.hpp"
#include "netlist/print/print.hpp"
#include "netlist/read.hpp"
#include "runtime/transputer/assembler.hpp"
#include "runtime/transputer/code_lines.hpp"
#include "runtime/transputer/code_text.hpp"
#include "tests/fuzz/reader.hpp"
#include "text/load_source.hpp"
#include "text/paint.hpp"
#include "text/repeated_faults.hpp"
#include "text/table.hpp"
#include "text/utf8.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace placedpar::fuzz {

namespace {

const Catalogue& kinds() {
    static const Catalogue kinds = [] {
        Catalogue all;
        add_csp_kinds(all);
        return all;
    }();
    return kinds;
}

/// Reads a netlist, prints the network, and requires that the printed netlist describes the same network.
void read_netlist(const std::string& text) {
    ReadResult result = read_netlist_text(text, kinds());
    render(result);
    if (!result.network)
        return require(has_errors(result.diagnostics), "what is refused is refused with an error");
    if (result.network->nodes.size() > 300 || result.network->processes.size() > 300)
        return;
    ReadResult again = read_netlist_text(print_cfs(*result.network), kinds());
    require(again.network.has_value(), "what show prints can be read");
    require(again.network->hash == result.network->hash, "what show prints is the same network");
}

/// The input's lines are a setting, NAME=VALUE, a fault, and a program with its kind, PROGRAM=KIND.
void read_options(const std::string& text) {
    static const std::string netlist = R"(val n 2; T800 (memory = 1M) t[n]; connect t[0].link[1] to t[1].link[0];
process a, b; use "csp.sink" for a; place a on t[0]; place b on t[1];)";
    std::vector<std::string> lines(3);
    for (std::size_t line = 0; char c : text)
        if (c == '\n' && line < 2)
            ++line;
        else
            lines[line] += c;
    auto pair = [](const std::string& line) {
        const std::size_t equals = std::min(line.find('='), line.size());
        return std::map<std::string, std::string>{
            {line.substr(0, equals), line.substr(std::min(equals + 1, line.size()))}};
    };
    ReadOptions options{.faults = {lines[1]}, .programs = pair(lines[2])};
    ReadResult result = read_netlist_text(netlist, kinds(), pair(lines[0]), "netlist", options);
    render(result);
    require(result.network.has_value() != has_errors(result.diagnostics), "what is refused is refused with an error");
}

/// Reads a record with the names of the files in examples/hydraulics/loggers.
void read_record(const std::string& text) {
    static const std::vector<hydraulics::ColumnName> names{
        hydraulics::column_name("time=TIMESTAMP"), hydraulics::column_name("pressure [psi]=P_boom_in"),
        hydraulics::column_name("angle=Winkel"), hydraulics::column_name("spool=X_boom")};
    hydraulics::ReadRecord read = hydraulics::read_record(text);
    for (const hydraulics::ColumnName& name : names)
        if (text.find(name.in_file) != text.npos)
            read = hydraulics::read_record(text, {{}, true, {name}});
    read.faults = RepeatedFaults().take(std::move(read.faults));
    render(read.faults);
    if (!read.record)
        return require(has_errors(read.faults), "what is refused is refused with an error");
    for (double time : read.record->time_s)
        require(std::isfinite(time), "times are finite");
}

void read_machine(const std::string& text) {
    hydraulics::Parameters parameters = hydraulics::Parameters::excavator();
    std::vector<Diagnostic> faults;
    parameters.read(text, faults);
    render(faults);
    for (const hydraulics::Parameter& each : parameters.all())
        require(std::isfinite(each.value), "parameters are finite");
}

bool moves_a_terminal(char c) { return (static_cast<unsigned char>(c) < ' ' && c != '\n' && c != '\t') || c == '\x7f'; }

void show_texts(const std::string& text) {
    for (const std::string& shown : {escaped(text), escaped_but_paint(text), as_json(text), as_markup(text)}) {
        require(std::ranges::none_of(shown, moves_a_terminal), "control characters are shown");
        require(as_utf8(shown) == shown, "what is shown is UTF-8");
        require(shown.find("\xc2\x9b") == shown.npos, "no terminal is moved by a single character");
    }
    require(escaped(escaped(text)) == escaped(text), "what is shown is not changed again");
    LoadedSource source = check_source("text", text);
    render(source.problems);
    std::vector<Diagnostic> faults;
    TextTable table = split_table(text, faults);
    for (const TextRow& row : table.rows)
        require(row.cells.size() == table.header.cells.size(), "rows are as long as the header");
}

/// Serves a program that sends these bytes.
void serve_requests(const std::string& bytes) {
    const std::string folder = "/dev/shm/placedpar-fuzz-" + std::to_string(::getpid());
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder + "/a");
    std::filesystem::create_symlink("/", folder + "/link");
    iserver::ScriptedTerminal terminal("keys\nand lines\n", [](std::string_view text) {
        require(text.find('\0') == text.npos, "control characters are shown");
    });
    iserver::Server server({.host_folder = folder, .write_limit_bytes = 10'000}, terminal);
    iserver::PacketReader reader;
    iserver::ByteView rest(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    while (!rest.empty() && reader.refusal().empty()) {
        const iserver::ByteView request = reader.take(rest);
        if (request.empty())
            continue;
        const iserver::Answer answer = server.answer(request, {});
        const bool serves = answer.state != iserver::ServerState::waits_for_input && !answer.reply.empty();
        require(!serves || (answer.reply.size() % 2 == 0 && answer.reply.size() >= 8 && answer.reply.size() <= 512),
                "a reply is a packet");
        require(serves || answer.state != iserver::ServerState::running, "a running program gets a reply");
    }
    server.finish();
    std::filesystem::remove_all(folder);
}

/// Disassembles a file, which may be cut off or refused.
void disassemble_file(const std::string& bytes) {
    const std::span<const std::uint8_t> file(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    why_not_bootable(file);
    for (const transputer::Model model : {transputer::Model::t414, transputer::Model::t805})
        transputer::print_bootable(file, model, {}, [](std::string_view text) {
            require(std::ranges::none_of(text, moves_a_terminal), "no terminal is moved");
        });
}

/// Assembles a program. What is accepted is listed in full; what is refused has its place in the text.
void assemble_program(const std::string& text) {
    try {
        const transputer::Assembly program = transputer::assemble(text, 0x80000070, transputer::Model::t800);
        require(program.listing().size() >= 3 * program.bytes.size(), "every byte is listed");
    } catch (const transputer::AssemblyError& error) {
        const auto lines = static_cast<std::size_t>(std::ranges::count(text, '\n')) + 1;
        require(error.line >= 1 && error.line <= lines && error.column >= 1 && error.column <= text.size() + 1,
                "an error has its place in the text");
    }
}

/// Reads a table of code and processes. What is refused has its place in the text.
void read_lines(const std::string& text) {
    for (const char* node : {"", "worker"})
        try {
            const transputer::CodeLines lines(text, node, 0x80000070);
            for (std::uint32_t address = 0x80000060; address < 0x80000100; ++address)
                require(lines.entry(address).empty() || !lines.place(address).empty(), "a procedure is a place");
        } catch (const transputer::CodeLinesError& error) {
            const auto lines = static_cast<std::size_t>(std::ranges::count(text, '\n')) + 1;
            require(error.line >= 1 && error.line <= lines + 1 && error.column >= 1 && error.column <= text.size() + 1,
                    "an error has its place in the text");
        }
}

} // namespace

std::span<const Reader> readers() {
    static const Reader all[] = {
        {"netlist", read_netlist},  {"options", read_options},     {"record", read_record},
        {"machine", read_machine},  {"texts", show_texts},         {"requests", serve_requests},
        {"code", disassemble_file}, {"program", assemble_program}, {"boot", boot_transputers},
        {"lines", read_lines},      {"occam", compile_occam},      {"configuration", configure_occam}};
    return all;
}

} // namespace placedpar::fuzz
