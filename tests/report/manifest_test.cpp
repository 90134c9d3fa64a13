// Tests JSON as the program writes it.

#include "report/manifest.hpp"

#include <boost/json.hpp>
#include <doctest/doctest.h>

#include <limits>

using namespace placedpar;

TEST_CASE("numbers read back exactly, and numbers that JSON lacks are null") {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    boost::json::array numbers{86.4,   0.1,      -0.0,      1e300,
                               5e-324, infinite, -infinite, std::numeric_limits<double>::quiet_NaN()};
    std::string text = print_pretty(boost::json::object{{"numbers", numbers}});
    CHECK(text.starts_with("{\n  \"numbers\": [\n    86.4,\n    0.1,\n"));
    boost::json::array read = boost::json::parse(text).at("numbers").as_array();
    REQUIRE(read.size() == numbers.size());
    for (std::size_t i = 0; i < 5; ++i)
        CHECK(read[i].to_number<double>() == numbers[i].get_double());
    for (std::size_t i = 5; i < 8; ++i)
        CHECK(read[i].is_null());
}

TEST_CASE("JSON is printed with one member a line, indented by two blanks; empty values stay on one line") {
    const boost::json::value value = boost::json::parse(R"({"a":{"b":[1,{"c":true}],"d":{}},"e":[],"f":"\u00b5\n"})");
    CHECK(print_pretty(value) == "{\n"
                                 "  \"a\": {\n"
                                 "    \"b\": [\n"
                                 "      1,\n"
                                 "      {\n"
                                 "        \"c\": true\n"
                                 "      }\n"
                                 "    ],\n"
                                 "    \"d\": {}\n"
                                 "  },\n"
                                 "  \"e\": [],\n"
                                 "  \"f\": \"\u00b5\\n\"\n"
                                 "}\n");
    CHECK(boost::json::parse(print_pretty(value)) == value);
}

TEST_CASE("a manifest has the settings and their targets, and limits, faults or shuffles only if used") {
    Network network;
    network.source_path = "ring.cfs";
    network.hash = 0xab;
    network.set = {{"clock", "20M", {"t[0]", "t[1]"}}, {"n", "3", {}}};
    Manifest manifest{.command = "run ring.cfs", .seed = 7, .overrides = {{"clock", "20M"}, {"n", "3"}}};
    boost::json::object json = manifest_json(manifest, network);
    CHECK(json.at("netlist_hash") == "00000000000000ab");
    CHECK(json.at("overrides").at("n") == "3");
    CHECK(json.at("set").at(0).at("elements") == boost::json::array{"t[0]", "t[1]"});
    CHECK(json.at("set").at(1).at("elements").as_array().empty()); // a val
    for (const char* unusual : {"faults", "until_ps", "shuffle"})
        CHECK_FALSE(json.contains(unusual));
    manifest.read.faults = {"t[0] dead"};
    manifest.until = Time{5};
    manifest.shuffle = 0;
    json = manifest_json(manifest, network);
    CHECK(json.at("faults") == boost::json::array{"t[0] dead"});
    CHECK(json.at("until_ps") == 5);
    CHECK(json.at("shuffle") == 0);
}
