#include "boom_records.hpp"
#include "gaprocs/search_problem.hpp"
#include "gaprocs/traditional.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <stdexcept>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

TEST_CASE("thesis_way() is the traditional genetic algorithm over the usable samples, to the bit") {
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

TEST_CASE("a record at rest is refused with the number of usable samples") {
    Record record = boom_measured(1.5, no_noise, 1);
    for (double& spool : record.of(Link::boom, Sensor::spool))
        spool = 0.1297;
    CHECK_THROWS_WITH_AS(identify_boom(record, thesis_way(), 1),
                         "0 usable samples, expected at least 5: the transient after the valve opens, in which "
                         "the pressure rises faster than 150 psi/s, is too short or missing",
                         UnfitRecord);
}

TEST_CASE("links that are not coupled cannot be identified together") {
    Record record = boom_measured(1.5, no_noise, 1);
    Question question{Configuration::a, {Link::boom, Link::stick}, {}};
    CHECK_THROWS_WITH_AS(prepare(record, Parameters::excavator(), question, thesis_way()),
                         "boom,stick are not hydraulically coupled in configuration a: identify each link separately",
                         UserError);
}
