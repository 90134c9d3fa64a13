#include "occam/network/file_kinds.hpp"

#include "occam/check/check.hpp"
#include "occam/code/compile.hpp"
#include "occam/library/library.hpp"
#include "occam/network/image_text.hpp"
#include "occam/network/kind.hpp"
#include "text/load_source.hpp"
#include "text/nearest.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <list>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

namespace placedpar::occam {

namespace {

using FilePath = std::filesystem::path;
using Folders = std::vector<FilePath>;

/// A file that was read, with the kind that was made of it. It stays as it is, for others point to the kind.
struct KindOfFile {
    std::string path;
    Folders folders;
    std::unique_ptr<Program> program;
    SourceOptions options;
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

/// Returns whether the files of the program are as they were when they were read.
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

void pass_on(std::vector<Diagnostic> diagnostics, Reporter& to) {
    for (Diagnostic& each : diagnostics)
        if (each.severity == Severity::error)
            to.error(each.location, std::move(each.message), std::move(each.hint), std::move(each.others));
        else
            to.warning(each.location, std::move(each.message), std::move(each.hint));
}

/// Parses and checks a text. Reports errors, and warnings if there are errors or `with_warnings`.
std::optional<Parsed> checked(const std::shared_ptr<const SourceFile>& file, const Folders& folders,
                              bool is_of_user, Reporter& reporter) {
    Reporter own;
    Parsed parsed = parse(file, parse_options(folders), own);
    if (!own.failed()) {
        parsed.program->has_channel_tables = !is_of_user;
        parsed.options.usage_checks &= is_of_user; // channels of a network have one process at each end
        parsed.options.alias_checks &= is_of_user;
        check(*parsed.program, parsed.options, own);
    }
    const bool failed = own.failed();
    if (failed || is_of_user)
        pass_on(own.take(), reporter);
    return failed ? std::nullopt : std::optional(std::move(parsed));
}

std::vector<std::string> procedures_of(const Program& program) {
    std::vector<std::string> names;
    for (const DeclarationBox& each : program.declarations)
        if (std::holds_alternative<Procedure>(each->form))
            names.push_back(each->name);
    return names;
}

/// Returns the last procedure of this name, or the last one if the name is empty. Null after reporting that there is
/// none.
const Declaration* procedure_named(const Program& program, const std::string& name, const Location& named_at,
                                   Reporter& reporter) {
    const Declaration* last = nullptr;
    for (const DeclarationBox& each : program.declarations)
        if (std::holds_alternative<Procedure>(each->form) && (name.empty() || each->name == name))
            last = each.get();
    if (last)
        return last;
    const std::string path = program.files.front()->path();
    if (name.empty())
        reporter.error(named_at, fmt::format("the file \"{}\" has no PROC", path));
    else
        reporter.error(named_at, fmt::format("the file \"{}\" has no PROC {}", path, name),
                       did_you_mean(name, procedures_of(program)));
    return nullptr;
}

class OccamKinds final : public FileKinds {
public:
    bool is_file(std::string_view program) const override {
        return program.substr(0, program.find('#')).ends_with(".occ");
    }

    std::string read(const std::string& program, const Location& named_at, const Folders& folders,
                     Reporter& reporter) override {
        const std::lock_guard lock(mutex_);
        const std::size_t hash = std::min(program.find('#'), program.size());
        const auto path = path_of(program.substr(0, hash), named_at, folders, reporter);
        if (!path)
            return "";
        const std::string name = path->string() + program.substr(hash);
        const KindOfFile* const known = newest(name);
        if (known && known->folders == folders && is_unchanged(*known->program))
            return name;
        KindOfFile made{.path = path->string(), .folders = folders, .program = {}, .options = {}, .kind = {}};
        const std::string procedure = hash == program.size() ? "" : program.substr(hash + 1);
        if (!make(made, procedure, named_at, reporter))
            return "";
        made.kind.name = name;
        newest_[name] = &all_.emplace_back(std::move(made));
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
        for (const std::shared_ptr<const SourceFile>& file : newest(name)->program->files)
            if (!is_built_in(*file))
                paths.push_back(file->path());
        return paths;
    }

    std::shared_ptr<const transputer::Image> image(const Network& network, std::size_t node,
                                                   Reporter& reporter) override {
        const std::lock_guard lock(mutex_);
        const auto first = std::ranges::find_if(network.processes, [&](const ProcessInstance& process) {
            return process.is_code && process.node == node;
        });
        try {
            return compiled(network, node, reporter);
        } catch (const RefusedInput& refused) {
            const std::string text = refused.what();
            reporter.error(first->declared,
                           fmt::format("the code of the processes on \"{}\" cannot be made", network.nodes[node].name),
                           text.substr(0, text.find('\n')));
        } catch (const UserError& refused) {
            reporter.error(first->declared, refused.what());
        }
        return nullptr;
    }

private:
    const KindOfFile* newest(std::string_view name) const {
        const auto found = newest_.find(name);
        return found == newest_.end() ? nullptr : found->second;
    }

    /// Returns the path of the file; nothing after reporting that there is none.
    static std::optional<FilePath> path_of(const std::string& file, const Location& named_at, const Folders& folders,
                                           Reporter& reporter) {
        Folders all{named_at.file ? FilePath(named_at.file->path()).parent_path() : FilePath()};
        all.insert(all.end(), folders.begin(), folders.end());
        std::string where;
        for (const FilePath& folder : all) {
            if (std::error_code error; std::filesystem::is_regular_file(folder / file, error))
                return folder / file;
            where += fmt::format("{}\"{}\"", where.empty() ? "" : ", ", folder.empty() ? "." : folder.string());
        }
        reporter.error(named_at, fmt::format("the file \"{}\" is missing", file), "looked for in " + where);
        return std::nullopt;
    }

    static bool make(KindOfFile& made, const std::string& procedure, const Location& named_at, Reporter& reporter) {
        const LoadedSource source = load_source(made.path);
        if (has_errors(source.problems)) {
            pass_on(source.problems, reporter);
            return false;
        }
        auto parsed = checked(source.file, made.folders, true, reporter);
        if (!parsed)
            return false;
        made.program = std::move(parsed->program);
        made.options = parsed->options;
        made.procedure = procedure_named(*made.program, procedure, named_at, reporter);
        auto kind = made.procedure ? kind_of(*made.program, *made.procedure, reporter) : std::nullopt;
        if (kind)
            made.kind = std::move(*kind);
        made.kind.text_hash = hash_of(*made.program);
        return kind.has_value();
    }

    std::shared_ptr<const transputer::Image> compiled(const Network& network, std::size_t node,
                                                      Reporter& reporter) const {
        CodeOptions options{.model = *transputer::model_named(network.nodes[node].type)};
        Folders folders;
        const auto program_of = [&](const ProcessInstance& process) {
            const KindOfFile& kind = *newest(process.kind);
            options.range_checks &= kind.options.range_checks && kind.options.run_time_checks;
            options.run_time_checks &= kind.options.run_time_checks;
            options.vector_space &= kind.options.vector_space;
            folders = kind.folders;
            return ProgramOfProcess{kind.path, kind.program.get(), kind.procedure};
        };
        const std::string text = text_of_image(network, node, program_of);
        const auto file = std::make_shared<const SourceFile>(fmt::format("<{}>", network.nodes[node].name), text);
        const auto parsed = checked(file, folders, false, reporter);
        if (!parsed)
            return nullptr;
        const Code code = compile(*parsed->program, *main_procedure(*parsed->program), options);
        return std::make_shared<const transputer::Image>(image_of(code, options));
    }

    mutable std::mutex mutex_;
    std::list<KindOfFile> all_; ///< also those of files that have changed since
    std::map<std::string, const KindOfFile*, std::less<>> newest_;
};

} // namespace

std::shared_ptr<FileKinds> make_file_kinds() { return std::make_shared<OccamKinds>(); }

} // namespace placedpar::occam
