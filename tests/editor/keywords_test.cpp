#include "netlist/language/parser.hpp"
#include "occam/language/words.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <string_view>

namespace placedpar {

namespace {

using Words = std::set<std::string, std::less<>>;

std::string text_of(const std::string& file) {
    std::ifstream in(std::string(PLACEDPAR_SOURCE_DIR) + "/" + file);
    REQUIRE(in);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Returns the words within all matches of a pattern, whose first group has them.
Words words_in(const std::string& text, const char* pattern) {
    const std::regex list(pattern), word("\\w+");
    Words found;
    for (std::sregex_iterator each(text.begin(), text.end(), list), end; each != end; ++each) {
        const std::string group = (*each)[1];
        for (std::sregex_iterator inner(group.begin(), group.end(), word); inner != end; ++inner)
            found.insert(inner->str());
    }
    return found;
}

template <class... Lists>
Words all_of(const Lists&... lists) {
    Words words;
    (words.insert(lists.begin(), lists.end()), ...);
    return words;
}

const char* const in_grammar =
    R"re("match": "[^"]*\(\?:([\w|]+)\)[^"]*",\s*"name": "(?:keyword.control|keyword.operator.word|storage|constant.language))re";
const char* const in_vim = R"re(syntax keyword \w+(?:Keyword|Operator|Type|Constant) ([^\n]*))re";
const char* const in_site = R"re(\\b\(([a-z|]+)\)\\b", Keyword)re";
const char* const in_emacs = R"re(\(defconst placedpar-[a-z-]+\s+'\(([^)]*)\))re";

} // namespace

TEST_CASE("editors' lists of occam's keywords are those of the scanner") {
    const Words keywords = all_of(occam::all_keywords());
    REQUIRE(keywords.size() > 50);
    CHECK(words_in(text_of("editors/vscode/syntaxes/occam.tmLanguage.json"), in_grammar) == keywords);
    CHECK(words_in(text_of("editors/vim/syntax/occam.vim"), in_vim) == keywords);
}

TEST_CASE("editors' lists of the netlist's words are those of the parser") {
    const Words constants{"TRUE", "FALSE", "HIGH", "LOW", "true", "false", "high", "low"};
    const Words words = all_of(reserved_words(), parameter_types());
    CHECK(words_in(text_of("editors/vscode/syntaxes/netlist.tmLanguage.json"), in_grammar) == all_of(words, constants));
    CHECK(words_in(text_of("editors/vim/syntax/netlist.vim"), in_vim) == all_of(words, constants));
    CHECK(words_in(text_of("tools/site/languages.py"), in_site) == all_of(reserved_words()));
    CHECK(words_in(text_of("editors/emacs/placedpar.el"), in_emacs) == all_of(words, occam::all_keywords()));
}

} // namespace placedpar
