// Whatever the code of a program's own throws is that program's: a UserError that names process, moment and what was
// said. What a process of PlacedPar throws stays a defect.

#include "gaprocs/objective_problem.hpp"
#include "netlist/kinds/description.hpp"
#include "netlist/kinds/environment.hpp"
#include "netlist/kinds/packet.hpp"
#include "netlist/read.hpp"
#include "runtime/executive.hpp"
#include "runtime/parallel.hpp"
#include "runtime/timer.hpp"
#include "text/user_error.hpp"
#include "workbench/netlist_run.hpp"
#include "workbench/problems.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <system_error>

using namespace placedpar;

namespace {

/// By the number of the parameter "what".
void throw_something(std::int64_t what) {
    switch (what) {
    case 0: throw std::runtime_error("worn out");
    case 1: throw std::logic_error("worn out");
    case 2: throw UserError("worn out");
    case 3: throw std::overflow_error("worn out");
    case 4: throw std::system_error(std::make_error_code(std::errc::io_error), "worn out");
    default: throw 42;
    }
}

const char* said(std::int64_t what) {
    return what == 4  ? "worn out: Input/output error"
           : what > 4 ? "an exception that is not a std::exception"
                      : "worn out";
}

void fail(ProcessEnvironment& environment) {
    wait_for(std::chrono::microseconds(7));
    auto work = [&] { throw_something(environment.integer("what")); };
    if (environment.text("where") == "body")
        work();
    else if (environment.text("where") == "component")
        par(work, [] { wait_for(std::chrono::microseconds(1)); });
    else
        par([&] { par(work, [] {}); }, [] {});
}

struct Failing {
    static constexpr std::string_view name = "own.failing", about = "throws when it is evaluated";
    std::size_t what = 0;
    static constexpr auto numbers() { return std::tuple(PolicyNumber{"what", &Failing::what, 0, 5}); }
    ParameterCoding representation() const { return ParameterCoding(1, {0, 1, 8}); }
    double objective(std::span<const double> x) const {
        throw_something(static_cast<std::int64_t>(what));
        return x[0];
    }
};

struct FailingSelection {
    static constexpr std::string_view name = "own.failing", about = "throws when it is asked";
    static constexpr bool needs_positive_fitness = false;
    std::size_t what = 0;
    static constexpr auto numbers() { return std::tuple(PolicyNumber{"what", &FailingSelection::what, 0, 5}); }
    Parents operator()(std::span<const double>, std::size_t, RandomStream&) const {
        throw_something(static_cast<std::int64_t>(what));
        return {};
    }
};

void add_failing() {
    static const bool added = [] {
        using namespace description;
        add_own_kinds({{.name = "own.failing",
                        .about = "Throws.",
                        .parameters = {integer("what", {.by_default = 0, .least = 0, .most = 5}, "it throws"),
                                       text("where", {.by_default = "body"}, "it throws")},
                        .body = fail}});
        add_own_problems({minimised<Failing>()});
        Reproduction::add<FailingSelection>();
        return true;
    }();
    REQUIRE(added);
}

/// What is thrown by a run.
std::string thrown_by(const std::string& text) {
    add_failing();
    ProblemRegistry problems = known_problems(1);
    Catalogue kinds = known_kinds(problems);
    ReadResult read = read_netlist_text(text, kinds, {}, "test.cfs");
    INFO(render(read));
    REQUIRE(read.network);
    try {
        run_netlist(*read.network, kinds, {});
    } catch (const UserError& refused) {
        return std::string("refused: ") + refused.what();
    } catch (const std::exception& defect) {
        return std::string("defect: ") + defect.what();
    }
    return "nothing";
}

std::string farm_with(const std::string& problem, const std::string& reproduction) {
    return "workstation sun; T800 t[2]; connect sun.link[0] to t[0].link[0]; connect t[0].link[1] to t[1].link[0];\n"
           "process host, master, slave; use \"ga.host\" for host; use \"ga.master\" for master; use \"ga.slave\" for "
           "slave;\n"
           "host (problem = \"" +
           problem +
           "\", generations = 3);\n"
           "master (problem = \"" +
           problem + "\", population = 10, own_share = 0, reproduction = \"" + reproduction +
           "\");\n"
           "slave (problem = \"" +
           problem +
           "\");\n"
           "connect host.to_masters[0] to master.from_host; connect master.to_slaves to slave.from_master;\n"
           "connect slave.to_master to master.from_slaves;\n"
           "place host on sun; place master on t[0]; place slave on t[1];\n";
}

} // namespace

TEST_CASE("what a process of an own kind throws names it, and when, from its body and from components of PARs") {
    for (std::int64_t what = 0; what <= 5; ++what)
        for (auto [where, path] : {std::pair("body", "p"), std::pair("component", "p/0"), std::pair("deep", "p/0/0")}) {
            CAPTURE(what);
            CAPTURE(where);
            std::string thrown = thrown_by("T800 t; process p; use \"own.failing\" for p; place p on t;\n"
                                           "p (what = " +
                                           std::to_string(what) + ", where = \"" + where + "\");\n");
            CAPTURE(thrown);
            CHECK(thrown.starts_with("refused: "));
            CHECK(thrown.find("process " + std::string(path) + " (own.failing) at ") != std::string::npos);
            CHECK(thrown.ends_with(std::string(": ") + said(what)));
        }
}

TEST_CASE("what an own problem or policy throws names it, and the process that asked it") {
    for (std::int64_t what = 0; what <= 5; ++what) {
        CAPTURE(what);
        std::string named = "own.failing(what = " + std::to_string(what) + ")";
        std::string problem = thrown_by(farm_with(named, "usual")), policy = thrown_by(farm_with("sphere", named));
        CAPTURE(problem);
        CAPTURE(policy);
        CHECK(problem.starts_with("refused: "));
        CHECK(problem.find("process slave") != std::string::npos);
        CHECK(problem.ends_with("the search problem \"" + named + "\": " + said(what)));
        CHECK(policy.starts_with("refused: "));
        CHECK(policy.find("process master (ga.master) at ") != std::string::npos);
        CHECK(policy.ends_with("the policy \"" + named + "\": " + said(what)));
    }
}

TEST_CASE("what a process of PlacedPar's own throws is a defect") {
    add_failing();
    ProblemRegistry problems = known_problems(1);
    Catalogue kinds = known_kinds(problems), house;
    for (const auto& [name, kind] : kinds.kinds())
        if (name == "own.failing") {
            ProcessKind of_the_house = kind;
            of_the_house.is_own = false;
            house.add(of_the_house);
        }
    for (const char* what : {"0", "1", "5"}) {
        ReadResult read = read_netlist_text(
            std::string("T800 t; process p; use \"own.failing\" for p; place p on t; p (what = ") + what + ");", house);
        REQUIRE(read.network);
        CHECK_THROWS_AS(run_netlist(*read.network, house, {}), std::logic_error);
    }
}
