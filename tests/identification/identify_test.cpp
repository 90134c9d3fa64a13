#include "boom_records.hpp"
#include "gaprocs/search_problem.hpp"
#include "gaprocs/traditional.hpp"
#include "identification/statistics.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <stdexcept>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

TEST_CASE("the thesis's way is the traditional genetic algorithm over the usable samples, to the bit") {
    Record record = boom_measured(1.5, low_noise, 7);
    ComplianceSearch prepared = prepare(record, Parameters::excavator(), {}, thesis_way());
    std::vector<Sample> samples;
    for (const CircuitSample& sample : prepared.samples)
        samples.push_back(sample.values());
    SearchResult traditional =
        run_traditional(*make_search_problem(prepared.problem), samples, {}, RandomStream(7, "master"));
    Identified identified = identify(prepared.problem, prepared.flow, prepared.samples, thesis_way(), 7);
    REQUIRE(identified.estimates.size() == traditional.estimates.size());
    for (std::size_t i = 0; i < identified.estimates.size(); ++i)
        CHECK(identified.estimates[i].compliance_in3_per_psi == traditional.estimates[i].parameters);
    CHECK(identified.generations == traditional.generations);
}

TEST_CASE("the service way: within 6 % at low and 12 % at mid noise, for 9 seeds of 10") {
    std::vector<double> low, mid;
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        auto error = [&](const MeasurementNoise& noise) {
            Identified identified = identify_boom(boom_measured(1.5, noise, seed), service_way(), seed);
            return error_percent(identified.links[0].compliance_in3_per_psi, 0.0086);
        };
        low.push_back(error(low_noise));
        mid.push_back(error(mid_noise));
    }
    CHECK(quantile(low, 0.9) <= 6);
    CHECK(quantile(mid, 0.9) <= 12);
}

TEST_CASE("the service way: 21 searches, from the third sample after the opening, with a gate") {
    Record record = boom_measured(4, low_noise, 3);
    IdentificationWay thesis = thesis_way(), service = service_way();
    thesis.usable.count = service.usable.count = 150;
    auto first_of = [&](const IdentificationWay& way) {
        return prepare(record, Parameters::excavator(), {}, way).samples.at(0).index;
    };
    CHECK(first_of(service) == first_of(thesis) + 2);
    Identified identified = identify_boom(record, service, 3);
    std::uint64_t live = 0;
    for (const TransientEstimate& estimate : identified.estimates)
        live += !estimate.frozen;
    CHECK(identified.estimates.back().frozen);
    // Each search freezes by its own answer, at about the same sample.
    CHECK(identified.generations > 20 * 5 * live);
    CHECK(identified.generations < 22 * 5 * live);
    CHECK(identify_boom(record, thesis, 3).generations == 5 * 146);
}

TEST_CASE("compliances from .0043 to .07 are followed") {
    for (double truth : {0.0043, 0.0172, 0.0344, 0.07})
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            Identified identified = identify_boom(boom_measured(2.5, low_noise, seed, truth), service_way(), seed);
            CAPTURE(truth);
            CHECK(error_percent(identified.links[0].compliance_in3_per_psi, truth) < 10);
        }
}

TEST_CASE("a record at rest is refused, with what is missing") {
    Record record = boom_measured(1.5, no_noise, 1);
    for (double& spool : record.of(Link::boom, Sensor::spool))
        spool = 0.1297;
    CHECK_THROWS_WITH_AS(identify_boom(record, thesis_way(), 1),
                         "0 usable samples, expected at least 5: the transient after the valve opens, with the "
                         "pressure rising faster than 150 psi/s, is too short or not in the record",
                         UnfitRecord);
}

TEST_CASE("links that are not coupled cannot be identified together") {
    Record record = boom_measured(1.5, no_noise, 1);
    Question question{Configuration::a, {Link::boom, Link::stick}, {}};
    CHECK_THROWS_WITH_AS(prepare(record, Parameters::excavator(), question, thesis_way()),
                         "boom,stick are not coupled with each other in configuration a: identify them one by one",
                         UserError);
}
