// Tests which faults in users' files cause a warning, and which are refused with their place.

#include "explore/load.hpp"

#include "gaprocs/problem_registry.hpp"
#include "hydraulics/data/parameters.hpp"
#include "hydraulics/data/record_table.hpp"
#include "tests/scratch.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <filesystem>
#include <string>

using namespace placedpar;

namespace {

/// Returns the message that reading the text throws, without the path before the line number; "" if nothing is thrown.
template <class Read>
std::string refusal_from(const std::string& text, Read read) {
    const Scratch folder;
    const std::filesystem::path file = folder.write("file.txt", text);
    try {
        read(file);
    } catch (const RefusedInput& refused) {
        const std::string said = refused.what(), path = file.string();
        return said.starts_with(path) ? said.substr(path.size()) : said;
    }
    return "";
}

void no_warnings(const std::string& warnings) { FAIL("unexpected: " << warnings); }

const char* const header_of_machine = "name,value,unit,mark,source\n";

} // namespace

TEST_CASE("a machine's file replaces constants of the excavator, in any unit of the quantity") {
    const hydraulics::Parameters& excavator = hydraulics::Parameters::excavator();
    CHECK(load_machine("", no_warnings)["boom.inlet_area"] == excavator["boom.inlet_area"]);
    const Scratch folder;
    const hydraulics::Parameters machine =
        load_machine(folder.write("machine.csv", std::string(header_of_machine) +
                                                     "boom.inlet_area,206.4512,cm^2,measured,data sheet\n"),
                     no_warnings);
    CHECK(machine["boom.inlet_area"] == doctest::Approx(32)); // in^2 of 6.4516 cm^2
    CHECK(machine.find("boom.inlet_area")->source == "data sheet");
    CHECK(machine["boom.outlet_area"] == excavator["boom.outlet_area"]);
}

TEST_CASE("a wrong machine's file is refused with the place and remedy of each fault") {
    const std::string said = refusal_from(std::string(header_of_machine) +
                                              "boom.inlet_aera,1,in^2,ours,\nboom.inlet_area,0,in^2,ours,guess\n",
                                          [](const auto& path) { load_machine(path, no_warnings); });
    CHECK(said.starts_with(":2:1: error: the machine has no parameter \"boom.inlet_aera\"\n"));
    CHECK(said.find("hint: placedpar parameters lists all parameters\n") != said.npos);
    CHECK(said.find(":3:17: error: boom.inlet_area cannot be 0\n") != said.npos);
}

TEST_CASE("the first twenty faults are shown, and the others are counted") {
    std::string text = header_of_machine;
    for (int i = 0; i < 25; ++i)
        text += "boom.inlet_aera,1,in^2,ours,\n";
    const std::string said = refusal_from(text, [](const auto& path) { load_machine(path, no_warnings); });
    std::size_t shown = 0;
    for (std::size_t at = 0; (at = said.find(": error: ", at)) != said.npos; ++at)
        ++shown;
    CHECK(shown == most_faults_shown);
    CHECK(said.ends_with("... 5 more errors not shown\n"));
}

TEST_CASE("a readable record keeps the warnings about it") {
    std::string rows;
    for (int i = 0; i < 60; ++i)
        rows += fmt::format("{:.2f},{},7\n", 0.02 * i, i);
    const Scratch folder;
    const auto file = folder.write("record.csv", "time [s],boom.angle [deg],boom.mood [deg]\n" + rows);
    std::string told;
    const LoadedRecord loaded = load_record(file, {}, [&](const std::string& warnings) { told += warnings; });
    REQUIRE(loaded.warnings.size() == 1);
    CHECK(loaded.warnings[0].severity == Severity::warning);
    CHECK(told.starts_with(file.string() + ":1:"));
    CHECK(told.find("boom.mood") != told.npos);
}

TEST_CASE("a missing file and an empty netlist are refused") {
    CHECK_THROWS_WITH_AS(load_machine("/no/such/file", no_warnings), doctest::Contains("/no/such/file"), RefusedInput);
    const ProblemRegistry problems;
    CHECK(
        refusal_from("/* nothing yet */\n", [&](const auto& path) { load_network(path, {}, problems, no_warnings); }) ==
        ": error: the netlist is empty\nhint: a netlist declares processors and processes; placedpar generate writes "
        "an example\n");
}
