// Tests the critical path of a run, and how its processes spent their time.

#include "observe/critical_path/critical_path.hpp"

#include "runtime/alternation.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/hardware/vme_bus.hpp"
#include "runtime/parallel.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <functional>
#include <string>
#include <vector>

using namespace placedpar;
using namespace std::chrono_literals;

namespace {

using Lines = std::vector<std::string>;

/// A simulation whose critical path is computed. A cycle of its processor of 1 GHz takes 1 ns.
struct Sought {
    explicit Sought(std::size_t most = most_path_points) : path(most) { simulation.trace_to(path); }
    hardware::Processor& processor(const char* name = "t") {
        return simulation.add<hardware::Processor>(name, 1'000'000'000);
    }
    /// Returns the path's parts as "computing: p on t, 0 to 19", in nanoseconds.
    Lines parts(Time limit = Time::max()) {
        simulation.run(limit);
        Lines lines;
        for (const PathPart& part : path.parts())
            lines.push_back(fmt::format("{}, {} to {}", name_on_path(part.activity, part.subject), part.begin / 1ns,
                                        part.end / 1ns));
        return lines;
    }

    Simulation simulation;
    CriticalPath path;
};

std::vector<std::string> texts_of(const std::vector<PathShare>& shares) {
    std::vector<std::string> texts;
    for (const PathShare& share : shares)
        texts.push_back(fmt::format("{} {}", name_of(share), share.time / 1ns));
    return texts;
}

} // namespace

TEST_CASE("of two independent processes, the path takes the process that ends last") {
    Sought sought;
    sought.simulation.process("short", [] { wait_for(1us); });
    sought.simulation.process("long", [] { wait_for(3us); });
    CHECK(sought.parts() == Lines{"delayed: long, 0 to 3000"});
}

TEST_CASE("at a message the path leads to the later process") {
    Sought sought;
    Channel<int> c("c");
    sought.simulation.process("early", [&] {
        wait_for(1us);
        c.in().input();
        wait_for(2us);
    });
    sought.simulation.process("late", [&] {
        wait_for(5us);
        c.out().output(1);
    });
    CHECK(sought.parts() == Lines{"delayed: late, 0 to 5000", "delayed: early, 5000 to 7000"});
}

TEST_CASE("at a message taken by an alternation the path leads to the later process") {
    Sought sought;
    Channel<int> c("c"), never("never");
    sought.simulation.process("chooses", [&] {
        alt(on(never.in(), [](int) {}), on(c.in(), [](int) {}));
        wait_for(1us);
    });
    sought.simulation.process("late", [&] {
        wait_for(5us);
        c.out().output(1);
    });
    CHECK(sought.parts() == Lines{"delayed: late, 0 to 5000", "delayed: chooses, 5000 to 6000"});
}

TEST_CASE("while a process waits for its processor, the path has the processor's work") {
    Sought sought;
    hardware::Processor& t = sought.processor();
    for (const char* name : {"first", "second"})
        sought.simulation.process(
            name, [] { compute(Cycles{1000}); }, &t);
    Lines parts = sought.parts();
    REQUIRE(parts.size() == 2);
    CHECK(parts[0].starts_with("computing: first on t, 0 to "));
    CHECK(parts[1].starts_with("computing: second on t, "));
}

TEST_CASE("at the end of a PAR the path leads to its last component") {
    Sought sought;
    sought.simulation.process("p", [] {
        par([] { wait_for(1us); }, [] { wait_for(2us); });
        wait_for(1us);
    });
    CHECK(sought.parts() == Lines{"delayed: p, 0 to 3000"}); // listed under the process's name
}

TEST_CASE("the path ends with an idle part if the run ends after its processes") {
    Sought sought;
    sought.simulation.process("p", [] { wait_for(1us); });
    sought.simulation.process("late", [] { wait_for(9us); });
    CHECK(sought.parts(5us) == Lines{"delayed: p, 0 to 1000", "nothing more, 1000 to 5000"});
}

TEST_CASE("the path avoids processes that never continue") {
    Sought sought;
    sought.simulation.process("p", [] { wait_for(1us); });
    sought.simulation.process("stuck", [] { stop(); });
    CHECK(sought.parts() == Lines{"delayed: p, 0 to 1000"});
}

TEST_CASE("while a process waits for a bus, the path has the bus's work") {
    Sought sought;
    struct Memory final : hardware::BusSlave {
        std::string name = "memory";
        const std::string& bus_name() const override { return name; }
    } memory;
    auto& bus = sought.simulation.add<hardware::VmeBus>("bus", hardware::Arbitration::priority,
                                                        hardware::VmeTiming{.word = 100ns, .arbitration = 50ns});
    for (int i = 0; i < 2; ++i) {
        std::string number = std::to_string(i);
        auto& m = sought.simulation.add<hardware::VmeMaster>("m" + number, bus, hardware::VmePlace{3, i + 1});
        sought.simulation.process(
            "p" + number, [&] { m.move_words(memory, 3); }, &sought.processor(("t" + number).c_str()));
    }
    CHECK(sought.parts() == Lines{"arbitrating: bus, 0 to 50", "moving words: p0 on t0 over bus, 50 to 350",
                                  "arbitrating: bus, 350 to 400", "moving words: p1 on t1 over bus, 400 to 700"});
    CHECK(sought.path.accounts().at("p1").communicating == 700ns);
}

TEST_CASE("a path with too many points is not kept, but the accounts are") {
    Sought sought(4);
    sought.simulation.process("p", [] {
        for (int i = 0; i < 100; ++i)
            wait_for(1us);
    });
    CHECK(sought.parts().empty());
    CHECK(sought.path.too_long());
    CHECK(sought.path.accounts().at("p").delayed == 100us);
}

TEST_CASE("a process's time is divided into computing, ready, delays, and waits by partner") {
    Sought sought;
    Channel<int> c("c");
    hardware::Processor& t = sought.processor();
    sought.simulation.process(
        "works",
        [&] {
            compute(Cycles{2000});
            c.out().output(1);
        },
        &t);
    sought.simulation.process("waits", [&] {
        wait_for(1us);
        c.in().input();
    });
    sought.simulation.run();
    const Account &works = sought.path.accounts().at("works"), &waits = sought.path.accounts().at("waits");
    CHECK(works.computing >= 2us);
    CHECK(works.waiting == 0us);
    CHECK(waits.delayed == 1us);
    CHECK(waits.computing == 0us);
    CHECK(waits.most_waited_for() == "works");
    CHECK(waits.waiting_for.at("works") == waits.waiting);
    CHECK(waits.life() == waits.delayed + waits.waiting + waits.communicating);
}

TEST_CASE("shares sum equal parts, the longest first, with arrays combined") {
    auto part = [](Activity activity, const char* subject, int begin, int end) {
        return PathPart{activity, subject, "", Time{1ns * begin}, Time{1ns * end}};
    };
    std::vector<PathPart> path{
        part(Activity::computing, "slave[0] on t[0]", 0, 3), part(Activity::carrying, "a[0] -> b", 3, 5),
        part(Activity::computing, "slave[1] on t[1]", 5, 6), part(Activity::computing, "slave[0] on t[0]", 6, 7)};
    CHECK(texts_of(shares_of(path)) ==
          Lines{"computing: slave[0] on t[0] 4", "communicating: a[0] -> b 2", "computing: slave[1] on t[1] 1"});
    CHECK(texts_of(shares_by_array(path)) == Lines{"computing: slave[] on t[] 5", "communicating: a[] -> b 2"});
    CHECK(texts_of(shares_by_activity(path)) == Lines{"computing 5", "communicating 2"});
}

TEST_CASE("of equal shares, computing comes before waits") {
    auto part = [](Activity activity, int begin) {
        return PathPart{activity, "p", "", Time{begin}, Time{begin + 1000}};
    };
    std::vector<PathPart> path{part(Activity::ready, 0), part(Activity::delayed, 1000), part(Activity::carrying, 2000),
                               part(Activity::computing, 3000), part(Activity::ended, 4000)};
    CHECK(texts_of(shares_of(path)) == Lines{"computing: p 1", "communicating: p 1", "delayed: p 1",
                                             "ready, not running: p 1", "nothing more: p 1"});
}
