#include "occam/network/file_kinds.hpp"

#include "occam/check/check.hpp"
#include "occam/code/compile.hpp"
#include "occam/code/place_table.hpp"
#include "occam/library/library.hpp"
#include "occam/network/image_text.hpp"
#include "occam/network/kind.hpp"
#include "runtime/transputer/code_lines.hpp"
#include "text/load_source.hpp"
#include "text/nearest.hpp"
#include "text/texts_in_memory.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <compare>
#include <list>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <utility>

namespace placedpar::occam {

namespace {

using FilePath = std::filesystem::path;
using Folders = std::vector<FilePath>;

/// Holds a file in occam that was read, and all files that it includes or uses.
struct FileOfPrograms {
    std::unique_ptr<Program> program;
    SourceOptions options;
    std::vector<Diagnostic> diagnostics;
    bool failed = false;
};

/// Holds everything that determines the image of a node: the program in its memory when a run begins. An image is
/// compiled again only if this has changed.
struct ImageSource {
    std::string text;               ///< the program of the node in occam, including the parameters of its processes
    std::vector<std::string> names; ///< names of the node, of its type, and of the processes
    Folders folders;
    std::vector<const FileOfPrograms*> files; ///< files of the processes

    auto operator<=>(const ImageSource&) const = default;
};

/// Holds a kind of process that was made from a file. It is never changed or removed, since other objects have pointers
/// to it.
struct KindOfFile {
    std::shared_ptr<const FileOfPrograms> file;
    Folders folders;
    std::string path;
    const Declaration* procedure = nullptr;
    ProcessKind kind;
};

ParseOptions parse_options(const Folders& folders) {
    ParseOptions options;
    options.folders = folders;
    options.built_in = [](const std::string& name) { return library_text(name); };
    return options;
}

bool is_built_in(const SourceFile& file) { return file.path().starts_with('<'); }

/// Returns whether no file of the program has changed since it was read.
bool is_unchanged(const Program& program) {
    return std::ranges::all_of(program.files, [](const std::shared_ptr<const SourceFile>& file) {
        return is_built_in(*file) || load_source(file->path()).file->text() == file->text();
    });
}

std::uint64_t hash_of(const Program& program) {
    std::uint64_t hash = 0xcbf29ce484222325U; // FNV-1a
    for (const std::shared_ptr<const SourceFile>& file : program.files)
        for (const char c : file->text())
            hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    return hash;
}

/// Parses and checks a text. `is_of_user` is false for the program that PlacedPar writes to run all processes of a
/// node. Parallel usage is not checked in this program, since the netlist guarantees that each channel has one process
/// at each end.
FileOfPrograms parsed_and_checked(const std::shared_ptr<const SourceFile>& file, const Folders& folders,
                                  bool is_of_user) {
    Reporter reporter;
    Parsed parsed = parse(file, parse_options(folders), reporter);
    if (!reporter.failed()) {
        parsed.program->has_channel_tables = !is_of_user;
        parsed.options.usage_checks &= is_of_user;
        parsed.options.alias_checks &= is_of_user;
        check(*parsed.program, parsed.options, reporter);
    }
    const bool failed = reporter.failed();
    return {std::move(parsed.program), parsed.options, reporter.take(), failed};
}

/// Reports the errors of a file, each with a note that shows where the netlist names the file.
void pass_errors_on(const FileOfPrograms& file, const std::string& note, const Location& named_at, Reporter& to) {
    for (Diagnostic each : file.diagnostics) {
        if (each.severity != Severity::error)
            continue;
        each.others.push_back({note, named_at});
        to.error(each.location, std::move(each.message), std::move(each.hint), std::move(each.others));
    }
}

void pass_warnings_on(const FileOfPrograms& file, Reporter& to) {
    for (const Diagnostic& each : file.diagnostics)
        if (each.severity == Severity::warning)
            to.warning(each.location, each.message, each.hint);
}

std::vector<std::string> procedures_of(const Program& program) {
    std::vector<std::string> names;
    for (const DeclarationBox& each : program.declarations)
        if (std::holds_alternative<Procedure>(each->form))
            names.push_back(each->name);
    return names;
}

void report_no_procedure(const Program& program, const std::string& name, const Location& named_at,
                         Reporter& reporter) {
    const std::string path = program.files.front()->path();
    if (name.empty())
        reporter.error(
            named_at, fmt::format("the file \"{}\" has no PROC", path),
            program.is_configuration ? "a configuration uses the PROCs of other files; name one of these files" : "");
    else
        reporter.error(named_at, fmt::format("the file \"{}\" has no PROC {}", path, name),
                       did_you_mean(name, procedures_of(program)));
}

/// Returns the last procedure of this name; if the name is empty, the last procedure of the file. Returns null after
/// reporting that there is none.
const Declaration* procedure_named(const Program& program, const std::string& name, const Location& named_at,
                                   Reporter& reporter) {
    const Declaration* last = nullptr;
    for (const DeclarationBox& each : program.declarations)
        if (std::holds_alternative<Procedure>(each->form) && (name.empty() || each->name == name))
            last = each.get();
    if (!last)
        report_no_procedure(program, name, named_at, reporter);
    return last;
}

/// Returns the place where the netlist declares the first process in occam on the node. If the node has no such
/// process, and only passes messages on, returns the place where the node is declared.
const Location& place_of_code(const Network& network, std::size_t node) {
    const auto first = std::ranges::find_if(
        network.processes, [&](const ProcessInstance& process) { return process.is_code && process.node == node; });
    return first == network.processes.end() ? network.nodes[node].declared : first->declared;
}

class OccamKinds final : public FileKinds {
public:
    bool is_file(std::string_view program) const override {
        const std::string_view file = program.substr(0, program.find('#'));
        return file.ends_with(".occ") || file.ends_with(".pgm") || file.ends_with(".module");
    }

    void choose(const CompileChoices& choices) override {
        const std::lock_guard lock(mutex_);
        chosen_ = choices;
    }

    std::string read(const std::string& program, const Location& named_at, const Folders& folders,
                     Reporter& reporter) override {
        const std::lock_guard lock(mutex_);
        const std::size_t hash = std::min(program.find('#'), program.size());
        const auto path = path_of(program.substr(0, hash), named_at, folders, reporter);
        if (!path)
            return "";
        const auto file = read_file(path->string(), folders, reporter);
        if (!file || file->failed) {
            if (file)
                pass_errors_on(*file, "the file is used here", named_at, reporter);
            return "";
        }
        const std::string name = path->string() + program.substr(hash);
        if (const KindOfFile* const known = newest(name); known && known->file == file)
            return name;
        const std::string procedure = hash == program.size() ? "" : program.substr(hash + 1);
        const Declaration* const found = procedure_named(*file->program, procedure, named_at, reporter);
        auto kind = found ? kind_of(*file->program, *found, reporter) : std::nullopt;
        if (!kind)
            return "";
        kind->name = name;
        kind->text_hash = hash_of(*file->program);
        newest_[name] = &all_.emplace_back(KindOfFile{file, folders, path->string(), found, std::move(*kind)});
        return name;
    }

    const ProcessKind* find(std::string_view name) const override {
        const std::lock_guard lock(mutex_);
        const KindOfFile* const found = newest(name);
        return found ? &found->kind : nullptr;
    }

    std::vector<std::string> files_of(std::string_view name) const override {
        const std::lock_guard lock(mutex_);
        std::vector<std::string> paths;
        for (const std::shared_ptr<const SourceFile>& file : newest(name)->file->program->files)
            if (!is_built_in(*file))
                paths.push_back(file->path());
        return paths;
    }

    std::shared_ptr<const transputer::Image> image(const Network& network, std::size_t node,
                                                   Reporter& reporter) override {
        const std::lock_guard lock(mutex_);
        const Location& at = place_of_code(network, node);
        try {
            return compiled(network, node, reporter);
        } catch (const RefusedInput& refused) {
            const std::string text = refused.what();
            reporter.error(at, fmt::format("the processes on \"{}\" cannot be compiled", network.nodes[node].name),
                           text.substr(0, text.find('\n')));
        } catch (const UserError& refused) {
            reporter.error(at, refused.what());
        }
        return nullptr;
    }

private:
    const KindOfFile* newest(std::string_view name) const {
        const auto found = newest_.find(name);
        return found == newest_.end() ? nullptr : found->second;
    }

    /// Returns the path of the file; nothing after reporting that the file is missing.
    static std::optional<FilePath> path_of(const std::string& file, const Location& named_at, const Folders& folders,
                                           Reporter& reporter) {
        Folders all{named_at.file ? FilePath(named_at.file->path()).parent_path() : FilePath()};
        all.insert(all.end(), folders.begin(), folders.end());
        std::string where;
        for (const FilePath& folder : all) {
            if (names_file(folder / file))
                return folder / file;
            where += fmt::format("{}\"{}\"", where.empty() ? "" : ", ", folder.empty() ? "." : folder.string());
        }
        reporter.error(named_at, fmt::format("the file \"{}\" is missing", file), "looked for in " + where);
        return std::nullopt;
    }

    /// Reads a file; returns null after reporting that the file cannot be read. If the file was read before, and no
    /// file of the program has changed since, returns the earlier result without reporting its warnings again.
    std::shared_ptr<const FileOfPrograms> read_file(const std::string& path, const Folders& folders,
                                                    Reporter& reporter) {
        std::shared_ptr<const FileOfPrograms>& known = files_[{path, folders}];
        if (known && is_unchanged(*known->program))
            return known;
        const LoadedSource source = load_source(path);
        for (const Diagnostic& problem : source.problems)
            reporter.error(problem.location, problem.message, problem.hint);
        if (has_errors(source.problems))
            return nullptr;
        known = std::make_shared<const FileOfPrograms>(parsed_and_checked(source.file, folders, true));
        pass_warnings_on(*known, reporter);
        return known;
    }

    /// Gives the workspaces and the code of the program's components their names in reports. A process within a
    /// component has the name of the component before its own: "table/phil[2]". If the netlist has no name for a
    /// process, the name of the node comes first.
    static void name_components(Code& code, const TextOfImage& text, const std::string& node) {
        const std::vector<Component>& all = text.components;
        std::erase_if(code.workspaces,
                      [](const CodeWorkspace& each) { return each.outermost == CodeWorkspace::first_process; });
        std::size_t outermost = 0;
        for (const CodeWorkspace& each : code.workspaces)
            outermost = std::max(outermost, each.outermost + 1);
        std::map<std::string, std::string> names; // names of components; key: name from the compiler
        for (CodeWorkspace& each : code.workspaces) {
            const Component none{};
            const Component& component = outermost == all.size() ? all[each.outermost] : none;
            each.carries = component.carries;
            if (!component.name.empty() && each.inner.empty() && !each.entry.empty())
                names[each.entry] = component.name;
            const std::string own = component.name.empty() ? each.name
                                    : each.inner.empty()   ? component.name
                                                           : component.name + "/" + each.inner;
            each.name = component.name.empty() || component.carries ? node + "." + own : own;
        }
        for (CodeName& each : code.names)
            if (const auto found = names.find(each.name); found != names.end())
                each.name = found->second;
    }

    /// Returns rows for transputer::CodeLines, so that reports give channels their names in the network. A channel to
    /// another processor then has one name, although its ends are words in two memories.
    static std::string channel_rows(const Code& code, const TextOfImage& text, transputer::Word first_workspace) {
        std::string rows;
        for (const CodeChannel& each : code.channels)
            if (const auto found = text.channels.find(each.name); found != text.channels.end())
                rows += fmt::format("channel #{:X} {}\n",
                                    (each.is_placed ? transputer::most_negative : first_workspace) +
                                        static_cast<transputer::Word>(4 * each.word),
                                    found->second);
        return rows;
    }

    ProgramOfProcess program_of(const ProcessInstance& process) const {
        const KindOfFile& kind = *newest(process.kind);
        return {kind.path, kind.file->program.get(), kind.procedure};
    }

    /// Turns off the checks and the vector space, the separate memory for arrays, if an #OPTION in a file of the node's
    /// processes does so. Returns the folders in which one of these files searches for other files.
    Folders read_options(const Network& network, std::size_t node, CodeOptions& options) const {
        Folders folders;
        for (const ProcessInstance& process : network.processes)
            if (process.is_code && process.node == node) {
                const KindOfFile& kind = *newest(process.kind);
                const SourceOptions& asked = kind.file->options;
                options.range_checks &= asked.range_checks && asked.run_time_checks;
                options.run_time_checks &= asked.run_time_checks;
                options.vector_space &= asked.vector_space;
                folders = kind.folders;
            }
        return folders;
    }

    /// Returns the image of a node. Compiles it only once, since a study runs the same program many times.
    std::shared_ptr<const transputer::Image> compiled(const Network& network, std::size_t node, Reporter& reporter) {
        constexpr std::size_t most_images = 1000;
        CodeOptions options{.mode = error_mode(chosen_.mode),
                            .range_checks = chosen_.range_checks,
                            .run_time_checks = chosen_.run_time_checks,
                            .ends_run = false};
        options.model = *transputer::model_named(network.nodes[node].type);
        ImageSource source;
        source.names = {network.nodes[node].name, network.nodes[node].type,
                        fmt::format("{} {} {}", chosen_.mode, chosen_.range_checks, chosen_.run_time_checks)};
        source.folders = read_options(network, node, options);
        for (const ProcessInstance& process : network.processes)
            if (process.is_code && process.node == node)
                source.files.push_back(newest(process.kind)->file.get());
        const TextOfImage text =
            text_of_image(network, node, [this](const ProcessInstance& process) { return program_of(process); });
        options.awaits_high = !text.carries;
        source.text = text.text;
        for (const Component& each : text.components)
            source.names.push_back(each.name);
        for (const auto& [in_text, name] : text.channels)
            source.names.push_back(name);
        if (const auto known = images_.find(source); known != images_.end())
            return known->second;
        auto image = image_from(source, text, options, network.nodes[node].declared, reporter);
        if (images_.size() == most_images)
            images_.clear();
        if (image)
            images_.emplace(std::move(source), image);
        return image;
    }

    static std::shared_ptr<const transputer::Image> image_from(const ImageSource& source, const TextOfImage& text,
                                                               const CodeOptions& options, const Location& declared,
                                                               Reporter& reporter) {
        const auto main = std::make_shared<const SourceFile>(fmt::format("<{}>", source.names.front()), source.text);
        const FileOfPrograms file = parsed_and_checked(main, source.folders, false);
        pass_errors_on(file, "the processor is declared here", declared, reporter);
        if (file.failed)
            return nullptr;
        Code code = compile(*file.program, *main_procedure(*file.program), options);
        name_components(code, text, source.names.front());
        transputer::Image image = image_of(code, options);
        const std::uint32_t memory_start = transputer::traits_of(options.model).memory_start;
        const std::string table = channel_rows(code, text, transputer::most_negative + image.workspace) +
                                  place_table(code, *file.program, image.offset - memory_start);
        image.lines =
            std::make_shared<const transputer::CodeLines>(table, "", transputer::most_negative + memory_start);
        return std::make_shared<const transputer::Image>(std::move(image));
    }

    mutable std::mutex mutex_;
    CompileChoices chosen_;
    std::map<std::pair<std::string, Folders>, std::shared_ptr<const FileOfPrograms>> files_;
    std::map<ImageSource, std::shared_ptr<const transputer::Image>> images_;
    std::list<KindOfFile> all_; ///< all kinds, including kinds from files that have changed since
    std::map<std::string, const KindOfFile*, std::less<>> newest_;
};

} // namespace

std::shared_ptr<FileKinds> make_file_kinds() { return std::make_shared<OccamKinds>(); }

} // namespace placedpar::occam
