// This program runs the machine of Figure E.2, which has sixteen transputers, as a sweep does. It measures the
// simulated seconds and the number of runs per second of one core. An event is a generation of one of the four islands.
// Runs that differ only in their seeds simulate the machine once; runs with different link speeds simulate it each
// time.

#include "bench/measure.hpp"
#include "explore/study/measure.hpp"
#include "explore/study/sweep.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdint>
#include <string>

using namespace placedpar;
using namespace placedpar::bench;

namespace {

struct Figures {
    double seconds = 0, simulated_seconds = 0, generations = 0;
    double bytes = 0;              ///< memory that the runs took
    std::uint64_t fingerprint = 0; ///< fingerprint of the last run
};

constexpr double processes = 17; ///< the host, four masters, twelve slaves

Figures run_all(const Study& study) {
    const StudyMeasure generations("sum(master.generations)");
    const double before = resident_bytes();
    Figures figures;
    StudyWorker worker(study);
    Interruption never;
    Stopwatch watch;
    for (std::uint64_t i = 0; i < study.count(); ++i) {
        StudyOutcome outcome = *worker.outcome_of(*study.at(i), never);
        if (outcome.ended != "completed")
            throw UserError(outcome.ended + " " + outcome.refused);
        figures.generations += generations.of(outcome.figures).value().value;
        figures.simulated_seconds += std::chrono::duration<double>(outcome.time).count();
        figures.fingerprint = outcome.fingerprint;
    }
    figures.seconds = watch.seconds();
    figures.bytes = resident_bytes() - before;
    return figures;
}

void print_row(const char* what, long runs, const Figures& figures) {
    fmt::print("{:<24} {:7.1f} simulated s/s {:8.1f} runs/s {:8.1f} ns/event   {:8.0f} bytes/process   "
               "fingerprint {:016x}\n",
               what, figures.simulated_seconds / figures.seconds, static_cast<double>(runs) / figures.seconds,
               1e9 * figures.seconds / figures.generations, figures.bytes / processes, figures.fingerprint);
}

Study study_of(const std::string& setting, long seeds) {
    Study study;
    study.netlist = fmt::format("{}/examples/thesis/figure-e2/figure-e2.cfs", PLACEDPAR_SOURCE_DIR);
    study.products.emplace_back();
    study.products.back().axes.push_back(read_axis(setting));
    study.seeds = static_cast<std::uint64_t>(seeds);
    return study;
}

} // namespace

int main(int argc, char** argv) {
    long runs = argument(argc, argv, 1, 50, "figure_e2 [RUNS, at least 1]");
    Figures seeds = run_all(study_of("slaves=3", runs));
    print_row("other seeds", runs, seeds);
    Figures links = run_all(study_of(fmt::format("linkspeed=20M..{}M..1M", 19 + runs), 1));
    print_row("other links, one seed", runs, links);
}
