#include "occam/code/place_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace placedpar::occam {

namespace {

constexpr std::size_t longest_path = 200; // the longest path that the table allows

/// Returns the path of a file, or its last part if the path is too long.
std::string_view path_in_table(const SourceFile& file) {
    const std::string_view path = file.path();
    return path.substr(path.size() - std::min(path.size(), longest_path));
}

} // namespace

std::string place_table(const Code& code, const Program& program, std::uint32_t code_at) {
    std::string table;
    const auto to = std::back_inserter(table);
    for (std::size_t i = 0; i < code.lines.size(); ++i) {
        const CodeLine& row = code.lines[i];
        const std::uint32_t until = i + 1 < code.lines.size() ? code.lines[i + 1].offset : code.constants;
        if (row.place.line > 0 && row.offset < until)
            fmt::format_to(to, "code +#{:X} +#{:X} {} {} {}\n", code_at + row.offset, code_at + until, row.place.line,
                           row.place.column, path_in_table(*program.files[row.place.file]));
    }
    for (const CodeName& name : code.names)
        fmt::format_to(to, "entry +#{:X} {}\n", code_at + name.offset, name.name.substr(0, longest_path));
    for (const CodeError& error : code.errors)
        fmt::format_to(to, "error +#{:X} {}\n", code_at + error.offset, error.text);
    const std::int64_t first_workspace = code_at - 4 * static_cast<std::int64_t>(code.first_workspace_words);
    for (const CodeWorkspace& each : code.workspaces)
        fmt::format_to(to, "{} +#{:X} +#{:X} {}\n", each.carries ? "carrier" : "process",
                       first_workspace + 4 * each.from, first_workspace + 4 * each.until,
                       each.name.substr(0, longest_path));
    return table + "end\n";
}

} // namespace placedpar::occam
