#include "explore/occam_program.hpp"

#include "explore/occam_check.hpp"
#include "occam/code/place_table.hpp"
#include "occam/configuration/configuration.hpp"
#include "occam/network/vals.hpp"
#include "text/number.hpp"
#include "text/program_name.hpp"
#include "text/refused_text.hpp"
#include "text/standard_streams.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <ranges>
#include <string_view>

namespace placedpar {

namespace {

constexpr std::array names_of_checks = {"usage", "alias", "range", "all"};

/// Returns whether the option --no-checks names the check `name`. Throws UserError if the option names an unknown
/// check.
bool leaves_out(const OccamOptions& options, std::string_view name) {
    bool found = false;
    std::string_view rest = options.no_checks;
    while (!rest.empty()) {
        const std::string_view each = rest.substr(0, rest.find(','));
        rest.remove_prefix(std::min(rest.size(), each.size() + 1));
        if (std::ranges::find(names_of_checks, each) == names_of_checks.end())
            throw UserError(fmt::format(
                "--no-checks: \"{}\" is not the name of a check: the names are usage, alias, range and all", each));
        found |= each == name;
    }
    return found;
}

/// Returns whether a main procedure has the channels keyboard, screen and error of a terminal, instead of channels to a
/// host.
bool uses_terminal(const occam::Declaration& main) {
    const auto& parameters = std::get<occam::Procedure>(main.form).parameters;
    return parameters.size() == 3 && std::ranges::all_of(parameters, [](const occam::DeclarationBox& each) {
               return each->type->kind == occam::Type::Kind::channel;
           });
}

bool gets_free_memory(const occam::Declaration& main) {
    return std::get<occam::Procedure>(main.form).parameters.size() == 3;
}

/// Returns a program whose only procedure connects the main procedure `main` of the file to the terminal.
std::shared_ptr<const SourceFile> around(const std::filesystem::path& path, const occam::Declaration& main) {
    const std::string file = path == shown_input("-") ? "standard input" : path.filename().string();
    const auto& keyboard = *std::get<occam::Procedure>(main.form).parameters.front();
    const bool reads = keyboard.direction != occam::Direction::unused;
    return std::make_shared<SourceFile>((path.parent_path() / ("terminal of " + file)).string(),
                                        fmt::format(R"(#INCLUDE "hostio.inc"
#USE "terminal.lib"
#INCLUDE "{}"
PROC run.with.terminal (CHAN OF SP fs, ts)
  CHAN OF BYTE keyboard, screen, error:
  CHAN OF BOOL ended:
  PAR
    terminal (fs, ts, keyboard, screen, error, ended, {})
    SEQ
      {} (keyboard, screen, error)
      ended ! TRUE
:
)",
                                                    file, reads ? "TRUE" : "FALSE", main.name));
}

} // namespace

CompileChoices choices_of(const OccamOptions& options) {
    for (const char* check : {"usage", "alias"})
        if (leaves_out(options, check))
            throw UserError(
                fmt::format("--no-checks: a netlist cannot turn off the check \"{}\" of its programs; write "
                            "#OPTION \"{}\" into the file",
                            check, check[0] == 'u' ? "N" : "A"));
    const bool all = leaves_out(options, "all");
    return {options.mode, !all && !leaves_out(options, "range"), !all};
}

occam::SourceOptions wanted_checks(const OccamOptions& options) {
    return {.alias_checks = !leaves_out(options, "alias"),
            .usage_checks = !leaves_out(options, "usage"),
            .range_checks = !leaves_out(options, "range"),
            .run_time_checks = !leaves_out(options, "all")};
}

bool can_be_run(const occam::Declaration& procedure) {
    const auto& parameters = std::get<occam::Procedure>(procedure.form).parameters;
    const auto is_channel = [](const occam::DeclarationBox& each) {
        return each->type->kind == occam::Type::Kind::channel;
    };
    const std::size_t channels = static_cast<std::size_t>(std::ranges::count_if(parameters, is_channel));
    const occam::Type* const last = parameters.empty() ? nullptr : parameters.back()->type;
    const bool gets_memory = parameters.size() == 3 && channels == 2 && last->kind == occam::Type::Kind::array &&
                             !last->count && last->element->is(occam::Basic::integer);
    const auto is_to_host = [](const occam::DeclarationBox& each) { return carries_host_protocol(*each->type); };
    const bool has_host = std::ranges::all_of(parameters | std::views::take(2), is_to_host);
    const bool has_terminal = parameters.size() == 3 && channels == 3;
    return has_terminal || (has_host && (parameters.size() <= 2 || gets_memory));
}

bool is_occam(const std::filesystem::path& path) {
    return path.extension() == ".occ" && !occam::is_configuration(path);
}

namespace {

/// Throws UserError if the file cannot be run on a single transputer: it is a configuration, or has no procedure.
void require_main(const OccamCheck& program, const std::string& path) {
    if (program.program->is_configuration)
        throw UserError(fmt::format("{}: the file is a configuration; compile makes a program for one transputer, and "
                                    "run executes a configuration",
                                    path));
    if (!program.main)
        throw UserError(fmt::format("{}: the file has no PROC that can be run", path));
}

void report_errors(const std::vector<Diagnostic>& diagnostics, Reporter& reporter) {
    for (const Diagnostic& each : diagnostics)
        if (each.severity == Severity::error)
            reporter.error(each.location, each.message, each.hint, each.others);
}

/// Checks a program. If its main procedure uses a terminal, the text gets a further procedure that calls the main
/// procedure. If `change` is set, it may change VALs. In both cases the new text is checked again. This second check
/// reports only errors, because the first check has reported the warnings.
OccamCheck checked_program(const std::shared_ptr<const SourceFile>& file,
                           const std::vector<std::filesystem::path>& folders, const occam::SourceOptions& wanted,
                           const occam::ChangeDeclaration& change, Reporter& reporter) {
    OccamCheck program = check_occam_source(file, folders, wanted, reporter);
    if (program.failed)
        return program;
    require_main(program, file->path());
    const bool is_wrapped = uses_terminal(*program.main);
    if (is_wrapped || change)
        program = check_occam_source(is_wrapped ? around(file->path(), *program.main) : file, folders, wanted,
                                     is_wrapped ? file : nullptr, change);
    report_errors(program.diagnostics, reporter);
    return program;
}

/// Throws RefusedText. REQUIRES: the program has no errors.
CompiledOccam compiled(const OccamCheck& program, const OccamOptions& typed, transputer::Model model) {
    const occam::CodeOptions options{.model = model,
                                     .mode = occam::error_mode(typed.mode),
                                     .range_checks = program.options.range_checks && program.options.run_time_checks,
                                     .run_time_checks = program.options.run_time_checks,
                                     .vector_space = program.options.vector_space};
    const occam::Code code = compile(*program.program, *program.main, options);
    const std::uint32_t code_at = where_code_is(code, options) - transputer::traits_of(model).memory_start;
    const std::uint64_t free_bytes = gets_free_memory(*program.main) ? occam::bytes_of_free_memory : 0;
    return {bootable(code, options), place_table(code, *program.program, code_at),
            image_of(code, options).bytes + free_bytes};
}

} // namespace

CompiledOccam compile_occam(const std::filesystem::path& path, const std::vector<std::filesystem::path>& folders,
                            const OccamOptions& typed, transputer::Model model, const WarningSink& warn) {
    Reporter reporter;
    const OccamCheck program = checked_program(load_text(path), folders, wanted_checks(typed), {}, reporter);
    const std::string found = render(reporter.take()) + reporter.not_shown();
    if (program.failed)
        throw RefusedInput(found);
    if (!found.empty())
        warn(found);
    return compiled(program, typed, model);
}

void require_compilable(const std::shared_ptr<const SourceFile>& file,
                        const std::vector<std::filesystem::path>& folders, const occam::SourceOptions& wanted) {
    Reporter reporter;
    const OccamCheck program = checked_program(file, folders, wanted, {}, reporter);
    if (!program.failed)
        compiled(program, {}, transputer::Model::t800);
}

std::optional<std::uint64_t> bytes_of_size(const std::string& text) {
    const char unit = text.empty() ? ' ' : text.back();
    const std::optional<std::uint64_t> number =
        parse_number<std::uint64_t>(unit == 'K' || unit == 'M' ? text.substr(0, text.size() - 1) : text);
    if (!number)
        return std::nullopt;
    return std::min(*number, std::uint64_t{1} << 32) << (unit == 'K' ? 10 : unit == 'M' ? 20 : 0);
}

std::string netlist_around(const std::filesystem::path& file, const ProgramMachine& machine) {
    const bool wraps = is_occam(file) && machine.occam.mode == "stop";
    return fmt::format(
        "{} (memory = {}, memorycycles = {}{}) root;\nconnect root.link[0] to host;\nuse \"{}\" for root;\n",
        machine.processor, machine.memory, machine.memory_cycles, wraps ? ", wraps = 1" : "", file.filename().string());
}

namespace {

CompiledProgram compiled_program(const OccamCheck& program, const std::string& file, const ProgramMachine& machine) {
    CompiledOccam made = compiled(program, machine.occam, *transputer::model_named(machine.processor));
    if (made.memory_bytes > *bytes_of_size(machine.memory))
        throw UserError(fmt::format(
            "{}: the program needs {} bytes of memory, but the transputer has {}\nhint: use --memory "
            "{}M",
            file, made.memory_bytes, machine.memory, std::bit_ceil((made.memory_bytes + (1 << 20) - 1) >> 20)));
    return {std::make_shared<const std::vector<std::uint8_t>>(std::move(made.file)),
            std::make_shared<const SourceFile>("lines of " + file, std::move(made.lines))};
}

std::string hint_of_program(const std::string& hint) {
    constexpr std::string_view netlist = "in the netlist its value is";
    return hint.starts_with(netlist) ? "in the program its value is" + hint.substr(netlist.size()) : hint;
}

/// Compiles the program, with the VALs that `choose` sets, and makes a netlist with one transputer that the program
/// boots. Reports the program's errors and warnings.
MadeNetlist netlist_of_program(const std::shared_ptr<const SourceFile>& file,
                               const std::vector<std::filesystem::path>& folders, const ProgramMachine& machine,
                               const ValChoice& choose, Reporter& reporter) {
    occam::ChangeDeclaration change;
    if (choose)
        change = [&](occam::Program& program, occam::Declaration& each) {
            occam::choose_val(program, each, choose, reporter);
        };
    const OccamCheck program = checked_program(file, folders, wanted_checks(machine.occam), change, reporter);
    MadeNetlist made{.translate_hint = hint_of_program};
    if (reporter.failed())
        return made;
    const std::filesystem::path path = file->path(),
                                as_found = path.parent_path() / path.filename(); // where the netlist looks for it
    made.text = std::make_shared<const SourceFile>(file->path(), netlist_around(path, machine));
    made.compiled[as_found.string()] = compiled_program(program, file->path(), machine);
    return made;
}

} // namespace

NetlistMaker netlist_maker(const ProgramMachine& machine) {
    return [machine](const std::shared_ptr<const SourceFile>& file, const std::vector<std::filesystem::path>& folders,
                     const ValChoice& choose, Reporter& reporter) -> MadeNetlist {
        if (!file->path().ends_with(".occ") || occam::is_configuration(*file))
            return occam::netlist_of_configuration(file, folders, choose, reporter);
        try {
            return netlist_of_program(file, folders, machine, choose, reporter);
        } catch (const RefusedText& refused) {
            report_errors(refused.diagnostics(), reporter);
            return {};
        }
    };
}

void require_netlist(const std::filesystem::path& file) {
    if (is_occam(file))
        throw UserError(fmt::format("{0}: the machine of a program in occam cannot be shown as a netlist; to use the "
                                    "program in one, compile it: {1} compile {0} -o FILE.btl",
                                    file.string(), program_name()));
}

} // namespace placedpar
