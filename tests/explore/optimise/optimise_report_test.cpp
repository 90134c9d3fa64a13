#include "explore/optimise/optimise_report.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

using namespace placedpar;

namespace {

/// Returns a course through machines 0, 1, 2 ... of these costs; machines without costs cannot be built.
SearchCourse course_of(const std::string& way, const std::vector<std::vector<double>>& costs) {
    SearchCourse course{.way = way};
    for (std::uint64_t machine = 0; const std::vector<double>& each : costs) {
        course.machines.push_back(machine);
        course.merits.push_back({!each.empty(), each});
        course.tried.insert(machine++);
    }
    return course;
}

Optimum optimum_of(std::vector<std::string> measures, std::vector<SearchCourse> courses) {
    Optimum optimum{.measures = std::move(measures), .start = {}, .courses = std::move(courses)};
    optimum.start.merit = {true, std::vector<double>(optimum.measures.size(), 10)};
    return optimum;
}

} // namespace

TEST_CASE("with one cost the best few machines are shown, the best first, one machine for each value of the cost") {
    const SearchCourse course = course_of("genetic", {{5}, {3}, {}, {3}, {9}, {8}, {7}, {6}, {4}});
    CHECK(best_of(course) == std::vector<std::size_t>{1, 8, 0, 7, 6}); // their costs are 3, 4, 5, 6, 7
    CHECK(best_of(course_of("genetic", {{}, {}})).empty());
}

TEST_CASE("with two costs the front is shown") {
    const SearchCourse course = course_of("genetic", {{1, 9}, {2, 2}, {9, 1}, {3, 3}, {2, 2}});
    CHECK(best_of(course) == std::vector<std::size_t>{0, 1, 2});
}

TEST_CASE("the comparison states the result of each method and the number of machines that it needed") {
    const std::string text = print_comparison(
        optimum_of({"time [ms]"}, {course_of("genetic", {{8}, {4}, {5}}), course_of("random", {{}, {7}})}));
    CHECK(text == "search        machines                 time [ms]      found with\n"
                  "as it is             1                        10\n"
                  "genetic              3                         4               2\n"
                  "random               2                         7               2\n");
}

TEST_CASE("the comparison says that a method found nothing, and why the start cannot be built") {
    Optimum optimum = optimum_of({"time [ms]"}, {course_of("random", {{}, {}})});
    optimum.start = {.merit = {}, .why = "it deadlocks\nat 5 ms"};
    CHECK(print_comparison(optimum) == "search        machines                 time [ms]      found with\n"
                                       "as it is             1              it deadlocks\n"
                                       "random               2                      none\n");
}

TEST_CASE("with two measures the comparison states each method's front and its part of the joint front") {
    const std::string text = print_comparison(optimum_of(
        {"time", "processors"}, {course_of("genetic", {{1, 9}, {9, 1}}), course_of("random", {{2, 8}, {9, 9}})}));
    CHECK(text == "search        machines                 its front   of all fronts\n"
                  "genetic              2                         2          2 of 2\n"
                  "random               2                         1          0 of 2\n");
}

TEST_CASE("the machines of several methods form one course, each machine once") {
    const Optimum optimum =
        optimum_of({"time"}, {course_of("genetic", {{8}, {4}}), course_of("random", {{8}, {4}, {1}})});
    const SearchCourse together = optimum.together();
    CHECK(together.machines == std::vector<std::uint64_t>{0, 1, 2});
    CHECK(together.front() == std::vector<std::size_t>{2});
}

TEST_CASE("the command makes the run again, with each word as a shell takes it") {
    Study study;
    study.netlist = "my nets/it's.cfs";
    study.first_seed = 7;
    study.read.include_folders = {"folder"};
    study.read.faults = {"t[0] halts (from = 1s)"};
    CHECK(command_of(study, {{"clock", "20M"}, {"kind", "\"a b\""}})
              .ends_with(" run 'my nets/it'\\''s.cfs' --set clock=20M --set 'kind=\"a b\"' -I folder "
                         "--fault 't[0] halts (from = 1s)' --seed 7"));
}

TEST_CASE("if no machine can be built, a single reason is printed in full; of several reasons, the most frequent comes "
          "first") {
    SearchCourse course = course_of("random", {{}, {}, {}});
    course.why["short"] = {.machines = 3, .said = "short\nand in full"};
    CHECK(print_why_none(course) ==
          "of 3 machines that were tried, none can be built and completes its runs:\nshort\nand in full");
    course.why["other"] = {.machines = 5, .said = "other"};
    CHECK(print_why_none(course).ends_with(":\n     5  other\n     3  short"));
    for (char more = 'a'; more < 'f'; ++more)
        course.why[std::string(1, more)] = {.machines = 1};
    const std::string text = print_why_none(course);
    CHECK(std::count(text.begin(), text.end(), '\n') == 5);
}

TEST_CASE("the minimised measures are shown first, and no measure twice") {
    Study study;
    study.measures = {"links", "time"};
    study.search = StudySearch{.minimise = {"time", "processors"}};
    CHECK(shown_measures(study) == std::vector<std::string>{"time", "processors", "links"});
}

TEST_CASE("one measure is plotted over the number of machines, two measures against each other") {
    const Plot one = optimum_plot(optimum_of({"time"}, {course_of("genetic", {{8}, {9}, {4}})}), "title");
    CHECK(one.title == "title");
    REQUIRE(one.panels.size() == 1);
    REQUIRE_FALSE(one.panels[0].series.empty());
    for (std::size_t i = 1; i < one.panels[0].series[0].points.size(); ++i) // the best found never becomes worse
        CHECK(one.panels[0].series[0].points[i].y <= one.panels[0].series[0].points[i - 1].y);
    const Plot two = optimum_plot(optimum_of({"time", "cost"}, {course_of("genetic", {{1, 9}, {9, 1}, {9, 9}})}), "");
    CHECK(two.panels[0].x.label.find("time") != std::string::npos);
    CHECK(two.panels[0].y.label.find("cost") != std::string::npos);
}

TEST_CASE("two critical paths are compared part by part, the greatest difference first, and the other parts together") {
    auto path = [](const std::vector<std::pair<std::string, int>>& parts) {
        std::vector<PathPart> all;
        for (Time begin{}; const auto& [subject, milliseconds] : parts) {
            const Time end = begin + std::chrono::milliseconds(milliseconds);
            all.push_back({Activity::computing, subject, "", begin, end});
            begin = end;
        }
        return all;
    };
    CHECK(print_paths(path({{"slave[0] on t[1]", 6}, {"slave[1] on t[2]", 4}, {"master on t[0]", 3}}),
                      path({{"slave[2] on t[3]", 2}, {"master on t[0]", 4}})) ==
          "    as it is      the best            ms  on the critical path\n"
          "      10.000         2.000        -8.000  computing: slave[] on t[]\n"
          "       3.000         4.000        +1.000  computing: master on t[]\n"
          "      13.000         6.000        -7.000  the whole run\n");
    std::vector<std::pair<std::string, int>> many;
    for (char name = 'a'; name < 'k'; ++name)
        many.emplace_back(std::string(1, name), name - 'a' + 1); // 1 ms to 10 ms
    CHECK(print_paths(path(many), {}).find("       3.000         0.000        -3.000  everything else\n") !=
          std::string::npos); // the sum of the two shortest
}
