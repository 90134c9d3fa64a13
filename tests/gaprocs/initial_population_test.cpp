#include "gaprocs/initial_population.hpp"
#include "gaprocs/objective_problem.hpp"
#include "gaprocs/search.hpp"
#include "gaprocs/spread_population.hpp"
#include "gaprocs/usual_settings.hpp"
#include "runtime/fingerprint.hpp"
#include "tests/gaprocs/cluster.hpp"
#include "tests/gaprocs/objectives.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <utility>

using namespace placedpar;

namespace {

/// A file of strings, which the destructor deletes.
class PopulationFile {
public:
    explicit PopulationFile(const std::string& text)
        : path_(std::filesystem::temp_directory_path() / "placedpar_initial_population.txt") {
        std::ofstream(path_) << text;
    }
    ~PopulationFile() { std::filesystem::remove(path_); }
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

std::string refusal_of_file(const std::string& text) {
    PopulationFile file(text);
    try {
        load_population(file.path(), BitString(4));
    } catch (const RefusedInput& refused) {
        return refused.what();
    }
    return "";
}

} // namespace

TEST_CASE("a file of strings has one string in each line; comments and empty lines are ignored") {
    PopulationFile file("# to begin with\n0101\n\n  1111\r\n0000");
    auto population = load_population(file.path(), BitString(4));
    REQUIRE(population.size() == 3);
    CHECK(population[0].to_string() == "0101");
    CHECK(population[1].to_string() == "1111");
    CHECK(population[2].to_string() == "0000");
}

TEST_CASE("a line that is not a string is refused at its place") {
    std::string refused = refusal_of_file("0101\n01012\n");
    CHECK(refused.find("placed") != refused.npos);
    CHECK(refused.find(":2:1: error: \"01012\" is not a string of 4 characters 0 and 1\n    01012\n    ^") !=
          refused.npos);
    CHECK(refusal_of_file("  # a comment\n 012 # none\n").find(":2:2: error: \"012 # none\" is not a string of") !=
          refused.npos);
    CHECK_THROWS_AS(load_population("there/is/none", BitString(4)), RefusedInput);
}

TEST_CASE("a search begins with the given individuals and draws the others") {
    auto seats = minimise(Seats{});
    Representation orders = seats->representation();
    SearchSettings settings = usual_settings(*seats);
    settings.population = 5;
    settings.initial = {orders.read("8 7 6 5 4 3 2 1 0"), orders.read("0 1 2 3 4 5 6 7 8")};
    Search search(orders, settings, RandomStream(1, "initial"));
    CHECK(search.population().size() == 5);
    CHECK(search.population()[0] == settings.initial[0]);
    CHECK(search.population()[1] == settings.initial[1]);
    RandomStream random(1, "initial");
    CHECK(search.population()[2] == orders.random(random));
    settings.population = 2;
    CHECK_NOTHROW(Search(orders, settings, RandomStream(1, "initial")));
    settings.initial.push_back(settings.initial[0]);
    CHECK_THROWS_WITH_AS(Search(orders, settings, RandomStream(1, "initial")),
                         "3 initial individuals are given for a population of 2", UserError);
    settings.initial = {Genome(3)};
    CHECK_THROWS_WITH_AS(Search(orders, settings, RandomStream(1, "initial")),
                         "an initial individual has 3 bits, expected 576", UserError);
}

TEST_CASE(
    "an error in a netlist's file of strings is shown once, at its place in the file, with the process that reads it") {
    PopulationFile file("0 1 2 3 4 5 6 7 8\n0 1 2\n");
    Cluster cluster{.slaves = 0,
                    .master_parameters = fmt::format("initial = \"{}\"", file.path().string()),
                    .problem = "seats",
                    .host_parameters = "generations = 1"};
    std::string refused;
    try {
        run_on_line(cluster.netlist());
    } catch (const RefusedInput& shown) {
        refused = shown.what();
    }
    CHECK(refused.starts_with(file.path().string() +
                              ":2:1: error: \"0 1 2\" has 3 numbers, expected 9\n    0 1 2\n    ^\n"));
    CHECK(refused.find("note: read by process master") != refused.npos);
    CHECK(refused.find("0 1 2\" has") == refused.rfind("0 1 2\" has"));
}

TEST_CASE("a master begins with the strings of the file that its netlist names") {
    PopulationFile file("0 1 2 3 4 5 6 7 8\n");
    Cluster cluster{.slaves = 0,
                    .master_parameters = fmt::format("initial = \"{}\"", file.path().string()),
                    .problem = "seats",
                    .host_parameters = "generations = 1"};
    CHECK(run_on_line(cluster.netlist()).measured("master0", "best_objective") == 0);
}

TEST_CASE("without the parameter `initial`, and with \"random\" or \"\", every string is drawn at random") {
    Cluster cluster{.slaves = 0, .problem = "sphere", .host_parameters = "generations = 1"};
    auto populations = [&](const std::string& more) {
        cluster.master_parameters = "rehearsals = 0" + more;
        return run_on_line(cluster.netlist()).measured_text("master0", "populations");
    };
    CHECK(populations(", initial = \"random\"") == populations(""));
    CHECK(populations(", initial = \"\"") == populations(""));
    CHECK(populations(", initial = \"spread\"") != populations(""));
}

TEST_CASE("an `initial` that is neither a policy nor a file is refused before the run, at its place") {
    Cluster cluster{.slaves = 0, .master_parameters = "initial = \"spraed\"", .problem = "sphere"};
    CHECK_THROWS_WITH(run_on_line(cluster.netlist()),
                      doctest::Contains("the text is neither the name of a file nor a policy: \"spraed\" is not one of "
                                        "random, spread; did you mean \"spread\"?"));
}

TEST_CASE("a netlist's spread population is that of the library, drawn from a separate random stream") {
    Cluster cluster{.slaves = 0, .master_parameters = "", .problem = "sphere", .host_parameters = "generations = 1"};
    for (const std::string coding : {"natural", "gray", "gray(1)"}) {
        CAPTURE(coding);
        cluster.master_parameters = fmt::format("initial = \"spread\", coding = \"{}\"", coding);
        auto sphere = minimise(PlainSphere{})->coded(Coding::named(coding));
        RandomStream random(1, "one stream spread");
        Fingerprint populations;
        for (const Genome& genome : spread_population(30, *sphere, random))
            for (std::uint64_t word : genome.words())
                populations.mix(word);
        CHECK(run_on_line(cluster.netlist()).measured_text("master0", "populations") ==
              fmt::format("{:016x}", populations.value()));
    }
}

TEST_CASE("strings without fields of bits cannot be spread") {
    for (auto each : {std::pair{"seats", ""}, {"plane", ""}, {"line", ""}, {"sphere", ", coding = \"real\""}}) {
        const char *problem = each.first, *more = each.second;
        CAPTURE(problem);
        Cluster cluster{
            .slaves = 0, .master_parameters = fmt::format("initial = \"spread\"{}", more), .problem = problem};
        CHECK_THROWS_WITH(run_on_line(cluster.netlist()),
                          doctest::Contains("a spread population needs strings with fields of bits that code numbers"));
    }
}
