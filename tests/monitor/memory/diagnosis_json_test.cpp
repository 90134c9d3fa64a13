#include "monitor/memory/diagnosis_json.hpp"
#include "tests/identification/on_line/transient.hpp"

#include <boost/json.hpp>
#include <doctest/doctest.h>

#include <stdexcept>
#include <string>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;
using namespace placedpar::monitor;

namespace {

std::string text_of(const Diagnosis& diagnosis) { return boost::json::serialize(state_json(diagnosis.state())); }

} // namespace

TEST_CASE("the state goes through JSON and on as if nothing had been") {
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

TEST_CASE("what has been judged goes through JSON, too") {
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
        diagnosis.change({Configuration::b, {Link::boom}}); // judges the movement: no alarm is told before a sample
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

TEST_CASE("a state whose matrices have no inverse is refused") {
    Diagnosis diagnosis("digger", excavator_parameters(Parameters::excavator()), {}, 1);
    diagnosis.change({Configuration::a, {Link::boom}});
    for (std::size_t movement = 0; movement < 5; ++movement)
        feed(diagnosis, Transient(Configuration::a, {Link::boom}, {0.0150, 0.0086, 0.0200, 0.0300}),
             100.0 * static_cast<double>(movement));
    const boost::json::object good = state_json(diagnosis.state());
    CHECK_NOTHROW(state_from(good, {}));
    auto refused = [&](auto path, const char* why) {
        for (const char* number : {" 0", " -1", " inf", " nan"}) {
            std::string numbers = "0 0 0 0"; // by each way
            for (int i = 0; i < 16; ++i)
                numbers += number;
            boost::json::object bad = good;
            path(bad["watches"].at(0).at("judges").at(0)) = numbers;
            CAPTURE(number);
            CHECK_THROWS_WITH_AS(state_from(bad, {}), why, std::runtime_error);
        }
    };
    for (const char* test : {"from_itself", "from_kind"})
        refused([&](boost::json::value& judge) -> boost::json::value& { return judge.at(test).at("total"); },
                "the information of a test has no inverse");
    refused([](boost::json::value& judge) -> boost::json::value& { return judge.at("first").at(0); },
            "the covariance of a movement has no inverse");
}

TEST_CASE("a state that lacks a field, or has a list that is too short, is refused") {
    const Diagnosis diagnosis("digger", excavator_parameters(Parameters::excavator()), {}, 1);
    const boost::json::object good = state_json(diagnosis.state());
    for (const char* name : {"machine", "parameters", "samples", "tracks", "sets", "health", "watches", "alarms"}) {
        boost::json::object bad = good;
        bad.erase(name);
        CHECK_THROWS_AS(state_from(bad, {}), std::runtime_error);
    }
    boost::json::object bad = good;
    bad["tracks"].as_array().pop_back();
    CHECK_THROWS_WITH_AS(state_from(bad, {}), "it is not whole: out of range", std::runtime_error);
}
