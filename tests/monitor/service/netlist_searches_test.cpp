#include "monitor/service/netlist_searches.hpp"

#include "hydraulics/plant/excavator_record.hpp"
#include "hydraulics/plant/excavator_values.hpp"
#include "hydraulics/plant/measurement.hpp"
#include "identification/on_line/record_samples.hpp"
#include "runtime/random.hpp"

#include <boost/asio/executor_work_guard.hpp>
#include <doctest/doctest.h>

#include <chrono>
#include <memory>
#include <utility>
#include <vector>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;
using namespace placedpar::monitor;

namespace {

Record measured_boom() {
    const ExcavatorScenario scenario = single_boom_scenario();
    RandomStream random(1, "noise");
    return measure_excavator(simulate_excavator(scenario), scenario, 0.020, low_noise,
                             [&] { return random.uniform(); });
}

/// A diagnosis whose movements are recorded. The search keeps what it is given.
struct Recorded {
    Recorded() { diagnosis.change({Configuration::a, {Link::boom}}); }

    /// Takes the rows of the record, then ends the movement.
    void move(const Record& record, double later_s = 0) {
        PerLink<LinkReader> readers;
        for (std::size_t i = 0; i < record.size(); ++i) {
            ExcavatorSample sample = sample_of(record, i, {Link::boom}, readers);
            sample.time_s += later_s;
            diagnosis.take(sample);
            searches->follow(diagnosis);
        }
        diagnosis.change({Configuration::a, {}});
        searches->follow(diagnosis);
        diagnosis.change({Configuration::a, {Link::boom}});
    }
    /// Waits until the answers of all searches have come.
    void wait(std::size_t answers) {
        while (told.size() < answers && io.run_one_for(std::chrono::seconds(60)) > 0) {
        }
    }

    boost::asio::io_context io;
    std::vector<ComplianceSearch> searched;
    std::vector<NetlistAnswer> told;
    Diagnosis diagnosis{"digger", excavator_parameters(Parameters::excavator()), DiagnosisSettings{}, 1};
    std::unique_ptr<NetlistSearches> searches = std::make_unique<NetlistSearches>(
        [this](ComplianceSearch search, double) {
            searched.push_back(std::move(search));
            return AnswerInTime{{0.0086}, "master"};
        },
        10, io, [this](const NetlistAnswer& answer) { told.push_back(answer); });
};

} // namespace

TEST_CASE("a movement is searched with the samples that identify makes of its readings") {
    Recorded recorded;
    const auto work = boost::asio::make_work_guard(recorded.io);
    const Record record = measured_boom();
    for (double later_s : {0.0, 100.0})
        recorded.move(record, later_s);
    recorded.wait(2);
    REQUIRE(recorded.searched.size() == 2);
    const Parameters& machine = Parameters::excavator();
    const auto expected = circuit_samples(record, boom_circuit(), link_calibrations(machine));
    for (const ComplianceSearch& search : recorded.searched) {
        REQUIRE(search.samples.size() > 20);
        const auto usable = usable_samples(search.samples, boom_circuit(), flow_constants(machine)),
                   of_record = usable_samples(expected, boom_circuit(), flow_constants(machine));
        REQUIRE(usable.size() == of_record.size());
        for (std::size_t i = 0; i < usable.size(); ++i)
            CHECK(usable[i].links == of_record[i].links);
    }
    CHECK(recorded.told[1].from_s == doctest::Approx(100));
    CHECK(recorded.searches->answers("digger").size() == 1);
}

TEST_CASE("a machine that was forgotten meanwhile gets no answer") {
    Recorded recorded;
    const auto work = boost::asio::make_work_guard(recorded.io);
    recorded.move(measured_boom());
    recorded.searches->forget("digger");
    recorded.move(measured_boom(), 100); // the same name, another machine
    recorded.wait(1);
    recorded.io.poll();
    REQUIRE(recorded.told.size() == 1);
    CHECK(recorded.told.front().from_s == doctest::Approx(100));
    CHECK(recorded.searches->answers("other").empty());
}
