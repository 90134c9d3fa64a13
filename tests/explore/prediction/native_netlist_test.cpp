// Tests the description of native runs as netlists.

#include "explore/prediction/calibration.hpp"
#include "explore/prediction/native_netlist.hpp"

#include "explore/load.hpp"
#include "explore/problems.hpp"
#include "tests/seeds.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numeric>
#include <random>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

using namespace placedpar;

namespace {

/// A calibration with known costs, in a file.
class KnownCalibration {
public:
    KnownCalibration() {
        Calibration known;
        known.processor = "known";
        known.date = "2026-11-29";
        known.repetitions = 15;
        known.threads.switching.median = 40;
        known.threads.there_and_back.median = 120;
        known.threads.across.median = 680;
        known.across_asleep.median = 680 + 2 * 50'000;
        known.threads.kilobyte.median = 1024;
        known.string.median = 60;
        known.ranks = known.threads;
        known.ranks->across.median = 2040;
        known.oversleeping.median = 55'000;
        known.problems.push_back({"sphere", {1000, 1000, 1000}, {500, 500, 500}});
        std::ofstream(path_) << print_calibration(known);
    }
    /// A file with another text.
    explicit KnownCalibration(const std::string& text, const std::string& ending = ".inc")
        : path_(std::filesystem::temp_directory_path() / ("changed_" + std::to_string(getpid()) + ending)) {
        std::ofstream(path_) << text;
    }
    ~KnownCalibration() { std::filesystem::remove(path_); }
    KnownCalibration(const KnownCalibration&) = delete;
    KnownCalibration& operator=(const KnownCalibration&) = delete;
    const std::filesystem::path& path() const { return path_; }
    std::string text() const {
        std::ifstream file(path_);
        return {std::istreambuf_iterator<char>(file), {}};
    }

private:
    std::filesystem::path path_ =
        std::filesystem::temp_directory_path() / ("calibration_" + std::to_string(getpid()) + ".inc");
};

Network network_of_text(const std::string& text) {
    const ProblemRegistry problems = known_problems(1);
    return load_network(ParsedNetlist::of_text(text), {}, known_kinds(problems), [](const std::string&) {});
}

/// Returns islands without exchange, each on a transputer of its own.
std::string islands_apart(int number, const std::string& problem = "sphere") {
    return "val n " + std::to_string(number) +
           ";\nworkstation w[n]; rep i = 0 for n - 1 connect w[0].link[i] to w[i + 1].link[0];\n"
           "process host, thread[n]; use \"ga.host\" for host; host (problem = \"" +
           problem +
           "\", generations = 10);\n"
           "rep i = 0 for n { use \"ga.master\" for thread[i]; place thread[i] on w[i];\n"
           "thread[i] (problem = \"" +
           problem +
           "\", population = 20, rehearsals = 0);\n"
           "connect host.to_masters[i] to thread[i].from_host; }\nplace host on w[0];\n";
}

RunReport run_predicted(const Network& network) { return run_netlist(network, known_problems(1), {}); }

} // namespace

TEST_CASE("the interval of a median comes from order statistics") {
    std::vector<double> values(15);
    std::iota(values.begin(), values.end(), 1.0);
    std::ranges::reverse(values);
    const MeasuredCost cost = cost_of(values);
    CHECK(cost.median == 8);
    CHECK(cost.low == 4); // the probability that 3 or fewer of 15 are less than the median is 0.018
    CHECK(cost.high == 12);
    CHECK(cost_of({6, 1, 5, 2, 4, 3}).median == 3.5);
    CHECK(cost_of({6, 1, 5, 2, 4, 3}).low == 1);
    CHECK(cost_of({6, 1, 5, 2, 4, 3}).high == 6);
}

TEST_CASE("each problem has its own val") {
    CHECK(val_of_problem("error", "boom-by-voltage") == "error_boom_by_voltage");
    CHECK(val_of_problem("error", "costly(work = 100)") == "error_costly_work_100");
    CHECK(val_of_problem("error", "quartic(noise = 0.5)") == "error_quartic_noise_0_point_5");
}

TEST_CASE("a search costs what the calibration says") {
    const KnownCalibration calibration;
    const RunReport report =
        run_predicted(network_of_text(native_netlist(network_of_text(islands_apart(1)), {}, calibration.path())));
    CHECK(report.measured("thread[0]", "P_time2") == doctest::Approx(20 * 1000e-6)); // ms
    CHECK(report.measured("thread[0]", "S_time2") == doctest::Approx(20 * 500e-6));
}

TEST_CASE("the prediction makes the generations of the netlist, on as many cores as there are threads") {
    const KnownCalibration calibration;
    const Network stated = network_of_text(islands_apart(4));
    const RunReport expected = run_predicted(stated);
    constexpr Time work = std::chrono::microseconds(4 * 10 * 20) * 3 / 2; // evaluating and breeding
    Time last = Time::max();
    for (std::size_t threads = 1; threads <= 4; ++threads) {
        const Network native = network_of_text(native_netlist(stated, {.count = threads}, calibration.path()));
        const RunReport report = run_predicted(native);
        CHECK(report.processors.size() == threads);
        for (const char* island : {"thread[0]", "thread[3]"})
            CHECK(report.measured_text(island, "populations") == expected.measured_text(island, "populations"));
        CHECK(report.result.time >= work / static_cast<std::int64_t>(threads));
        if (threads <= 2) // with more, the messages of the host take longer than generations of 30 us
            CHECK(report.result.time < std::exchange(last, report.result.time));
    }
}

TEST_CASE("predictions for many numbers of threads are those for each") {
    const KnownCalibration calibration;
    const Network stated = network_of_text(islands_apart(4));
    const Interruption none;
    using enum PredictedPlaces::Kind;
    Time on_two_threads{}, on_two_ranks{};
    for (const auto kind : {threads, ranks}) {
        const std::vector<PredictedTime> times = predict_times(stated, kind, calibration.path(), 1, none);
        REQUIRE(times.size() == 4);
        for (const PredictedTime& each : times)
            CHECK(each.time ==
                  run_predicted(network_of_text(native_netlist(stated, {kind, each.places}, calibration.path())))
                      .result.time);
        (kind == threads ? on_two_threads : on_two_ranks) = times[1].time;
    }
    CHECK(on_two_ranks > on_two_threads); // their messages cost three times as much
}

TEST_CASE("a calibration that does not fit is refused") {
    const KnownCalibration calibration;
    CHECK_THROWS_WITH_AS(native_netlist(network_of_text(islands_apart(2, "step")), {.count = 2}, calibration.path()),
                         (calibration.path().string() +
                          ": the file has no cost of the problem \"step\": write it by "
                          "placedpar calibrate NETLIST -o " +
                          calibration.path().string())
                             .c_str(),
                         UserError);
    CHECK_THROWS_AS(native_netlist(network_of_text(islands_apart(2)), {}, "no such file.inc"), UserError);
}

/// Returns why a prediction is refused; "" if it is made.
std::string why_refused(const std::filesystem::path& calibration, const PredictedPlaces& places = {}) {
    try {
        network_of_text(native_netlist(network_of_text(islands_apart(2)), places, calibration));
    } catch (const UserError& refused) {
        return refused.what();
    }
    return "";
}

TEST_CASE("what a calibration only mentions does not count as there") {
    const std::string text = KnownCalibration().text();
    const std::string val = "val error_sphere 10000;";
    REQUIRE(text.find(val) != std::string::npos);
    std::string commented = text;
    commented.replace(text.find(val), val.size(), "/* " + val + " */");
    CHECK(why_refused(KnownCalibration(text).path()) == "");
    CHECK(why_refused(KnownCalibration(commented).path()).find("the file has no cost of the problem \"sphere\"") !=
          std::string::npos);
}

TEST_CASE("a calibration of threads alone has no ranks, and a broken one is shown with the place of its error") {
    const std::string text = KnownCalibration().text();
    const std::size_t ranks = text.find("/* the ranks of mpirun");
    const KnownCalibration only_threads(text.substr(0, ranks) + text.substr(text.find("val individual_bytes")));
    CHECK(why_refused(only_threads.path()) == "");
    CHECK(why_refused(only_threads.path(), {PredictedPlaces::Kind::ranks, 2})
              .find("the file does not describe ranks: write it by mpirun -n 2 placedpar calibrate NETLIST -o ") !=
          std::string::npos);
    CHECK(why_refused(KnownCalibration("define core (clock = 1.5.2) this_core;").path()).find(".inc:1:") !=
          std::string::npos);
}

TEST_CASE("a path that the language cannot write is refused") {
    CHECK(why_refused(KnownCalibration(KnownCalibration().text(), "\".inc").path()).find("quotation mark") !=
          std::string::npos);
}

TEST_CASE("a calibration with random changes is accepted or refused, and no more") {
    const std::string text = KnownCalibration().text();
    const std::string pieces[] = {"",          "0",  "-1",  "99999999999999999999", "*/", "/*", "\"", ";", "val ",
                                  "this_core", "\n", "\xff"};
    std::size_t refused = 0;
    constexpr std::uint64_t changed = 200;
    for (const std::uint64_t seed : test::seeds(changed)) {
        INFO(test::replay(seed));
        std::mt19937_64 random(seed);
        std::string edited = text;
        for (std::size_t edits = 1 + random() % 3; edits > 0; --edits)
            edited.replace(random() % edited.size(), random() % 12, pieces[random() % std::size(pieces)]);
        refused += why_refused(KnownCalibration(edited).path(), {PredictedPlaces::Kind::ranks, 2}).empty() ? 0 : 1;
    }
    if (test::all_seeds())
        CHECK(refused > changed / 4);
}

TEST_CASE("the problems of a netlist are listed once") {
    CHECK(problems_of(network_of_text(islands_apart(3))) == std::vector<std::string>{"sphere"});
}
