// Tests the reader of XML: what it passes on, and which texts it refuses.

#include "explore/generate/xml.hpp"

#include "explore/generate/graph.hpp"
#include "text/refused_text.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace placedpar;
using namespace placedpar::generate;

namespace {

/// Writes down what it receives. Successive pieces of text become one.
class WrittenParts final : public XmlParts {
public:
    void begin(const XmlTag& tag) override {
        std::string line = fmt::format("{} <{}", tag.line, tag.name);
        for (const auto& [name, value] : tag.attributes)
            line += fmt::format(" {}={}", name, value);
        lines.push_back(line);
    }
    void end(const std::string& name) override { lines.push_back("/" + name); }
    void text(std::string_view piece) override {
        if (lines.empty() || !lines.back().starts_with('"'))
            lines.emplace_back("\"");
        lines.back() += piece;
    }

    std::vector<std::string> lines;
};

std::shared_ptr<const SourceFile> xml_file(const std::string& text) {
    return std::make_shared<const SourceFile>("graph.xml", text);
}

std::vector<std::string> parts_of_xml(const std::string& text) {
    WrittenParts parts;
    read_xml(xml_file(text), parts);
    return parts.lines;
}

/// Returns the only diagnostic with which the text is refused, as "line: message".
std::string xml_refusal(const std::string& text) {
    try {
        parts_of_xml(text);
    } catch (const RefusedText& refused) {
        REQUIRE(refused.diagnostics().size() == 1);
        return fmt::format("{}: {}", refused.diagnostics()[0].location.line, refused.diagnostics()[0].message);
    }
    return "";
}

std::string nested_elements(std::size_t depth) {
    std::string text;
    for (std::size_t i = 0; i < depth; ++i)
        text += "<a>";
    for (std::size_t i = 0; i < depth; ++i)
        text += "</a>";
    return text;
}

using Lines = std::vector<std::string>;

} // namespace

TEST_CASE("elements, attributes and texts come in the order of the text, tags with their lines") {
    CHECK(parts_of_xml("<a>\n<b y='2' x='1'>one</b><c/>\n</a>") ==
          Lines{"1 <a", "\"\n", "2 <b x=1 y=2", "\"one", "/b", "2 <c", "/c", "\"\n", "/a"});
}

TEST_CASE("prefixes of namespaces are left out of the names of elements and attributes") {
    CHECK(parts_of_xml("<y:Node xmlns:y='http://www.yworks.com' y:id='3'/>") ==
          Lines{"1 <Node id=3 y=http://www.yworks.com", "/Node"});
}

TEST_CASE("characters that are written as entities, by number or in CDATA are passed on as characters") {
    CHECK(parts_of_xml("<a b='&quot;&#65;'>&lt;&amp;&gt;<![CDATA[<&>]]>&#x20AC;</a>") ==
          Lines{"1 <a b=\"A", "\"<&><&>\u20ac", "/a"});
}

TEST_CASE("texts in other encodings become UTF-8") {
    CHECK(parts_of_xml("<?xml version='1.0' encoding='ISO-8859-1'?><a>\xE9</a>") == Lines{"1 <a", "\"\u00e9", "/a"});
    const std::string utf_16("\xFE\xFF\0<\0a\0/\0>", 10);
    CHECK(parts_of_xml(utf_16) == Lines{"1 <a", "/a"});
    CHECK(parts_of_xml("\xEF\xBB\xBF<a/>") == Lines{"1 <a", "/a"}); // a mark of the byte order in UTF-8
    CHECK(xml_refusal("<a>\xE9</a>").starts_with("1: this is not well-formed XML")); // no valid UTF-8
}

TEST_CASE("comments, instructions and a document type without entities are skipped") {
    CHECK(parts_of_xml("<?xml version='1.0'?><!DOCTYPE a><!-- <b/> --><a><?go on?></a>") == Lines{"1 <a", "/a"});
}

TEST_CASE("a text that is not well-formed is refused with the line of the fault") {
    CHECK(xml_refusal("").starts_with("1: this is not well-formed XML: "));
    CHECK(xml_refusal("<a>\n</b>") == "2: this is not well-formed XML: mismatched tag");
    CHECK(xml_refusal("<a x='1' x='2'/>") == "1: this is not well-formed XML: duplicate attribute");
    CHECK(xml_refusal("<a/>\n<b/>") == "2: this is not well-formed XML: junk after document element");
    CHECK(xml_refusal("<a>\n\n&b;</a>") == "3: this is not well-formed XML: undefined entity");
    for (const char* text : {"<a", "<a>", "<a b=c/>", "<a b='<'/>", "graph", "<a>&#0;</a>", "<a><![CDATA[</a>"})
        CHECK_MESSAGE(xml_refusal(text).find("this is not well-formed XML") != std::string::npos, text);
}

TEST_CASE("declared entities are refused before they can multiply") {
    const std::string laughs = "<!DOCTYPE a [\n<!ENTITY x 'ha'>\n<!ENTITY y '&x;&x;&x;&x;'>]><a>&y;</a>";
    CHECK(xml_refusal(laughs) == "2: the document type declares entities");
    CHECK(xml_refusal("<!DOCTYPE a [<!ENTITY x SYSTEM 'file:///etc/passwd'>]><a>&x;</a>") ==
          "1: the document type declares entities");
}

TEST_CASE("elements can be nested as deeply as the limit, but no deeper") {
    CHECK(parts_of_xml(nested_elements(deepest_graph)).size() == 2 * deepest_graph);
    CHECK(xml_refusal(nested_elements(deepest_graph + 1)) ==
          fmt::format("1: the elements are nested deeper than {} levels", deepest_graph));
    std::string beside; // elements beside each other do not add up
    for (std::size_t i = 0; i <= deepest_graph; ++i)
        beside += "<a/>";
    CHECK(xml_refusal("<all>" + beside + "</all>") == "");
}

TEST_CASE("an exception of the receiver ends the reading, and reaches the caller") {
    class Throwing final : public XmlParts {
    public:
        void begin(const XmlTag& tag) override {
            ++begun;
            if (tag.name == "stop")
                throw std::length_error("enough");
        }
        void end(const std::string&) override {}
        void text(std::string_view) override {}

        int begun = 0;
    };
    Throwing parts;
    CHECK_THROWS_WITH_AS(read_xml(xml_file("<a><stop/><b/><c/></a>"), parts), "enough", std::length_error);
    CHECK(parts.begun == 2);
}
