// Tests masters that share slaves by a ga.pipeline (thesis, Figure 4.5). Each master must have the same generations as
// with its own slaves, for any number of masters, split and form. The slaves must work while a master breeds; this is
// the purpose of the pipeline.

#include "tests/gaprocs/cluster.hpp"
#include "tests/gaprocs/slave_forms.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

/// Masters with their parameters, and the form of their slaves.
struct SharedFarm {
    std::vector<std::string> masters; ///< parameters of each master
    SlaveForm form;                   ///< `the_master` stands for the pipeline here
    bool own_slaves = false;          ///< true: no pipeline; the slaves belong to the only master

    std::string netlist() const {
        auto text = fmt::format("workstation sun;\nprocess host, master[{0}], slave[{1}];\n"
                                "use \"ga.host\" for host; host (problem = \"line\"); place host on sun;\n"
                                "T800 t[{2}]; connect sun.link[0] to t[0].link[0];\n",
                                masters.size(), form.size(), form.size() + 1);
        if (!own_slaves)
            text += "process pipeline; use \"ga.pipeline\" for pipeline; place pipeline on t[0];\n";
        for (std::size_t i = 0; i < masters.size(); ++i)
            text += master(i);
        std::vector<std::size_t> behind(form.size() + 1, 0);
        for (std::size_t i = 0; i < form.size(); ++i)
            text += slave(i, behind[form[i] + 1]++);
        return text;
    }

private:
    std::string master(std::size_t i) const {
        auto text = fmt::format("use \"ga.master\" for master[{0}]; place master[{0}] on t[0];\n"
                                "connect host.to_masters[{0}] to master[{0}].from_host;\n"
                                "master[{0}] (problem = \"line\", stream = \"master {0}\", slaves = {1}, "
                                "rehearsals = 1, trials = 2, {2});\n",
                                i, form.size(), masters[i]);
        if (!own_slaves)
            text += fmt::format("connect master[{0}].to_slaves to pipeline.from_masters[{0}];\n"
                                "connect pipeline.to_masters[{0}] to master[{0}].from_slaves;\n",
                                i);
        return text;
    }

    std::string slave(std::size_t i, std::size_t channel) const {
        auto before = form[i] != the_master ? fmt::format("slave[{}]", form[i]) : own_slaves ? "master[0]" : "pipeline";
        return fmt::format("use \"ga.slave\" for slave[{0}]; slave[{0}] (problem = \"line\");\n"
                           "place slave[{0}] on t[{1}]; connect t[{3}].link[{4}] to t[{1}].link[0];\n"
                           "connect {2}.to_slaves[{5}] to slave[{0}].from_master;\n"
                           "connect slave[{0}].to_master to {2}.from_slaves[{5}];\n",
                           i, i + 1, before, form[i] + 1, channel + 1, channel);
    }
};

std::string populations_of(const RunReport& report, std::size_t master) {
    return report.measured_text(fmt::format("master[{}]", master), "populations");
}

/// Returns the hash of the populations of one of the masters with its own slaves. The random stream keeps its name,
/// although the master becomes master 0.
std::string populations_alone(const SharedFarm& farm, std::size_t master) {
    SharedFarm alone{{farm.masters[master]}, farm.form, true};
    auto text = alone.netlist();
    std::string stream = "stream = \"master 0\"";
    text.replace(text.find(stream), stream.size(), fmt::format("stream = \"master {}\"", master));
    return populations_of(run_on_line(text), 0);
}

double rate(const RunReport& report, std::size_t master) {
    return report.measured(fmt::format("master[{}]", master), "generations_per_second");
}

std::string refusal_of(std::string text, const std::string& from, const std::string& to) {
    auto at = text.find(from);
    REQUIRE(at != std::string::npos);
    text.replace(at, from.size(), to);
    try {
        run_on_line(text);
    } catch (const std::exception& refused) {
        return refused.what();
    }
    return "";
}

} // namespace

TEST_CASE("a master that shares slaves has the same generations as with its own slaves") {
    std::string small = "population = 12, window = 4, first_window = 4",
                large = "population = 18, window = 9, bias = 300";
    for (const SlaveForm& form : {chain_of(1), chain_of(3), star_of(3), tree_of(5, 2)})
        for (const char* way : {"split = \"individuals\"", "split = \"evaluations\", results = \"ready\"",
                                "split = \"evaluations\", own_share = 0", "own_share = .4, sending = \"at once\""}) {
            SharedFarm farm{{small + ", " + way, large + ", " + way, small + ", " + way}, form};
            RunReport report = run_on_line(farm.netlist());
            CHECK(report.result.ending == Ending::completed);
            for (std::size_t master = 0; master < farm.masters.size(); ++master)
                CHECK(populations_of(report, master) == populations_alone(farm, master));
        }
}

TEST_CASE("two masters that share slaves use all of the slaves' time; one master leaves half of it unused") {
    // To evaluate an individual takes 10 errors of 40000 cycles, four times as long as to breed it (100000 cycles). So
    // four slaves evaluate a population in the time in which a master breeds one. One master uses half of the slaves'
    // time, two masters use all of it.
    std::string costs = "population = 30, split = \"evaluations\", own_share = 0, cycles_per_error = 40000, "
                        "cycles_per_individual = 100000";
    auto slaves_cost = [](std::string text) {
        for (std::size_t at = 0; (at = text.find("(problem = \"line\");\nplace", at)) != std::string::npos; at += 40)
            text.replace(at, 18, "(problem = \"line\", cycles_per_error = 40000)");
        return text;
    };
    RunReport alone = run_on_line(slaves_cost(SharedFarm{{costs}, chain_of(4), true}.netlist()));
    RunReport shared = run_on_line(slaves_cost(SharedFarm{{costs, costs}, chain_of(4)}.netlist()));
    double one = 1 / (30 * (10 * 40000 + 100000) * 50e-9);            // a single processor that evaluates and breeds
    CHECK(rate(alone, 0) == doctest::Approx(2.5 * one).epsilon(.02)); // (4 + 1) / (4 / 4 + 1), equation 4.9
    CHECK(rate(shared, 0) + rate(shared, 1) == doctest::Approx(5 * one).epsilon(.04));
}

TEST_CASE("masters that cannot share slaves are refused") {
    std::string text = SharedFarm{{"population = 12", "population = 12"}, chain_of(2)}.netlist();
    CHECK(refusal_of(text, "population = 12", "population = 12, split = \"demand\"")
              .find("deals out individuals on demand") != std::string::npos);
    CHECK(refusal_of(text, "population = 12", "population = 12, split = \"demand\", own_share = .5")
              .find("evaluates whenever it is idle") != std::string::npos);
    CHECK(refusal_of(text, "connect pipeline.to_masters[0] to master[0].from_slaves;\n",
                     "connect pipeline.to_masters[1] to master[0].from_slaves;\n")
              .find("pipeline.to_masters") != std::string::npos);
    CHECK(refusal_of(text, "slaves = 2", "slaves = 3")
              .find("slaves = 3, but the number of slaves connected to \"master[0].to_slaves\" is 2") !=
          std::string::npos);
}
