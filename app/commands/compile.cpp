#include "app/command.hpp"
#include "app/options/common_options.hpp"
#include "app/options/occam_options.hpp"
#include "app/standard_error.hpp"
#include "text/output_file.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <memory>

namespace placedpar {

namespace {

struct CompileOptions {
    std::string file, out, processor = "T800";
    std::vector<std::string> folders;
    OccamOptions occam;
};

ExitCode compile_file(const CompileOptions& options) {
    const std::filesystem::path out = options.out;
    const std::filesystem::path lines = out == "-" ? "" : std::filesystem::path(out).replace_extension(".lines");
    require_apart(std::array{out, lines}, options.file);
    require_writable(out);
    if (!lines.empty())
        require_writable(lines);
    const CompiledOccam made = compile_occam(options.file, options.folders, options.occam,
                                             *transputer::model_named(options.processor), print_warnings);
    write_whole(out, std::string(made.file.begin(), made.file.end()));
    if (!lines.empty())
        write_whole(lines, made.lines);
    print_out(fmt::format("{}: {} bytes for a {}{}\n", options.out, made.file.size(), options.processor,
                          lines.empty() ? "" : "; the code's source lines are in " + lines.string()));
    return ExitCode::success;
}

Action declare_compile(Options& command, const std::string&) {
    auto options = std::make_shared<CompileOptions>();
    std::vector<std::string> models;
    for (const transputer::Traits& each : transputer::all_traits)
        models.emplace_back(each.name);
    add_file(command, "FILE", options->file, "a program in occam; - is standard input").required();
    add_file(command, "-o,--out", options->out, "the bootable file that is written").required();
    command.add_list("-I", options->folders, "FOLDER",
                     "folder to search for included files, besides the program's own; may be repeated");
    command.add("--processor", options->processor, "type of the transputer that executes the program")
        .one_of(models)
        .show_default();
    add_occam(command, options->occam);
    return [options] { return compile_file(*options); };
}

} // namespace

extern const Command compile_command{
    .name = "compile",
    .about = "Makes a bootable file from a program in occam",
    .place = 43,
    .declare = declare_compile,
};

} // namespace placedpar
