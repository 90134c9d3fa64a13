#include "picture/fault_marks.hpp"

#include "tests/picture/networks.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace picture = placedpar::picture;
using namespace placedpar;
using picture::FaultMark;

namespace {

struct Marked {
    Network network;
    picture::Picture drawn;
    std::vector<FaultMark> marks;
};

Marked marked(const std::string& text) {
    Marked result{picture::network_of(text), {}, {}};
    result.drawn = picture::draw(result.network, picture::spans_of(result.network));
    result.marks = picture::fault_marks(result.network, result.drawn);
    return result;
}

} // namespace

TEST_CASE("a network without faults has no marks") { CHECK(marked(picture::chain(3)).marks.empty()); }

TEST_CASE("the mark of a link's fault is at the link's wire") {
    const Marked found = marked(picture::chain(3) + "fault t[1].link[1] silent (from = 20ms);");
    REQUIRE(found.marks.size() == 1);
    const FaultMark& mark = found.marks.front();
    CHECK_FALSE(mark.node);
    REQUIRE(mark.wire);
    CHECK(found.network.connections[*mark.wire].a.node == 1);
    CHECK(mark.text == "silent from 20 ms");
    CHECK(mark.statement == "t[1].link[1] silent (from = 20ms)");
    const picture::Path& path = found.drawn.wires[*mark.wire].spans.front();
    const picture::Point middle = .5 * (path.front() + path.back());
    CHECK(distance(mark.box.centre, middle) < distance(mark.box.centre, found.drawn.nodes[0].box.centre));
}

TEST_CASE("the mark of a device's fault is above or below the device's box") {
    const Marked found = marked(picture::chain(3) + "fault t[2] halts (from = 1s);");
    REQUIRE(found.marks.size() == 1);
    CHECK(found.marks[0].node == 2);
    CHECK_FALSE(found.marks[0].wire);
    const picture::Box& box = found.drawn.nodes[2].box;
    CHECK(std::abs(found.marks[0].box.centre.x - box.centre.x) <= box.width / 2);
    CHECK_FALSE(overlap(found.marks[0].box, box));
}

TEST_CASE("marks lie on no box, no label and no other mark") {
    std::string text = picture::torus(3, 3);
    for (int i = 0; i < 3; ++i)
        text += fmt::format("fault t[{0}][1].link[1] slow (factor = 4); fault t[{0}][0] halts (from = {0}s);\n"
                            "fault t[{0}][1].link[1] silent (from = 5ms);\n",
                            i);
    const Marked found = marked(text);
    REQUIRE(found.marks.size() == 9);
    for (std::size_t i = 0; i < found.marks.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j)
            CHECK_FALSE(overlap(found.marks[i].box, found.marks[j].box));
        for (const picture::DrawnNode& node : found.drawn.nodes)
            CHECK_FALSE(overlap(found.marks[i].box, node.box));
        for (const picture::DrawnWire& wire : found.drawn.wires)
            for (const picture::LinkLabel& label : wire.links)
                CHECK_FALSE(overlap(found.marks[i].box, label.box));
    }
}
