#include "explore/check/line_cycles.hpp"

#include "explore/occam_check.hpp"
#include "occam/code/compile.hpp"
#include "runtime/transputer/disassembler.hpp"
#include "text/counted.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <span>
#include <utility>

namespace placedpar {

namespace {

/// Returns the declaration of a variable or channel of this type, for use as an argument. An array of unknown size is
/// declared with one element.
std::string declaration_of(const occam::Type& type, const std::string& name) {
    std::string text = occam::name_of(type);
    for (std::size_t at = 0; text[at] == '['; at = text.find(']', at) + 1)
        if (text[at + 1] == ']')
            text.insert(at + 1, "1");
    return fmt::format("  {} {}:\n", text, name);
}

/// Returns a program that calls all procedures of a file, so that the compiler makes code for each procedure.
std::string caller_of(const occam::Program& program) {
    std::string declarations, calls;
    std::size_t number = 0;
    for (const occam::DeclarationBox& each : program.declarations) {
        const auto* procedure = std::get_if<occam::Procedure>(&each->form);
        if (!procedure || each->at.file != 0)
            continue;
        std::string arguments;
        for (const occam::DeclarationBox& parameter : procedure->parameters) {
            const std::string name = fmt::format("argument.{}", number++);
            declarations += declaration_of(*parameter->type, name);
            arguments += (arguments.empty() ? "" : ", ") + name;
        }
        calls += fmt::format("    {} ({})\n", each->name, arguments);
    }
    const std::string file = std::filesystem::path(program.files.front()->path()).filename().string();
    return fmt::format("#INCLUDE \"{}\"\nPROC caller.of.all ()\n{}  SEQ\n{}:\n", file, declarations, calls);
}

void add_instructions(LineCycles& line, std::span<const std::uint8_t> code, transputer::Model model) {
    while (!code.empty()) {
        const transputer::CodedInstruction instruction = transputer::read_instruction(code, model);
        if (instruction.length == 0)
            return;
        const transputer::CycleRange cycles = transputer::published_cycles(instruction, model);
        ++line.instructions;
        line.least += cycles.least;
        line.most += cycles.most.value_or(cycles.least);
        line.is_open |= !cycles.most;
        code = code.subspan(instruction.length);
    }
}

std::map<std::size_t, LineCycles> lines_of(const occam::Code& code, const occam::Program& program,
                                           const std::string& path, transputer::Model model) {
    std::map<std::size_t, LineCycles> lines;
    for (std::size_t i = 0; i < code.lines.size(); ++i) {
        const occam::CodeLine& row = code.lines[i];
        const std::uint32_t until = i + 1 < code.lines.size() ? code.lines[i + 1].offset : code.constants;
        if (row.place.line > 0 && row.offset < until && program.files[row.place.file]->path() == path)
            add_instructions(lines[row.place.line], std::span(code.bytes).subspan(row.offset, until - row.offset),
                             model);
    }
    return lines;
}

} // namespace

std::map<std::size_t, LineCycles> cycles_of_lines(const occam::Program& program,
                                                  std::vector<std::filesystem::path> folders, transputer::Model model) {
    const std::filesystem::path path = program.files.front()->path();
    const auto caller = std::make_shared<const SourceFile>(
        (path.parent_path() / ("caller of " + path.filename().string())).string(), caller_of(program));
    const OccamCheck checked =
        check_occam_source(caller, std::move(folders), {.alias_checks = false, .usage_checks = false});
    if (checked.failed || !checked.main)
        return {};
    try {
        const occam::Code code = occam::compile(*checked.program, *checked.main, {.model = model});
        return lines_of(code, *checked.program, path.string(), model);
    } catch (const UserError&) {
        return {};
    }
}

std::string text_of_cycles(const LineCycles& line, transputer::Model model) {
    const std::string range = line.is_open              ? fmt::format("{} or more", line.least)
                              : line.least == line.most ? fmt::format("{}", line.least)
                                                        : fmt::format("{} to {}", line.least, line.most);
    return fmt::format("{}, {} cycles on a {}\n", counted(line.instructions, "instruction"), range,
                       transputer::traits_of(model).name);
}

} // namespace placedpar
