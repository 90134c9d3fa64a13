// Tests how a run's trace events become slices and messages.

#include "on_one_node.hpp"

#include "observe/trace/timeline.hpp"
#include "runtime/alternation.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/parallel.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace placedpar;
using test::on_one_node;
using namespace std::chrono_literals;

namespace {

const char* word(Activity activity) {
    const char* words[] = {"executes", "carries",    "ready", "computes",   "delayed", "outputs",
                           "inputs",   "alternates", "joins", "after_work", "stopped"};
    return words[static_cast<std::size_t>(activity)];
}

/// Writes the slices and messages that it receives as text.
struct Notes final : TraceWriter {
    explicit Notes(const Tracks& t) : tracks(t) {}
    void write(const Slice& s) override {
        std::string line = fmt::format("{}: {} {} to {}", tracks.all()[s.track].name, word(s.activity), s.begin / 1ns,
                                       s.open ? "the end" : std::to_string(s.end / 1ns));
        for (const Awaited& awaited : s.awaited)
            line += fmt::format(", {} with {}", awaited.channel, awaited.partner);
        lines.push_back(line + (s.awaits_timer ? ", timer" : ""));
    }
    void write(const MessageArrow& p) override {
        lines.push_back(fmt::format("{}: {} at {} to {} at {}", p.channel, tracks.all()[p.from].name, p.left / 1ns,
                                    tracks.all()[p.to].name, p.arrived / 1ns));
    }
    void finish(Time begin, Time end, const std::string& why) override {
        lines.push_back(fmt::format("{} to {}: {}", begin / 1ns, end / 1ns, why));
    }

    /// Returns the lines that begin with `what`.
    std::vector<std::string> about(const std::string& what) const {
        std::vector<std::string> found;
        for (const std::string& line : lines)
            if (line.starts_with(what))
                found.push_back(line);
        return found;
    }

    const Tracks& tracks;
    std::vector<std::string> lines;
};

using Lines = std::vector<std::string>;

/// A simulation with traced processes. A cycle of its processor of 1 GHz takes 1 ns.
struct Traced {
    explicit Traced(const std::vector<std::string>& processes, const TraceWindow& window = {})
        : tracks(on_one_node(processes)), notes(tracks), timeline(tracks, window, notes) {
        simulation.trace_to(timeline);
    }
    hardware::Processor& processor() { return simulation.add<hardware::Processor>("t", 1'000'000'000); }
    const Notes& run(Time limit = Time::max()) {
        timeline.finish(simulation.run(limit));
        return notes;
    }

    Simulation simulation;
    Tracks tracks;
    Notes notes;
    Timeline timeline;
};

} // namespace

TEST_CASE("a PAR in a loop reuses its tracks, which follow their parent") {
    Traced traced({"p", "q"});
    for (const char* name : {"p", "q"})
        traced.simulation.process(name, [] {
            for (int i = 0; i < 5; ++i)
                par([] { wait_for(1us); }, [] { wait_for(2us); });
        });
    traced.run();
    Lines drawn;
    for (std::size_t track : traced.tracks.drawn())
        drawn.push_back(traced.tracks.all()[track].name);
    CHECK(drawn == Lines{"t", "p", "p/0", "p/1", "q", "q/0", "q/1"});
    CHECK(traced.notes.about("p/1").size() == 5);
    CHECK(traced.notes.about("p:").size() == 5); // p waits for its components
}

TEST_CASE("a wait shows its channels, its partner and its timer") {
    Traced traced({"p", "q"});
    Channel<int> c("c"), d("d");
    traced.simulation.process("p", [&] {
        wait_for(1us);
        alt(on(c.in(), [](int) {}), on(d.in(), [](int) {}), after(4us, [] {}));
        c.in().input();
    });
    traced.simulation.process("q", [&] {
        wait_for(6us);
        c.out().output(1);
    });
    const Notes& notes = traced.run();
    CHECK(notes.about("p:") == Lines{"p: delayed 0 to 1000, timer",
                                     "p: alternates 1000 to 4000, c with , d with , timer",
                                     "p: inputs 4000 to 6000, c with q"});
    CHECK(notes.about("q:") == Lines{"q: delayed 0 to 6000, timer"});
}

TEST_CASE("a message begins at the output and ends where the other process continues") {
    Traced traced({"p", "q"});
    Channel<int> c("c");
    hardware::Processor& t = traced.processor();
    auto input = [&] {
        c.in().input();
        compute(Cycles{500});
    };
    auto output = [&] {
        compute(Cycles{1000});
        c.out().output(1);
        compute(Cycles{1000});
    };
    traced.simulation.process("q", input, &t);
    traced.simulation.process("p", output, &t);
    const Notes& notes = traced.run();
    // q is first, and waits. The message leaves when p has spent the time of its output, including the copy.
    CHECK(notes.about("q:") ==
          Lines{"q: computes 0 to 19", "q: inputs 19 to 2042, c with p", "q: computes 2042 to 2542"});
    CHECK(notes.about("p:") == Lines{"p: ready 0 to 19", "p: computes 19 to 1042", "p: computes 1042 to 2042"});
    CHECK(notes.about("t:") == Lines{"t: executes 0 to 19", "t: executes 19 to 2042", "t: executes 2042 to 2542"});
    CHECK(notes.about("c:") == Lines{"c: p at 1042 to q at 2042"});
}

TEST_CASE("a process that loses its processor is ready until it computes again") {
    Traced traced({"low", "high"});
    hardware::Processor& t = traced.processor();
    traced.simulation.process(
        "low", [] { compute(Cycles{10'000}); }, &t);
    auto interrupt = [] {
        wait_for(4us);
        compute(Cycles{1000});
    };
    traced.simulation.process("high", interrupt, &t, Priority::high);
    const Notes& notes = traced.run();
    // An interruption costs the processor 19 cycles; the second time, `high` is still waiting meanwhile.
    CHECK(notes.about("high:") ==
          Lines{"high: computes 0 to 19", "high: delayed 19 to 4038, timer", "high: computes 4038 to 5038"});
    CHECK(notes.about("low:") == Lines{"low: ready 0 to 19", "low: computes 19 to 4019", "low: ready 4019 to 5038",
                                       "low: computes 5038 to 11038"});
    CHECK(notes.about("t:") == Lines{"t: executes 0 to 19", "t: executes 19 to 4019", "t: executes 4019 to 5038",
                                     "t: executes 5038 to 11038"});
}

TEST_CASE("at a deadlock, at the limit of time and at the end of the window the waits are open") {
    SUBCASE("deadlock") {
        Traced traced({"p"});
        Channel<int> c("c");
        traced.simulation.process("p", [&] { c.in().input(); });
        CHECK(traced.run().lines == Lines{"p: inputs 0 to the end, c with ", "0 to 0: deadlock"});
    }
    SUBCASE("stopped process") {
        Traced traced({"p"});
        traced.simulation.process("p", [] { wait_for(1us), stop(); });
        traced.simulation.process("q", [] { wait_for(9us); });
        CHECK(traced.run().lines ==
              Lines{"p: delayed 0 to 1000, timer", "p: stopped 1000 to the end", "0 to 9000: deadlock"});
    }
    SUBCASE("limit") {
        Traced traced({"p"});
        traced.simulation.process("p", [] { wait_for(9us); });
        CHECK(traced.run(5us).lines == Lines{"p: delayed 0 to the end, timer", "0 to 5000: stopped at the time limit"});
    }
    SUBCASE("window") {
        Traced traced({"p"}, {.from = 2us, .until = 5us});
        traced.simulation.process("p", [] {
            for (int i = 0; i < 9; ++i)
                wait_for(3us);
        });
        CHECK(traced.run().lines == Lines{"p: delayed 2000 to 3000, timer", "p: delayed 3000 to the end, timer",
                                          "2000 to 5000: end of the part that is traced"});
    }
}

TEST_CASE("at the end of the work only endless waits are open") {
    auto run = [](bool stuck) {
        Traced traced({"p", "q", "r"});
        Channel<int> c("c"), never("never");
        traced.simulation.process("p", [&] {
            wait_for(1us);
            wait_until_work_is_over();
            c.out().output(1);
        });
        traced.simulation.process("q", [&] { c.in().input(); });
        traced.simulation.process("r", [&] {
            wait_for(2us);
            if (stuck)
                never.in().input();
        });
        return traced.run().lines;
    };
    for (bool stuck : {false, true}) {
        Lines lines = run(stuck);
        auto has = [&](const std::string& line) { return std::ranges::find(lines, line) != lines.end(); };
        CHECK(has("p: after_work 1000 to 2000"));
        CHECK(has("q: inputs 0 to 2000, c with "));
        CHECK(has("r: inputs 2000 to the end, never with ") == stuck);
        CHECK(lines.back() == (stuck ? "0 to 2000: deadlock" : "0 to 2000: completed"));
    }
}

TEST_CASE("a full trace ends and reports its end") {
    Traced traced({"p"}, {.most_entries = 3});
    traced.simulation.process("p", [] {
        for (int i = 0; i < 9; ++i)
            wait_for(1us);
    });
    const Notes& notes = traced.run();
    CHECK(notes.about("p:").size() == 3);
    CHECK(notes.lines.back() == "0 to 3000: the trace is full");
    CHECK(traced.timeline.full_at() == Time{3us});
}

TEST_CASE("slices without duration are not drawn") {
    Traced traced({"p", "q"});
    Channel<int> c("c");
    traced.simulation.process("p", [&] {
        for (int i = 0; i < 3; ++i)
            c.out().output(i);
        wait_for(1us);
    });
    traced.simulation.process("q", [&] {
        for (int i = 0; i < 3; ++i)
            c.in().input();
        wait_for(1us);
    });
    const Notes& notes = traced.run();
    CHECK(notes.about("p:") == Lines{"p: delayed 0 to 1000, timer"});
    CHECK(notes.about("c:").size() == 3);
}

TEST_CASE("processes that are known by their names have slices and messages") {
    Traced t({"p", "q"});
    const auto turn = [&](const std::string& process, Activity activity, Time now, const std::string& partner = "") {
        std::vector<AwaitedByProgram> awaited;
        if (!partner.empty())
            awaited.push_back({"c", partner});
        t.timeline.program_turns({process, "t", activity, awaited, false, ""}, now);
    };
    const auto part = [&](std::uint64_t number, const std::string& process, const std::string& partner, Time now) {
        t.timeline.program_communicates({"c", number, process, partner, process == "q"}, now);
    };
    turn("p", Activity::computing, 0ns);
    turn("p", Activity::outputting, 10ns, "q");
    turn("q", Activity::computing, 20ns);
    part(1, "q", "p/0", 30ns); // the outputter waits
    part(1, "p", "q", 40ns);
    turn("p", Activity::computing, 50ns);
    turn("q", Activity::inputting, 60ns, "p");
    part(2, "p", "q", 70ns); // the inputter waits
    part(2, "q", "p/0", 70ns);
    turn("q", Activity::computing, 80ns);
    part(3, "q", "p", 85ns); // by a clock that is behind
    part(3, "p", "q", 90ns);
    t.timeline.ends_early(100ns, "the record is full");
    t.timeline.finish({});
    CHECK(t.notes.about("p: ") == Lines{"p: computes 0 to 10", "p: outputs 10 to 50, c with q", "p: computes 50 to 70",
                                        "p: computes 70 to 90", "p: computes 90 to the end"});
    CHECK(t.notes.about("q: ") == Lines{"q: computes 20 to 30", "q: computes 30 to 60",
                                        "q: inputs 60 to 80, c with p/0", "q: computes 80 to 85",
                                        "q: computes 85 to the end"});
    CHECK(t.notes.about("c: ") == Lines{"c: p at 10 to q at 30", "c: p at 70 to q at 80", "c: p at 90 to q at 90"});
    CHECK(t.notes.lines.back() == "0 to 100: the record is full");
}
