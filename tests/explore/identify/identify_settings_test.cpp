// Tests which settings of an identification are accepted, which way they choose, and which channels a record must have.

#include "explore/identify/identify_record.hpp"
#include "explore/identify/identify_settings.hpp"
#include "explore/identify/identifying.hpp"
#include "explore/identify/question.hpp"

#include "hydraulics/data/record_table.hpp"
#include "hydraulics/data/sampling.hpp"
#include "tests/scratch.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <doctest/doctest.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

using namespace placedpar;
using hydraulics::AreasFrom;
using hydraulics::ChannelSet;
using hydraulics::Link;
using hydraulics::LinkSet;
using hydraulics::Sensor;

namespace {

IdentifySettings settled(IdentifySettings settings) {
    settle_way(settings);
    return settings;
}

/// Returns the settings of a way, changed by the function.
IdentifySettings by_way(const std::string& way, const std::function<void(IdentifySettings&)>& change) {
    IdentifySettings settings;
    settings.way = way;
    change(settings);
    return settings;
}

ChannelSet channels(std::initializer_list<std::pair<Link, Sensor>> all) {
    ChannelSet set;
    for (const auto& [link, sensor] : all)
        set.insert(link, sensor);
    return set;
}

/// Returns the names of the columns that the settings state, as "in_file>sensor".
std::vector<std::string> named_columns(const IdentifySettings& settings) {
    std::vector<std::string> names;
    for (const hydraulics::ColumnName& each : needs_of(settings, [](const ChannelSet&) { return LinkSet{}; }).names)
        names.push_back(each.in_file + ">" + std::string(name_of(each.channel.sensor.value())));
    return names;
}

constexpr auto nothing = [](IdentifySettings&) {};

} // namespace

TEST_CASE("without a way the movements are identified as a service, and the outlet side over the whole record") {
    CHECK(settled(by_way("", nothing)).way == "service");
    CHECK(settled(by_way("", nothing)).configuration == ""); // it is recognised, if possible
    const IdentifySettings outlet = settled(by_way("", [](IdentifySettings& set) { set.side = "outlet"; }));
    CHECK(outlet.way == "whole");
    CHECK(outlet.configuration == "a");
    CHECK(settled(by_way("thesis", nothing)).configuration == "a");
    CHECK(settled(by_way("thesis", [](IdentifySettings& set) { set.configuration = "d"; })).configuration == "d");
}

TEST_CASE("numbers are accepted from the least to the greatest value, and refused beyond") {
    struct Range {
        std::string option;
        std::optional<std::size_t> IdentifySettings::*number;
        std::size_t least, most;
    };
    for (const Range& range : {Range{"--bits", &IdentifySettings::bits, 6, 52},
                               {"--elite", &IdentifySettings::elite, 0, 1'000'000},
                               {"--population", &IdentifySettings::population, 2, 1'000'000},
                               {"--trials", &IdentifySettings::trials, 1, 1'000'000},
                               {"--window", &IdentifySettings::window, 1, 1024},
                               {"--samples", &IdentifySettings::samples, 1, 1'000'000}}) {
        CAPTURE(range.option);
        const auto with = [&](std::size_t number) {
            return by_way("thesis", [&](IdentifySettings& set) { set.*range.number = number; });
        };
        CHECK_NOTHROW(settled(with(range.least)));
        CHECK_NOTHROW(settled(with(range.most)));
        const std::string expected = ": expected " + std::to_string(range.least) + " to " + std::to_string(range.most);
        const std::string said = range.option + " " + std::to_string(range.most + 1) + expected;
        CHECK_THROWS_WITH_AS(settled(with(range.most + 1)), said.c_str(), UserError);
        if (range.least > 0)
            CHECK_THROWS_AS(settled(with(range.least - 1)), UserError);
    }
}

TEST_CASE("a setting that has no effect with the way is refused with the ways in which it has one") {
    const auto refused = [](const std::string& way, const std::function<void(IdentifySettings&)>& change,
                            const std::string& why) {
        CHECK_THROWS_WITH_AS(settled(by_way(way, change)), doctest::Contains(why.c_str()), UserError);
        CHECK_NOTHROW(settled(by_way("thesis", change)));
    };
    const auto rising = [](IdentifySettings& set) { set.rising = true; };
    refused("whole", rising, "--rising works only with --way thesis; --way whole uses all samples at once");
    refused("service", rising, "--rising works only with --way thesis; --way service identifies as");
    refused(
        "whole", [](IdentifySettings& set) { set.window = 7; }, "--window works only with --way thesis; ");
    refused(
        "service", [](IdentifySettings& set) { set.samples = 9; }, "--samples works only with --way thesis or whole");
    refused(
        "service", [](IdentifySettings& set) { set.coding = "gray"; }, "--coding works only with --way thesis or");
    refused(
        "service", [](IdentifySettings& set) { set.offset = "auto"; }, "--offset auto works only with --way thesis");
    refused(
        "service", [](IdentifySettings& set) { set.side = "outlet"; }, "--side outlet works only with --way");
}

TEST_CASE("a message says that a way is the default, so that it blames no option that was not given") {
    const auto chosen = [](const std::string& way, const std::string& side) {
        return shown_way(settled(by_way(way, [&](IdentifySettings& set) { set.side = side; })));
    };
    CHECK(chosen("", "inlet") == "--way service (the default)");
    CHECK(chosen("", "outlet") == "--way whole (the default with --side outlet)");
    CHECK(chosen("whole", "outlet") == "--way whole");
    IdentifySettings rising;
    rising.rising = true;
    rising.side = "outlet";
    CHECK_THROWS_WITH_AS(settled(rising),
                         "--rising works only with --way thesis; --way whole (the default with --side outlet) uses all "
                         "samples at once",
                         UserError);
}

TEST_CASE("links are named once each, in any order") {
    CHECK(links_of("boom") == LinkSet{Link::boom});
    CHECK(links_of("swing,bucket,boom,stick") == LinkSet::all());
    CHECK_THROWS_WITH_AS(links_of("boom,arm"),
                         "--link boom,arm: unknown link \"arm\"; the links are bucket, boom, stick and swing",
                         UserError);
    CHECK_THROWS_WITH_AS(links_of("boom,stick,boom"), "--link boom,stick,boom: boom is named twice", UserError);
    for (const char* text : {"", ",", "boom,", ",boom", "Boom", "boom, stick"})
        CHECK_THROWS_AS(links_of(text), UserError);
}

TEST_CASE("an offset is a number of inches of at most 0.08") {
    CHECK(offset_asked("0.08") == 0.08);
    CHECK(offset_asked("-0.08") == -0.08);
    CHECK(offset_asked("1e-3") == 0.001);
    for (const char* text : {"0.081", "-0.081", "nan", "inf", "", "0.01in", "auto"})
        CHECK_THROWS_WITH_AS(offset_asked(text), doctest::Contains("expected auto, none, or a number of inches from"),
                             UserError);
}

TEST_CASE("a record needs pressure, angle and the source of the areas of each link that is asked for") {
    IdentifySettings settings;
    const ChannelSet there = channels({{Link::boom, Sensor::inlet_pressure},
                                       {Link::boom, Sensor::angle},
                                       {Link::boom, Sensor::spool},
                                       {Link::boom, Sensor::servo},
                                       {Link::stick, Sensor::angle}});
    const auto needed = [&] {
        return needs_of(settings, [](const ChannelSet&) { return LinkSet{Link::boom}; }).of(there);
    };
    CHECK(needed().contains(
        channels({{Link::boom, Sensor::inlet_pressure}, {Link::boom, Sensor::angle}, {Link::boom, Sensor::spool}})));
    CHECK_FALSE(needed().contains(Link::boom, Sensor::servo));
    CHECK_FALSE(needed().contains(Link::stick, Sensor::angle));
    settings.areas = "servo";
    CHECK(needed().contains(Link::boom, Sensor::servo));
    CHECK_FALSE(needed().contains(Link::boom, Sensor::spool));
    settings.side = "outlet";
    CHECK(needed().contains(Link::boom, Sensor::outlet_pressure));
    CHECK_FALSE(needed().contains(Link::boom, Sensor::inlet_pressure));
}

TEST_CASE("the source of areas and the side are read from the settings") {
    IdentifySettings settings;
    CHECK_FALSE(areas_asked(settings));
    CHECK(side_asked(settings) == hydraulics::Side::inlet);
    for (const auto& [text, from] :
         {std::pair("spool", AreasFrom::spool), {"servo", AreasFrom::servo}, {"areas", AreasFrom::areas}}) {
        settings.areas = text;
        CHECK(areas_asked(settings) == from);
    }
}

TEST_CASE("rows without a reading are skipped only on request") {
    IdentifySettings settings;
    const auto skips = [&] { return needs_of(settings, [](const ChannelSet&) { return LinkSet{}; }).skip_missing; };
    CHECK_FALSE(skips());
    settings.missing = "skip";
    CHECK(skips());
}

TEST_CASE("a typed name of a column replaces the file's name of the same channel") {
    const Scratch folder;
    IdentifySettings settings;
    settings.columns_from =
        folder.write("names.txt", "# a logger's names\nboom.inlet_pressure = P1\n\nboom.angle = Phi\n").string();
    CHECK(named_columns(settings) == std::vector<std::string>{"P1>inlet_pressure", "Phi>angle"});
    settings.columns = {"boom.inlet_pressure=P2"};
    CHECK(named_columns(settings) == std::vector<std::string>{"Phi>angle", "P2>inlet_pressure"});
}

TEST_CASE("names of columns that contradict each other are refused") {
    IdentifySettings settings;
    settings.columns = {"boom.inlet_pressure=P", "boom.angle=P"};
    CHECK_THROWS_WITH_AS(named_columns(settings), "the column \"P\" is given to two channels; expected one channel",
                         UserError);
    settings.columns = {"boom.angle=P", "boom.angle=Q"};
    CHECK_THROWS_WITH_AS(named_columns(settings), "\"P\": the channel already has a column; expected one column",
                         UserError);
    settings.columns = {"boom.mood=P"};
    CHECK_THROWS_WITH_AS(named_columns(settings), doctest::Contains("--column "), UserError);
}

TEST_CASE("a wrong line in a file of names is refused with its number, a missing file with its name") {
    const Scratch folder;
    IdentifySettings settings;
    const auto path = folder.write("names.txt", "# names\n\nboom.angle = Phi\nboom.mood = P\n");
    settings.columns_from = path.string();
    CHECK_THROWS_WITH_AS(named_columns(settings), doctest::Contains((path.string() + ":4: error: ").c_str()),
                         RefusedInput);
    settings.columns_from = (folder / "none.txt").string();
    CHECK_THROWS_WITH_AS(named_columns(settings), doctest::Contains("none.txt"), RefusedInput);
}

TEST_CASE("a configuration is recognised only if none is given") {
    ChannelSet all;
    for (const Link link : hydraulics::all_links)
        for (const Sensor sensor : hydraulics::all_sensors)
            all.insert(link, sensor);
    IdentifySettings settings;
    CHECK(moves(settings, all));
    CHECK_FALSE(moves(settings, channels({{Link::boom, Sensor::angle}})));
    settings.configuration = "a";
    CHECK_FALSE(moves(settings, all));
}

TEST_CASE("with a configuration that is recognised, settings of a fixed one are refused") {
    IdentifySettings settings;
    CHECK_NOTHROW(require_no_fixed_settings(settings));
    CHECK(links_that_move(settings) == LinkSet::all());
    settings.links = "stick";
    CHECK(links_that_move(settings) == LinkSet{Link::stick});
    for (const auto& change : std::vector<std::function<void(IdentifySettings&)>>{
             [](IdentifySettings& set) { set.window = 5; }, [](IdentifySettings& set) { set.areas = "spool"; },
             [](IdentifySettings& set) { set.offset = "none"; }})
        CHECK_THROWS_WITH_AS(require_no_fixed_settings(by_way("service", change)),
                             doctest::Contains("need --configuration"), UserError);
}

TEST_CASE("given settings replace the defaults of a way; others stay") {
    IdentifySettings settings;
    const identification::DiagnosisSettings usual = settings_of(settings);
    settings.population = usual.search.population + 2;
    settings.bits = 9;
    settings.bias = 123;
    const identification::DiagnosisSettings changed = settings_of(settings);
    CHECK(changed.search.population == usual.search.population + 2);
    CHECK(changed.bits == 9);
    CHECK(changed.search.window.bias == 123);
    CHECK(changed.search.window.trials == usual.search.window.trials);
    CHECK(changed.search.elite == usual.search.elite);
}

TEST_CASE("1 kHz is averaged to samples of 20 ms, as JSON says") {
    const boost::json::object json = sampling_json(hydraulics::Sampling::of(0.001));
    CHECK(json.at("reading_s") == 0.001);
    CHECK(json.at("readings_a_sample") == 20);
    CHECK(json.at("sample_s").as_double() == doctest::Approx(0.02));
}

TEST_CASE("warnings as JSON have their place, message and hint") {
    const boost::json::array json = warnings_json({warning_at(3, 7, "the pressure is frozen", "check the sensor")});
    REQUIRE(json.size() == 1);
    CHECK(json[0] ==
          boost::json::value{
              {"line", 3}, {"column", 7}, {"message", "the pressure is frozen"}, {"hint", "check the sensor"}});
    CHECK(warnings_json({}).empty());
}
