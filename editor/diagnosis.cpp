#include "editor/diagnosis.hpp"

#include "editor/language/study_text.hpp"
#include "explore/check/check_file.hpp"
#include "occam/configuration/configuration.hpp"
#include "occam/language/parse.hpp"
#include "occam/library/library.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace placedpar::editor {

namespace {

namespace json = boost::json;

std::filesystem::path normal(const std::filesystem::path& path) {
    return std::filesystem::absolute(path).lexically_normal();
}

/// Stores the paths of the files that were read with a document. If the text has errors, reading may have stopped
/// early; the paths that were stored before are then kept, too.
void note_included(Document& document, const std::vector<std::string>& paths, bool failed) {
    if (!failed)
        document.included.clear();
    for (const std::string& each : paths)
        document.included.insert(normal(each));
}

/// Returns the syntax errors of a file that other files include.
std::vector<Diagnostic> check_part(Document& document) {
    if (document.language != Language::occam)
        return syntax_of(document).diagnostics;
    Reporter reporter;
    occam::ParseOptions options;
    options.built_in = [](const std::string& name) { return occam::library_text(name); };
    occam::parse(document.file, options, reporter);
    return reporter.take();
}

/// Returns whether a line of a text begins with `netlist =`. A text in TOML without such a line is not a study (a file
/// about experiments with a netlist).
bool names_netlist(const std::string& text) {
    constexpr std::string_view setting = "netlist";
    for (auto at = text.find(setting); at != text.npos; at = text.find(setting, at + 1)) {
        const auto before = at == 0 ? text.npos : text.find_last_not_of(" \t", at - 1);
        const auto behind = text.find_first_not_of(" \t", at + setting.size());
        if ((before == text.npos || text[before] == '\n') && behind != text.npos && text[behind] == '=')
            return true;
    }
    return false;
}

json::object position_json(const Position& position) {
    return {{"line", position.line}, {"character", position.character}};
}

/// Returns whether an editor can open the file of this place.
bool is_in_file(const Location& at) { return at.file && std::filesystem::path(at.file->path()).is_absolute(); }

json::array related_json(const Diagnostic& diagnostic, NamesOf names, const Documents& documents, RangeWriter& writer) {
    json::array related;
    for (const SecondPlace& each : diagnostic.others)
        if (is_in_file(each.location))
            related.push_back(json::object{{"location",
                                            {{"uri", documents.uri_of(each.location.file->path())},
                                             {"range", writer.range_of_word(each.location, names)}}},
                                           {"message", each.message}});
    return related;
}

} // namespace

const NetlistSyntax& syntax_of(Document& document) {
    if (!document.netlist)
        document.netlist = read_syntax(document.file);
    return *document.netlist;
}

const OccamCheck& program_of(Document& document) {
    if (!document.occam.present) {
        document.occam.present = std::make_shared<const OccamCheck>(document.language == Language::configuration
                                                                        ? check_configuration_source(document.file)
                                                                        : check_occam_source(document.file, {}));
        if (document.occam.present->parsed)
            document.occam.last_parsed = document.occam.present;
    }
    return *document.occam.present;
}

const StudyNames& names_of(Document& document, const Catalogue& catalogue, const ProblemRegistry& problems) {
    if (document.study)
        return *document.study;
    const std::filesystem::path folder = document.path.parent_path();
    std::filesystem::path netlist;
    ReadOptions options;
    for (const StudyWord& each : read_study_text(document.file->text()).words)
        if (!each.is_key && each.path == std::vector<std::string>{"netlist"})
            netlist = folder / each.text;
        else if (!each.is_key && each.path == std::vector<std::string>{"include"})
            options.include_folders.push_back(folder / each.text);
    document.study = names_for_study(netlist, options, catalogue, problems).value_or(StudyNames());
    return *document.study;
}

std::vector<Diagnostic> check_document(Document& document, const Catalogue& catalogue) {
    if (document.is_part)
        return check_part(document);
    if (document.language == Language::occam) {
        const OccamCheck& program = program_of(document);
        std::vector<std::string> paths;
        for (const auto& file : program.program->files)
            if (file != document.file && !file->path().starts_with('<'))
                paths.push_back(file->path());
        note_included(document, paths, program.failed);
        return program.diagnostics;
    }
    if (document.language == Language::study && !names_netlist(document.file->text()))
        return {};
    CheckOptions options;
    options.read.make_netlist = occam::netlist_of_configuration;
    CheckedFile checked = check_file(document.path, catalogue, options);
    note_included(document, checked.included, checked.failed());
    document.names = checked.names;
    return std::move(checked.diagnostics);
}

json::object RangeWriter::range_of_word(const Location& at, NamesOf names) {
    return range(at, end_of_word(at, names).column - at.column);
}

json::object RangeWriter::range(const Location& at, std::size_t bytes) {
    const Positions& positions = positions_.try_emplace(at.file.get(), at.file->text()).first->second;
    const std::size_t first = offset_of(at);
    return {{"start", position_json(positions.position(first))},
            {"end", position_json(positions.position(first + bytes))}};
}

std::map<std::string, json::array> diagnostics_json(const std::vector<Diagnostic>& diagnostics,
                                                    const Document& document, const Documents& documents) {
    std::map<std::string, json::array> by_file;
    RangeWriter writer;
    for (const Diagnostic& each : diagnostics) {
        const bool in_file = is_in_file(each.location);
        const Location at = in_file ? each.location : Location{document.file, 0, 0};
        const std::string where = in_file || !each.location.file ? "" : each.location.file->path() + ": ";
        const std::string hint = each.hint.empty() ? "" : "\nhint: " + each.hint;
        by_file[documents.uri_of(at.file->path())].push_back(
            json::object{{"range", writer.range_of_word(at, document.names)},
                         {"severity", each.severity == Severity::error ? 1 : 2},
                         {"source", "placedpar"},
                         {"message", where + each.message + hint},
                         {"relatedInformation", related_json(each, document.names, documents, writer)}});
    }
    return by_file;
}

} // namespace placedpar::editor
