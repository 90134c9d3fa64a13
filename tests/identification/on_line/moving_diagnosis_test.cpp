#include "identification/on_line/moving_diagnosis.hpp"

#include "identification/on_line/refused_sample.hpp"
#include "tests/identification/on_line/digging.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

namespace {

/// What the diagnoses of several machines found.
struct Outcome {
    std::size_t machines = 0;
    std::size_t named = 0;   ///< machines with an alarm for the expected fault
    std::size_t accused = 0; ///< machines with another alarm
    std::size_t samples = 0, recognised = 0;
    std::size_t changes = 0, soon = 0; ///< changes of configuration, and those recognised within two samples
};

/// Counts the samples and the changes of configuration that are recognised.
class Recognised {
public:
    void take(char truth, char found, Outcome& all) {
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

/// Diagnoses one machine. `fault` is the beginning of the alarm's text; "": there is no fault.
void diagnose(const Record& record, std::uint64_t seed, const std::string& fault, Outcome& all) {
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
Outcome outcome(std::uint64_t first, std::uint64_t last, const Digger& digger) {
    const std::string sign = digger.factor > 1 ? "+" : "-";
    const std::string fault =
        digger.factor == 1 ? "" : fmt::format("{}: the compliance has changed by {}", digger.link, sign);
    Outcome all;
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
    const Outcome sound = outcome(400, 412, {});
    CHECK(sound.machines >= 5);
    CHECK(sound.accused == 0);
    CHECK(percent(sound.recognised, sound.samples) > 97);
    CHECK(percent(sound.soon, sound.changes) > 90);
}

TEST_CASE("cross-check 2 raises an alarm for a boom that has become softer, and for nothing else") {
    const Outcome soft = outcome(420, 436, {.factor = 1.5});
    CHECK(2 * soft.named > soft.machines);
    CHECK(soft.accused == 0);
}

TEST_CASE("the table of docs/guides/monitor.md" * doctest::skip()) { // takes ten minutes
    auto row = [](const char* machines, std::uint64_t first, Digger digger) {
        digger.seconds = 120;
        const Outcome found = outcome(first, first + (digger.factor == 1 ? 130 : 60), digger);
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
    const Record record = dug(400, {.seconds = 30});
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
