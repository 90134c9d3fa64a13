#include "monitor/protocol/field_reader.hpp"

#include <boost/json/basic_parser_impl.hpp>

#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

namespace placedpar::monitor {

namespace {

namespace json = boost::json;

/// A handler of boost::json::basic_parser that looks at keys only.
class Keys {
public:
    static constexpr std::size_t max_object_size = SIZE_MAX, max_array_size = SIZE_MAX, max_key_size = SIZE_MAX,
                                 max_string_size = SIZE_MAX;
    using Error = json::error_code;
    using Text = json::string_view;

    std::string repeated; ///< its path

    bool on_object_begin(Error&) {
        objects_.emplace_back();
        return true;
    }
    bool on_object_end(std::size_t, Error&) {
        objects_.pop_back();
        return true;
    }
    bool on_key_part(Text part, std::size_t, Error&) {
        key_.append(part.data(), part.size());
        return true;
    }
    bool on_key(Text rest, std::size_t, Error& error) {
        key_.append(rest.data(), rest.size());
        objects_.back().current = std::exchange(key_, {});
        if (objects_.back().seen.insert(objects_.back().current).second)
            return true;
        for (const Object& object : objects_)
            repeated += (repeated.empty() ? "" : ".") + object.current;
        error = json::error::extra_data;
        return false;
    }

    bool on_document_begin(Error&) { return true; }
    bool on_document_end(Error&) { return true; }
    bool on_array_begin(Error&) { return true; }
    bool on_array_end(std::size_t, Error&) { return true; }
    bool on_string_part(Text, std::size_t, Error&) { return true; }
    bool on_string(Text, std::size_t, Error&) { return true; }
    bool on_number_part(Text, Error&) { return true; }
    bool on_int64(std::int64_t, Text, Error&) { return true; }
    bool on_uint64(std::uint64_t, Text, Error&) { return true; }
    bool on_double(double, Text, Error&) { return true; }
    bool on_bool(bool, Error&) { return true; }
    bool on_null(Error&) { return true; }
    bool on_comment_part(Text, Error&) { return true; }
    bool on_comment(Text, Error&) { return true; }

private:
    struct Object {
        std::string current;
        std::set<std::string> seen;
    };

    std::vector<Object> objects_; ///< the outermost first
    std::string key_;             ///< its parts so far
};

} // namespace

std::optional<std::string> repeated_field(std::string_view text) {
    json::basic_parser<Keys> parser{json::parse_options()};
    json::error_code error;
    parser.write_some(false, text.data(), text.size(), error);
    if (!error)
        return std::nullopt;
    return parser.handler().repeated;
}

} // namespace placedpar::monitor
