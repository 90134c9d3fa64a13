#include "monitor/memory/diagnosis_json.hpp"
#include "tests/identification/on_line/digging.hpp"
#include "tests/identification/on_line/transient.hpp"

#include <boost/json.hpp>
#include <doctest/doctest.h>

#include <limits>
#include <stdexcept>
#include <string>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;
using namespace placedpar::monitor;

namespace {

std::string text_of(const Diagnosis& diagnosis) { return boost::json::serialize(state_json(diagnosis.state())); }

} // namespace

TEST_CASE("a diagnosis restored from JSON continues identically") {
    for (std::size_t cut : {0u, 3u, 7u, 12u, 29u}) {
        Diagnosis diagnosis("digger", excavator_parameters(Parameters::excavator()), {}, 1);
        diagnosis.change({Configuration::c, LinkSet::all()});
        Transient transient(Configuration::c, LinkSet::all(), {0.0150, 0.0086, 0.0200, 0.0300});
        feed(diagnosis, transient, 0, cut);
        boost::json::value stored = boost::json::parse(text_of(diagnosis));
        Diagnosis restored(state_from(stored, {}), {}, 1);
        CHECK(restored.state() == diagnosis.state());
        CHECK(text_of(restored) == text_of(diagnosis));
        for (std::size_t i = cut; i < 30; ++i) {
            diagnosis.take(transient.sample(0, i));
            restored.take(transient.sample(0, i));
        }
        CHECK(text_of(restored) == text_of(diagnosis));
    }
}

TEST_CASE("judged movements are restored from JSON") {
    constexpr PerLink<double> sound{0.0150, 0.0086, 0.0200, 0.0300}, soft{0.0150, 0.0172, 0.0200, 0.0300};
    constexpr std::size_t length = 30, movements = 7;
    auto take = [&](Diagnosis& diagnosis, std::size_t i) {
        const std::size_t movement = i / length;
        Transient transient(Configuration::a, {Link::boom}, movement < 4 ? sound : soft);
        diagnosis.take(transient.sample(100.0 * static_cast<double>(movement), i % length));
    };
    for (std::size_t cut : {50u, 110u, 145u, 209u}) {
        Diagnosis diagnosis("digger", excavator_parameters(Parameters::excavator()), {}, 1);
        diagnosis.change({Configuration::a, {Link::boom}});
        for (std::size_t i = 0; i < cut; ++i)
            take(diagnosis, i);
        diagnosis.change({Configuration::b, {Link::boom}}); // judged now; its alarm follows later
        const Diagnosis::State state = diagnosis.state();
        CHECK(state.judged);
        CHECK_FALSE(state.watches.at({Link::boom}).judges.front().first.empty());
        Diagnosis restored(state_from(boost::json::parse(text_of(diagnosis)), {}), {}, 1);
        CHECK(restored.state() == state);
        for (std::size_t i = cut; i < length * movements; ++i) {
            take(diagnosis, i);
            take(restored, i);
        }
        CHECK(diagnosis.alarms().size() == 1);
        CHECK(text_of(restored) == text_of(diagnosis));
    }
}

TEST_CASE("a state with a missing or wrong member is refused with the member's path") {
    const Diagnosis diagnosis("digger", excavator_parameters(Parameters::excavator()), {}, 1);
    const std::string good = text_of(diagnosis);
    auto refused = [&](const std::string& part, const std::string& instead, const char* because) {
        std::string bad = good;
        const std::size_t at = bad.find(part);
        REQUIRE_MESSAGE(at != std::string::npos, part);
        bad.replace(at, part.size(), instead);
        CHECK_THROWS_WITH_AS(state_from(boost::json::parse(bad), {}), doctest::Contains(because), std::runtime_error);
    };
    const boost::json::value value = boost::json::parse(good);
    for (const auto& field : value.as_object()) {
        const std::string name = field.key();
        if (name == "moving") // may be missing: see below
            continue;
        boost::json::value bad = value;
        bad.as_object().erase(name);
        CHECK_THROWS_WITH_AS(state_from(bad, {}),
                             ("the state is incomplete or wrong: " + name + ": it is missing").c_str(),
                             std::runtime_error);
    }
    boost::json::value bad = value;
    bad.at("tracks").as_array().pop_back();
    CHECK_THROWS_WITH_AS(state_from(bad, {}), "the state is incomplete or wrong: tracks: 3 values, expected 4",
                         std::runtime_error);
    refused("\"readings\":0", "\"readings\":-1", "open.readings: not exact");
    refused("\"readings\":0", "\"readings\":0.5", "open.readings: not exact");
    refused("\"readings\":0", "\"readings\":1", "the unfinished sample already has all its readings");
    refused("\"sums\":{\"inlet_psi\":\"0\"", "\"sums\":{\"inlet_psi\":\"0 1\"",
            "tracks.0.sums.inlet_psi: 2 numbers, expected 1");
    refused("\"sums\":{\"inlet_psi\":\"0\"", "\"sums\":{\"inlet_psi\":\"x\"",
            "tracks.0.sums.inlet_psi: \"x\" is not a number");
    refused("\"judged\":false", "\"judged\":0", "judged: ");
    refused("\"judged\":false", "\"judged\":false,\"more\":1",
            "the state is incomplete or wrong: 19 members, expected 18");
    refused("\"configuration\":null", "\"configuration\":\"f\"", "configuration: \"f\" is not a known name");
    refused("\"active\":\"\"", "\"active\":\"BO BU\"", "active: \"BO BU\" is not a list of links");
    refused("\"sets\":{}", "\"sets\":{\"P9\":{}}", "sets.P9: this is not a set of links, expected P1a to P4");
    refused("\"inlet_psi\":\"\"", "\"inlet_psi\":\"1\"", "the parts of a link's readings do not fit together");
    CHECK_THROWS_AS(state_from("text", {}), std::runtime_error);
}

TEST_CASE("inconsistent parts of a population set, movement or watched set are refused") {
    Diagnosis diagnosis("digger", excavator_parameters(Parameters::excavator()), {}, 1);
    diagnosis.change({Configuration::c, LinkSet::all()});
    feed(diagnosis, Transient(Configuration::c, LinkSet::all(), {0.0150, 0.0086, 0.0200, 0.0300}), 0, 20);
    const Diagnosis::State good = diagnosis.state();
    auto refused = [&](const char* because, auto change) {
        Diagnosis::State bad = good;
        change(bad);
        CHECK_THROWS_WITH_AS(state_from(state_json(bad), {}), doctest::Contains(because), std::runtime_error);
    };
    using State = Diagnosis::State;
    auto set = [](State& state) -> PopulationSet::State& { return state.sets.begin()->second; };
    auto watch = [](State& state) -> SetWatch::State& { return state.watches.begin()->second; };
    refused("a population has 119 individuals, expected 120", [&](State& state) { set(state).population.pop_back(); });
    refused("of a population set", [&](State& state) { set(state).population.assign(120, Genome(3)); });
    refused("of a population set", [&](State& state) { set(state).estimates.pop_back(); });
    refused("of a population set", [&](State& state) { set(state).window.front().pop_back(); });
    refused("of a movement", [&](State& state) { watch(state).movement.samples.moving.resize(1000); });
    refused("of a movement", [&](State& state) { watch(state).movement.shut.emplace_back(9); });
    refused("of a watched set", [&](State& state) { watch(state).valves.pop_back(); });
    refused("of a watched set", [&](State& state) { watch(state).judges.front().first.resize(100); });
}

TEST_CASE("a diagnosis that recognises configurations is restored from JSON") {
    const Record record = dug(400, {.seconds = 30});
    Diagnosis diagnosis = recognising();
    for (std::size_t i = 0; i < record.size(); ++i) {
        if (i % 500 == 499) {
            Diagnosis restored(state_from(boost::json::parse(text_of(diagnosis)), {}), {}, 1);
            CHECK(restored.state() == diagnosis.state());
            diagnosis = std::move(restored);
        }
        diagnosis.take(sample_at(record, i));
    }
    const Diagnosis::State good = diagnosis.state();
    REQUIRE(good.moving);
    REQUIRE_FALSE(good.moving->estimates.empty());
    auto refused = [&](const char* because, auto change) {
        Diagnosis::State bad = good;
        change(*bad.moving);
        CHECK_THROWS_WITH_AS(state_from(state_json(bad), {}), doctest::Contains(because), std::runtime_error);
    };
    using State = MovingDiagnosisState;
    const LinkSet set = good.moving->estimates.begin()->first;
    auto search = [&](State& state) -> SetSearchState& { return state.search.searches.at(set); };
    refused("of the search of a set", [&](State& state) { search(state).population.pop_back(); });
    refused("of the search of a set",
            [&](State& state) { search(state).population.assign(search(state).population.size(), Genome(3)); });
    refused("of the search of a set", [&](State& state) { search(state).configurations.clear(); });
    refused("of the samples of a configuration",
            [&](State& state) { search(state).configurations.front().samples.front().links.emplace_back(); });
    refused("of the estimates of a set", [&](State& state) { state.estimates.at(set).emplace_back(); });
    refused("of the estimates of a set", [&](State& state) { state.search.searches.erase(set); });
    refused("of a sample that waits", [&](State& state) { state.search.pending = {{LinkSet(), {0, 0, {}}}}; });
    refused("of the recognised configuration", [&](State& state) { state.search.watch.recent.resize(100); });
    refused("of the recognised configuration", [&](State& state) { state.search.watch.recent.back().misfit += 1; });
    refused("of the recognised configuration", [&](State& state) {
        state.search.watch.recent.clear();
        state.search.watch.last.junction_psi.front() = std::numeric_limits<double>::quiet_NaN();
    });
    Diagnosis::State bad = good;
    bad.configuration.reset();
    CHECK_THROWS_AS(state_from(state_json(bad), {}), std::runtime_error);
}

TEST_CASE("a state of an earlier version has no recognised configuration") {
    Diagnosis diagnosis("digger", excavator_parameters(Parameters::excavator()), {}, 1);
    boost::json::value stored = state_json(diagnosis.state());
    CHECK(stored.as_object().erase("moving") == 1);
    CHECK(state_from(stored, {}) == diagnosis.state());
    CHECK(stored.as_object().erase("alarms") == 1);
    CHECK_THROWS_WITH_AS(state_from(stored, {}), doctest::Contains("alarms: it is missing"), std::runtime_error);
}

TEST_CASE("a state whose matrices have no inverse is refused") {
    Diagnosis diagnosis("digger", excavator_parameters(Parameters::excavator()), {}, 1);
    diagnosis.change({Configuration::a, {Link::boom}});
    for (std::size_t movement = 0; movement < 5; ++movement)
        feed(diagnosis, Transient(Configuration::a, {Link::boom}, {0.0150, 0.0086, 0.0200, 0.0300}),
             100.0 * static_cast<double>(movement));
    const Diagnosis::State good = diagnosis.state();
    CHECK_NOTHROW(state_from(state_json(good), {}));
    auto refused = [&](const char* because, auto matrix_of) {
        for (double number : {0.0, -1.0}) {
            Diagnosis::State bad = good;
            matrix_of(bad.watches.begin()->second.judges.front()).fill(number);
            CAPTURE(number);
            CHECK_THROWS_WITH_AS(state_from(state_json(bad), {}), doctest::Contains(because), std::runtime_error);
        }
    };
    refused("the information of a test has no inverse",
            [](LinkJudge::State& judge) -> PerPairOfHypotheses& { return judge.from_itself.information; });
    refused("the information of a test has no inverse",
            [](LinkJudge::State& judge) -> PerPairOfHypotheses& { return judge.from_kind.information; });
    refused("the covariance of a movement has no inverse",
            [](LinkJudge::State& judge) -> PerPairOfHypotheses& { return judge.first.front().covariance; });
}
