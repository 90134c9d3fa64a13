// Tests which constants of a netlist an option can set, and with which expressions the netlist states them.

#include "explore/stated_vals.hpp"

#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"
#include "netlist/read.hpp"
#include "tests/scratch.hpp"

#include <doctest/doctest.h>

#include <map>
#include <string>

using namespace placedpar;

namespace {

using StatedVals = std::map<std::string, std::string>;

StatedVals vals_of_file(const Scratch& folder, const std::string& text, const Overrides& set = {}) {
    const ReadResult read = read_netlist(folder.write("n.cfs", text), Catalogue(), set);
    INFO(render(read));
    REQUIRE(read.network);
    return stated_vals(*read.network);
}

StatedVals vals_in_text(const std::string& text, const Overrides& set = {}) {
    return vals_of_file(Scratch(), text + "T800 t;\n", set);
}

} // namespace

TEST_CASE("a constant has the expression of the file, not its value") {
    CHECK(vals_in_text("val n 4;\nval m 2 * (n + 1);\nval speed 20M;\nval list {1, 2};\n") ==
          StatedVals{{"n", "4"}, {"m", "2 * (n + 1)"}, {"speed", "20M"}, {"list", "{1, 2}"}});
    CHECK(vals_in_text("").empty());
}

TEST_CASE("an option's expression replaces the file's; settings of elements are no constants") {
    CHECK(vals_in_text("val n 4;\nval m n;\n", {{"n", "7"}, {"clock", "10M"}}) == StatedVals{{"n", "7"}, {"m", "n"}});
}

TEST_CASE("constants in blocks, comments and texts are left out, since no option can set them") {
    CHECK(vals_in_text(
              "/* val a 1; */\nval b \"val c 2;\";\nif 1 {\n    val d 3;\n    if 1 { val e 4; }\n}\nval f 5;\n") ==
          StatedVals{{"b", "\"val c 2;\""}, {"f", "5"}});
}

TEST_CASE("an expression may have several lines, and several constants a line") {
    CHECK(vals_in_text("val n 1 +\n      2; val\tm\n3;\n") == StatedVals{{"n", "1 +\n      2"}, {"m", "3"}});
}

TEST_CASE("constants of included files count, too") {
    const Scratch folder;
    folder.write("common.inc", "val shared 3;\n");
    CHECK(vals_of_file(folder, "#include \"common.inc\"\nval n shared;\nT800 t;\n") ==
          StatedVals{{"shared", "3"}, {"n", "shared"}});
}
