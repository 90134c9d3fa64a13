// Tests the recording of a run's processes, and their replay with other messages and without a machine.

#include "runtime/alternation.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/kernel.hpp"
#include "runtime/parallel.hpp"
#include "runtime/recovery.hpp"
#include "runtime/replay_log.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using namespace placedpar;
using namespace placedpar::hardware;
using std::chrono::microseconds;
using std::chrono::nanoseconds;

namespace {

struct Saying {
    std::uint64_t says = 0;
    std::uint32_t bytes = 1;
    WireForm wire_form() const { return WireForm(4u, bytes); }
};

std::uint64_t mixed(std::uint64_t a, std::uint64_t b) {
    Fingerprint both;
    both.mix(a), both.mix(b);
    return both.value();
}

struct Histories {
    ReplaySession course;
    std::list<ReplayLog> histories;
};

/// Sources, mergers that alternate between their sources, and a sink that alternates between the mergers. Each process
/// runs on its own processor, with links between them, or all run without processors. One seed determines their
/// actions, another the content of their messages. If `depends`, the actions depend on a message.
class MergingProgram {
public:
    MergingProgram(std::uint64_t seed, std::uint64_t says, bool on_machine, bool depends)
        : says_(says), depends_(depends), random_(seed, "program") {
        std::size_t mergers = 1 + random_.below(3);
        std::vector<PlacedNode> merging;
        for (std::size_t i = 0; i < mergers; ++i)
            merging.push_back(node(on_machine));
        PlacedNode sink = node(on_machine);
        std::vector<Channel<Saying>*> merged;
        for (PlacedNode& merger : merging) {
            std::vector<Channel<Saying>*> sent;
            std::size_t letters = 0;
            for (std::size_t i = 0, sources = 1 + random_.below(3); i < sources; ++i) {
                PlacedNode source = node(on_machine);
                sent.push_back(&channel(source, merger));
                std::size_t count = 1 + random_.below(8);
                letters += count;
                add(source, [this, to = sent.back(), count](RandomStream& random) { send(*to, count, random); });
            }
            merged.push_back(&channel(merger, sink));
            letters_ += letters;
            add(merger, [this, sent, to = merged.back(), letters](RandomStream& random) {
                merge(
                    sent, letters, [to](Saying letter) { to->out().output(letter); }, random);
            });
        }
        add(sink, [this, merged](RandomStream& random) {
            merge(
                merged, letters_, [](Saying) {}, random);
        });
    }

    /// The values that each process computed from its messages and observations, and the fingerprint.
    struct Result {
        std::vector<std::uint64_t> computed;
        std::uint64_t fingerprint = 0;
    };
    Result record(Histories& all) {
        for (Process* process : processes_)
            process->keep(all.histories.emplace_back(all.course, all.histories.size()));
        return run();
    }
    std::optional<Result> repeat(const Histories& originals) {
        auto original = originals.histories.begin();
        for (Process* process : processes_)
            process->keep(again_.histories.emplace_back(again_.course, *original++));
        try {
            Result result = run();
            return again_.course.has_diverged ? std::nullopt : std::optional(result);
        } catch (const ReplayDivergence&) {
            return std::nullopt;
        }
    }
    Result run() {
        RunResult run = simulation_.run();
        result_.fingerprint = run.fingerprint;
        if (run.ending != Ending::completed)
            result_.computed.clear();
        return result_;
    }

private:
    struct PlacedNode {
        Processor* processor;
    };
    PlacedNode node(bool on_machine) {
        return {on_machine ? &simulation_.add<Processor>(fmt::format("t{}", ++nodes_)) : nullptr};
    }
    Channel<Saying>& channel(PlacedNode& from, PlacedNode& to) {
        auto& made = channels_.emplace_back(fmt::format("c{}", channels_.size()));
        if (from.processor) {
            Link& link = simulation_.add<Link>();
            from.processor->has_link(link), to.processor->has_link(link);
            made.put_on(link.from_a_to_b());
        }
        return made;
    }
    void add(PlacedNode node, const std::function<void(RandomStream&)>& body) {
        std::size_t number = processes_.size();
        std::uint32_t seed = random_.below(1'000'000);
        result_.computed.push_back(0);
        processes_.push_back(&simulation_.process(
            fmt::format("p{}", number),
            [this, number, seed, body] {
                RandomStream random(seed, "process");
                computed_ = &result_.computed[number];
                body(random);
            },
            node.processor, random_.chance(0.3) ? Priority::high : Priority::low));
    }

    /// Mixes a number into the running process's state, which determines what the process computes.
    static void learn(std::uint64_t& knows, std::uint64_t what) { knows = mixed(knows, what); }

    void send(Channel<Saying>& to, std::size_t count, RandomStream& random) {
        std::uint64_t& knows = *computed_;
        for (std::size_t i = 0; i < count; ++i) {
            do_something(knows, random);
            learn(knows, mixed(says_, i));
            to.out().output({knows, 1 + random.below(60)});
        }
    }
    void merge(const std::vector<Channel<Saying>*>& from, std::size_t letters, const std::function<void(Saying)>& then,
               RandomStream& random) {
        std::uint64_t& knows = *computed_;
        while (letters > 0) {
            std::vector<Guard> guards;
            for (Channel<Saying>* each : from)
                guards.push_back({Guard::input, each});
            if (random.chance(0.4))
                guards.push_back({Guard::timeout, nullptr, later(now(), nanoseconds{random.below(30'000)})});
            std::size_t chosen = select(guards);
            learn(knows, chosen);
            if (chosen == from.size())
                continue;
            Saying letter = from[chosen]->in().input();
            learn(knows, letter.says);
            if (depends_ && letter.says % 64 == 0)
                do_something(knows, random);
            do_something(knows, random);
            then({knows, letter.bytes});
            --letters;
        }
    }
    static void do_something(std::uint64_t& knows, RandomStream& random) {
        switch (random.below(6)) {
        case 0: compute(Cycles{random.below(400)}); break;
        case 1: wait_for(nanoseconds{random.below(20'000)}); break;
        case 2: learn(knows, static_cast<std::uint64_t>(now().count())); break;
        case 3: learn(knows, static_cast<std::uint64_t>(Timer().read())); break;
        case 4: learn(knows, in_parallel(knows, random)); break;
        default: break;
        }
    }
    static std::uint64_t in_parallel(std::uint64_t knows, RandomStream& random) {
        Channel<std::uint64_t> inner("inner");
        std::uint64_t sum = 0;
        Cycles first{random.below(200)}, second{random.below(200)};
        auto tell = [&] { compute(first), inner.out().output(knows + 1); };
        auto hear = [&] { compute(second), sum = inner.in().input() + static_cast<std::uint64_t>(now().count()); };
        random.chance(0.5) ? par(tell, hear) : pri_par(hear, tell);
        return sum;
    }

    std::uint64_t says_;
    bool depends_;
    RandomStream random_;
    std::deque<Channel<Saying>> channels_;
    Histories again_;
    Simulation simulation_;
    std::vector<Process*> processes_;
    std::size_t nodes_ = 0, letters_ = 0;
    std::uint64_t* computed_ = nullptr; ///< result of the process that begins next
    Result result_;
};

/// A recorded process that performs one action after another, on a processor or without one.
struct Recorded {
    template <class Body>
    explicit Recorded(Body body) {
        Simulation simulation;
        auto& t800 = simulation.add<Processor>("t800");
        simulation
            .process(
                "p", [&] { body(); }, &t800)
            .keep(history);
        CHECK(simulation.run().ending == Ending::completed);
    }
    /// Replays the process. Returns false if it departs from the record.
    template <class Body>
    bool repeats(Body body) const {
        ReplaySession again;
        ReplayLog history_again(again, history);
        Simulation simulation;
        simulation.process("p", [&] { body(); }).keep(history_again);
        try {
            return simulation.run().ending == Ending::completed && !again.has_diverged;
        } catch (const ReplayDivergence&) {
            CHECK(again.has_diverged);
            return false;
        }
    }
    ReplaySession course;
    ReplayLog history{course, 0};
};

/// Runs a PAR of a process that outputs this many bytes and a process that inputs them.
void communicate(std::uint32_t bytes) {
    Channel<Saying> channel("c");
    par([&] { channel.out().output({0, bytes}); }, [&] { channel.in().input(); });
}

} // namespace

TEST_CASE("a program replayed with other messages does what it would have done on the machine") {
    std::size_t repeated = 0, has_diverged = 0;
    for (std::uint64_t seed : test::seeds(400, 1))
        for (bool depends : {false, true}) {
            INFO(test::replay(seed));
            Histories histories;
            MergingProgram::Result first = MergingProgram(seed, 1, true, depends).record(histories);
            REQUIRE(!first.computed.empty());
            std::optional<MergingProgram::Result> again = MergingProgram(seed, 2, false, depends).repeat(histories);
            MergingProgram::Result on_machine = MergingProgram(seed, 2, true, depends).run();
            if (!depends) {
                REQUIRE(again);
                CHECK(on_machine.fingerprint == first.fingerprint);
            }
            ++(again ? repeated : has_diverged);
            if (again) {
                CHECK(again->computed == on_machine.computed);
                CHECK(on_machine.fingerprint == first.fingerprint);
                CHECK(again->computed != first.computed);
            }
        }
    CHECK(repeated > has_diverged);
    if (test::all_seeds())
        CHECK(has_diverged > 50);
}

TEST_CASE("keeping a history does not change the run") {
    for (std::uint64_t seed : test::seeds(100, 1)) {
        Histories histories;
        MergingProgram::Result recorded = MergingProgram(seed, 1, true, true).record(histories);
        MergingProgram::Result run = MergingProgram(seed, 1, true, true).run();
        CHECK(recorded.fingerprint == run.fingerprint);
        CHECK(recorded.computed == run.computed);
    }
}

TEST_CASE("a process that acts differently departs from its history") {
    auto work = [](Cycles cycles, Time delay, std::uint32_t bytes) {
        compute(cycles, {.between_points = Cycles{5}});
        wait_for(delay);
        communicate(bytes);
    };
    Recorded recorded([&] { work(Cycles{7}, microseconds{3}, 2); });
    CHECK(recorded.course.can_be_repeated);
    CHECK(recorded.repeats([&] { work(Cycles{7}, microseconds{3}, 2); }));
    CHECK_FALSE(recorded.repeats([&] { work(Cycles{8}, microseconds{3}, 2); }));
    CHECK_FALSE(recorded.repeats([&] { work(Cycles{7}, microseconds{4}, 2); }));
    CHECK_FALSE(recorded.repeats([&] { work(Cycles{7}, microseconds{3}, 3); }));
    SUBCASE("at the end") {
        CHECK_FALSE(
            recorded.repeats([&] { compute(Cycles{7}, {.between_points = Cycles{5}}), wait_for(microseconds{3}); }));
        CHECK_FALSE(recorded.repeats([&] { work(Cycles{7}, microseconds{3}, 2), compute(Cycles{1}); }));
        CHECK_FALSE(recorded.repeats([&] { work(Cycles{7}, microseconds{3}, 2), now(); }));
    }
    SUBCASE("where it can be left") {
        CHECK_FALSE(recorded.repeats([&] { compute(Cycles{7}), wait_for(microseconds{3}), communicate(2); }));
    }
}

TEST_CASE("a process that alternates between other guards departs, and with the same guards chooses as before") {
    std::optional<std::size_t> chosen;
    auto alternate = [&](bool on_another, Time due) {
        Channel<int> never("never"), other("other");
        wait_for(microseconds{5});
        chosen = select(std::vector<Guard>{
            {Guard::input, on_another ? &other : &never}, {Guard::timeout, nullptr, due}, {Guard::skip}});
    };
    Recorded recorded([&] { alternate(false, microseconds{4}); });
    CHECK(chosen == 1);
    chosen.reset();
    CHECK(recorded.repeats([&] { alternate(false, microseconds{4}); }));
    CHECK(chosen == 1);
    CHECK_FALSE(recorded.repeats([&] { alternate(false, microseconds{6}); }));
    CHECK_FALSE(recorded.repeats([&] { alternate(true, microseconds{4}); }));
    CHECK_FALSE(recorded.repeats([&] {
        Channel<int> never("never"), other("other");
        wait_for(microseconds{5});
        select(std::vector<Guard>{{Guard::input, &never}, {Guard::timeout, nullptr, microseconds{4}}});
    }));
}

TEST_CASE("a process with other components departs from its history") {
    auto nothing = [] {};
    auto computes = [] { compute(Cycles{3}); };
    Recorded recorded([&] { pri_par(computes, nothing); });
    CHECK(recorded.repeats([&] { pri_par(computes, nothing); }));
    CHECK_FALSE(recorded.repeats([&] { pri_par(nothing, computes); }));
    CHECK_FALSE(recorded.repeats([&] { par(computes, nothing); }));
    CHECK_FALSE(recorded.repeats([&] { par(computes, nothing, nothing); }));
    CHECK_FALSE(recorded.repeats([&] { pri_par(computes, nothing), pri_par(computes, nothing); }));
}

TEST_CASE("replayed clocks show the recorded times") {
    std::vector<std::int64_t> readings;
    auto read = [&] {
        compute(Cycles{3'000});
        Timer timer;
        wait_for(microseconds{100});
        timer.wait_after(timer.plus(timer.read(), 2));
        readings = {now().count(), timer.read(), timer.tick().count(), timer.bits()};
    };
    Recorded recorded(read);
    std::vector<std::int64_t> then = std::exchange(readings, {});
    CHECK(then[0] > 250'000'000);
    CHECK(recorded.repeats(read));
    CHECK(readings == then);
}

TEST_CASE("a process departs if it reads a clock at another point, reads another one, once more, or not at all") {
    auto ask = [](int before, int between, bool again) {
        compute(Cycles{before});
        Time first = now();
        compute(Cycles{between});
        return first + (again ? now() : Time{0});
    };
    Recorded once([&] { ask(5, 7, false); }), twice([&] { ask(5, 7, true); });
    CHECK(once.repeats([&] { ask(5, 7, false); }));
    CHECK_FALSE(once.repeats([&] { ask(5, 7, true); }));
    CHECK_FALSE(twice.repeats([&] { ask(5, 7, false); }));
    CHECK_FALSE(twice.repeats([&] { compute(Cycles{5}), compute(Cycles{7}), now(), now(); }));
    CHECK_FALSE(once.repeats([&] { compute(Cycles{5}), Timer().tick(), compute(Cycles{7}); }));
    CHECK_FALSE(once.repeats([&] { compute(Cycles{5}), Timer().read(), compute(Cycles{7}); }));
    CHECK_FALSE(once.repeats([&] { compute(Cycles{5}), compute(Cycles{7}); }));
}

TEST_CASE("an alternation is given only a choice that it made itself") {
    std::vector<Guard> guards{{Guard::skip}, {Guard::skip}};
    Recorded recorded([&] { now(), select(guards); });
    std::size_t chosen = 0;
    CHECK_FALSE(recorded.repeats([&] { chosen = select(guards); }));
    CHECK(chosen == 0);
    CHECK_FALSE(recorded.repeats([&] { now(), now(), chosen = select(guards); }));
    CHECK(chosen == 0);
}

TEST_CASE("channels of the same name are distinguished") {
    auto use_two = [](bool swapped) {
        Channel<int> a("c"), b("c");
        auto outputs = [&] { (swapped ? b : a).out().output(1), (swapped ? a : b).out().output(2); };
        par(
            outputs, [&] { a.in().input(); }, [&] { b.in().input(); });
    };
    Recorded recorded([&] { use_two(false); });
    CHECK(recorded.repeats([&] { use_two(false); }));
    CHECK_FALSE(recorded.repeats([&] { use_two(true); }));
}

TEST_CASE("a departure counts even if the program swallows its exception") {
    Recorded recorded([] { compute(Cycles{5}); });
    CHECK_FALSE(recorded.repeats([] {
        try {
            compute(Cycles{5}), compute(Cycles{6});
        } catch (...) {
        }
    }));
}

TEST_CASE("destructors may read the clock where the original did not") {
    struct ReadsClock {
        ~ReadsClock() { now(); }
    };
    Recorded recorded([] { compute(Cycles{5}); });
    CHECK_FALSE(recorded.repeats([] {
        ReadsClock here;
        compute(Cycles{5});
    }));
}

TEST_CASE("a process that waits by reading the clock in a loop departs in the end") {
    Recorded recorded([] {
        while (now() < microseconds{5})
            compute(Cycles{20});
    });
    CHECK_FALSE(recorded.repeats([] {
        while (now() < microseconds{6}) {
        }
    }));
}

TEST_CASE("a run with too many readings is not replayed") {
    Recorded recorded([] {
        for (std::size_t i = 0; i <= ReplaySession{}.room; ++i) {
            now();
            if (i % 1000 == 0)
                compute(Cycles{1});
        }
    });
    CHECK_FALSE(recorded.course.can_be_repeated);
}

TEST_CASE("a communication that may be given up cannot be replayed") {
    auto try_input = [] {
        Channel<int> c("c");
        int message = 0;
        CHECK_FALSE(input_or_fail(c.in(), message, microseconds{5}));
    };
    auto reset_one = [] {
        Channel<int> c("c");
        reset(c.in());
    };
    CHECK_FALSE(Recorded(try_input).course.can_be_repeated);
    CHECK_FALSE(Recorded([&] { par(reset_one, [] {}); }).course.can_be_repeated);
    CHECK_FALSE(Recorded([] {}).repeats(reset_one));
}

TEST_CASE("a process that departs may read the clock while it is unwound") {
    struct ReadsClock {
        ~ReadsClock() { read = now(); }
        Time& read;
    };
    Recorded recorded([] {});
    Time read = Time::max();
    CHECK_FALSE(recorded.repeats([&] {
        ReadsClock reader{read};
        communicate(1);
    }));
    CHECK(read == Time{0});
}

TEST_CASE("a process that still waits when another departs may read the clock while it is unwound") {
    Channel<int> never("never");
    struct ReadsClock {
        ~ReadsClock() { read = now(); }
        Time& read;
    };
    Recorded recorded([] {
        Channel<int> c("never");
        par([&] { c.in().input(); }, [&] { c.out().output(1); });
    });
    Time read = Time::max();
    CHECK_FALSE(recorded.repeats([&] {
        auto waits = [&] {
            ReadsClock reader{read};
            never.in().input();
        };
        par(waits, [] { compute(Cycles{1}); });
    }));
    CHECK(read == Time{0});
}
