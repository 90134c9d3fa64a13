#include "hydraulics/plant/excavator_record.hpp"
#include "hydraulics/plant/excavator_values.hpp"
#include "hydraulics/plant/measurement.hpp"
#include "identification/on_line/machine.hpp"
#include "monitor/memory/machine_json.hpp"
#include "runtime/random.hpp"
#include "tests/identification/on_line/transient.hpp"

#include <boost/json.hpp>
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::monitor;

namespace {

constexpr PerLink<double> healthy{0.0150, 0.0086, 0.0200, 0.0300};
constexpr LinkSet bucket{hydraulics::Link::bucket}, boom{hydraulics::Link::boom},
    bucket_boom{hydraulics::Link::bucket, hydraulics::Link::boom};

std::string text_of(const Machine& machine) { return boost::json::serialize(state_json(machine.state())); }

std::string text_of(const Machine& machine, LinkSet set) {
    Machine::State state = machine.state();
    std::erase_if(state.sets, [&](const auto& each) { return each.first != set; });
    return boost::json::serialize(state_json(state).at("sets"));
}

Machine machine_in(Configuration configuration, LinkSet active, std::uint64_t seed = 1) {
    Machine machine("digger", {}, {}, seed);
    machine.change({configuration, active});
    return machine;
}

Record boom_record(std::uint64_t seed, const MeasurementNoise& noise) {
    ExcavatorScenario scenario = single_boom_scenario();
    RandomStream random(seed, "noise");
    return measure_excavator(simulate_excavator(scenario), scenario, 0.020, noise, [&] { return random.uniform(); });
}

void feed(Machine& machine, const Record& record) {
    auto of = [&](Sensor sensor) { return record.of(hydraulics::Link::boom, sensor); };
    for (std::size_t i = 0; i < record.size(); ++i) {
        SampleMessage message{record.time_s[i], {}};
        message.links[index_of(hydraulics::Link::boom)] = Reading{of(Sensor::inlet_pressure)[i], of(Sensor::angle)[i],
                                                                  SpoolReading{std::max(of(Sensor::spool)[i], 0.0)}};
        machine.take(message);
    }
}

double off(std::optional<double> found, double right) { return std::abs(found.value() / right - 1); }

} // namespace

TEST_CASE("the boom's compliance out of scenario A, by spool") {
    for (const MeasurementNoise& noise : {no_noise, low_noise}) {
        int good = 0;
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            Machine machine = machine_in(Configuration::a, boom, seed);
            feed(machine, boom_record(seed, noise));
            good += off(estimate_of(machine, boom, hydraulics::Link::boom).compliance_in3_per_psi(), 0.0086) <= 0.10;
        }
        CHECK(good >= 19); // 90th percentile 4 % without noise, 8 % at low noise
    }
}

TEST_CASE("all links of every configuration are found within 10 %") {
    for (Configuration configuration : all_configurations) {

        int good = 0, of = 0;
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            Machine machine = machine_in(configuration, LinkSet::all(), seed);
            feed(machine, {configuration, LinkSet::all(), healthy}, 0);
            for (LinkSet set : machine.sets_in_use())
                for (hydraulics::Link link : links_of(set)) {
                    auto found = estimate_of(machine, set, link).compliance_in3_per_psi();
                    CHECK(found);
                    good += off(found, healthy[index_of(link)]) <= 0.10;
                    ++of;
                }
        }
        MESSAGE(std::string(1, name_of(configuration)), ": ", good, " of ", of);
        CHECK(good >= 0.9 * of);
    }
}

TEST_CASE("a change from a to b leaves P2a untouched") {
    Machine machine = machine_in(Configuration::a, bucket_boom);
    feed(machine, {Configuration::a, bucket_boom, healthy}, 0);
    CHECK(machine.sets().size() == 1); // lazily made
    machine.change({Configuration::b, bucket_boom});
    std::string before = text_of(machine, bucket_boom);
    feed(machine, {Configuration::b, bucket_boom, healthy}, 10);
    CHECK(machine.sets().size() == 3);
    CHECK(machine.sets().at(bucket).state().generations > 0);
    CHECK(text_of(machine, bucket_boom) == before);
    machine.change({Configuration::a, bucket_boom});
    feed(machine, {Configuration::a, bucket_boom, healthy}, 20);
    CHECK(text_of(machine, bucket_boom) != before);
}

TEST_CASE("what a set finds does not depend on the other sets") {
    Machine alone = machine_in(Configuration::a, boom),
            both = machine_in(Configuration::a, {hydraulics::Link::boom, hydraulics::Link::stick});
    feed(alone, {Configuration::a, boom, healthy}, 0);
    feed(both, {Configuration::a, {hydraulics::Link::boom, hydraulics::Link::stick}, healthy}, 0);
    CHECK(text_of(alone, boom) == text_of(both, boom));
    Machine other = machine_in(Configuration::a, boom, 2);
    feed(other, {Configuration::a, boom, healthy}, 0);
    CHECK(text_of(alone, boom) != text_of(other, boom));
}

TEST_CASE("after a change of configuration the window begins anew") {
    Machine machine = machine_in(Configuration::a, boom);
    Transient before(Configuration::a, boom, healthy), after(Configuration::b, boom, healthy);
    auto generations = [](const std::vector<SampleOutcome>& outcomes) {
        std::vector<std::size_t> counts;
        for (const SampleOutcome& outcome : outcomes)
            counts.push_back(outcome.generations);
        return counts;
    };
    // 5 samples to the first slope, 5 slopes to the first generation, 5 generations a sample.
    std::vector<std::size_t> expected{0, 0, 0, 0, 0, 0, 0, 0, 5, 5};
    CHECK(generations(feed(machine, before, 0, 10)) == expected);
    machine.change({Configuration::a, boom}); // the same again: no change
    CHECK(machine.take(before.sample(0, 10)).generations == 5);
    machine.change({Configuration::b, boom});
    CHECK(machine.sets().at(boom).state().window.empty());
    std::vector<SampleOutcome> outcomes;
    for (std::size_t i = 11; i < 21; ++i)
        outcomes.push_back(machine.take(after.sample(0, i)));
    CHECK(generations(outcomes) == expected);
    CHECK(machine.take(after.sample(7, 0)).window_restarted); // a gap
    CHECK(machine.take(after.sample(7, 1)).generations == 0);
}

TEST_CASE("below the gate nothing moves") {
    Machine machine = machine_in(Configuration::a, boom);
    feed(machine, {Configuration::a, boom, healthy}, 0);
    double found = estimate_of(machine, boom, hydraulics::Link::boom).compliance_in3_per_psi().value();
    CHECK(estimate_of(machine, boom, hydraulics::Link::boom).excited());
    std::vector<Genome> population = machine.sets().at(boom).state().population;
    Transient slow(Configuration::a, boom, {0.03, 0.03, 0.03, 0.03});
    slow.slope_psi_per_s.fill(700);
    slow.curvature_psi_per_s2 = 0;
    for (const SampleOutcome& outcome : feed(machine, slow, 10))
        CHECK(outcome.generations == 0);
    CHECK(estimate_of(machine, boom, hydraulics::Link::boom).compliance_in3_per_psi() == found);
    CHECK_FALSE(estimate_of(machine, boom, hydraulics::Link::boom).excited());
    CHECK(estimate_of(machine, boom, hydraulics::Link::boom).state().excitation_psi_per_s == doctest::Approx(700));
    CHECK(machine.sets().at(boom).state().population == population);
}

TEST_CASE("a link below the gate keeps its column of a common population") {
    Machine machine = machine_in(Configuration::a, bucket_boom);
    feed(machine, {Configuration::a, bucket_boom, healthy}, 0);
    auto columns = [&](std::size_t first) {
        std::vector<std::uint64_t> codes;
        for (const Genome& genome : machine.sets().at(bucket_boom).state().population)
            codes.push_back(genome.field(first, 10));
        return codes;
    };
    auto bucket_codes = columns(0), boom_codes = columns(10);
    Transient half(Configuration::a, bucket_boom, healthy);
    half.slope_psi_per_s[index_of(hydraulics::Link::bucket)] = 500;
    half.curvature_psi_per_s2 = 0;
    auto outcomes = feed(machine, half, 10, 12); // the boom stays below the bucket
    CHECK(outcomes.back().generations == 5);
    CHECK(columns(0) == bucket_codes);
    CHECK(columns(10) != boom_codes);
}

TEST_CASE("a refused sample changes nothing") {
    Machine fresh("digger", {}, {}, 1);
    Transient transient(Configuration::a, boom, healthy);
    CHECK_THROWS_WITH_AS(fresh.take(transient.sample(0, 0)), doctest::Contains("before any configuration"), BadMessage);
    Machine machine = machine_in(Configuration::a, boom);
    feed(machine, transient, 0, 12);
    std::string before = text_of(machine);
    CHECK_THROWS_AS(machine.take(transient.sample(0, 11)), BadMessage); // the same time again
    CHECK_THROWS_AS(machine.take(transient.sample(0, 3)), BadMessage);
    CHECK_THROWS_WITH_AS(machine.take({5, {}}), doctest::Contains("missing"), BadMessage);
    CHECK(text_of(machine) == before);
    machine.connected(); // after another hello time may begin anew
    CHECK(machine.take(transient.sample(0, 0)).window_restarted);
}

TEST_CASE("a doubled compliance is told once, and its end") {
    Machine machine = machine_in(Configuration::a, boom);
    Transient good(Configuration::a, boom, healthy);
    PerLink<double> twice = healthy;
    twice[index_of(hydraulics::Link::boom)] *= 2;
    Transient bad(Configuration::a, boom, twice);
    feed(machine, good, 0);
    feed(machine, good, 10);
    CHECK(machine.alarms().empty());
    CHECK(off(machine.check(hydraulics::Link::boom).baseline_in3_per_psi, 0.0086) < 0.05);
    std::size_t raised = 0, cleared = 0;
    for (const SampleOutcome& outcome : feed(machine, bad, 20)) {
        raised += static_cast<std::size_t>(std::ranges::count(outcome.raised, AlarmKind::doubled, &Alarm::kind));
        cleared += outcome.cleared.size();
    }
    CHECK(raised == 1);
    CHECK(cleared == 0);
    for (const SampleOutcome& outcome : feed(machine, good, 30))
        cleared += static_cast<std::size_t>(std::ranges::count(outcome.cleared, AlarmKind::doubled, &Alarm::kind));
    CHECK(cleared == 1);
    CHECK(machine.alarms().empty());
}

TEST_CASE("sets that disagree are told") {
    Machine machine = machine_in(Configuration::a, bucket_boom);
    feed(machine, {Configuration::a, bucket_boom, healthy}, 0);
    machine.change({Configuration::b, bucket_boom});
    PerLink<double> other = healthy;
    other[index_of(hydraulics::Link::boom)] *= 1.5;
    feed(machine, {Configuration::b, bucket_boom, other}, 10);
    LinkCheck check = machine.check(hydraulics::Link::boom);
    REQUIRE(check.estimates.size() == 2);
    CHECK(check.spread() == doctest::Approx(0.5 / 1.25).epsilon(0.1));
    CHECK(std::ranges::count(machine.alarms(), Alarm{AlarmKind::inconsistent, boom, ""}) == 1);
    CHECK(std::ranges::count(machine.alarms(), Alarm{AlarmKind::inconsistent, bucket, ""}) == 0);
}

TEST_CASE("a machine of negative compliance is at its lower bound: drift") {
    Machine machine = machine_in(Configuration::a, boom);
    PerLink<double> negative = healthy;
    negative[index_of(hydraulics::Link::boom)] = -0.004;
    feed(machine, {Configuration::a, boom, negative}, 0);
    CHECK(std::ranges::count(machine.alarms(), Alarm{AlarmKind::drift, boom, ""}) == 1);
    CHECK_FALSE(machine.check(hydraulics::Link::boom).baseline_in3_per_psi); // no measure of health
}

TEST_CASE("the state goes through JSON and on as if nothing had been") {
    for (std::size_t cut : {0u, 3u, 7u, 12u, 29u}) {
        Machine machine = machine_in(Configuration::c, LinkSet::all());
        Transient transient(Configuration::c, LinkSet::all(), healthy);
        feed(machine, transient, 0, cut);
        boost::json::value stored = boost::json::parse(text_of(machine));
        Machine restored(state_from(stored, {}), {}, 1);
        CHECK(text_of(restored) == text_of(machine));
        for (std::size_t i = cut; i < 30; ++i) {
            machine.take(transient.sample(0, i));
            restored.take(transient.sample(0, i));
        }
        CHECK(text_of(restored) == text_of(machine));
    }
}

namespace {

SampleMessage boom_by_voltage(double time_s, double volts) {
    SampleMessage message{time_s, {}};
    message.links[index_of(hydraulics::Link::boom)] = Reading{1500, 0, ServoReading{volts}};
    return message;
}

double followed_spool_in(const Machine& machine) {
    return machine.state().tracks[index_of(hydraulics::Link::boom)].state().spool_in.value();
}

// A.1 at .3 V, and the spool at rest.
constexpr double raised_in = 0.0892 * 0.027 + 0.2352 * 0.09 + 0.2815 * 0.3 + 0.1297, rest_in = 0.1297;

} // namespace

TEST_CASE("the spool moves on over a gap, a change of configuration and a late sample, by the time that passed") {
    // From rest, .3 V from 1 s on; a_0 as in A.2.
    Machine machine = machine_in(Configuration::a, boom);
    double lag_per_s = machine.parameters().links[index_of(hydraulics::Link::boom)].spool_lag_per_s;
    auto way = [&](double elapsed_s) { return raised_in + (rest_in - raised_in) * std::exp(-lag_per_s * elapsed_s); };
    machine.take(boom_by_voltage(0.98, 0));
    machine.take(boom_by_voltage(1, 0.3));
    CHECK(followed_spool_in(machine) == doctest::Approx(rest_in));
    CHECK(machine.take(boom_by_voltage(1.1, 0.3)).window_restarted);
    CHECK(followed_spool_in(machine) == doctest::Approx(way(0.1)));
    machine.change({Configuration::b, boom});
    machine.take(boom_by_voltage(1.12, 0.3));
    CHECK(followed_spool_in(machine) == doctest::Approx(way(0.12)));
    machine.take(boom_by_voltage(1.1417, 0.3)); // within the jitter
    CHECK(followed_spool_in(machine) == doctest::Approx(way(0.1417)));
    machine.take(boom_by_voltage(1000, 0));
    CHECK(followed_spool_in(machine) == doctest::Approx(raised_in));
}

TEST_CASE("where its voltage was not told the spool starts at rest") {
    Machine machine = machine_in(Configuration::a, boom);
    machine.take(boom_by_voltage(1, 0));
    machine.connected(); // and time begins anew
    machine.take(boom_by_voltage(0, 0.3));
    CHECK(followed_spool_in(machine) == doctest::Approx(raised_in));
    machine.change({Configuration::a, bucket});
    machine.change({Configuration::a, boom});
    machine.take(boom_by_voltage(0.02, 0));
    CHECK(followed_spool_in(machine) == doctest::Approx(rest_in));
    SampleMessage by_spool = boom_by_voltage(0.04, 0);
    by_spool.links[index_of(hydraulics::Link::boom)]->valve = SpoolReading{0.2};
    machine.take(by_spool);
    machine.take(boom_by_voltage(0.06, 0.3));
    CHECK(followed_spool_in(machine) == doctest::Approx(raised_in));
}

TEST_CASE("the spool is followed from its voltage") {
    LinkTrack by_voltage, by_spool;
    LinkParameters parameters{716.8, 8};
    // A.2: at a step of the voltage the spool stays for one sample, then goes exp(-8 * .02) of the way a sample.
    double spool = 0.1297, desired = 0.0892 * 0.027 + 0.2352 * 0.09 + 0.2815 * 0.3 + 0.1297;
    for (int k = 0; k < 8; ++k) {
        by_voltage.push({1500, 0, ServoReading{k < 2 ? 0 : 0.3}}, parameters, 0.020);
        if (k > 2)
            spool = desired + (spool - desired) * 0.852143788966211;
        by_spool.push({1500, 0, SpoolReading{spool}}, parameters, 0.020);
    }
    REQUIRE(by_voltage.state().inlet_in2.size() == 5);
    for (std::size_t i = 0; i < 5; ++i)
        CHECK(by_voltage.state().bypass_in2[i] == doctest::Approx(by_spool.state().bypass_in2[i]).epsilon(1e-9));
}
