#include "netlist/language/include_path.hpp"

#include "text/nearest.hpp"
#include "text/texts_in_memory.hpp"

#include <algorithm>

namespace placedpar {

namespace {

namespace fs = std::filesystem;

/// Returns the folder's entry with this name, ignoring the case of letters. If there are several, returns the first in
/// order of names.
std::optional<fs::path> entry_like(const fs::path& folder, const std::string& name) {
    std::optional<fs::path> first;
    std::error_code error;
    for (fs::directory_iterator entry(folder.empty() ? "." : folder, error), end; !error && entry != end;
         entry.increment(error))
        if (auto found = entry->path().filename();
            lower_case(found.string()) == lower_case(name) && (!first || found < *first))
            first = found;
    return first;
}

std::optional<fs::path> find_in(const fs::path& folder, const fs::path& name) {
    std::error_code error;
    if (text_in_memory(folder / name) || fs::exists(folder / name, error))
        return folder / name;
    fs::path found = folder;
    for (const auto& part : name)
        if (fs::exists(found / part, error))
            found /= part;
        else if (auto entry = entry_like(found, part.string()))
            found /= *entry;
        else
            return std::nullopt;
    return found;
}

} // namespace

std::string without_backslashes(std::string name) {
    std::ranges::replace(name, '\\', '/');
    return name;
}

bool is_of_the_toolset(const std::string& name) {
    auto file = lower_case(fs::path(name).filename().string());
    return file == "setconf.inc" || file == "boards.inc" || file == "trams.inc";
}

std::optional<fs::path> find_included(const std::string& name, const std::vector<fs::path>& folders) {
    for (const auto& folder : folders)
        if (auto found = find_in(folder, name))
            return found;
    return std::nullopt;
}

} // namespace placedpar
