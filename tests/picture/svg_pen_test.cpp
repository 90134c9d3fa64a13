#include "picture/svg_pen.hpp"

#include <doctest/doctest.h>

using namespace placedpar::picture;

namespace {

/// Returns the lines between the white background and the end of the document.
std::string drawn_by(const SvgPen& pen) {
    std::string document = pen.document({{50, 50}, 100, 100}, "");
    std::size_t start = document.find("fill=\"#ffffff\"/>\n") + 17;
    return document.substr(start, document.rfind("\n</svg>\n") - start);
}

} // namespace

TEST_CASE("a document begins with its size and its title, and is closed") {
    std::string document = SvgPen().document({{50, 20}, 120, 60}, ".box { fill: none; }\n", "<marker/>", "a < b");
    CHECK(document.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-10 -10 120 60\" width=\"120\" "
                               "height=\"60\">\n<title>a &lt; b</title><style>\n"));
    CHECK(document.find("\n.box { fill: none; }\n</style>\n<marker/><rect ") != std::string::npos);
    CHECK(document.ends_with("</svg>\n"));
    CHECK(SvgPen().document({}, "").find("<title>") == std::string::npos);
}

TEST_CASE("each element has its own line, in painting order") {
    SvgPen pen;
    pen.rect({{10, 20}, 4, 6}, {{"class", "box"}}).ellipse({1, 2}, 3, 4).circle({5, 6}, 7);
    pen.line({0, 1}, {2, 3}).path(svg_corners({{0, 0}, {8, 0}, {8, 9}}));
    CHECK(drawn_by(pen) == R"(<rect x="8" y="17" width="4" height="6" class="box"/>
<ellipse cx="1" cy="2" rx="3" ry="4"/>
<circle cx="5" cy="6" r="7"/>
<line x1="0" y1="1" x2="2" y2="3"/>
<path d="M0 0 L8 0 L8 9"/>)");
}

TEST_CASE("lengths are rounded to a tenth of a pixel, without negative zero") {
    CHECK(svg_number(1.25001) == "1.3");
    CHECK(svg_number(2.04) == "2");
    CHECK(svg_number(-0.04) == "0");
    CHECK(svg_point({-1.26, 300}) == "-1.3 300");
}

TEST_CASE("texts, values and tooltips are escaped, and an attribute without a value is left out") {
    CHECK(drawn_by(SvgPen().text({1, 2}, "note", "<g> & co")) ==
          R"(<text class="note" x="1" y="2">&lt;g&gt; &amp; co</text>)");
    CHECK(drawn_by(SvgPen().circle({0, 0}, 1, {{"data-node", "say \"a\""}, {"rx", ""}})) ==
          R"(<circle cx="0" cy="0" r="1" data-node="say &quot;a&quot;"/>)");
    CHECK(drawn_by(SvgPen().path("M0 0", {}, "a > b\nc\td")) == "<path d=\"M0 0\"><title>a &gt; b\nc?d</title></path>");
}

TEST_CASE("a group encloses its contents and inner groups") {
    SvgPen inner, outer;
    inner.text({1, 2}, "name", "p");
    outer.circle({0, 0}, 1).group({{"class", "inner"}}, inner, "about p");
    CHECK(drawn_by(SvgPen().group({{"class", "outer"}}, outer).add(inner)) ==
          R"(<g class="outer"><circle cx="0" cy="0" r="1"/><g class="inner"><title>about p</title>)"
          R"(<text class="name" x="1" y="2">p</text></g></g>)"
          "\n"
          R"(<text class="name" x="1" y="2">p</text>)");
}
