#include "explore/stated_vals.hpp"

#include "netlist/language/names_in_text.hpp"
#include "netlist/network/network.hpp"
#include "text/load_source.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

namespace placedpar {

namespace {

using Vals = std::map<std::string, std::string>;

/// Returns a text's part from one token to another, on one line or several.
std::string text_between(const SourceFile& file, const Token& first, const Token& last) {
    const char* const begin = file.line(first.at.line).data() + (first.at.column - 1);
    return {begin, file.line(last.end.line).data() + (last.end.column - 1)};
}

/// Adds the constants (`val`) of a file that are outside of blocks; options cannot set other constants.
void add_vals(Vals& vals, const std::string& path) {
    const std::shared_ptr<const SourceFile> file = load_shown_input(path).file;
    const std::vector<Token> tokens = tokens_of(file);
    std::size_t depth = 0;
    for (auto token = tokens.begin(); token != tokens.end(); ++token) {
        depth += token->is("{") ? 1U : 0U;
        depth -= token->is("}") && depth > 0 ? 1U : 0U;
        if (depth > 0 || !token->is_word("val"))
            continue;
        const auto end = std::find_if(token, tokens.end(), [](const Token& each) { return each.is(";"); });
        if (end != tokens.end() && end - token > 2)
            vals[(token + 1)->text] = text_between(*file, *(token + 2), *(end - 1));
    }
}

} // namespace

Vals stated_vals(const Network& network) {
    Vals vals;
    for (const std::string& path : network.included_paths)
        add_vals(vals, path);
    add_vals(vals, network.source_path);
    for (const SetByOption& set : network.set)
        if (auto stated = vals.find(set.name); stated != vals.end() && set.elements.empty())
            stated->second = set.value;
    return vals;
}

} // namespace placedpar
