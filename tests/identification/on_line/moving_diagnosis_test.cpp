#include "identification/on_line/moving_diagnosis.hpp"

#include "identification/on_line/refused_sample.hpp"
#include "tests/identification/on_line/digging.hpp"

#include <doctest/doctest.h>

#include <set>
#include <string>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

namespace {

struct Day {
    std::set<std::string> raised; ///< alarms and their links
    std::size_t samples = 0, recognised = 0;
};

Day day_of(std::uint64_t seed, double boom_factor = 1) {
    const Record record = dug(seed, 60, boom_factor);
    Diagnosis diagnosis = recognising(seed);
    Day day;
    for (std::size_t i = 0; i < record.size(); ++i) {
        for (const Alarm& alarm : diagnosis.take(sample_at(record, i)).raised)
            day.raised.insert(alarm.text.substr(0, alarm.text.find(" by")));
        ++day.samples;
        day.recognised += name_of(*diagnosis.configuration()) == record.configuration[i];
    }
    return day;
}

/// Calls use(day) for each machine of these seeds whose job is fit. Returns the number of machines.
template <typename Use>
std::size_t for_each_day(std::uint64_t first, std::uint64_t last, double boom_factor, Use use) {
    std::size_t machines = 0;
    for (std::uint64_t seed = first; seed < last; ++seed)
        try {
            use(day_of(seed, boom_factor));
            ++machines;
        } catch (const UnfitScenario&) {
        }
    return machines;
}

} // namespace

TEST_CASE("a sound machine that digs raises no alarm, and its configuration is recognised") {
    std::size_t samples = 0, recognised = 0;
    const std::size_t machines = for_each_day(400, 416, 1, [&](const Day& day) {
        CHECK(day.raised.empty());
        samples += day.samples;
        recognised += day.recognised;
    });
    CHECK(machines >= 6);
    CHECK(static_cast<double>(recognised) > 0.95 * static_cast<double>(samples));
}

TEST_CASE("cross-check 2 raises an alarm for a boom that has become softer, and for nothing else") {
    std::size_t named = 0;
    const std::size_t machines = for_each_day(420, 436, 1.5, [&](const Day& day) {
        named += day.raised.contains("boom: the compliance has changed");
        CHECK(day.raised.size() == day.raised.count("boom: the compliance has changed"));
    });
    CHECK(2 * named > machines);
}

TEST_CASE("a diagnosis that recognises configurations is restored in the middle of its work") {
    const Record record = dug(400, 30);
    Diagnosis diagnosis = recognising();
    for (std::size_t i = 0; i < record.size(); ++i) {
        if (i % 400 == 399) {
            const Diagnosis::State state = diagnosis.state();
            REQUIRE(state.moving);
            Diagnosis restored(state, {}, 1);
            CHECK(restored.state() == state);
            diagnosis = std::move(restored);
        }
        diagnosis.take(sample_at(record, i));
    }
    Diagnosis whole = recognising();
    for (std::size_t i = 0; i < record.size(); ++i)
        whole.take(sample_at(record, i));
    CHECK(whole.state() == diagnosis.state());
    CHECK_FALSE(whole.estimates().empty());
}

TEST_CASE("an impossible pressure is an alarm until a set with this link has been searched") {
    const Record record = dug(400, 60);
    Diagnosis diagnosis = recognising();
    std::vector<std::string> alarms;
    for (std::size_t i = 0; i < record.size(); ++i) {
        ExcavatorSample sample = sample_at(record, i);
        if (i == 20)
            sample.links[index_of(Link::bucket)]->inlet_psi = vacuum_psi - 1;
        const SampleOutcome outcome = diagnosis.take(sample);
        for (const Alarm& alarm : outcome.raised)
            alarms.push_back(std::string(name_of(alarm.kind)) +
                             (alarm.links == LinkSet{Link::bucket} ? " bucket" : ""));
        for (const Alarm& alarm : outcome.cleared)
            alarms.push_back("no " + std::string(name_of(alarm.kind)));
    }
    CHECK(alarms == std::vector<std::string>{"sensor bucket", "no sensor"});
}

TEST_CASE("all links must be read while the configuration is recognised") {
    const Record record = dug(400, 1);
    Diagnosis diagnosis = recognising();
    ExcavatorSample sample = sample_at(record, 0);
    sample.links[index_of(Link::stick)].reset();
    CHECK_THROWS_AS(diagnosis.take(sample), RefusedSample);
    CHECK(diagnosis.samples() == 0);
}

TEST_CASE("a reported configuration ends the recognition") {
    const Record record = dug(400, 30);
    Diagnosis diagnosis = recognising();
    for (std::size_t i = 0; i < record.size(); ++i)
        diagnosis.take(sample_at(record, i));
    CHECK(diagnosis.recognises());
    CHECK_FALSE(diagnosis.estimates().empty());
    diagnosis.change(ConfigurationChange{Configuration::a, {Link::boom}});
    CHECK_FALSE(diagnosis.recognises());
    CHECK(diagnosis.estimates().empty());
    CHECK(diagnosis.sets_in_use() == std::vector<LinkSet>{{Link::boom}});
}
