// The log of a run as its readers are told it.

#include "observe/trace/trace_fork.hpp"

#include "runtime/hardware/processor.hpp"
#include "runtime/parallel.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

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

/// Notes what it is told as text, with moments in nanoseconds.
struct ToldLines final : TraceSink {
    void turns(const Process& process, Activity activity, Time now) override {
        lines.push_back(fmt::format("{} {} {}", now / 1ns, process.path(), log_word(activity)));
    }
    void communicated(const AnyChannel& channel, Time now) override {
        lines.push_back(fmt::format("{} over {}", now / 1ns, channel.name()));
    }
    void takes(const PlaceTaken& taken, Time now) override {
        lines.push_back(
            fmt::format("{} {} takes {} from {}", now / 1ns, taken.subject, taken.place, taken.since / 1ns));
    }
    void leaves(const PlaceLeft& left, Time now) override {
        lines.push_back(fmt::format("{} {} left at {}, {} bytes", now / 1ns, left.place, left.until / 1ns, left.bytes));
    }
    void over(Time now) override { lines.push_back(fmt::format("{} over", now / 1ns)); }

    Lines lines;
};

} // namespace

TEST_CASE("a process starts, waits, is ready, goes on and ends") {
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

TEST_CASE("a PAR joins its components, and what ends it is said of them alone") {
    Simulation simulation;
    ToldLines notes;
    simulation.trace_to(notes);
    simulation.process("p", [] { par([] { wait_for(1us); }, [] {}); });
    simulation.run();
    for (const char* line :
         {"0 p joins", "0 p/0 starts", "0 p/1 starts", "0 p/1 ended", "1000 p/0 ended", "1000 p executes"})
        CHECK(std::ranges::count(notes.lines, line) == 1);
}

TEST_CASE("several sinks are told the same") {
    ToldLines alone, one, other;
    auto run = [](TraceSink& sink) {
        Simulation simulation;
        simulation.trace_to(sink);
        simulation.process("p", [] { wait_for(1us); });
        simulation.run();
    };
    TraceFork fork({&one, &other});
    run(alone);
    run(fork);
    std::string place = "bus", subject = "m";
    for (TraceSink* sink : std::initializer_list<TraceSink*>{&alone, &fork}) {
        sink->takes({place, subject, Time{2us}}, Time{1us});
        sink->leaves({place, Time{4us}, 8}, Time{3us});
    }
    CHECK(alone.lines.back() == "3000 bus left at 4000, 8 bytes");
    CHECK(one.lines == alone.lines);
    CHECK(other.lines == alone.lines);
}
