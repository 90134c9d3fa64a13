#include "hydraulics/plant/excavator_record.hpp"
#include "hydraulics/plant/excavator_values.hpp"
#include "hydraulics/plant/record_scenario.hpp"
#include "identification/compliance_fit.hpp"
#include "identification/flow_weights.hpp"
#include "identification/whole_search.hpp"
#include "runtime/random.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

namespace {

struct Group {
    Configuration configuration;
    LinkSet links;
    std::size_t size;
};

const std::vector<Group> groups{{Configuration::a, {Link::bucket, Link::boom}, 2},
                                {Configuration::b, {Link::boom, Link::stick, Link::swing}, 3},
                                {Configuration::c, {Link::bucket, Link::boom, Link::stick}, 3},
                                {Configuration::d, LinkSet::all(), 4},
                                {Configuration::e, LinkSet::all(), 4}};

Record record_of(const Group& group, const char* noise, const ExcavatorMotion& motion, std::uint64_t seed) {
    Parameters machine = Parameters::excavator();
    for (const Parameter& row : noise_rows(machine, noise))
        machine.put(row);
    RandomStream sensors(seed, "sensors");
    return measure_excavator(motion, step_scenario(group.configuration, group.links, machine),
                             machine["sensors.period"], measurement_noise(machine), [&] { return sensors.uniform(); });
}

ExcavatorMotion motion_of(const Group& group) {
    return simulate_excavator(step_scenario(group.configuration, group.links, Parameters::excavator()));
}

ComplianceSearch search_of(const Group& group, const Record& record, const WholeWay& whole) {
    return prepare(record, Parameters::excavator(), {group.configuration, group.links, {}, {}}, whole.way);
}

bool within_ten_percent(const Identified& found) {
    return std::ranges::all_of(found.links, [](const LinkIdentified& link) {
        const double right = Parameters::excavator()[std::string(name_of(link.link)) + ".inlet_compliance"];
        return std::abs(link.compliance_in3_per_psi / right - 1) <= 0.1;
    });
}

/// Counts the seeds from 1 on with all links within 10 %, and checks that the others are flagged.
int right_of(const Group& group, const char* noise, std::size_t samples, int seeds) {
    const ExcavatorMotion motion = motion_of(group);
    WholeWay whole = whole_way(group.size);
    whole.way.usable.count = samples;
    int right = 0;
    for (int seed = 1; seed <= seeds; ++seed) {
        const auto number = static_cast<std::uint64_t>(seed);
        const ComplianceSearch search = search_of(group, record_of(group, noise, motion, number), whole);
        const Identified found = identify_whole(search, whole, number);
        const bool within = within_ten_percent(found);
        right += within;
        CHECK((within || found.flagged()));
    }
    MESSAGE(std::string(1, name_of(group.configuration)), ", ", std::string(noise), " noise: ", right, " of ", seeds);
    return right;
}

} // namespace

TEST_CASE("all links of every configuration are found within 10 % over the whole movement at low noise") {
    for (const Group& group : groups)
        CHECK(right_of(group, "low", 1024, 3) == 3);
}

TEST_CASE("all links of every configuration are found without noise over the thesis's window of 10 samples") {
    for (const Group& group : groups)
        CHECK(right_of(group, "none", 10, 5) >= 4);
}

TEST_CASE("for the swing in configuration e, weighed least squares has a quarter of the standard error of plain least "
          "squares") {
    const Group& all = groups.back();
    const WholeWay whole = whole_way(all.size);
    const ComplianceSearch search = search_of(all, record_of(all, "low", motion_of(all), 1), whole);
    const std::vector<double> start(4, 0.007);
    const auto plain = fit_compliances(search.problem.circuit(), search.samples, search.flow, start);
    const auto weighed = fit_weighed_compliances(search.problem.circuit(), search.samples, search.flow, start);
    REQUIRE(plain);
    REQUIRE(weighed);
    CHECK(weighed->standard_error[0] < plain->standard_error[0] / 4);
}

TEST_CASE("scaled flows are uncorrelated and have the requested mean square") {
    const Group& all = groups.back();
    const WholeWay whole = whole_way(all.size);
    const ComplianceSearch search = search_of(all, record_of(all, "high", motion_of(all), 1), whole);
    const std::vector<double> compliance(4, 0.007);
    const FlowWeights weights = weights_at(search.problem.circuit(), search.samples, search.flow, compliance, 100);
    double squares = 0, products = 0;
    for (const CircuitSample& sample : search.samples) {
        auto scaled =
            weights.scaled<double>(missing_flows_in3_per_s<double>(search.problem.circuit(), compliance, sample.links,
                                                                   search.flow, InletFlow::as_signed),
                                   4);
        for (std::size_t j = 0; j < 4; ++j)
            squares += scaled[j] * scaled[j] / static_cast<double>(search.samples.size());
        products += scaled[0] * scaled[3] / static_cast<double>(search.samples.size());
    }
    CHECK(squares == doctest::Approx(100).epsilon(0.05));
    CHECK(std::abs(products) < 2);
}

TEST_CASE("the cost of a search on T800s follows from Table E.1's workload") {
    const WholeWay whole = whole_way(2);
    const ComplianceSearch search = search_of(groups[0], record_of(groups[0], "none", motion_of(groups[0]), 1), whole);
    const SearchCost cost = cost_of(whole, search.problem, 10, 100);
    // 1,200 individuals, 100 samples, two junctions, 24 bits
    CHECK(cost.individuals == whole.way.search.population * 10);
    CHECK(cost.errors == cost.individuals * 100);
    CHECK(cost.seconds == doctest::Approx(cost.errors * 2 * 72e-6 + cost.individuals * 87.5e-6 * 2.4));
    CHECK(cost.seconds_on_16 > cost.seconds / 16);
}

TEST_CASE("a record that is too short is refused") {
    const WholeWay whole = whole_way(2);
    ComplianceSearch search = search_of(groups[0], record_of(groups[0], "none", motion_of(groups[0]), 1), whole);
    search.samples.resize(3);
    CHECK_THROWS_AS(identify_whole(search, whole, 1), UnfitRecord);
}
