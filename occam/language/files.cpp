#include "occam/language/files.hpp"

#include "text/load_source.hpp"
#include "text/nearest.hpp"
#include "text/texts_in_memory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace placedpar::occam {

namespace {

using Path = std::filesystem::path;

/// Returns the name of a file without its folders. In old files, `\` separates the folders.
std::string without_folders(const std::string& name) {
    const auto slash = name.find_last_of("/\\");
    return slash == std::string::npos ? name : name.substr(slash + 1);
}

/// Returns the names of files that may have the text for a name in #USE or #INCLUDE. For a compiled file, such as
/// x.tco, these are the names of its source. For x.module, which the compiler KRoC makes from x.occ, they include
/// x.occ.
std::vector<std::string> file_names(const std::string& name, FileUse use) {
    static constexpr std::array<std::string_view, 4> sources = {".occ", ".inc", ".module", ".pgm"};
    std::string forward = name;
    std::ranges::replace(forward, '\\', '/');
    const std::string extension = lower_case(Path(forward).extension().string());
    const std::string stem = extension.empty() ? forward : forward.substr(0, forward.size() - extension.size());
    if (extension == ".module")
        return {forward, stem + ".occ"};
    const bool is_source = std::ranges::find(sources, extension) != sources.end();
    if (use == FileUse::include || is_source)
        return extension.empty() ? std::vector{forward, forward + ".inc", forward + ".occ", forward + ".module"}
                                 : std::vector{forward};
    return {stem + ".occ", stem + ".module"};
}

/// Returns whether this is the name of a library, which is not made from a single source file.
bool is_library(const std::string& name) { return lower_case(name).ends_with(".lib"); }

std::vector<Path> folders_of(const Reading& reading, const Place& named_at) {
    std::vector<Path> folders{Path(reading.program.files[named_at.file]->path()).parent_path()};
    folders.insert(folders.end(), reading.options.folders.begin(), reading.options.folders.end());
    return folders;
}

std::optional<Path> path_of(const std::vector<Path>& folders, const std::vector<std::string>& names) {
    for (const Path& folder : folders)
        for (const std::string& name : names)
            if (names_file(folder / name))
                return folder / name;
    return std::nullopt;
}

std::optional<FoundFile> built_in_file(const Reading& reading, const std::string& name) {
    if (!reading.options.built_in)
        return std::nullopt;
    const std::string own = lower_case(without_folders(name));
    const bool has_extension = own.find('.') != std::string::npos;
    for (const auto& each : has_extension ? std::vector{own} : std::vector{own, own + ".lib", own + ".inc"})
        if (auto text = reading.options.built_in(each)) {
            const std::string shown = "<" + each + ">";
            return FoundFile{shown, std::make_shared<const SourceFile>(shown, std::move(*text))};
        }
    return std::nullopt;
}

void refuse_missing(Reading& reading, const std::string& name, const std::vector<std::string>& names,
                    const std::vector<Path>& folders, const Place& at) {
    std::string where;
    for (const Path& folder : folders)
        where += fmt::format("{}\"{}\"", where.empty() ? "" : ", ", folder.empty() ? "." : folder.string());
    std::string sought;
    for (const std::string& each : names)
        sought += (sought.empty() ? "" : ", ") + each;
    reading.reporter.error(reading.location(at), fmt::format("the file \"{}\" is missing", name),
                           fmt::format("looked for {} in {}, and among the built-in libraries", sought, where));
}

/// Loads a file that exists. Its problems, such as bytes that are not text, are reported.
FoundFile loaded(Reading& reading, const Path& path, std::string key, const Place& named_at) {
    LoadedSource source = load_source(path);
    if (source.problems.empty())
        return {std::move(key), source.file};
    const Diagnostic& problem = source.problems.front();
    reading.reporter.error(reading.location(named_at),
                           fmt::format("the file \"{}\" cannot be read: {}", path.string(), problem.message));
    return {std::move(key), nullptr};
}

/// Returns whether a file may be opened while the files in `reading.open` are being read. Otherwise reports an error.
bool may_open(Reading& reading, const std::string& key, const std::string& name, const Place& at) {
    const auto same = std::ranges::find(reading.open, key, &OpenFile::key);
    if (same != reading.open.end()) {
        std::vector<SecondPlace> others;
        if (same->named_at.file)
            others.push_back({"the file is first named here", same->named_at});
        reading.reporter.error(reading.location(at), fmt::format("the file \"{}\" includes or uses itself", name), "",
                               std::move(others));
        return false;
    }
    if (reading.open.size() > deepest_files)
        reading.reporter.error(
            reading.location(at),
            fmt::format("files include or use each other too deeply: at most {} levels are allowed", deepest_files));
    return reading.open.size() <= deepest_files;
}

/// Finds a file in the folder of the file that names it, or in one of the folders of the options.
std::optional<FoundFile> stored_file(Reading& reading, const Path& path, const std::string& name, FileUse use,
                                     const Place& at) {
    std::error_code error;
    const std::string key = std::filesystem::weakly_canonical(path, error).string();
    if (use == FileUse::use && reading.units.contains(key))
        return FoundFile{key, nullptr};
    return may_open(reading, key, name, at) ? std::optional(loaded(reading, path, key, at)) : std::nullopt;
}

std::optional<FoundFile> own_file(Reading& reading, FoundFile found, const std::string& name, FileUse use,
                                  const Place& at) {
    if (use == FileUse::use && reading.units.contains(found.key))
        return FoundFile{found.key, nullptr};
    return may_open(reading, found.key, name, at) ? std::optional(std::move(found)) : std::nullopt;
}

} // namespace

std::optional<FoundFile> find_file(Reading& reading, const std::string& name, FileUse use, const Place& named_at) {
    const auto names = file_names(name, use);
    const auto folders = folders_of(reading, named_at);
    const auto path = path_of(folders, names);
    auto own = built_in_file(reading, name);
    if (own && (!path || is_library(name)))
        return own_file(reading, std::move(*own), name, use, named_at);
    if (path)
        return stored_file(reading, *path, name, use, named_at);
    refuse_missing(reading, name, names, folders, named_at);
    return std::nullopt;
}

std::uint32_t add_file(Reading& reading, std::shared_ptr<const SourceFile> file, const Location& named_at) {
    if (named_at.file)
        reading.reporter.add_included(file, named_at);
    reading.program.files.push_back(std::move(file));
    return static_cast<std::uint32_t>(reading.program.files.size() - 1);
}

} // namespace placedpar::occam
