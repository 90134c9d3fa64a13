#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace placedpar::editor {

/// Returns the path that a URI such as "file:///nets/a%20b.cfs" names; nothing for a URI of another scheme.
std::optional<std::filesystem::path> path_of_uri(std::string_view uri);
/// Returns the URI of a file. REQUIRES: the path is absolute.
std::string uri_of_path(const std::filesystem::path&);

} // namespace placedpar::editor
