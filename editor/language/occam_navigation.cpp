#include "editor/language/completion.hpp"
#include "editor/language/navigation.hpp"
#include "editor/language/occam_names.hpp"
#include "occam/language/words.hpp"
#include "occam/library/library.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <string_view>
#include <utility>

namespace placedpar::editor {

namespace {

using occam::Declaration;
using occam::DeclarationBox;
using occam::Program;

bool is_in_name(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x80 && (std::isalnum(byte) != 0 || c == '.' || c == '_');
}

std::string text_of_line(const Program& program, const occam::Place& at) {
    const std::string_view line = program.files[at.file]->line(at.line);
    return std::string(line.substr(std::min(line.find_first_not_of(' '), line.size())));
}

/// Calls the function with each declaration of a list that introduces a name.
template <class Function>
void for_each_named(const std::vector<DeclarationBox>& declarations, const Function& function) {
    for (const DeclarationBox& each : declarations)
        if (each->at.line > 0 && !std::holds_alternative<occam::Use>(each->form) &&
            !std::holds_alternative<occam::Placement>(each->form))
            function(*each);
}

bool is_routine(const Declaration& declaration) {
    return std::holds_alternative<occam::Procedure>(declaration.form) ||
           std::holds_alternative<occam::Function>(declaration.form);
}

std::size_t indentation_of(std::string_view line) { return std::min(line.find_first_not_of(' '), line.size()); }

/// Returns for each earlier line whether its declarations are visible at a line. A line that is indented less ends the
/// scope of the declarations before it. The index is the number of the line.
std::vector<bool> visible_at(const SourceFile& file, std::size_t line) {
    std::vector<bool> visible(line);
    std::size_t least = std::string_view::npos; // smallest indentation of the lines from here to `line`
    for (std::size_t i = line; i-- > 0;) {
        const std::string_view text = file.line(i);
        const std::size_t indentation = indentation_of(text);
        visible[i] = indentation <= least;
        if (indentation < text.size())
            least = std::min(least, indentation);
    }
    return visible;
}

std::string type_text(const Declaration& declaration) {
    return declaration.type && !is_routine(declaration) ? occam::name_of(*declaration.type) : "";
}

/// Adds the names that used files declare, and the names of the main file that are visible at a place; each name once.
void add_names(const Program& program, const SourceFile& file, const Location& at, std::vector<Completion>& found) {
    std::set<std::string> known;
    const auto add = [&](const Declaration& each) {
        if (!known.insert(each.name).second)
            return;
        const auto kind = is_routine(each) ? Completion::Kind::routine : Completion::Kind::variable;
        found.push_back({each.name, kind, is_routine(each) ? text_of_line(program, each.at) : type_text(each)});
    };
    for (const auto& unit : program.units)
        for_each_named(unit->declarations, add);
    for_each_named(program.declarations, [&](const Declaration& each) {
        if (each.at.file != 0)
            add(each);
    });
    const std::vector<bool> visible = visible_at(file, at.line);
    for (const occam::ResolvedName& each : program.resolved)
        if (each.meaning->at.file == 0 && each.meaning->at.line < at.line && visible[each.meaning->at.line])
            add(*each.meaning);
}

} // namespace

std::pair<std::string, std::size_t> name_at(const SourceFile& file, const Location& at) {
    const std::string_view line = file.line(at.line);
    std::size_t first = std::min(at.column - 1, line.size()), last = first;
    while (first > 0 && is_in_name(line[first - 1]))
        --first;
    while (last < line.size() && is_in_name(line[last]))
        ++last;
    return {std::string(line.substr(first, last - first)), first + 1};
}

const Declaration* meaning_at(const Program& program, const Location& at) {
    const auto [name, column] = name_at(*program.files.front(), at);
    for (const occam::ResolvedName& each : program.resolved)
        if (each.at.file == 0 && each.at.line == at.line && each.meaning->name == name && each.at.column == column)
            return each.meaning;
    return nullptr;
}

std::string hover_occam(const Program& program, const Location& at) {
    const Declaration* const meaning = meaning_at(program, at);
    if (!meaning)
        return "";
    const std::string type = type_text(*meaning);
    const std::string what = type.empty() ? "" : fmt::format("{} {}\n", type, meaning->name);
    if (meaning->at.line == 0)
        return what.empty() ? fmt::format("{} is predefined\n", meaning->name) : what;
    return fmt::format("{}\n{}declared in {}, line {}\n", text_of_line(program, meaning->at), what,
                       program.files[meaning->at.file]->path(), meaning->at.line);
}

std::optional<Location> definition_in_occam(const Program& program, const Location& at) {
    const std::string_view line = program.files.front()->line(at.line);
    if (const auto quote = line.find('"'); line.find_first_not_of(' ') == line.find('#') && quote != line.npos) {
        const std::filesystem::path name = line.substr(quote + 1, line.find('"', quote + 1) - quote - 1);
        for (const auto& file : program.files)
            if (std::filesystem::path(file->path()).stem() == name.stem() && !file->path().starts_with('<'))
                return Location{file, 1, 1};
        return std::nullopt;
    }
    const Declaration* const meaning = meaning_at(program, at);
    const bool has_file = meaning && meaning->at.line > 0 && !program.files[meaning->at.file]->path().starts_with('<');
    return has_file ? std::optional(program.location(meaning->at)) : std::nullopt;
}

std::vector<OutlineEntry> outline_of(const Program& program) {
    std::vector<OutlineEntry> entries;
    for_each_named(program.declarations, [&](const Declaration& each) {
        if (each.at.file == 0)
            entries.push_back({each.name, type_text(each), program.location(each.at), is_routine(each)});
    });
    return entries;
}

std::vector<Completion> complete_occam(const SourceFile& file, const Program* parsed, const Location& at) {
    const std::string_view before = file.line(at.line).substr(0, at.column - 1);
    if (before.find("--") != before.npos)
        return {};
    std::vector<Completion> found;
    if (const auto first = before.find_first_not_of(' '); first != before.npos && before[first] == '#') {
        for (const std::string& each : occam::library_names())
            found.push_back({each, Completion::Kind::file, "library"});
        return found;
    }
    for (const std::string_view each : occam::all_keywords())
        found.push_back({std::string(each), Completion::Kind::keyword});
    if (parsed)
        add_names(*parsed, file, at, found);
    return found;
}

} // namespace placedpar::editor
