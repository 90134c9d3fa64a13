// Identifies the compliance of a simulated record whose true compliance is known: 0.0086 in^3/psi.

#include "explore/identify/identify_record.hpp"
#include "explore/identify/identify_settings.hpp"
#include "explore/identify/ways.hpp"

#include "explore/load.hpp"
#include "explore/process_search.hpp"
#include "hydraulics/data/record_table.hpp"
#include "tests/nearly.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <doctest/doctest.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

using namespace placedpar;

namespace {

constexpr double true_compliance = 0.0086;
const std::filesystem::path boom_record = PLACEDPAR_SOURCE_DIR "/examples/hydraulics/records/boom-4deg.csv";
const std::filesystem::path one_cluster = PLACEDPAR_SOURCE_DIR "/examples/thesis/table-e1/cluster.cfs";

void ignore(const std::string&) {}

/// The whole record in one piece; then, if it was stopped, nothing more.
class OnePiece final : public RecordStream {
public:
    OnePiece(hydraulics::Record record, bool is_stopped) : record_(std::move(record)), is_stopped_(is_stopped) {}

    std::optional<hydraulics::Record> next() override { return std::exchange(record_, std::nullopt); }
    std::uint64_t bytes() const override { return 0; }
    bool stopped() const override { return is_stopped_; }
    const std::vector<Diagnostic>& warnings() const override { return warnings_; }

private:
    std::optional<hydraulics::Record> record_;
    bool is_stopped_;
    std::vector<Diagnostic> warnings_;
};

struct IdentifiedBoom {
    boost::json::object json;
    std::string printed;
    IdentifyEnd end = IdentifyEnd::interrupted;

    explicit IdentifiedBoom(IdentifySettings settings, bool is_stopped = false) {
        settle_way(settings);
        const RecordInput input{
            [](const hydraulics::RecordNeeds& needs) { return load_record(boom_record, needs, ignore); },
            [is_stopped](hydraulics::RecordNeeds needs) -> std::unique_ptr<RecordStream> {
                return std::make_unique<OnePiece>(load_record(boom_record, needs, ignore).record, is_stopped);
            }};
        end = identify_record(settings, input,
                              {json, true, [this](const std::string& text) { printed += text; }, ignore, ignore});
    }
};

IdentifySettings way_and_seed(const std::string& way, std::uint64_t seed = 1) {
    IdentifySettings settings;
    settings.way = way;
    settings.seed = seed;
    return settings;
}

/// The search of chapter 3 on the record, and the netlist that is to make this search.
struct SearchOnMachine {
    boost::json::object json;
    ThesisAnswer answer;

    SearchOnMachine() : answer(answered(json)) {}

    ProcessSearch on(const std::filesystem::path& netlist, const Overrides& set = {},
                     const std::filesystem::path& output = "result.json") const {
        return search_by_processes({netlist, set, ParsedNetlist(netlist), output}, answer.prepared, answer.way, ignore);
    }

private:
    static ThesisAnswer answered(boost::json::object& json) {
        IdentifySettings settings = way_and_seed("thesis");
        settle_way(settings);
        const RecordInput input{
            [](const hydraulics::RecordNeeds& needs) { return load_record(boom_record, needs, ignore); }, {}};
        return identify_by_thesis(settings, input, {json, true, ignore, ignore, ignore});
    }
};

} // namespace

TEST_CASE("the search of chapter 3 finds the true compliance within a tenth, whatever its random numbers") {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const IdentifiedBoom boom(way_and_seed("thesis", seed));
        CHECK(boom.end == IdentifyEnd::sound);
        CHECK(boom.json.at("links").at(0).at("compliance").to_number<double>() == test::nearly(true_compliance, .1));
        CHECK(boom.printed.find("C_BOi ") != std::string::npos);
    }
}

TEST_CASE("equal settings give the same answer to the last bit, another seed another") {
    const auto answer = [](std::uint64_t seed) { return IdentifiedBoom(way_and_seed("thesis", seed)).json; };
    CHECK(answer(1) == answer(1));
    CHECK(answer(1) != answer(2));
}

TEST_CASE("as a service the movements of the record are listed, with the links' verdicts") {
    const IdentifiedBoom boom(way_and_seed("service"));
    CHECK(boom.end == IdentifyEnd::sound);
    CHECK(boom.json.at("movements").as_array().size() >= 1);
    CHECK(boom.printed.find("boom in configuration a; search with ") == 0);
    CHECK(boom.json.at("sampling").at("readings_a_sample") == 1);
}

TEST_CASE("a record that is stopped gives what was found, and counts as interrupted") {
    const IdentifiedBoom boom(way_and_seed("service"), true);
    CHECK(boom.end == IdentifyEnd::interrupted);
    CHECK(boom.json.contains("movements"));
}

TEST_CASE("fewer samples than the first generation needs are refused with the number that it needs") {
    IdentifySettings settings = way_and_seed("thesis");
    settings.samples = 1;
    CHECK_THROWS_WITH_AS(IdentifiedBoom{settings}, doctest::Contains("--samples 1: expected at least "), UserError);
}

TEST_CASE("a link that the record lacks, and an offset without a spool, are refused") {
    IdentifySettings settings = way_and_seed("service");
    settings.links = "bucket";
    CHECK_THROWS_AS(IdentifiedBoom{settings}, UserError);
    settings = way_and_seed("service");
    settings.offset = "0.01";
    settings.areas = "servo";
    CHECK_THROWS_AS(IdentifiedBoom{settings}, UserError);
}

TEST_CASE("the processes of a netlist take over the settings of the search") {
    const SearchOnMachine search;
    const ProcessSearch processes = search.on(one_cluster);
    CHECK(processes.searches == std::vector<std::string>{"master"});
    CHECK(processes.population == search.answer.way.search.population);
    CHECK(processes.answers().searches() == processes.searches);
    for (const ProcessInstance& process : processes.network.processes)
        if (process.name == "master")
            CHECK(std::get<std::int64_t>(process.parameters.at("trials")) ==
                  static_cast<std::int64_t>(search.answer.way.search.window.trials));
}

TEST_CASE("a netlist without a search, with other individuals or with an included file as output is refused") {
    const SearchOnMachine search;
    const std::filesystem::path matrix = PLACEDPAR_SOURCE_DIR "/examples/csp/matrix/matrix.cfs";
    CHECK_THROWS_WITH_AS(
        search.on(matrix),
        ("--on " + matrix.string() +
         ": no process searches; expected a process of the kind ga.traditional, ga.master or ga.island")
            .c_str(),
        UserError);
    CHECK_THROWS_WITH_AS(search.on(one_cluster, {{"population", "60"}}),
                         doctest::Contains("population = 60 in the netlist for \"master\", but the identification has"),
                         RefusedInput);
    CHECK_THROWS_AS(search.on(one_cluster, {}, one_cluster.parent_path().parent_path() / "workload.inc"), UserError);
}
