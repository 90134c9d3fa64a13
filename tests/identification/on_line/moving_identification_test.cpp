#include "identification/on_line/moving_identification.hpp"

#include "hydraulics/data/parameters.hpp"
#include "hydraulics/plant/moving_record.hpp"
#include "hydraulics/plant/requirement.hpp"
#include "tests/random_job.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

namespace {

/// Simulates the seed's job, which is the same for each period of the readings.
Record dug(std::uint64_t seed, const MeasurementNoise& noise, double boom_factor = 1, double period_s = 0.02) {
    Parameters parameters = Parameters::excavator();
    parameters.set("boom.inlet_compliance", boom_factor * parameters["boom.inlet_compliance"]);
    const DigJob job = random_job(seed, moving_excavator(parameters), 60);
    parameters.set("sensors.period", period_s);
    RandomStream random(seed, "sensors");
    return measure_moving(moving_excavator(parameters), job, noise, [&] { return random.uniform(); });
}

MovingIdentification identified(const Record& record, std::uint64_t seed = 1) {
    MovingIdentification moving(
        Parameters::excavator(), [](std::size_t links) { return whole_way(links); }, seed);
    moving.take(record);
    return moving;
}

struct Outcome {
    std::size_t answers = 0, near = 0, silent = 0; ///< silent: off by more than 10 % without a flag
};

/// Identifies the records of seeds to which nothing was tuned.
Outcome outcome(const MeasurementNoise& noise, std::uint64_t first, std::uint64_t last) {
    Outcome all;
    for (std::uint64_t seed = first; seed < last; ++seed)
        try {
            MovingIdentification moving = identified(dug(seed, noise));
            for (const LinkIdentified& link : combined_links(moving.sets())) {
                const double off = std::abs(link.compliance_in3_per_psi / moving.healthy_in3_per_psi(link.link) - 1);
                ++all.answers;
                all.near += off < 0.1;
                all.silent += off > 0.1 && link.flags.empty();
            }
        } catch (const UnfitScenario&) { // the soil lifts a load
        }
    return all;
}

/// Returns how often the configurations of twelve jobs are recognised in readings this far apart.
Recognition recognised(double period_s) {
    Recognition all;
    for (std::uint64_t seed = 400; seed < 412; ++seed)
        try {
            const Recognition one = identified(dug(seed, low_noise, 1, period_s)).recognition();
            all.judged += one.judged;
            all.right += one.right;
            all.changes += one.changes;
            all.soon += one.soon;
        } catch (const UnfitScenario&) { // the soil lifts a load
        }
    return all;
}

double share(std::size_t part, std::size_t whole) { return static_cast<double>(part) / static_cast<double>(whole); }

} // namespace

TEST_CASE("configurations are recognised in readings at 200 Hz as well as at 50 Hz") {
    const Recognition usual = recognised(0.02), quick = recognised(0.005);
    CHECK(usual.changes > 100);
    CHECK(share(quick.judged, usual.judged) == doctest::Approx(1).epsilon(0.001));
    constexpr double chance = 0.02; // in a single interval of several seconds, noise decides; it is 1 % of all samples
    CHECK(share(quick.right, quick.judged) > share(usual.right, usual.judged) - chance);
    CHECK(share(quick.soon, quick.changes) > share(usual.soon, usual.changes) - chance);
}

TEST_CASE("the compliances of a machine that digs are found within 10 %, or flagged") {
    for (const MeasurementNoise& noise : {no_noise, low_noise, mid_noise}) {
        const Outcome found = outcome(noise, 300, 308);
        CAPTURE(noise.pressure_psi);
        CHECK(found.answers >= 12);
        CHECK(static_cast<double>(found.near) > 0.85 * static_cast<double>(found.answers));
        CHECK(found.silent <= 1);
    }
}

TEST_CASE("cross-check 2 names a boom that has become softer, and no other link") {
    std::size_t boom = 0, other = 0;
    for (std::uint64_t seed = 310; seed < 318; ++seed)
        try {
            MovingIdentification moving = identified(dug(seed, low_noise, 1.5));
            PerLink<double> healthy;
            for (Link link : all_links)
                healthy[index_of(link)] = moving.healthy_in3_per_psi(link);
            const std::string text = locate_faults(combined_links(moving.sets()), healthy);
            boom += text.starts_with("boom: in all sets, the compliance differs by +") &&
                    text.ends_with("check the link's hose, cylinder and oil\n");
            for (std::string_view name : {"bucket:", "stick:", "swing:"})
                other += text.find(name) != std::string::npos;
        } catch (const UnfitScenario&) { // the soil lifts a load
        }
    CHECK(boom >= 2);
    CHECK(other == 0);
}

TEST_CASE("cross-check 1 flags a link whose sets disagree") {
    auto of = [](double compliance, double error) {
        LinkIdentified link{Link::boom, compliance, error};
        return link;
    };
    const SetAnswer alone{{Link::boom}, "a", 20, 1, {of(0.0086, 0.0001)}};
    const SetAnswer agrees{{Link::bucket, Link::boom}, "a", 20, 1, {of(0.0088, 0.0001)}};
    const SetAnswer differs{{Link::bucket, Link::boom}, "a", 20, 1, {of(0.0129, 0.0001)}};
    CHECK(combined_links({alone, agrees}).front().flags.empty());
    CHECK(combined_links({alone, differs}).front().flagged(FlagKind::inconsistent));
}

TEST_CASE("the same record and seed give the same answers; the column judges every sample") {
    const Record whole = dug(300, low_noise);
    MovingIdentification once = identified(whole), again = identified(whole);
    const auto first = once.sets(), second = again.sets();
    REQUIRE(first.size() == second.size());
    CHECK(first.size() >= 2);
    for (std::size_t i = 0; i < first.size(); ++i)
        for (std::size_t l = 0; l < first[i].links.size(); ++l)
            CHECK(first[i].links[l].compliance_in3_per_psi == second[i].links[l].compliance_in3_per_psi);
    CHECK(once.recognition().judged == whole.size());
}
