// Reads the drawings with the XML parser expat: each is well-formed whatever names the user gives, and each reference
// in a drawing has its target there.

#include "picture/hypercube.hpp"
#include "picture/plot.hpp"
#include "picture/plot_over_dates.hpp"
#include "picture/svg.hpp"
#include "tests/picture/networks.hpp"

#include <doctest/doctest.h>

#include <expat.h>

#include <cstring>
#include <memory>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

using namespace placedpar;

namespace {

/// What expat finds in a drawing.
struct ReadDrawing {
    std::string error;                     ///< "" if the drawing is well-formed
    std::string first;                     ///< name of the outermost element
    std::string texts;                     ///< all texts, one after the other
    std::multiset<std::string> names;      ///< values of the attribute id
    std::set<std::string> references = {}; ///< names to which the drawing refers

    void take(const char* element, const char** attributes) {
        first = first.empty() ? element : first;
        for (; *attributes; attributes += 2) {
            const std::string name = attributes[0], value = attributes[1];
            if (name == "id")
                names.insert(value);
            if (name == "xlink:href" && value.starts_with('#'))
                references.insert(value.substr(1));
            if (value.starts_with("url(#"))
                references.insert(value.substr(5, value.find(')') - 5));
        }
    }
};

ReadDrawing drawing_in(const std::string& svg) {
    ReadDrawing read;
    const std::unique_ptr<std::remove_pointer_t<XML_Parser>, void (*)(XML_Parser)> parser(XML_ParserCreate(nullptr),
                                                                                          XML_ParserFree);
    XML_SetUserData(parser.get(), &read);
    XML_SetStartElementHandler(parser.get(), [](void* data, const char* name, const char** attributes) {
        static_cast<ReadDrawing*>(data)->take(name, attributes);
    });
    XML_SetCharacterDataHandler(parser.get(), [](void* data, const char* text, int bytes) {
        static_cast<ReadDrawing*>(data)->texts.append(text, static_cast<std::size_t>(bytes));
    });
    if (XML_Parse(parser.get(), svg.data(), static_cast<int>(svg.size()), XML_TRUE) != XML_STATUS_OK)
        read.error = XML_ErrorString(XML_GetErrorCode(parser.get()));
    return read;
}

void check_drawing(const std::string& svg) {
    const ReadDrawing read = drawing_in(svg);
    CHECK(read.error == "");
    CHECK(read.first == "svg");
    for (const std::string& name : read.names)
        CHECK_MESSAGE(read.names.count(name) == 1, name);
    for (const std::string& name : read.references)
        CHECK_MESSAGE(read.names.contains(name), name);
}

/// Returns names that could break XML, gnuplot's commands or UTF-8.
std::vector<std::string> odd_names() {
    return {"<b>&amp;</b>",
            "]]>",
            "<!-- --",
            "a \"b\" 'c'",
            "\xE9",
            "\xC3",
            "\x01\x1b[0m",
            "a\tb",
            "\xEF\xBF\xBF",
            "$HOME `date` {/Bold x} ^2_3 @ %s \\n",
            "",
            " ",
            std::string(300, '<')};
}

Plot plot_named(const std::string& name) {
    Panel panel{name, {.label = name}, {.label = name}, {{name, {{0, 1}, {1, 2}}}}, {{name, 1.5}}, {}};
    panel.bands = {{name, {{0, 0.5, 1.5}, {1, 1, 2}}, 2}};
    return {name, {panel, panel}};
}

} // namespace

TEST_CASE("networks of every shape are drawn as well-formed XML, with all targets of references") {
    for (const std::string& text :
         {std::string("T800 alone;"), picture::chain(3) + picture::stream("t[0]", "t[2]"), picture::torus(3, 4),
          picture::cube(3), picture::random_wiring(9, 1), picture::chain(250),
          picture::chain(2) + "fault t[0].link[1] silent (from = 1ms);"}) {
        CAPTURE(text);
        const Network network = picture::network_of(text);
        check_drawing(print_svg(network));
        check_drawing(print_software_svg(network));
    }
}

TEST_CASE("the names of programs and of the netlist's file cannot break a drawing of a network") {
    for (const std::string& name : odd_names()) {
        if (name.find_first_of("\"\\\x01\x1b") != std::string::npos || name.empty())
            continue; // the language does not accept such a program's name
        CAPTURE(name);
        Network network = picture::network_of("T800 t; process p; use \"" + name + ".lku\" for p; place p on t;");
        network.source_path = "folder/" + name;
        check_drawing(print_svg(network));
        check_drawing(print_software_svg(network));
    }
}

TEST_CASE("titles and names of curves cannot break a plot") {
    for (const std::string& name : odd_names()) {
        CAPTURE(name);
        check_drawing(draw_svg(plot_named(name)));
    }
}

TEST_CASE("texts beside a hypercube cannot break its drawing, and are read back as they were given") {
    for (const std::string& name : odd_names()) {
        CAPTURE(name);
        check_drawing(draw_hypercubes(name,
                                      {{.title = name, .vertices = {{3, VertexLook::parent, name}}, .lines = {name}}},
                                      1, {{VertexLook::member, name}}));
    }
    const std::string svg = draw_hypercubes("a < b & \"c\"", {{.title = "Zoë's"}}, 1, {});
    CHECK(drawing_in(svg).texts.find("a < b & \"c\"") != std::string::npos);
    CHECK(drawing_in(svg).texts.find("Zoë's") != std::string::npos);
}

TEST_CASE("an axis of dates shows the dates of its seconds since 1970") {
    const double day = 86400, first_of_may_2024 = 1714521600; // `date -d 2024-05-01 +%s` in UTC
    Plot plot{"", {{"", {.from = first_of_may_2024, .to = first_of_may_2024 + 4 * day}, {}, {}}}};
    plot.panels[0].series = {{"", {{first_of_may_2024, 1}, {first_of_may_2024 + 4 * day, 2}}}};
    const std::string svg = draw_svg_over_dates(plot);
    check_drawing(svg);
    const std::string texts = drawing_in(svg).texts;
    CHECK(texts.find("2024") != std::string::npos);
    CHECK(texts.find("1714") == std::string::npos);
    CHECK(drawing_in(draw_svg(plot)).texts.find("1.714") != std::string::npos);
}
