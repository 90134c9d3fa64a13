#include "editor/documents.hpp"

#include "editor/protocol/file_uri.hpp"
#include "editor/protocol/json_members.hpp"
#include "explore/check/check_file.hpp"
#include "netlist/language/occam.hpp"
#include "occam/configuration/configuration.hpp"
#include "text/nearest.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace placedpar::editor {

namespace {

namespace json = boost::json;

/// Sets the language of a text. The extension of the file name decides. If the extension is unknown, the editor's name
/// for the language decides. If this name is unknown, too, the contents of the text decide.
void choose_language(Document& document, const std::string& language_id) {
    const std::string extension = lower_case(document.path.extension().string());
    document.is_part = extension != ".cfs" && extension != ".occ" && extension != ".pgm" && extension != ".toml";
    if (is_study(document.path))
        document.language = Language::study;
    else if (occam::is_configuration(*document.file))
        document.language = Language::configuration;
    else if (extension == ".occ" || (document.is_part && language_id.find("occam") != std::string::npos))
        document.language = Language::occam;
    else if (document.is_part && language_id.find("netlist") == std::string::npos && occam_in(document.file))
        document.language = Language::occam;
    document.names = document.language == Language::netlist ? NamesOf::netlist : NamesOf::occam;
}

/// Returns a path for a text without a file, such as a text that was never saved.
std::filesystem::path path_without_file(const std::string& uri, const std::string& language_id) {
    std::string name = uri;
    std::ranges::replace(name, '/', '_');
    return "/unsaved/" + name + (language_id.find("occam") == std::string::npos ? ".cfs" : ".occ");
}

std::size_t offset_in(const Positions& positions, Position position) {
    try {
        return positions.offset(position);
    } catch (const std::out_of_range&) {
        throw RequestError(
            ErrorCode::invalid_params,
            fmt::format("line {} does not exist: the number of lines is {}, and the first line is line 0",
                        position.line, positions.lines()));
    }
}

/// Applies one change, which replaces a range or the whole text.
void apply(std::string& text, const json::value& change) {
    const json::object* object = change.if_object();
    if (!object)
        throw RequestError(ErrorCode::invalid_params, "a change must be an object");
    std::string changed = text_in(*object, "text");
    if (!object->contains("range")) {
        text = std::move(changed);
        return;
    }
    const json::object& range = object_in(*object, "range");
    const Positions positions(text);
    const std::size_t first = offset_in(positions, position_in(range, "start"));
    const std::size_t last = offset_in(positions, position_in(range, "end"));
    if (last < first)
        throw RequestError(ErrorCode::invalid_params, "the range of a change ends before it starts");
    text.replace(first, last - first, changed);
}

} // namespace

Location Document::location(Position position) const {
    const std::string& text = file->text();
    const std::size_t offset = offset_in(Positions(text), position);
    const auto start = offset == 0 ? 0 : text.rfind('\n', offset - 1) + 1;
    const auto line = static_cast<std::size_t>(std::count(text.data(), text.data() + start, '\n')) + 1;
    return {file, line, offset - start + 1};
}

void Document::forget() {
    netlist.reset();
    occam.present.reset();
    occam.cycles.reset();
    study.reset();
}

void Documents::set_text(Document& document, std::string text) {
    texts_.put(document.path, text);
    document.file = std::make_shared<const SourceFile>(document.path.string(), std::move(text));
    document.forget();
}

Document& Documents::open(const std::string& uri, const std::string& language_id, std::string text) {
    Document& document = documents_[uri];
    document = {.uri = uri, .path = path_of_uri(uri).value_or(path_without_file(uri, language_id)), .file = nullptr};
    set_text(document, std::move(text));
    choose_language(document, language_id);
    return document;
}

void Documents::change(Document& document, const json::array& changes) {
    std::string text = document.file->text();
    for (const json::value& each : changes)
        apply(text, each);
    set_text(document, std::move(text));
}

void Documents::close(const std::string& uri) {
    texts_.remove(at(uri).path);
    documents_.erase(uri);
}

Document& Documents::at(const std::string& uri) {
    const auto found = documents_.find(uri);
    if (found == documents_.end())
        throw RequestError(ErrorCode::invalid_params, fmt::format("no text with the URI {} is open", uri));
    return found->second;
}

std::string Documents::uri_of(const std::filesystem::path& path) const {
    const std::filesystem::path absolute = std::filesystem::absolute(path).lexically_normal();
    for (const auto& [uri, document] : documents_)
        if (document.path == absolute)
            return uri;
    return uri_of_path(absolute);
}

} // namespace placedpar::editor
