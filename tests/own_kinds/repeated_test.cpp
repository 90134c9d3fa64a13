// Tests processes that do odd things at random. A worker that repeats runs with other seeds must get the results of
// separate runs.

#include "explore/problems.hpp"
#include "explore/study/sweep.hpp"
#include "netlist/kinds/description.hpp"
#include "netlist/kinds/environment.hpp"
#include "netlist/repeated_run.hpp"
#include "runtime/alternation.hpp"
#include "runtime/executive.hpp"
#include "runtime/parallel.hpp"
#include "runtime/timer.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using namespace placedpar;

namespace {

using Body = std::function<void(ProcessEnvironment&, RandomStream&)>;

void throw_dice(ProcessEnvironment& environment, RandomStream& random) {
    std::uint32_t eyes = 0;
    for (int i = 0; i < 3; ++i) {
        eyes += 1 + random.below(6);
        compute(Cycles{1000});
    }
    environment.measure("eyes", eyes);
}

void compute_for_the_eyes(ProcessEnvironment& environment, RandomStream& random) {
    std::uint32_t eyes = 1 + random.below(3);
    compute(Cycles{1000 * eyes});
    environment.measure("eyes", eyes);
}

void note_when_it_was_better(ProcessEnvironment& environment, RandomStream& random) {
    std::uint32_t best = 0;
    Time when{};
    for (int i = 0; i < 20; ++i) {
        compute(Cycles{1000});
        if (std::uint32_t drawn = random.below(1000); drawn > best)
            best = drawn, when = now();
    }
    environment.measure("when", in_milliseconds(when), "ms");
}

void read_the_timer_by_chance(ProcessEnvironment& environment, RandomStream& random) {
    std::int32_t last = 0;
    for (int i = 0; i < 200; ++i) {
        compute(Cycles{100});
        if (i < 10 || random.chance(0.2))
            last = Timer().read();
    }
    environment.measure("last", last);
}

void read_the_clock_before_alternating(ProcessEnvironment& environment, RandomStream& random) {
    std::vector<Guard> guards{{Guard::skip}, {Guard::skip}};
    std::vector<double> values{1, 2};
    double sum = 0;
    for (int i = 0; i < 10; ++i) {
        compute(Cycles{100});
        if (random.chance(0.1))
            now();
        sum += values.at(select(guards));
    }
    environment.measure("sum", sum);
}

void measure_in_components(ProcessEnvironment& environment, RandomStream& random) {
    auto component = [&](std::int64_t cycles, const char* name) {
        return [&environment, cycles, name, drawn = random.below(100)] {
            compute(Cycles{cycles});
            environment.measure(name, drawn);
        };
    };
    par(component(5000, "a"), component(1000, "b"));
}

void measure_in_a_destructor(ProcessEnvironment& environment, RandomStream& random) {
    struct Reporter {
        ~Reporter() { environment.measure("n", n); }
        ProcessEnvironment& environment;
        double n = 0;
    } reporter{environment};
    for (std::uint32_t i = 0, n = 1 + random.below(3); i < n; ++i) {
        ++reporter.n;
        compute(Cycles{100});
    }
}

void read_the_clock_in_destructors(ProcessEnvironment& environment, RandomStream& random) {
    std::vector<Time> laps;
    laps.reserve(100);
    struct Lap {
        ~Lap() { laps.push_back(now()); }
        std::vector<Time>& laps;
    };
    for (int i = 0; i < 20; ++i) {
        compute(Cycles{100});
        if (random.chance(0.2))
            Lap lap{laps};
    }
    environment.measure("laps", static_cast<double>(laps.size()));
    environment.measure("last", laps.empty() ? 0 : in_milliseconds(laps.back()), "ms");
}

void swap_channels_of_one_name(ProcessEnvironment& environment, RandomStream& random) {
    Channel<int> a("c"), b("c");
    Time came_on_a{}, came_on_b{};
    auto output = [&](Channel<int>& first, Channel<int>& second) {
        first.out().output(1), compute(Cycles{1000}), second.out().output(1);
    };
    auto outputs = [&, swapped = random.chance(0.5)] { swapped ? output(b, a) : output(a, b); };
    par(
        outputs, [&] { a.in().input(), came_on_a = now(); }, [&] { b.in().input(), came_on_b = now(); });
    environment.measure("a", in_milliseconds(came_on_a), "ms");
    environment.measure("b", in_milliseconds(came_on_b), "ms");
}

void swallow_everything(ProcessEnvironment& environment, RandomStream& random) {
    environment.measure("drawn", random.below(100));
    try {
        for (std::uint32_t i = 0, n = 1 + random.below(3); i < n; ++i)
            compute(Cycles{1000});
    } catch (const Unwinding&) {
        throw;
    } catch (...) { // bad practice
    }
}

/// Reads the clock at random, and then uses the timer.
void wait_for_the_timer(ProcessEnvironment& environment, RandomStream& random) {
    Timer timer;
    for (int i = 0; i < 5; ++i) {
        compute(Cycles{100});
        if (random.chance(0.1))
            now();
        timer.wait_after(timer.plus(timer.read(), 2));
    }
    environment.measure("read", timer.read());
}

/// Catches everything and retries, which is bad practice.
void try_again_for_ever(ProcessEnvironment& environment, RandomStream& random) {
    std::uint32_t done = 0;
    for (std::uint32_t n = 1 + random.below(3); done < n;)
        try {
            compute(Cycles{100});
            ++done;
        } catch (const Unwinding&) {
            throw;
        } catch (...) {
        }
    environment.measure("done", done);
}

/// Asks for a negative computation, which an executive refuses.
void compute_backwards(ProcessEnvironment& environment, RandomStream& random) {
    double failed = 0;
    try {
        compute(Cycles{-1});
    } catch (const std::logic_error&) {
        failed = 1 + random.below(100);
    }
    environment.measure("failed", failed);
}

/// Throws if the clock makes no sense, as it may after a departure from the recorded run.
void throw_what_it_likes(ProcessEnvironment& environment, RandomStream& random) {
    Time first = now();
    compute(Cycles{100});
    if (random.chance(0.3))
        now();
    Time second = now();
    if (second <= first)
        throw std::bad_alloc();
    compute(Cycles{100});
    if (now() <= second)
        throw 5;
    environment.measure("eyes", random.below(6));
}

/// May refuse the result when everything else is done.
void refuse_what_came_out(ProcessEnvironment& environment, RandomStream& random) {
    std::uint32_t eyes = 1 + random.below(6);
    compute(Cycles{1000});
    if (eyes == 6 || environment.seed() == 1)
        throw UserError("not a six again");
    environment.measure("eyes", eyes);
}

void compute_very_often(ProcessEnvironment& environment, RandomStream&) {
    for (int i = 0; i < 2'000'000; ++i)
        compute(Cycles{1});
    environment.measure("done", 1);
}

const std::map<std::string, Body>& bodies() {
    static const std::map<std::string, Body> all{
        {"throws", throw_dice},
        {"computes", compute_for_the_eyes},
        {"when", note_when_it_was_better},
        {"timer", read_the_timer_by_chance},
        {"clock, then ALT", read_the_clock_before_alternating},
        {"components", measure_in_components},
        {"reporter", measure_in_a_destructor},
        {"laps", read_the_clock_in_destructors},
        {"swapped", swap_channels_of_one_name},
        {"swallows", swallow_everything},
        {"refuses", refuse_what_came_out},
        {"waits", wait_for_the_timer},
        {"tries again", try_again_for_ever},
        {"backwards", compute_backwards},
        {"senseless", throw_what_it_likes},
        {"often", compute_very_often},
    };
    return all;
}

ProcessKind odd_kind() {
    return {.name = "own.odd",
            .about = "Does odd things.",
            .parameters = {description::text("does", {}, "what")},
            .body =
                [](ProcessEnvironment& environment) {
                    RandomStream random = environment.random_stream(environment.process());
                    bodies().at(environment.text("does"))(environment, random);
                },
            .is_determinate = always};
}

/// The netlist, deleted after the tests.
struct NetlistFile {
    NetlistFile() {
        std::ofstream(path) << R"(val does "throws"; T800 t; process (interface ()) odd; use "own.odd" for odd;
odd (does = does); place odd on t;)";
    }
    ~NetlistFile() { std::filesystem::remove(path); }
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / fmt::format("placedpar-own-kinds-{}.cfs", ::getpid());
};

Study study_of(const std::string& does, std::uint64_t seeds) {
    static const bool known = (add_own_kinds({odd_kind()}), true);
    REQUIRE(known);
    static const NetlistFile netlist;
    Study study;
    study.netlist = netlist.path.string();
    study.products.emplace_back();
    study.products.back().axes.push_back(read_axis("does=\"" + does + "\""));
    study.seeds = seeds;
    return study;
}

std::string all_of(const std::optional<StudyOutcome>& outcome) {
    REQUIRE(outcome);
    return fmt::format("{} {} {:016x} {} {}", outcome->ended, to_string(outcome->time), outcome->fingerprint,
                       outcome->refused, figures_text(outcome->figures));
}

/// Compares a worker's runs with separate runs. Returns how many runs the worker repeated.
std::uint64_t check(const std::string& does, std::uint64_t seeds = 12) {
    Study study = study_of(does, seeds);
    StudyWorker worker(study);
    Interruption never;
    for (std::uint64_t i = 0; i < seeds; ++i) {
        CAPTURE(does);
        CAPTURE(i);
        CHECK(all_of(worker.outcome_of(*study.at(i), never)) ==
              all_of(StudyWorker(study).outcome_of(*study.at(i), never)));
    }
    return worker.repeated();
}

} // namespace

TEST_CASE("what does not depend on random numbers is repeated, whatever these are") { CHECK(check("throws") == 11); }

TEST_CASE("where one run does something else than the one before, it is simulated, and the next is compared with it") {
    std::uint64_t repeated = check("computes");
    CHECK(repeated > 0);
    CHECK(repeated < 11);
}

TEST_CASE("odd programs come to what they come to alone") {
    for (const auto& [does, body] : bodies())
        if (does != "often")
            check(does);
}

TEST_CASE("a run that was refused is not repeated") {
    std::uint64_t repeated = check("refuses");
    CHECK(repeated > 0);
    CHECK(repeated < 10);
}

TEST_CASE("who measures in components is not repeated") { CHECK(check("components") == 0); }

TEST_CASE("an interruption reaches a run that is repeated by one process that never waits") {
    Study study = study_of("often", 2);
    StudyWorker worker(study);
    Interruption never, soon;
    REQUIRE(worker.outcome_of(*study.at(0), never));
    std::thread interrupter([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds{1});
        soon.request();
    });
    std::optional<StudyOutcome> outcome = worker.outcome_of(*study.at(1), soon);
    interrupter.join();
    CHECK_FALSE(outcome);
    CHECK(worker.repeated() == 0);
}
