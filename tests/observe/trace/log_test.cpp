// Tests the events of a run's log in the form in which its readers receive them.

#include "observe/trace/trace_fork.hpp"

#include "runtime/hardware/link.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/hardware/vme_bus.hpp"
#include "runtime/parallel.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace placedpar;
using namespace std::chrono_literals;

namespace {

using Lines = std::vector<std::string>;

const char* log_word(Activity activity) {
    const char* words[] = {"executes", "carries",    "ready", "computes",   "delayed", "outputs",
                           "inputs",   "alternates", "joins", "after work", "stopped", "halted",
                           "ended",    "starts",     "moves", "arbitrates"};
    return words[static_cast<std::size_t>(activity)];
}

/// Writes each event as text, with times in nanoseconds.
struct ToldLines final : TraceSink {
    void turns(const Process& process, Activity activity, Time now) override {
        lines.push_back(fmt::format("{} {} {}", now / 1ns, process.path(), log_word(activity)));
    }
    void communicated(const AnyChannel& channel, Time now) override {
        lines.push_back(fmt::format("{} over {}", now / 1ns, channel.name()));
    }
    void takes(const PlaceTaken& taken, Time now) override {
        lines.push_back(fmt::format("{} {} takes {} from {}{}", now / 1ns, taken.subject, taken.place,
                                    taken.since / 1ns, taken.channel ? ", for " + taken.channel->name() : ""));
    }
    void leaves(const PlaceLeft& left, Time now) override {
        std::string line =
            fmt::format("{} {} left at {}, {} bytes", now / 1ns, left.place, left.until / 1ns, left.bytes);
        if (left.moves_for)
            line += fmt::format(", {}'s from {}", left.moves_for->path(), left.since / 1ns);
        lines.push_back(line);
    }
    void over(Time now) override { lines.push_back(fmt::format("{} over", now / 1ns)); }

    Lines lines;
};

} // namespace

TEST_CASE("the log follows a process that starts, waits, is ready, continues and ends") {
    Simulation simulation;
    Channel<int> c("c");
    ToldLines notes;
    simulation.trace_to(notes);
    simulation.process("p", [&] { c.in().input(); });
    simulation.process("q", [&] {
        wait_for(1us);
        c.out().output(1);
    });
    simulation.run();
    CHECK(notes.lines == Lines{"0 p ready", "0 q ready", "0 p starts", "0 q starts", "0 p inputs", "0 q delayed",
                               "1000 q executes", "1000 over c", "1000 p ready", "1000 q ended", "1000 p executes",
                               "1000 p ended", "1000 over"});
}

TEST_CASE("a process computes while it has its processor, and is ready from then on") {
    Simulation simulation;
    ToldLines notes;
    simulation.trace_to(notes);
    hardware::Processor& t = simulation.add<hardware::Processor>("t", 1'000'000'000);
    simulation.process(
        "p", [] { compute(Cycles{100}); }, &t);
    simulation.run();
    CHECK(notes.lines == Lines{"0 p ready", "0 p starts", "0 p computes", "100 p ready", "100 p ended", "100 over"});
}

TEST_CASE("a PAR joins its components; the log has the end of each component") {
    Simulation simulation;
    ToldLines notes;
    simulation.trace_to(notes);
    simulation.process("p", [] { par([] { wait_for(1us); }, [] {}); });
    simulation.run();
    for (const char* line :
         {"0 p joins", "0 p/0 starts", "0 p/1 starts", "0 p/1 ended", "1000 p/0 ended", "1000 p executes"})
        CHECK(std::ranges::count(notes.lines, line) == 1);
}

namespace {

/// Two processes on one processor move words over a bus, and the second sends a message over a link to a third process.
void run_on_bus_and_link(TraceSink& sink) {
    struct Memory final : hardware::BusSlave {
        std::string name = "memory";
        const std::string& bus_name() const override { return name; }
    } memory;
    Simulation simulation;
    simulation.trace_to(sink);
    hardware::Link& link = simulation.add<hardware::Link>();
    auto& bus = simulation.add<hardware::VmeBus>("bus", hardware::Arbitration::priority,
                                                 hardware::VmeTiming{.word = 100ns, .arbitration = 50ns});
    Channel<int> c("c", link.from_a_to_b());
    for (int i = 0; i < 2; ++i) {
        std::string number = std::to_string(i);
        auto& t = simulation.add<hardware::Processor>("t" + number, 1'000'000'000);
        auto& m = simulation.add<hardware::VmeMaster>("m" + number, bus, hardware::VmePlace{3, i + 1});
        auto move = [&, i] {
            m.move_words(memory, 3);
            if (i == 1)
                c.out().output(1);
        };
        simulation.process("p" + number, move, &t);
    }
    simulation.process("q", [&] { c.in().input(); });
    simulation.run();
}

} // namespace

TEST_CASE("the log of a bus has its waiting masters, its holder, and the process it serves") {
    ToldLines notes;
    run_on_bus_and_link(notes);
    for (const char* line : {"0 waits at BR3 takes bus <- m1 from 0", "350 bus left at 350, 0 bytes, p0's from 50",
                             "400 bus <- m1 left at 400, 0 bytes", "400 m1 takes bus from 400",
                             "700 bus left at 700, 0 bytes, p1's from 400"})
        CHECK_MESSAGE(std::ranges::count(notes.lines, line) == 1, line);
}

TEST_CASE("several sinks receive all events") {
    ToldLines alone, one, other;
    TraceFork fork({&one, &other});
    run_on_bus_and_link(alone);
    run_on_bus_and_link(fork);
    auto told = [&](const char* what) {
        return std::ranges::any_of(alone.lines, [&](const std::string& line) { return line.find(what) != line.npos; });
    };
    for (const char* what :
         {" over c", "c takes a -> b from ", ", for c", " a -> b left at ", " 4 bytes", ", p1's from "})
        CHECK_MESSAGE(told(what), what);
    CHECK(one.lines == alone.lines);
    CHECK(other.lines == alone.lines);
}
