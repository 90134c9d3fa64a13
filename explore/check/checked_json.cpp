#include "explore/check/check_file.hpp"

#include <boost/json.hpp>

namespace placedpar {

namespace {

namespace json = boost::json;

json::object place_json(const Location& at, NamesOf names) {
    json::object place;
    if (at.file)
        place["file"] = at.file->path();
    if (at.line == 0)
        return place;
    const Location end = end_of_word(at, names);
    place["line"] = at.line;
    place["column"] = at.column;
    place["end_line"] = end.line;
    place["end_column"] = end.column;
    return place;
}

} // namespace

json::object diagnostic_json(const Diagnostic& diagnostic, NamesOf names) {
    json::object object{{"severity", diagnostic.severity == Severity::error ? "error" : "warning"}};
    for (auto& [key, value] : place_json(diagnostic.location, names))
        object[key] = value;
    object["message"] = diagnostic.message;
    object["hint"] = diagnostic.hint;
    json::array also;
    for (const SecondPlace& other : diagnostic.others) {
        json::object place = place_json(other.location, names);
        place["message"] = other.message;
        also.push_back(std::move(place));
    }
    object["also"] = std::move(also);
    return object;
}

json::object checked_json(const std::filesystem::path& path, const CheckedFile& checked) {
    json::array diagnostics;
    for (const Diagnostic& each : checked.diagnostics)
        diagnostics.push_back(diagnostic_json(each, checked.names));
    return {{"file", path.string()},
            {"language", checked.language},
            {"valid", !checked.failed()},
            {"summary", checked.summary.substr(0, checked.summary.find('\n'))},
            {"diagnostics", std::move(diagnostics)},
            {"not_shown", checked.not_shown.substr(0, checked.not_shown.find('\n'))}};
}

} // namespace placedpar
