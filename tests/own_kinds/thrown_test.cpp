// Tests that an exception from a program's own code becomes a UserError that names process, time and text. An exception
// from one of PlacedPar's own processes remains a defect.

#include "explore/netlist_run.hpp"
#include "explore/problems.hpp"
#include "gaprocs/objective_problem.hpp"
#include "gaprocs/policies/initial_population.hpp"
#include "gaprocs/policies/mutation.hpp"
#include "netlist/kinds/description.hpp"
#include "netlist/kinds/environment.hpp"
#include "netlist/kinds/packet.hpp"
#include "netlist/print/promela.hpp"
#include "netlist/read.hpp"
#include "netlist/repeated_run.hpp"
#include "report/policies_report.hpp"
#include "runtime/executive.hpp"
#include "runtime/parallel.hpp"
#include "runtime/timer.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <system_error>

using namespace placedpar;

namespace {

/// Throws the exception with this number, which is the parameter "what".
void throw_something(std::int64_t what) {
    switch (what) {
    case 0: throw std::runtime_error("worn out");
    case 1: throw std::logic_error("worn out");
    case 2: throw UserError("worn out");
    case 3: throw std::overflow_error("worn out");
    case 4: throw std::system_error(std::make_error_code(std::errc::io_error), "worn out");
    case 5: throw 42;
    default: throw "worn out";
    }
}

const char* said(std::int64_t what) {
    return what == 4   ? "worn out: Input/output error"
           : what == 5 ? "an exception that is not a std::exception"
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
    static constexpr auto numbers() { return std::tuple(PolicyNumber{"what", &Failing::what, 0, 6}); }
    ParameterCoding representation() const { return ParameterCoding(1, {0, 1, 8}); }
    double objective(std::span<const double> x) const {
        throw_something(static_cast<std::int64_t>(what));
        return x[0];
    }
};

/// Throws while it is constructed, or in the member function that `question` selects.
class Unwilling final : public SearchProblem {
public:
    Unwilling(std::size_t what, std::size_t question) : what_(what), question_(question) { refuse(0); }
    std::size_t bits() const override { return refuse(1), 8; }
    Representation representation() const override { return refuse(2), BitString(8); }
    std::size_t channels() const override { return refuse(3), 1; }
    std::optional<Objective> objective() const override { return refuse(4), std::nullopt; }
    bool depends_on_window() const override { return refuse(5), false; }
    double error(const Genome&, std::span<const double>) const override { return refuse(6), 0; }
    double fitness(const Genome&, std::span<const Sample>, double) const override { return refuse(7), 1; }
    void fitness_of(std::span<const Genome>, std::span<const Sample>, double, std::span<double>) const override {
        refuse(8);
    }
    std::vector<double> decode(const Genome&) const override { return refuse(9), std::vector<double>{0}; }
    std::vector<std::string> parameter_names() const override { return refuse(10), std::vector<std::string>{"x"}; }
    std::vector<std::string> parameter_units() const override { return refuse(11), std::vector<std::string>{""}; }
    std::vector<double> true_parameters() const override { return refuse(12), std::vector<double>{}; }
    std::vector<std::size_t> fields() const override { return refuse(13), std::vector<std::size_t>{8}; }
    Coding coding() const override { return refuse(14), Coding::natural; }

private:
    std::shared_ptr<const SearchProblem> coded_plainly(Coding) const override { return refuse(15), nullptr; }
    void refuse(std::size_t asked) const {
        if (asked == question_)
            throw_something(static_cast<std::int64_t>(what_));
    }
    std::size_t what_, question_;
};

/// Question 16 throws when the record is asked for, 17 in its samples, 18 never.
ProblemFamily unwilling() {
    auto refuse = [](const std::vector<double>& numbers, int asked) {
        if (numbers[1] == asked)
            throw_something(static_cast<std::int64_t>(numbers[0]));
    };
    return {{"own.unwilling", "throws where it is asked", {{"what", 0, 0, 6, true}, {"question", 0, 0, 18, true}}},
            [](const std::vector<double>& numbers) {
                return std::make_shared<Unwilling>(static_cast<std::size_t>(numbers[0]),
                                                   static_cast<std::size_t>(numbers[1]));
            },
            [refuse](const std::vector<double>& numbers) {
                refuse(numbers, 16);
                return RecordToMake{10, [refuse, numbers] {
                                        refuse(numbers, 17);
                                        return std::vector<Sample>(10, {0});
                                    }};
            }};
}

/// Throws when constructed, but not the first time, or it could not be added.
struct FailingStart {
    static constexpr std::string_view name = "own.failing-start", about = "throws when it is named";
    static inline bool fails = false;
    FailingStart() {
        if (fails)
            throw_something(5);
    }
    std::vector<Genome> operator()(std::size_t, const Representation&, RandomStream&) const { return {}; }
};

struct FailingMutation {
    static constexpr std::string_view name = "own.failing", about = "throws when it is asked what it fits";
    static inline bool fails = false;
    static bool fits(StringKind) {
        if (fails)
            throw_something(5);
        return false;
    }
    void operator()(Genome&, std::size_t, const Representation&, RandomStream&) const {}
};

/// Throws when it is added.
struct NeverMade {
    static constexpr std::string_view name = "own.never", about = "throws when it is added";
    static constexpr bool needs_positive_fitness = false;
    std::size_t what = 0;
    static constexpr auto numbers() { return std::tuple(PolicyNumber{"what", &NeverMade::what, 0, 6}); }
    NeverMade() { throw_something(5); }
    Parents operator()(std::span<const double>, std::size_t, RandomStream&) const { return {}; }
};

void throw_in(const char* where, const Network& network, std::size_t process) {
    const auto& parameters = network.processes[process].parameters;
    if (std::get<std::string>(parameters.at("where")) == where)
        throw_something(std::get<std::int64_t>(parameters.at("what")));
}

struct FailingSelection {
    static constexpr std::string_view name = "own.failing", about = "throws when it is asked";
    static constexpr bool needs_positive_fitness = false;
    std::size_t what = 0;
    static constexpr auto numbers() { return std::tuple(PolicyNumber{"what", &FailingSelection::what, 0, 6}); }
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
                        .parameters = {integer("what", {.by_default = 0, .least = 0, .most = 6}, "it throws"),
                                       text("where", {.by_default = "body"}, "it throws")},
                        .body = fail},
                       {.name = "own.asked",
                        .about = "Throws where it is asked.",
                        .parameters = {integer("what", {.by_default = 0, .least = 0, .most = 6}, "it throws"),
                                       text("where", {.by_default = ""}, "it throws"),
                                       text("word",
                                            {.by_default = "x",
                                             .check = [](const std::string& word) { throw_something(word[0] - '0'); }},
                                            "it throws")},
                        .body = [](ProcessEnvironment&) {},
                        .check =
                            [](const Network& network, std::size_t process) {
                                throw_in("check", network, process);
                                return std::vector<Complaint>{};
                            },
                        .is_determinate =
                            [](const Network& network, std::size_t process) {
                                throw_in("determinate", network, process);
                                return true;
                            },
                        .promela =
                            [](const PromelaProcess& process) {
                                throw_something(process.integer("what"));
                                return std::string();
                            }}});
        add_own_problems({minimised<Failing>(), unwilling()});
        InitialPopulation::add<FailingStart>();
        Mutation::add<FailingMutation>();
        Reproduction::add<FailingSelection>();
        return true;
    }();
    REQUIRE(added);
}

/// Returns the message that the work throws.
template <class Work>
std::string thrown_in(Work work) {
    try {
        work();
    } catch (const UserError& refused) {
        return std::string("refused: ") + refused.what();
    } catch (const std::exception& defect) {
        return std::string("defect: ") + defect.what();
    }
    return "nothing";
}

/// Returns the message that a run throws, or with which its netlist is refused.
std::string thrown_by(const std::string& text) {
    add_failing();
    ProblemRegistry problems = known_problems(1);
    Catalogue kinds = known_kinds(problems);
    return thrown_in([&] {
        ReadResult read = read_netlist_text(text, kinds, {}, "test.cfs");
        if (!read.network)
            throw RefusedInput(render(read));
        run_netlist(*read.network, kinds, {});
        is_determinate(*read.network, kinds);
        print_promela(*read.network, kinds);
    });
}

std::string asked_kind(const std::string& parameters) {
    return thrown_by("T800 t; process p; use \"own.asked\" for p; place p on t;\np (" + parameters + ");\n");
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
    for (std::int64_t what = 0; what <= 6; ++what)
        for (const auto& at : {std::pair("body", "p"), std::pair("component", "p/0"), std::pair("deep", "p/0/0")}) {
            CAPTURE(what);
            CAPTURE(at.first);
            std::string thrown = thrown_by("T800 t; process p; use \"own.failing\" for p; place p on t;\n"
                                           "p (what = " +
                                           std::to_string(what) + ", where = \"" + at.first + "\");\n");
            CAPTURE(thrown);
            CHECK(thrown.starts_with("refused: "));
            CHECK(thrown.find("process " + std::string(at.second) + " (own.failing) at ") != std::string::npos);
            CHECK(thrown.ends_with(std::string(": ") + said(what)));
        }
}

TEST_CASE("what an own problem or policy throws names it, and the process that asked it") {
    for (std::int64_t what = 0; what <= 6; ++what) {
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

TEST_CASE("what an own kind throws where it is asked names the process, its kind, and its place in the netlist") {
    for (int what = 0; what <= 6; ++what) {
        const std::string number = std::to_string(what), why = said(what);
        CHECK(asked_kind("what = " + number + ", where = \"check\"")
                  .starts_with("refused: test.cfs:1:17: error: the kind \"own.asked\" cannot check this process: " +
                               why + "\n"));
        std::string refused = asked_kind("word = \"" + number + "\"");
        CHECK(refused.starts_with("refused: test.cfs:2:4: error: illegal value of the parameter \"word\": \"" + number +
                                  "\"\n"));
        CHECK(refused.ends_with("hint: " + why + "\n"));
        CHECK(asked_kind("what = " + number + ", where = \"determinate\"") ==
              "refused: test.cfs:1:17: process p (own.asked), asked whether it is determinate: " + why);
        CHECK(asked_kind("what = " + number) ==
              "refused: test.cfs:1:17: process p (own.asked), asked for its statements in Promela: " + why);
    }
}

TEST_CASE("what an own problem throws names it, whatever it is asked") {
    add_failing();
    for (int what = 0; what <= 6; ++what)
        for (int question = 0; question <= 17; ++question) {
            ProblemRegistry problems = known_problems(1);
            std::string named =
                "own.unwilling(what = " + std::to_string(what) + ", question = " + std::to_string(question) + ")";
            CAPTURE(named);
            const Genome genome(8);
            std::vector<double> worth(1);
            std::string thrown = thrown_in([&] {
                const RecordedProblem& recorded = problems.find(named);
                const SearchProblem& problem = *recorded.problem();
                problem.bits(), problem.representation(), problem.channels(), problem.objective();
                problem.depends_on_window(), problem.error(genome, {}), problem.fitness(genome, {}, 1);
                problem.fitness_of(std::span(&genome, 1), {}, 1, worth);
                problem.decode(genome), problem.parameter_names(), problem.parameter_units();
                problem.true_parameters(), problem.fields(), problem.coding(), recorded.record();
                problem.coded(Coding::gray);
            });
            CHECK(thrown == "refused: the search problem \"" + named + "\": " + said(what));
        }
}

TEST_CASE("a netlist with an own problem that throws is refused at the process") {
    std::string thrown = thrown_by(farm_with("own.unwilling(what = 5, question = 4)", "usual"));
    CAPTURE(thrown);
    CHECK(thrown.starts_with("refused: test.cfs:2:"));
    CHECK(thrown.find("the search problem \"own.unwilling(what = 5, question = 4)\": an exception") != thrown.npos);
}

TEST_CASE("what an own policy throws while it is added, named or described names it") {
    add_failing();
    const std::string why = said(5);
    CHECK(thrown_in([] { Reproduction::add<NeverMade>(); }) ==
          "refused: the policy \"own.never\" for selection: " + why);
    FailingStart::fails = FailingMutation::fails = true;
    CHECK(thrown_in([] { InitialPopulation::named("own.failing-start"); }) ==
          "refused: the policy \"own.failing-start\" for initial-population: " + why);
    CHECK(thrown_in([] { Mutation::fitting(StringKind::real); }) == "refused: the policy \"own.failing\": " + why);
    CHECK(thrown_in([] {
              ProblemRegistry problems = known_problems(1);
              print_policy(known_kinds(problems), "mutation");
          }) == "refused: the policy \"own.failing\": " + why);
    FailingStart::fails = FailingMutation::fails = false;
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
