#include "monitor/protocol/message_json.hpp"

#include "monitor/protocol/bad_message.hpp"

#include <boost/json.hpp>
#include <boost/json/basic_parser_impl.hpp>
#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace placedpar::monitor {

namespace {

namespace json = boost::json;

constexpr const char *beyond_numbers = "it is beyond the range of numbers",
                     *within_numbers = "a number from -1.7e308 to 1.7e308";

/// A handler of boost::json::basic_parser that builds the value as boost::json::parser does, and also checks the keys.
/// boost::json::parser itself would silently keep the last of two equal keys.
class Builder {
public:
    static constexpr std::size_t max_object_size = SIZE_MAX, max_array_size = SIZE_MAX, max_key_size = SIZE_MAX,
                                 max_string_size = SIZE_MAX;
    using Error = json::error_code;
    using Text = json::string_view;

    Builder() { stack_.reset(); }

    std::optional<BadMessage> wrong; ///< the first error in a line that can be parsed
    json::value release() { return stack_.release(); }

    bool on_object_begin(Error&) {
        objects_.emplace_back();
        return true;
    }
    bool on_object_end(std::size_t fields, Error&) {
        objects_.pop_back();
        stack_.push_object(fields);
        return true;
    }
    bool on_key_part(Text part, std::size_t, Error&) {
        key_.append(part.data(), part.size());
        stack_.push_chars(part);
        return true;
    }
    bool on_key(Text rest, std::size_t, Error&) {
        key_.append(rest.data(), rest.size());
        stack_.push_key(rest);
        objects_.back().current = std::exchange(key_, {});
        if (!objects_.back().seen.insert(objects_.back().current).second && !wrong)
            wrong.emplace(path(), "it is given twice", "each field once");
        return true;
    }

    bool on_document_begin(Error&) { return true; }
    bool on_document_end(Error&) { return true; }
    bool on_array_begin(Error&) { return true; }
    bool on_array_end(std::size_t values, Error&) {
        stack_.push_array(values);
        return true;
    }
    bool on_string_part(Text part, std::size_t, Error&) {
        stack_.push_chars(part);
        return true;
    }
    bool on_string(Text rest, std::size_t, Error&) {
        stack_.push_string(rest);
        return true;
    }
    bool on_number_part(Text, Error&) { return true; }
    bool on_int64(std::int64_t number, Text, Error&) {
        stack_.push_int64(number);
        return true;
    }
    bool on_uint64(std::uint64_t number, Text, Error&) {
        stack_.push_uint64(number);
        return true;
    }
    bool on_double(double number, Text, Error&) {
        if (!std::isfinite(number) && !wrong)
            wrong.emplace(path(), beyond_numbers, within_numbers);
        stack_.push_double(number);
        return true;
    }
    bool on_bool(bool flag, Error&) {
        stack_.push_bool(flag);
        return true;
    }
    bool on_null(Error&) {
        stack_.push_null();
        return true;
    }
    bool on_comment_part(Text, Error&) { return true; }
    bool on_comment(Text, Error&) { return true; }

    /// Returns the path of the present field, such as "links.BO.inlet_psi".
    std::string path() const {
        std::string path;
        for (const Object& object : objects_)
            path += (path.empty() ? "" : ".") + object.current;
        return path;
    }

private:
    struct Object {
        std::string current;
        std::set<std::string> seen;
    };

    json::value_stack stack_;
    std::vector<Object> objects_; ///< the outermost first
    std::string key_;             ///< the parts of the key so far
};

/// Limits the depth of objects; every message is two or three deep.
constexpr std::size_t deepest = 8;

} // namespace

json::value read_message_json(std::string_view line) {
    json::parse_options options;
    options.max_depth = deepest;
    json::basic_parser<Builder> parser(options);
    json::error_code error;
    std::size_t column = parser.write_some(true, line.data(), line.size(), error) + 1;
    if (!error && column <= line.size())
        error = json::error::extra_data;
    if (!error) {
        parser.write_some(false, nullptr, 0, error);
        column = line.size() + 1;
    }
    if (error == json::error::exponent_overflow)
        throw BadMessage(parser.handler().path(), beyond_numbers, within_numbers, column);
    if (error)
        throw BadMessage("", fmt::format("it is not JSON: {}", error.message()), "one JSON object in one line", column);
    json::value value = parser.handler().release();
    if (!value.is_object())
        throw BadMessage("", "it is not a JSON object",
                         "such as {\"type\":\"hello\",\"version\":1,\"machine\":\"name\"}", 1);
    if (parser.handler().wrong)
        throw *parser.handler().wrong;
    return value;
}

} // namespace placedpar::monitor
