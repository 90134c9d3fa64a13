#pragma once

#include "identification/on_line/population_sets.hpp"
#include "monitor/memory/described.hpp"
#include "monitor/memory/exact_text.hpp"
#include "monitor/protocol/link_words.hpp"

#include <boost/json.hpp>

#include <concepts>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

namespace placedpar::monitor {

/// Reports an error in a value read from the state file, and the path of the wrong member, such as
/// "tracks.2.sums.readings".
struct NotWhole : std::runtime_error {
    NotWhole(std::string where, const std::string& what) : std::runtime_error(what), path(std::move(where)) {}
    std::string path;
};

/// Returns the number of doubles in a T if T consists of a fixed number of doubles and nothing else; otherwise 0.
template <typename T>
constexpr std::size_t doubles_in() {
    if constexpr (std::same_as<T, double>)
        return 1;
    else if constexpr (boost::describe::has_describe_members<T>::value) {
        std::size_t count = 0;
        bool only = true;
        boost::mp11::mp_for_each<MembersOf<T>>([&](auto member) {
            std::size_t more = doubles_in<std::remove_cvref_t<decltype(std::declval<T&>().*member.pointer)>>();
            count += more;
            only &= more > 0;
        });
        return only ? count : 0;
    } else if constexpr (requires { std::tuple_size<T>::value; })
        return std::tuple_size_v<T> * doubles_in<typename T::value_type>();
    else
        return 0;
}

template <typename T, typename Use>
void for_each_double(T& value, Use& use) {
    if constexpr (std::same_as<std::remove_const_t<T>, double>)
        use(value);
    else if constexpr (requires { value.data(); })
        for (auto* each = value.data(); each != value.data() + value.size(); ++each)
            for_each_double(*each, use);
    else
        for_each_member(value, [&](const std::string&, auto& member) { for_each_double(member, use); });
}

/// Whether a member of type T may be missing in a file, because earlier versions of the program did not write it.
template <typename T>
inline constexpr bool may_be_missing = false;

/// Converts the state of a diagnosis to JSON for the state file, and back to the same bits. Boost.Describe gives the
/// members of each struct. A struct becomes an object with a field for each member. A class with a function `state()`
/// is stored as the result of this function. A value or a list of doubles only becomes one text, because a JSON parser
/// may change a double's last bit (exact_text.hpp).
struct KeptJson {
    template <typename T>
    static boost::json::value write(const T& value) {
        if constexpr (std::integral<T> || std::same_as<T, std::string>)
            return boost::json::value(value);
        else if constexpr (doubles_in<T>() > 0)
            return write_doubles(value);
        else if constexpr (std::same_as<T, hydraulics::LinkSet>)
            return boost::json::string(words_of(value));
        else if constexpr (boost::describe::has_describe_enumerators<T>::value)
            return boost::json::string(boost::describe::enum_to_string(value, ""));
        else if constexpr (requires { T(value.state()); })
            return write(value.state());
        else if constexpr (requires { value[0]; })
            return write_list(value);
        else
            return write_members(value);
    }
    template <typename T>
    static boost::json::value write(const std::optional<T>& value) {
        return value ? write(*value) : boost::json::value(nullptr);
    }
    static boost::json::value write(const std::vector<Genome>& strings) {
        return boost::json::string(exact_text(strings));
    }
    template <typename T>
    static boost::json::value write(const std::map<hydraulics::LinkSet, T>& values) {
        boost::json::object object;
        for (const auto& [links, value] : values)
            object[identification::name_of_set(links)] = write(value);
        return object;
    }

    /// Reads the value back from JSON. If a member is wrong, throws a NotWhole that names the member. If the value as a
    /// whole is wrong, throws another exception.
    template <typename T>
    static void read(T& value, const boost::json::value& json) {
        if constexpr (std::same_as<T, bool>)
            value = json.as_bool();
        else if constexpr (std::integral<T>)
            value = json.to_number<T>();
        else if constexpr (std::same_as<T, std::string>)
            value = text_in(json);
        else if constexpr (doubles_in<T>() > 0)
            read_doubles(value, numbers_from(text_in(json)), doubles_in<T>());
        else if constexpr (std::same_as<T, hydraulics::LinkSet>)
            value = links_in(text_in(json));
        else if constexpr (boost::describe::has_describe_enumerators<T>::value) {
            if (!boost::describe::enum_from_string(text_in(json).c_str(), value))
                throw_no_name(text_in(json));
        } else if constexpr (requires { T(value.state()); }) {
            auto state = value.state();
            read(state, json);
            value = T(std::move(state));
        } else if constexpr (requires { value[0]; })
            read_list(value, json);
        else
            read_members(value, json.as_object());
    }
    template <typename T>
    static void read(std::optional<T>& value, const boost::json::value& json) {
        value.reset();
        if (!json.is_null())
            read(value.emplace(), json);
    }
    static void read(std::vector<Genome>& strings, const boost::json::value& json) {
        strings = genomes_from(text_in(json));
    }
    template <typename T>
    static void read(std::map<hydraulics::LinkSet, T>& values, const boost::json::value& json) {
        for (const auto& field : json.as_object())
            at_member(std::string(field.key()), [&] {
                auto links = identification::set_named(field.key());
                if (!links)
                    throw std::runtime_error("this is not a set of links, expected P1a to P4");
                read(values[*links], field.value());
            });
    }

private:
    static std::string text_in(const boost::json::value& json) { return std::string(json.as_string()); }
    /// Calls read(), and adds `name` to the path in any exception from it.
    template <typename Read>
    static void at_member(const std::string& name, Read read) {
        try {
            read();
        } catch (const NotWhole& inner) {
            throw NotWhole(name + "." + inner.path, inner.what());
        } catch (const std::exception& error) {
            throw NotWhole(name, error.what());
        }
    }
    template <typename T>
    static boost::json::value write_doubles(const T& value) {
        std::vector<double> numbers;
        auto add = [&](double each) { numbers.push_back(each); };
        for_each_double(value, add);
        return boost::json::string(exact_text(numbers));
    }
    template <typename T>
    static void read_doubles(T& value, const std::vector<double>& numbers, std::size_t expected) {
        require_count(numbers.size(), "numbers", expected);
        auto take = [next = numbers.begin()](double& each) mutable { each = *next++; };
        for_each_double(value, take);
    }
    template <typename List>
    static boost::json::value write_list(const List& values) {
        if constexpr (doubles_in<typename List::value_type>() > 0)
            return write_doubles(values);
        boost::json::array array;
        for (const auto& each : values)
            array.push_back(write(each));
        return array;
    }
    template <typename List>
    static void read_list(List& values, const boost::json::value& json) {
        if constexpr (constexpr std::size_t size = doubles_in<typename List::value_type>(); size > 0) {
            const std::vector<double> numbers = numbers_from(text_in(json));
            values.resize(numbers.size() / size);
            read_doubles(values, numbers, values.size() * size);
        } else {
            const boost::json::array& array = json.as_array();
            if constexpr (requires { values.resize(1); })
                values.resize(array.size());
            require_count(array.size(), "values", values.size());
            for (std::size_t i = 0; i < values.size(); ++i)
                at_member(std::to_string(i), [&] { read(values[i], array[i]); });
        }
    }
    template <typename T>
    static boost::json::value write_members(const T& object) {
        boost::json::object json;
        for_each_member(object, [&](const std::string& name, const auto& member) { json[name] = write(member); });
        return json;
    }
    template <typename T>
    static void read_members(T& object, const boost::json::object& json) {
        std::size_t count = 0;
        for_each_member(object, [&](const std::string& name, auto& member) {
            const boost::json::value* field = json.if_contains(name);
            count += field != nullptr;
            at_member(name, [&] { field ? read(member, *field) : leave_out(member); });
        });
        require_count(json.size(), "members", count);
    }
    template <typename T>
    static void leave_out(T& member) {
        if constexpr (may_be_missing<T>)
            member = {};
        else
            throw std::runtime_error("it is missing");
    }
    static hydraulics::LinkSet links_in(std::string_view words);
    /// Throws unless `found` equals `expected`; `what` names the things counted.
    static void require_count(std::size_t found, const char* what, std::size_t expected);
    [[noreturn]] static void throw_no_name(const std::string& text);
};

} // namespace placedpar::monitor
