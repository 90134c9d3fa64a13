#include "problems/benchmark/benchmark.hpp"
#include "problems/benchmark/tour_file.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

/// A file that exists as long as this object.
struct WrittenFile {
    explicit WrittenFile(const std::string& text)
        : path(std::filesystem::temp_directory_path() / "placedpar_tour_file_test.tsp") {
        std::ofstream(path) << text;
    }
    ~WrittenFile() { std::filesystem::remove(path); }
    std::filesystem::path path;
};

TableTour tour_of(const std::string& text) { return read_tour_file(WrittenFile(text).path); }

std::string refusal_of(const std::string& text) {
    try {
        tour_of(text);
    } catch (const UserError& refused) {
        const std::string message = refused.what();
        return message.substr(message.find(".tsp:") + 5);
    }
    return "";
}

/// Returns twice the distance of two cities.
double there_and_back(const std::string& type, const std::string& cities) {
    const TableTour tour =
        tour_of("TYPE: TSP\nDIMENSION: 2\nEDGE_WEIGHT_TYPE: " + type + "\nNODE_COORD_SECTION\n" + cities + "EOF\n");
    return tour.objective(std::vector<std::size_t>{0, 1});
}

std::string matrix(const std::string& form, const std::string& numbers, const std::string& type = "TSP") {
    return "NAME : m\nTYPE : " + type + "\nDIMENSION : 3\nEDGE_WEIGHT_TYPE : EXPLICIT\nEDGE_WEIGHT_FORMAT : " + form +
           "\nEDGE_WEIGHT_SECTION\n" + numbers + "\nEOF\n";
}

/// Returns the length of the shortest tour, by dynamic programming over sets of cities (Held and Karp, 1962).
double shortest(const TableTour& tour) {
    const std::size_t count = tour.representation().places(), last = count - 1;
    auto distance = [&](std::size_t from, std::size_t to) {
        std::vector<std::size_t> pair{from, to};
        return tour.objective(pair) / 2;
    };
    std::vector<double> between(count * count);
    for (std::size_t i = 0; i < count * count; ++i)
        between[i] = distance(i / count, i % count);
    std::vector<double> best((std::size_t{1} << last) * last, std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < last; ++i)
        best[(std::size_t{1} << i) * last + i] = between[last * count + i];
    for (std::size_t set = 1; set < std::size_t{1} << last; ++set)
        for (std::size_t i = 0; i < last; ++i)
            for (std::size_t next = 0; next < last; ++next)
                if ((set >> next & 1) == 0)
                    best[(set | std::size_t{1} << next) * last + next] =
                        std::min(best[(set | std::size_t{1} << next) * last + next],
                                 best[set * last + i] + between[i * count + next]);
    double length = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < last; ++i)
        length = std::min(length, best[((std::size_t{1} << last) - 1) * last + i] + between[i * count + last]);
    return length;
}

/// The instances of TSPLIB whose shortest tours are 3323 and 2085.
constexpr const char* burma14 = R"(NAME: burma14
TYPE: TSP
COMMENT: 14-Staedte in Burma (Zaw Win)
DIMENSION: 14
EDGE_WEIGHT_TYPE: GEO
EDGE_WEIGHT_FORMAT: FUNCTION
DISPLAY_DATA_TYPE: COORD_DISPLAY
NODE_COORD_SECTION
   1  16.47       96.10
   2  16.47       94.44
   3  20.09       92.54
   4  22.39       93.37
   5  25.23       97.24
   6  22.00       96.05
   7  20.47       97.02
   8  17.20       96.29
   9  16.30       97.38
  10  14.05       98.12
  11  16.53       97.38
  12  21.52       95.59
  13  19.41       97.13
  14  20.09       94.55
EOF
)";
constexpr const char* gr17 = R"(NAME: gr17
TYPE: TSP
COMMENT: 17-city problem (Groetschel)
DIMENSION: 17
EDGE_WEIGHT_TYPE: EXPLICIT
EDGE_WEIGHT_FORMAT: LOWER_DIAG_ROW
EDGE_WEIGHT_SECTION
 0 633 0 257 390 0 91 661 228 0 412 227
 169 383 0 150 488 112 120 267 0 80 572 196
 77 351 63 0 134 530 154 105 309 34 29 0
 259 555 372 175 338 264 232 249 0 505 289 262
 476 196 360 444 402 495 0 353 282 110 324 61
 208 292 250 352 154 0 324 638 437 240 421 329
 297 314 95 578 435 0 70 567 191 27 346 83
 47 68 189 439 287 254 0 211 466 74 182 243
 105 150 108 326 336 184 391 145 0 268 420 53
 239 199 123 207 165 383 240 140 448 202 57 0
 246 745 472 237 528 364 332 349 202 685 542 157
 289 426 483 0 121 518 142 84 297 35 29 36
 236 390 238 301 55 96 153 336 0
EOF
)";

} // namespace

TEST_CASE("the shortest tours of instances of TSPLIB have the published lengths") {
    CHECK(shortest(tour_of(burma14)) == 3323);
    CHECK(shortest(tour_of(gr17)) == 2085);
}

TEST_CASE("distances are rounded as TSPLIB prescribes") {
    CHECK(there_and_back("EUC_2D", "1 0 0\n2 3 4\n") == 2 * 5);
    CHECK(there_and_back("EUC_2D", "1 0 0\n2 1 1\n") == 2 * 1);
    CHECK(there_and_back("CEIL_2D", "1 0 0\n2 1 1\n") == 2 * 2);
    CHECK(there_and_back("ATT", "1 6734 1453\n2 2233 10\n") == 2 * 1495); // att48: sqrt(2234125.3) = 1494.7
    CHECK(there_and_back("ATT", "2 0 0\n1 1 1\n") == 2 * 1);              // sqrt(0.2), never rounded down
}

TEST_CASE("all forms of a matrix give the same distances") {
    const std::vector<std::size_t> order{0, 1, 2};
    for (const auto& [form, numbers] :
         std::vector<std::pair<std::string, std::string>>{{"FULL_MATRIX", "0 5 7\n5 0 9\n7 9 0"},
                                                          {"UPPER_ROW", "5 7\n9"},
                                                          {"LOWER_ROW", "5\n7 9"},
                                                          {"UPPER_DIAG_ROW", "0 5 7 0\n9 0"},
                                                          {"LOWER_DIAG_ROW", "0 5 0\n7 9 0"}})
        CHECK(tour_of(matrix(form, numbers)).objective(order) == 21);
    const TableTour one_way = tour_of(matrix("FULL_MATRIX", "0 5 1\n1 0 9\n7 1 0", "ATSP"));
    CHECK(one_way.objective(order) == 21);
    CHECK(one_way.objective(std::vector<std::size_t>{0, 2, 1}) == 3);
}

TEST_CASE("a matrix that is not symmetric, and more cities than DIMENSION says, are refused") {
    CHECK(refusal_of(matrix("FULL_MATRIX", "0 5 7\n4 0 9\n7 9 0")) ==
          "9: the distance from city 2 to city 1 is 4, but 5 in the other direction; write \"TYPE: ATSP\" if that is "
          "right");
    CHECK(refusal_of(matrix("UPPER_ROW", "5 7\n9\n3")) ==
          "8: after this line follow more distances than the format and DIMENSION allow");
    CHECK(refusal_of("TYPE: TSP\nDIMENSION: 2\nEDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n1 0 0\n2 1 1\n3 2 2\n") ==
          "6: after this line follow more cities than \"DIMENSION: 2\" says");
}

TEST_CASE("a file that cannot be read is refused with its line") {
    const std::string head = "TYPE: TSP\nDIMENSION: 2\nEDGE_WEIGHT_TYPE: EUC_2D\n";
    CHECK(refusal_of("TYPE: CVRP\n") == "1: TYPE: \"CVRP\" cannot be read: expected ATSP, TSP");
    CHECK(refusal_of("DIMENSION: 6000\n") == "1: DIMENSION: \"6000\" is not a number of cities from 1 to 5000");
    CHECK(refusal_of("DIMENSION: -2\n") == "1: DIMENSION: \"-2\" is not a number of cities from 1 to 5000");
    CHECK(refusal_of("EDGE_WEIGHT_TYPE: XRAY1\n") ==
          "1: EDGE_WEIGHT_TYPE: \"XRAY1\" cannot be read: expected ATT, CEIL_2D, EUC_2D, EXPLICIT, GEO");
    CHECK(refusal_of("CAPACITY: 3\n") == "1: unknown keyword \"CAPACITY\"");
    CHECK_THROWS_WITH_AS(read_tour_file("no/such.tsp"), "no/such.tsp: this file does not exist", UserError);
    CHECK(refusal_of("NODE_COORD_SECTION\n") == "1: DIMENSION is missing before \"NODE_COORD_SECTION\"");
    CHECK(refusal_of(head + "NODE_COORD_SECTION\n1 0 0\n") == "5: the file ends after 1 of 2 cities");
    CHECK(refusal_of(head + "NODE_COORD_SECTION\n1 0 0\n3 1 1\n") ==
          "6: expected a city from 1 to 2 and its two coordinates, not \"3 1 1\"");
    CHECK(refusal_of(head + "NODE_COORD_SECTION\n1 0 0\n1 1 1\n") == "6: city 1 has coordinates twice, expected once");
    CHECK(refusal_of(head + "NODE_COORD_SECTION\n1 0 0\n2 nan 1\n").starts_with("6: expected a city"));
    CHECK(refusal_of(head + "NODE_COORD_SECTION\n1 0 0\n2 1e300 1\n").starts_with("6: the distance 1e+300 is not"));
    CHECK(refusal_of(head + "EOF\n").starts_with("4: the file ends without cities"));
    CHECK(refusal_of(head + "FIXED_EDGES_SECTION\n1 2\n").starts_with("4: \"FIXED_EDGES_SECTION\" cannot be read"));
    CHECK(refusal_of(matrix("UPPER_COL", "5 7 9")).starts_with("5: EDGE_WEIGHT_FORMAT: \"UPPER_COL\" cannot be read"));
    CHECK(refusal_of(matrix("UPPER_ROW", "5 7")) ==
          "8: the matrix has fewer distances than the format and DIMENSION need");
    CHECK(refusal_of(matrix("UPPER_ROW", "5 7 9 9")) ==
          "7: the line has more distances than the format and DIMENSION allow");
    CHECK(refusal_of(matrix("UPPER_ROW", "5 -7 9")).starts_with("7: \"-7\" is not a distance"));
    CHECK_THROWS_AS(read_tour_file("/nowhere.tsp"), UserError);
}

TEST_CASE("a keyword or section that comes twice is refused, but for comments") {
    const std::string head = "TYPE: TSP\nCOMMENT: a\nCOMMENT: b\nDIMENSION: 2\nEDGE_WEIGHT_TYPE: EUC_2D\n";
    const std::string cities = "NODE_COORD_SECTION\n1 0 0\n2 3 4\n";
    CHECK(tour_of(head + cities).objective(std::vector<std::size_t>{0, 1}) == 10);
    CHECK(refusal_of(head + cities + "DIMENSION: 4000\n") == "9: \"DIMENSION\" occurs twice, expected once");
    CHECK(refusal_of(head + cities + cities) == "9: \"NODE_COORD_SECTION\" occurs twice, expected once");
    CHECK(refusal_of(head + "EDGE_WEIGHT_FORMAT: FULL_MATRIX\nEDGE_WEIGHT_SECTION\n0 1\n1 0\n" + cities) ==
          "10: \"NODE_COORD_SECTION\" is one section too many: an earlier section has given all distances");
}

TEST_CASE("a problem is named by its file") {
    ProblemRegistry problems;
    add_benchmark_problems(problems);
    const WrittenFile file(burma14);
    const std::string name = "tsp:" + file.path.string();
    CHECK(problems.find(name).problem()->representation().permutation().places() == 14);
    CHECK(&problems.find(name) == &problems.find(name));
    CHECK_THROWS_AS(problems.find("tsp"), UserError);
    CHECK_THROWS_AS(problems.find("vrp:x"), UserError);
    CHECK_THROWS_WITH_AS(problems.find("tsp:"),
                         "the problem \"tsp:\" names no file: expected tsp:FILE, a travelling-salesman file of TSPLIB",
                         UserError);
}
