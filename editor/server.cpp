#include "editor/server.hpp"

#include "editor/diagnosis.hpp"
#include "editor/language/completion.hpp"
#include "editor/language/navigation.hpp"
#include "editor/language/study_text.hpp"
#include "editor/protocol/json_members.hpp"
#include "editor/protocol/message_stream.hpp"
#include "explore/problems.hpp"
#include "netlist/language/layout.hpp"
#include "occam/language/blanks.hpp"
#include "report/manifest.hpp"
#include "text/user_error.hpp"
#include "text/utf8.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace placedpar::editor {

namespace {

namespace json = boost::json;

constexpr transputer::Model hover_model = transputer::Model::t800;

json::object capabilities() {
    return {{"positionEncoding", "utf-16"},
            {"textDocumentSync", {{"openClose", true}, {"change", 2}, {"save", true}}},
            {"hoverProvider", true},
            {"completionProvider", {{"triggerCharacters", {".", "(", "\"", "#"}}}},
            {"definitionProvider", true},
            {"renameProvider", true},
            {"documentFormattingProvider", true},
            {"documentSymbolProvider", true}};
}

/// Returns the number that the language server protocol gives to a kind of completion.
int number_of(Completion::Kind kind) {
    switch (kind) {
    case Completion::Kind::keyword: return 14;
    case Completion::Kind::kind: return 7;       // class
    case Completion::Kind::port: return 5;       // field
    case Completion::Kind::parameter: return 10; // property
    case Completion::Kind::value: return 12;
    case Completion::Kind::variable: return 6;
    case Completion::Kind::routine: return 3;
    case Completion::Kind::type: return 22; // struct
    case Completion::Kind::file: return 17;
    }
    return 1;
}

json::object symbol_json(const OutlineEntry& entry, const json::object& range) {
    return {{"name", entry.name},
            {"detail", entry.detail},
            {"kind", entry.is_routine ? 12 : 13}, // a function, a variable
            {"range", range},
            {"selectionRange", range}};
}

/// Returns the edit that changes one text into another. The edit replaces the lines between the common beginning and
/// the common end of both texts.
json::array edits_between(const std::string& before, const std::string& after) {
    if (before == after)
        return {};
    const auto shorter = std::min(before.size(), after.size());
    std::size_t first = static_cast<std::size_t>(
        std::mismatch(before.begin(), before.begin() + static_cast<std::ptrdiff_t>(shorter), after.begin()).first -
        before.begin());
    first = first == 0 ? 0 : before.rfind('\n', first - 1) + 1;
    std::size_t same = 0; // number of equal bytes at the ends of both texts
    while (same < shorter - first && before[before.size() - 1 - same] == after[after.size() - 1 - same])
        ++same;
    while (same > 0 && before[before.size() - same - 1] != '\n')
        --same;
    const Positions positions(before);
    const auto start = positions.position(first), end = positions.position(before.size() - same);
    return {json::object{{"range",
                          {{"start", {{"line", start.line}, {"character", start.character}}},
                           {"end", {{"line", end.line}, {"character", end.character}}}}},
                         {"newText", after.substr(first, after.size() - same - first)}}};
}

} // namespace

struct LanguageServer::State {
    using Handler = json::value (State::*)(const json::object&);

    explicit State(std::function<void(const std::string&)> sender)
        : send(std::move(sender)), problems(known_problems(0)), catalogue(known_kinds(problems)) {}

    void send_json(json::object message) {
        message["jsonrpc"] = "2.0";
        send(as_json(json::serialize(message)));
    }

    void answer(const json::value& id, json::value result) { send_json({{"id", id}, {"result", std::move(result)}}); }

    void answer_error(const json::value& id, ErrorCode code, const std::string& why) {
        send_json({{"id", id}, {"error", {{"code", static_cast<int>(code)}, {"message", why}}}});
    }

    /// Reports an invalid notification in the editor's log, because notifications have no answer.
    void log(const std::string& why) {
        send_json({{"method", "window/logMessage"}, {"params", {{"type", 1}, {"message", why}}}});
    }

    Document& document_of(const json::object& params) {
        return documents.at(text_in(object_in(params, "textDocument"), "uri"));
    }
    Location location_of(const json::object& params) {
        return document_of(params).location(position_in(params, "position"));
    }

    // Requests
    json::value initialize(const json::object&) {
        initialized = true;
        return {{"capabilities", capabilities()}, {"serverInfo", {{"name", "placedpar"}, {"version", version}}}};
    }

    json::value shutdown(const json::object&) {
        shut_down = true;
        return nullptr;
    }

    json::value hover(const json::object& params) {
        const std::string text = hover_text(document_of(params), location_of(params));
        if (text.empty())
            return nullptr;
        return {{"contents", {{"kind", "plaintext"}, {"value", text}}}};
    }

    json::value complete(const json::object& params) {
        Document& document = document_of(params);
        json::array items;
        for (const Completion& each : completions(document, location_of(params)))
            items.push_back(json::object{{"label", each.text},
                                         {"kind", number_of(each.kind)},
                                         {"detail", each.detail},
                                         {"documentation", each.about}});
        return {{"isIncomplete", false}, {"items", std::move(items)}};
    }

    json::value define(const json::object& params) {
        Document& document = document_of(params);
        const Location at = location_of(params);
        const std::optional<Location> found =
            document.language == Language::netlist ? definition_in_netlist(syntax_of(document), at)
            : document.language == Language::study ? definition_in_study(read_study_text(document.file->text()),
                                                                         names_of(document, catalogue, problems), at)
                                                   : definition_in_occam(*program_of(document).program, at);
        if (!found)
            return nullptr;
        return {{"uri", documents.uri_of(found->file->path())},
                {"range", RangeWriter().range_of_word(*found, document.names)}};
    }

    json::value rename(const json::object& params) {
        Document& document = document_of(params);
        refuse_to_rename_in(document);
        const std::string name = text_in(params, "newName");
        const NetlistSyntax& syntax = syntax_of(document);
        const Location at = location_of(params);
        const std::vector<Location> places = places_to_rename(syntax, catalogue, at, name);
        const std::size_t bytes = syntax.name_at(at)->name.size();
        RangeWriter writer;
        json::array edits;
        for (const Location& each : places)
            edits.push_back(json::object{{"range", writer.range(each, bytes)}, {"newText", name}});
        return {{"changes", {{document.uri, std::move(edits)}}}};
    }

    json::value lay_out(const json::object& params) {
        const Document& document = document_of(params);
        const auto text = document.language == Language::netlist ? laid_out_netlist(document.file)
                          : document.language == Language::study ? std::nullopt
                                                                 : occam::with_tidy_blanks(document.file);
        return text ? json::value(edits_between(document.file->text(), *text)) : json::value(nullptr);
    }

    json::value outline(const json::object& params) {
        Document& document = document_of(params);
        std::vector<OutlineEntry> entries;
        if (document.language == Language::netlist)
            entries = outline_of(syntax_of(document));
        else if (document.language != Language::study)
            entries = outline_of(*program_of(document).program);
        RangeWriter writer;
        json::array symbols;
        for (const OutlineEntry& each : entries)
            symbols.push_back(symbol_json(each, writer.range_of_word(each.at, document.names)));
        return symbols;
    }

    // Notifications

    json::value nothing(const json::object&) { return nullptr; }

    json::value exit(const json::object&) {
        ended = true;
        return nullptr;
    }

    json::value opened(const json::object& params) {
        const json::object& item = object_in(params, "textDocument");
        const std::uint64_t version_opened = number_in(item, "version");
        Document& document = documents.open(text_in(item, "uri"), text_in(item, "languageId"), text_in(item, "text"));
        document.version = version_opened;
        mark_changed(document);
        for (auto& [uri, other] : documents.all())
            if (other.failed) // the check may have failed because this file was missing
                check_again(other);
        return nullptr;
    }

    json::value changed(const json::object& params) {
        Document& document = document_of(params);
        const json::object& item = object_in(params, "textDocument");
        const json::value* const named = item.if_contains("version");
        const auto version_now = named && named->is_null() ? std::nullopt : std::optional(number_in(item, "version"));
        documents.change(document, array_in(params, "contentChanges"));
        document.version = version_now;
        mark_changed(document);
        return nullptr;
    }

    /// Checks every open text again, because the files that it includes may have changed on the disk.
    json::value saved(const json::object&) {
        for (auto& [uri, document] : documents.all())
            check_again(document);
        return nullptr;
    }

    json::value closed(const json::object& params) {
        const std::string closed_uri = document_of(params).uri;
        mark_changed(documents.at(closed_uri));
        documents.close(closed_uri);
        to_check.erase(closed_uri);
        const auto files = std::exchange(published[closed_uri], {});
        published.erase(closed_uri);
        for (const auto& [uri, diagnostics] : files)
            send_diagnostics(uri);
        return nullptr;
    }

    void check_again(Document& document) {
        to_check.insert(document.uri);
        document.forget();
    }

    /// Marks a text, and the texts that include it, as changed, so that they are checked.
    void mark_changed(const Document& document) {
        to_check.insert(document.uri);
        for (auto& [uri, other] : documents.all())
            if (other.included.contains(document.path))
                check_again(other);
    }

    /// Returns the cycles that a line of a program takes on the transputer; "" if the program cannot be compiled.
    std::string cycles_text(Document& document, const Location& at) {
        const OccamCheck& program = program_of(document);
        if (program.failed || document.is_part)
            return "";
        if (!document.occam.cycles)
            document.occam.cycles = cycles_of_lines(*program.program, {}, hover_model);
        const auto found = document.occam.cycles->find(at.line);
        return found == document.occam.cycles->end() ? "" : text_of_cycles(found->second, hover_model);
    }

    std::string hover_text(Document& document, const Location& at) {
        if (document.language == Language::netlist)
            return hover_netlist(syntax_of(document), catalogue, at);
        if (document.language == Language::study)
            return hover_study(read_study_text(document.file->text()), names_of(document, catalogue, problems), at);
        const OccamCheck& program = program_of(document);
        if (document.language == Language::configuration)
            return program.configured ? hover_configuration(*program.program, *program.configured, at) : "";
        return hover_occam(*program.program, at) + cycles_text(document, at);
    }

    std::vector<Completion> completions(Document& document, const Location& at) {
        if (document.language == Language::netlist)
            return complete_netlist(syntax_of(document), catalogue, at);
        if (document.language == Language::study)
            return complete_study(read_study_text(document.file->text().substr(0, offset_of(at))),
                                  names_of(document, catalogue, problems), catalogue);
        program_of(document); // also stores it as the last parsed program, if it has no errors of syntax
        const OccamCheck* const parsed = document.occam.last_parsed.get();
        return (document.language == Language::occam ? complete_occam : complete_configuration)(
            *document.file, parsed ? parsed->program.get() : nullptr, at);
    }

    /// Throws RequestError if the document is not a netlist, or if another open text includes it.
    void refuse_to_rename_in(const Document& document) {
        if (document.language != Language::netlist)
            throw RequestError(ErrorCode::request_failed, "only names of netlists can be renamed");
        for (const auto& [uri, other] : documents.all())
            if (other.included.contains(document.path))
                throw RequestError(
                    ErrorCode::request_failed,
                    fmt::format("{} includes this file, and may also use the name", other.path.string()));
    }

    void send_diagnostics(const std::string& uri) {
        json::array all;
        for (const auto& [checked, files] : published)
            if (const auto found = files.find(uri); found != files.end())
                for (const json::value& each : found->second)
                    if (std::ranges::find(all, each) == all.end()) // several texts may include the file
                        all.push_back(each);
        json::object params{{"uri", uri}, {"diagnostics", std::move(all)}};
        if (const auto found = documents.all().find(uri); found != documents.all().end() && found->second.version)
            params["version"] = *found->second.version;
        send_json({{"method", "textDocument/publishDiagnostics"}, {"params", std::move(params)}});
    }

    void publish(const std::string& uri) {
        Document& document = documents.at(uri);
        const auto is_included_by = [&](const auto& each) { return each.second.included.contains(document.path); };
        std::map<std::string, json::array> files;
        if (!document.is_part || std::ranges::none_of(documents.all(), is_included_by)) {
            const std::vector<Diagnostic> diagnostics = check_document(document, catalogue);
            document.failed = has_errors(diagnostics);
            files = diagnostics_json(diagnostics, document, documents);
        }
        files[uri]; // also sends an empty list, which clears earlier errors
        std::set<std::string> uris;
        for (const auto& [file, diagnostics] : published[uri])
            uris.insert(file);
        for (const auto& [file, diagnostics] : files)
            uris.insert(file);
        published[uri] = std::move(files);
        for (const std::string& each : uris)
            send_diagnostics(each);
    }

    json::value carry_out(const std::string& method, const json::object& params) {
        static const std::map<std::string, Handler> handlers{
            {"initialize", &State::initialize},
            {"initialized", &State::nothing},
            {"shutdown", &State::shutdown},
            {"exit", &State::exit},
            {"textDocument/didOpen", &State::opened},
            {"textDocument/didChange", &State::changed},
            {"textDocument/didClose", &State::closed},
            {"textDocument/didSave", &State::saved},
            {"textDocument/hover", &State::hover},
            {"textDocument/completion", &State::complete},
            {"textDocument/definition", &State::define},
            {"textDocument/rename", &State::rename},
            {"textDocument/formatting", &State::lay_out},
            {"textDocument/documentSymbol", &State::outline},
        };
        if (!initialized && method != "initialize" && method != "exit")
            throw RequestError(ErrorCode::not_initialized, "the first request must be \"initialize\"");
        if (shut_down && method != "exit")
            throw RequestError(ErrorCode::invalid_request, "the server has been shut down");
        const auto handler = handlers.find(method);
        if (handler == handlers.end())
            throw RequestError(ErrorCode::method_not_found, fmt::format("the method \"{}\" is unknown", method));
        const ReadsFromMemory reads(documents.texts());
        return (this->*handler->second)(params);
    }

    void take(const json::object& message) {
        const json::value* const id = message.if_contains("id");
        const json::value* const method = message.if_contains("method");
        if (!method && id && (message.contains("result") || message.contains("error")))
            return; // ignores an answer, since the server has sent no request
        const json::value* const params = message.if_contains("params");
        const bool is_optional = method && method->is_string() && method->as_string().starts_with("$/");
        const auto fail = [&](ErrorCode code, const std::string& why) {
            if (id || !method)
                answer_error(id ? *id : nullptr, code, why);
            else if (!is_optional)
                log(why);
        };
        try {
            const bool has_params = params && !params->is_null();
            if (!method || !method->is_string())
                throw RequestError(ErrorCode::invalid_request,
                                   "a message must have a \"method\", which must be a string");
            if (has_params && !params->is_object())
                throw RequestError(ErrorCode::invalid_params, "\"params\" must be an object");
            json::value result =
                carry_out(std::string(method->as_string()), has_params ? params->as_object() : json::object());
            if (id)
                answer(*id, std::move(result));
        } catch (const RequestError& refused) {
            fail(refused.code, refused.what());
        } catch (const UserError& refused) {
            fail(ErrorCode::request_failed, refused.what());
        }
    }

    std::function<void(const std::string&)> send;
    ProblemRegistry problems;
    Catalogue catalogue;
    Documents documents;
    std::set<std::string> to_check; ///< URIs of texts that have changed
    std::map<std::string, std::map<std::string, json::array>>
        published; ///< diagnostics that the editor has; keys: URI of the checked text, then URI of the file with the
                   ///< diagnostic
    bool initialized = false, shut_down = false, ended = false;
};

LanguageServer::LanguageServer(std::function<void(const std::string&)> send)
    : state_(std::make_unique<State>(std::move(send))) {}
LanguageServer::~LanguageServer() = default;

void LanguageServer::take(const std::string& message) {
    json::error_code error;
    const json::value parsed = json::parse(message, error);
    if (error)
        state_->answer_error(nullptr, ErrorCode::parse_error, "the message is not JSON: " + error.message());
    else if (!parsed.is_object())
        state_->answer_error(nullptr, ErrorCode::invalid_request, "a message must be an object");
    else
        state_->take(parsed.as_object());
}

void LanguageServer::refuse(const std::string& why) { state_->answer_error(nullptr, ErrorCode::parse_error, why); }

void LanguageServer::publish() {
    const ReadsFromMemory reads(state_->documents.texts());
    for (const std::string& each : std::exchange(state_->to_check, {}))
        state_->publish(each);
}

bool LanguageServer::has_ended() const { return state_->ended; }
bool LanguageServer::was_shut_down() const { return state_->shut_down; }

bool serve_editor(std::istream& in, std::ostream& out) {
    MessageStream messages(in, out);
    LanguageServer server([&](const std::string& message) { messages.write(message); });
    while (!server.has_ended() && out) {
        try {
            const auto message = messages.read();
            if (!message)
                break;
            server.take(*message);
        } catch (const BadHeader& wrong) {
            server.refuse(wrong.what());
        }
        if (!messages.has_more())
            server.publish();
    }
    return server.was_shut_down();
}

} // namespace placedpar::editor
