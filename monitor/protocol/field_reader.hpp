#pragma once

#include <boost/json/fwd.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace placedpar::monitor {

/// The range of a number, both ends included.
struct Range {
    double least, greatest;
    const char* unit; ///< may be ""
};

/// Reads the fields of a JSON object in a client's message, and remembers which names the caller requested. finish()
/// refuses any other field, because its name is most likely misspelt. Every function throws BadMessage, which names the
/// field by its path.
class FieldReader {
public:
    FieldReader(const boost::json::object& object, std::string path) : object_(object), path_(std::move(path)) {}

    bool has(std::string_view name);
    double number(std::string_view name, const Range& range);
    double number_or(std::string_view name, const Range& range, double otherwise);
    std::string text(std::string_view name);
    std::string text_or(std::string_view name, std::string otherwise);
    bool flag_or(std::string_view name, bool otherwise);
    const boost::json::array& array(std::string_view name);
    /// Returns a reader of the object in this field.
    FieldReader object(std::string_view name);

    /// Returns the names of all fields, in the order of the message.
    std::vector<std::string> names() const;
    /// Throws if the object has a field that no call has requested.
    void finish() const;
    std::string path_of(std::string_view name) const;

private:
    const boost::json::value& require(std::string_view name, const char* right);

    const boost::json::object& object_;
    std::string path_;
    std::vector<std::string> asked_;
};

} // namespace placedpar::monitor
