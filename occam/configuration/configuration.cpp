#include "occam/configuration/configuration.hpp"

#include "occam/configuration/configurer.hpp"
#include "occam/configuration/netlist_writer.hpp"
#include "occam/language/parse.hpp"
#include "occam/library/library.hpp"
#include "text/load_source.hpp"
#include "text/nearest.hpp"

#include <algorithm>
#include <regex>
#include <set>
#include <string_view>
#include <utility>

namespace placedpar::occam {

namespace {

/// Returns whether a line of the text begins with PLACED, without indentation. Only a configuration has such a line.
bool has_placed_par(std::string_view text) {
    constexpr std::string_view word = "PLACED ";
    return text.starts_with(word) || text.find("\n" + std::string(word)) != text.npos;
}

/// Passes errors and warnings on, except warnings about the files of programs. These are reported when the kinds of
/// processes are made.
void pass_on(std::vector<Diagnostic> diagnostics, const Program& program, Reporter& reporter) {
    std::set<std::string> programs;
    for (const std::unique_ptr<Unit>& unit : program.units)
        programs.insert(program.files[unit->file]->path());
    for (Diagnostic& each : diagnostics)
        if (each.severity == Severity::error)
            reporter.error(each.location, std::move(each.message), std::move(each.hint), std::move(each.others));
        else if (!each.location.file || !programs.contains(each.location.file->path()))
            reporter.warning(each.location, std::move(each.message), std::move(each.hint));
}

/// Returns the hint with its connections in the syntax of configurations: CONNECT a[link][0] TO b[link][1].
std::string hint_of_configuration(const std::string& hint) {
    static const std::regex connection(R"(connect (\S+\.link\[\d+\]) to ([^\s;]+);)"), link(R"(\.link\[)");
    return std::regex_replace(std::regex_replace(hint, connection, "CONNECT $1 TO $2"), link, "[link][");
}

MadeNetlist made_of(const std::shared_ptr<const SourceFile>& file, const std::vector<std::filesystem::path>& folders,
                    const ValChoice& choose, Reporter& reporter) {
    ParseOptions options;
    options.folders = folders;
    options.built_in = [](const std::string& name) { return library_text(name); };
    Reporter own;
    const Parsed parsed = parse(file, options, own);
    Program& program = *parsed.program;
    MadeNetlist made;
    if (!own.failed()) {
        const Configured configured = Configurer(program, choose, own).run();
        if (!own.failed())
            made = NetlistWriter(program, configured, own).write();
        made.translate_hint = hint_of_configuration;
    }
    for (std::size_t i = 1; i < program.files.size(); ++i)
        if (!program.files[i]->path().starts_with('<'))
            made.paths.push_back(program.files[i]->path());
    pass_on(own.take(), program, reporter);
    return made;
}

} // namespace

bool is_configuration(const SourceFile& file) {
    const std::string extension = lower_case(std::filesystem::path(file.path()).extension().string());
    return extension == ".pgm" || (extension == ".occ" && has_placed_par(file.text()));
}

bool is_configuration(const std::filesystem::path& path) {
    const std::string extension = lower_case(path.extension().string());
    return (extension == ".pgm" || extension == ".occ") && is_configuration(*load_source(path).file);
}

MadeNetlist netlist_of_configuration(const std::shared_ptr<const SourceFile>& file,
                                     const std::vector<std::filesystem::path>& folders, const ValChoice& choose,
                                     Reporter& reporter) {
    return is_configuration(*file) ? made_of(file, folders, choose, reporter) : MadeNetlist{};
}

} // namespace placedpar::occam
