#include "identification/on_line/moving_diagnosis.hpp"

#include "identification/on_line/refused_sample.hpp"
#include "tests/identification/on_line/digging.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

namespace {

/// What the diagnoses of several machines found.
struct Diagnosed {
    std::size_t machines = 0;
    std::size_t named = 0;   ///< machines with an alarm for the expected fault
    std::size_t accused = 0; ///< machines with another alarm
    std::size_t samples = 0, recognised = 0;
    std::size_t changes = 0, soon = 0; ///< changes of configuration, and those recognised within two samples
};

/// Counts the samples and the changes of configuration that are recognised.
class Recognised {
public:
    void take(char truth, char found, Diagnosed& all) {
        if (last_ && truth != *last_) {
            ++all.changes;
            awaited_until_ = all.samples + 3;
        }
        last_ = truth;
        all.recognised += found == truth;
        if (found == truth && all.samples < awaited_until_) {
            ++all.soon;
            awaited_until_ = 0;
        }
        ++all.samples;
    }

private:
    std::optional<char> last_;
    std::size_t awaited_until_ = 0;
};

/// Diagnoses one machine. `fault` is the beginning of the expected alarm's text, "" for a sound machine.
void diagnose(const Record& record, std::uint64_t seed, const std::string& fault, Diagnosed& all) {
    Diagnosis diagnosis = recognising(seed);
    Recognised recognised;
    bool named = false, accused = false;
    for (std::size_t i = 0; i < record.size(); ++i) {
        for (const Alarm& alarm : diagnosis.take(sample_at(record, i)).raised)
            (!fault.empty() && alarm.text.starts_with(fault) ? named : accused) = true;
        recognised.take(record.configuration[i], name_of(*diagnosis.configuration()), all);
    }
    ++all.machines;
    all.named += named;
    all.accused += accused;
}

/// Diagnoses the machines of these seeds whose jobs are fit.
Diagnosed diagnosed(std::uint64_t first, std::uint64_t last, const Digger& digger) {
    const std::string sign = digger.factor > 1 ? "+" : "-";
    const std::string fault =
        digger.factor == 1 ? "" : fmt::format("{}: the compliance has changed by {}", digger.link, sign);
    Diagnosed all;
    for (std::uint64_t seed = first; seed < last; ++seed)
        try {
            diagnose(dug(seed, digger), seed, fault, all);
        } catch (const UnfitScenario&) {
        }
    return all;
}

double percent(std::size_t part, std::size_t whole) {
    return 100 * static_cast<double>(part) / static_cast<double>(whole);
}

} // namespace

TEST_CASE("a sound machine that digs raises no alarm, and its configuration is recognised") {
    const Diagnosed sound = diagnosed(400, 412, {});
    CHECK(sound.machines >= 5);
    CHECK(sound.accused == 0);
    CHECK(percent(sound.recognised, sound.samples) > 99);
    CHECK(percent(sound.soon, sound.changes) > 95);
}

TEST_CASE("cross-check 2 raises an alarm for a boom that has become softer, and for nothing else") {
    const Diagnosed soft = diagnosed(420, 436, {.factor = 1.5});
    CHECK(2 * soft.named > soft.machines);
    CHECK(soft.accused == 0);
}

TEST_CASE("the table of docs/guides/monitor.md" * doctest::skip()) { // takes ten minutes
    auto row = [](const std::string& machines, std::uint64_t first, Digger digger) {
        digger.seconds = 120;
        const Diagnosed found = diagnosed(first, first + (digger.factor == 1 ? 130 : 60), digger);
        MESSAGE(machines << ": " << found.machines << ", right " << found.named << ", wrong " << found.accused
                         << "; recognised " << percent(found.recognised, found.samples) << " %, changes within two "
                         << "samples " << percent(found.soon, found.changes) << " %");
        CHECK(found.accused == 0);
    };
    row("sound, low noise", 4000, {});
    row("sound, medium noise", 4200, {.noise = mid_noise});
    row("boom 1.5, low noise", 4400, {.factor = 1.5});
    row("bucket .7, medium noise", 4500, {"bucket", 0.7, mid_noise});
    row("swing 1.4, medium noise", 4600, {"swing", 1.4, mid_noise});
}

TEST_CASE("a diagnosis that recognises configurations is restored in the middle of its work") {
    const Record record = dug(400);
    Diagnosis diagnosis = recognising();
    for (std::size_t i = 0; i < record.size(); ++i) {
        if (i % 100 == 99) {
            const Diagnosis::State state = diagnosis.state();
            REQUIRE(state.moving);
            Diagnosis restored(state, {}, 1);
            CHECK(restored.state() == state);
            for (Link link : all_links)
                CHECK(restored.verdict(link).verdict.deviation == diagnosis.verdict(link).verdict.deviation);
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
    const Record record = dug(400);
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

TEST_CASE("an impossible reading in the sample of a round is an alarm, too") {
    const Record record = dug(400);
    Diagnosis diagnosis = recognising();
    std::optional<std::size_t> round;
    for (std::size_t i = 0; i < record.size() && !round; ++i)
        if (diagnosis.take(sample_at(record, i)).generations > 0)
            round = i;
    REQUIRE(round);
    const LinkSet set = diagnosis.estimates().front().set;
    const Link link = links_of(set).front();
    Diagnosis struck = recognising();
    for (std::size_t i = 0; i < *round; ++i)
        struck.take(sample_at(record, i));
    ExcavatorSample sample = sample_at(record, *round);
    sample.links[index_of(link)]->inlet_psi = vacuum_psi - 1;
    const SampleOutcome outcome = struck.take(sample);
    REQUIRE(outcome.raised.size() == 1);
    CHECK(outcome.raised.front() == Alarm{AlarmKind::sensor, {link}, ""});
}

TEST_CASE("an alarm of a recognised configuration ends with the recognition") {
    const Digger soft{.factor = 1.5};
    std::size_t alarms = 0;
    for (std::uint64_t seed = 420; seed < 436; ++seed)
        try {
            const Record record = dug(seed, soft);
            Diagnosis diagnosis = recognising(seed);
            for (std::size_t i = 0; i < record.size(); ++i)
                diagnosis.take(sample_at(record, i));
            const std::vector<Alarm> before = diagnosis.alarms();
            const SampleOutcome outcome = diagnosis.change(ConfigurationChange{Configuration::a, {Link::boom}});
            CHECK(outcome.cleared == before);
            CHECK(diagnosis.alarms().empty());
            alarms += before.size();
        } catch (const UnfitScenario&) {
        }
    CHECK(alarms > 0);
}

TEST_CASE("a machine is recognised only if its samples are about 20 ms apart") {
    for (const auto& [period_s, suits] : {std::pair{0.001, true},
                                          {0.005, true},
                                          {0.01, true},
                                          {0.012, true},
                                          {0.014, false},
                                          {0.02, true},
                                          {0.025, true},
                                          {0.026, false},
                                          {0.1, false}}) {
        ExcavatorParameters parameters = excavator_parameters(Parameters::excavator());
        parameters.period_s = period_s;
        CAPTURE(period_s);
        CHECK(Diagnosis("digger", parameters, {}, 1).can_recognise() == suits);
    }
}

TEST_CASE("all links must be read while the configuration is recognised") {
    const Record record = dug(400, {.seconds = 1});
    Diagnosis diagnosis = recognising();
    ExcavatorSample sample = sample_at(record, 0);
    sample.links[index_of(Link::stick)].reset();
    CHECK_THROWS_AS(diagnosis.take(sample), RefusedSample);
    CHECK(diagnosis.samples() == 0);
}

TEST_CASE("a reported configuration ends the recognition") {
    const Record record = dug(400, {.seconds = 30});
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
