#include "editor/protocol/file_uri.hpp"

#include "text/number.hpp"

#include <fmt/format.h>

#include <cctype>

namespace placedpar::editor {

namespace {

/// Replaces escapes such as `%20` by the bytes that they represent.
std::string decoded(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte =
            text[i] == '%' && i + 2 < text.size() ? parse_number<unsigned>(text.substr(i + 1, 2), 16) : std::nullopt;
        result += byte ? static_cast<char>(*byte) : text[i];
        i += byte ? 2 : 0;
    }
    return result;
}

} // namespace

std::optional<std::filesystem::path> path_of_uri(std::string_view uri) {
    constexpr std::string_view scheme = "file://";
    if (!uri.starts_with(scheme))
        return std::nullopt;
    const auto slash = uri.find('/', scheme.size()); // a host may precede the slash
    if (slash == uri.npos)
        return std::nullopt;
    return std::filesystem::path(decoded(uri.substr(slash))).lexically_normal();
}

std::string uri_of_path(const std::filesystem::path& path) {
    std::string uri = "file://";
    for (const char c : path.lexically_normal().string()) {
        const auto byte = static_cast<unsigned char>(c);
        const bool is_plain =
            byte < 0x80 && (std::isalnum(byte) != 0 || std::string_view("/-._~").find(c) != std::string_view::npos);
        uri += is_plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
    }
    return uri;
}

} // namespace placedpar::editor
