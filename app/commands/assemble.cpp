#include "app/command.hpp"
#include "app/options/common_options.hpp"
#include "runtime/transputer/assembler.hpp"
#include "text/counted.hpp"
#include "text/diagnostic.hpp"
#include "text/load_source.hpp"
#include "text/output_file.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <string_view>

namespace placedpar {

namespace {

/// The greatest length, in bytes, of a program that a boot packet can hold. The packet's first byte states the length.
constexpr std::size_t longest_packet = 255;

/// A loader for a program that does not fit in a boot packet. It reads four bytes with the program's length, and then
/// the program, from the link that booted the transputer. It starts the program with the same registers as a boot
/// packet. Iptr has the address of the program's first byte, Wptr the address of the first word after the program, and
/// C the address of the link's input channel.
constexpr std::string_view loader_source = R"(
        ajw     -4              -- four variables; `in` uses the three words below them
        stl     0; stl  0       -- A and B are not needed
        stl     0               -- variable 0: the link, which the boot leaves in C
        ldlp    1; ldl  0; ldc  4; in           -- variable 1: the length
        ldlp    4; ldl  0; ldl  1; in           -- the program comes after the variables
        ldlp    4; ldl  1; adc  3; ldc -4; and; bsub
        stl     1               -- variable 1: the first word after the program
        ldl     0; ldlp 4; ldl  1
        gajw; rev; gcall        -- into Wptr and Iptr; what remains is C
        .align
        .word   0, 0, 0, 0, 0, 0, 0             -- memory for the variables, and for the words below them
)";

struct AssembleOptions {
    std::string file, out, processor = "T800";
    bool listing = false;
};

void append_length(std::string& file, std::size_t length, std::size_t bytes) {
    for (std::size_t i = 0; i < bytes; ++i)
        file += static_cast<char>(length >> 8 * i & 255);
}

/// Assembles a user's program. Throws RefusedInput.
transputer::Assembly assembled(const LoadedSource& source, transputer::Word origin, transputer::Model model) {
    try {
        return transputer::assemble(source.file->text(), origin, model);
    } catch (const transputer::AssemblyError& error) {
        Diagnostic diagnostic = error_at(error.line, error.column, error.what());
        diagnostic.location.file = source.file;
        throw RefusedInput(render(diagnostic));
    }
}

struct BootableProgram {
    transputer::Assembly program;
    std::string file, loaded; ///< the bootable file, and a phrase for the report that says how the program is loaded
};

/// Assembles a program and makes a bootable file from it: one boot packet, or a loader followed by the program.
BootableProgram bootable(const LoadedSource& source, transputer::Model model) {
    const transputer::Word memory_start = transputer::most_negative + transputer::traits_of(model).memory_start;
    BootableProgram result{assembled(source, memory_start, model), "", "in one boot packet"};
    if (result.program.bytes.empty())
        throw UserError(fmt::format("{}: the program has no instruction", source.file->path()));
    result.program.bytes.resize(
        std::max<std::size_t>(result.program.bytes.size(), 2)); // a first byte of 1 means peek, not boot
    if (result.program.bytes.size() <= longest_packet) {
        append_length(result.file, result.program.bytes.size(), 1);
    } else {
        const auto loader = transputer::assemble(loader_source, memory_start).bytes;
        result.program = assembled(source, memory_start + static_cast<transputer::Word>(loader.size()), model);
        append_length(result.file, loader.size(), 1);
        result.file.append(loader.begin(), loader.end());
        append_length(result.file, result.program.bytes.size(), 4);
        result.loaded = fmt::format("after a loader of {} bytes", loader.size());
    }
    result.file.append(result.program.bytes.begin(), result.program.bytes.end());
    return result;
}

ExitCode assemble_file(const AssembleOptions& options) {
    require_apart(std::array{std::filesystem::path(options.out)}, options.file);
    require_writable(options.out);
    const LoadedSource source = load_input(options.file);
    if (has_errors(source.problems))
        throw RefusedInput(render(source.problems));
    const BootableProgram made = bootable(source, *transputer::model_named(options.processor));
    write_whole(options.out, made.file);
    print_out(fmt::format("{}: {} for address #{:X}, {}\n{}", options.out, counted(made.program.bytes.size(), "byte"),
                          made.program.origin, made.loaded, options.listing ? made.program.listing() : ""));
    return ExitCode::success;
}

Action declare_assemble(Options& command, const std::string&) {
    auto options = std::make_shared<AssembleOptions>();
    std::vector<std::string> models;
    for (const transputer::Traits& each : transputer::all_traits)
        models.emplace_back(each.name);
    add_file(command, "FILE", options->file, "a program in transputer assembly language; - is standard input")
        .required();
    add_file(command, "-o,--out", options->out, "the bootable file that is written").required();
    command.add("--processor", options->processor, "type of the transputer that executes the program")
        .one_of(models)
        .show_default();
    command.add_flag("--listing", options->listing, "also prints the program with its addresses and bytes");
    command.add_footer("docs/reference/transputer.md describes the instructions and how to write them.");
    return [options] { return assemble_file(*options); };
}

} // namespace

extern const Command assemble_command{
    .name = "assemble",
    .about = "Makes a bootable file from a program in transputer assembly language",
    .place = 44,
    .declare = declare_assemble,
};

} // namespace placedpar
