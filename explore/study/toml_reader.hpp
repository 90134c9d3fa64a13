#pragma once

// Without this macro, a program that uses Debian's package must link a library.
#define TOML_HEADER_ONLY 1
// With assertions off, the parser tells the compiler to assume the asserted conditions, and the text "[(set]" violates
// such a condition. With this macro, which neither asserts nor assumes, the parser reports the error in such a text.
#define TOML_ASSERT(condition) static_cast<void>(0)
#pragma push_macro("NDEBUG")
#undef NDEBUG
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

#include "text/load_source.hpp"
#include "text/nearest.hpp"
#include "text/paint.hpp"
#include "text/refused_text.hpp"
#include "text/reporter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace placedpar {

/// Reads a file of TOML. Reports all errors, not only the first. A value with an error is read as some meaningless
/// value, so call refuse_if_failed() before using any value.
class TomlReader {
protected:
    /// `kind`: what messages call the file. Throws RefusedInput if the text cannot be read.
    explicit TomlReader(const std::string& path, std::string_view kind = "study") : kind_(kind) {
        LoadedSource loaded = load_input(path);
        source_ = loaded.file;
        if (has_errors(loaded.problems))
            throw RefusedText(std::move(loaded.problems));
    }

    TomlReader(std::shared_ptr<const SourceFile> source, std::string_view kind)
        : kind_(kind), source_(std::move(source)) {}

    using Handler = std::function<void(const toml::node&)>;
    using Handlers = std::map<std::string, Handler>;
    toml::table parsed() {
        try {
            return toml::parse(source_->text(), source_->path());
        } catch (const toml::parse_error& error) {
            report(error.source().begin, described(error),
                   fmt::format("a {} is written in TOML: https://toml.io", kind_));
        }
        refuse_if_failed();
        return {};
    }

    /// Returns the error's text. If a key is given twice, names the key itself, because the parser garbles its name.
    std::string described(const toml::parse_error& error) const {
        const std::string description(error.description());
        if (description.find("redefine existing") == std::string::npos ||
            description.ends_with("as dotted key-value pair"))
            return description;
        return fmt::format("\"{}\" is given twice", key_at(error.source().begin));
    }

    /// Returns the key at a position, without quotes. The position may be in the key or in its value.
    std::string key_at(const toml::source_position& place) const {
        std::string key;
        char quote = 0;
        bool complete = false;
        std::size_t column = 0;
        for (char each : source_->line(place.line)) {
            if (const bool past = ++column >= place.column; past && complete)
                break;
            if (quote ? each == quote : each == '"' || each == '\'') {
                quote = quote ? 0 : each;
            } else if (quote == 0 && (each == ',' || each == '{')) {
                key.clear();
                complete = false;
            } else if (quote == 0 && (each == '=' || each == ']')) {
                complete = true;
            } else if (!complete && (quote || std::string_view(" \t\r[").find(each) == std::string_view::npos)) {
                key += each;
            }
        }
        return key;
    }

    /// Passes each member to its handler. Reports members without a handler.
    void read_table(const toml::table& table, const Handlers& handlers, std::string_view what = "study") {
        for (const auto& [key, node] : table) {
            std::string name(key.str());
            if (auto found = handlers.find(name); found != handlers.end())
                found->second(node);
            else
                report(key.source().begin, fmt::format("a {} has no key \"{}\"", what, name), hint_for(name, handlers));
        }
    }

    static std::vector<std::string> names_of(const Handlers& handlers) {
        std::vector<std::string> names;
        for (const auto& each : handlers)
            names.push_back(each.first);
        return names;
    }

    std::string hint_for(const std::string& name, const Handlers& handlers) const {
        const std::vector<std::string> names = names_of(handlers);
        if (std::string meant = did_you_mean(name, names); !meant.empty())
            return meant;
        return kind_ == "study" ? "write settings of the netlist below [set]"
                                : fmt::format("its keys are {}", fmt::join(names, ", "));
    }

    std::vector<const toml::table*> tables_in(const toml::node& node, const char* what, const char* form) {
        std::vector<const toml::table*> tables;
        if (const toml::array* array = node.as_array(); array && array->is_homogeneous(toml::node_type::table))
            for (const toml::node& each : *array)
                tables.push_back(each.as_table());
        else
            report(node.source().begin, what, form);
        return tables;
    }

    /// Returns the value as text for --set.
    std::string value_text(const toml::node& node) {
        if (const auto* text = node.as_string())
            return text->get();
        if (const auto* integer = node.as_integer())
            return fmt::format("{}", integer->get());
        if (const auto* real = node.as_floating_point())
            return fmt::format("{}", real->get());
        if (const auto* truth = node.as_boolean())
            return truth->get() ? "1" : "0";
        report(node.source().begin, "expected a number or a text", "[1, 2, 5], [\"5M\", \"10M\"] or \"0..7\"");
        return "0";
    }

    std::vector<std::string> texts(const toml::node& node) {
        std::vector<std::string> found;
        if (const toml::array* array = node.as_array())
            for (const toml::node& each : *array)
                found.push_back(text(each));
        else
            found.push_back(text(node));
        return found;
    }

    std::string text(const toml::node& node) {
        if (const auto* text = node.as_string(); text && !text->get().empty())
            return text->get();
        report(node.source().begin, "expected a text in quotes");
        return "?";
    }

    bool truth(const toml::node& node) {
        if (!node.is_boolean())
            report(node.source().begin, "expected true or false");
        return node.value_or(false);
    }

    /// Returns a table of numbers from 0 to 1e12. `example` is the error's hint if the node is not such a table.
    std::map<std::string, double> numbers(const toml::node& node, const char* example) {
        std::map<std::string, double> all;
        const toml::table* table = node.as_table();
        if (!table) {
            report(node.source().begin, "expected a table of numbers", example);
            return all;
        }
        for (const auto& [key, value] : *table) // a copy of the table would have no positions
            if (const auto number = value.value<double>(); number && *number >= 0 && *number <= 1e12)
                all[std::string(key.str())] = *number;
            else
                report(value.source().begin, fmt::format("\"{}\" is not a number from 0 to 1e12", key.str()), example);
        return all;
    }

    std::uint64_t whole(const toml::node& node, std::int64_t least,
                        std::uint64_t most = std::numeric_limits<std::uint64_t>::max()) {
        std::int64_t number = node.value_exact<std::int64_t>().value_or(least - 1);
        auto found = static_cast<std::uint64_t>(std::max(number, least));
        if (number < least)
            report(node.source().begin, fmt::format("expected a whole number of at least {}", least));
        else if (found > most)
            report(node.source().begin, fmt::format("expected a whole number of at most {}", most));
        return std::min(found, most);
    }

    template <class Work>
    void attempt_at(const toml::node& node, Work work) {
        try {
            work();
        } catch (const RefusedInput& refused) {
            std::string said = unpainted(refused.what());
            report(node.source().begin, "the text cannot be read: " + said.substr(0, said.find('\n')));
        } catch (const UserError& refused) {
            report(node.source().begin, refused.what());
        }
    }

    void report(const toml::source_position& at, std::string message, std::string hint = "") {
        if (reported_.emplace(at.line, at.column, message).second)
            reporter_.error({source_, at.line, at.column}, std::move(message), std::move(hint));
    }

    void refuse_if_failed() {
        if (reporter_.failed())
            throw RefusedText(reporter_.take());
    }

private:
    std::string kind_;
    std::shared_ptr<const SourceFile> source_;
    Reporter reporter_;
    /// Errors reported so far, so that each error is reported only once.
    std::set<std::tuple<toml::source_index, toml::source_index, std::string>> reported_;
};

} // namespace placedpar
