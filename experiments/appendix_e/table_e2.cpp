#include "experiments/kit/study_replay.hpp"

#include <fmt/format.h>

#include <string>

namespace placedpar {

namespace {

/// Returns a text with the parts of a generation's time on sixteen transputers. Beside each part stands a sixteenth of
/// the time that the traditional algorithm needs for the part.
std::string print_where_it_goes(const StudyReplay& study, const char* individuals) {
    auto figure = [&](const char* clusters, const char* slaves, const char* population, const char* name) {
        return study.measured(
            {{"reading", individuals}, {"clusters", clusters}, {"slaves", slaves}, {"population", population}},
            fmt::format("master[0].{}", name));
    };
    auto one = [&](const char* name) { return figure("1", "0", "120", name); };
    auto all = [&](const char* name) { return figure("4", "3", "30", name); };
    double generation = 1000 / all("generations_per_second");
    double ideal = 1000 / one("generations_per_second") / 16;
    return fmt::format(
        "A + B: a generation takes {:.2f} ms; a sixteenth of the traditional algorithm's would be {:.2f} ms, a twelfth "
        "{:.2f} ms:\n"
        "  {:5.2f} ms  the master's own error evaluations (a sixteenth: {:.2f})\n"
        "  {:5.2f} ms  genetic operators, a quarter of the population on each master (a sixteenth: {:.2f})\n"
        "  {:5.2f} ms  sending to the slaves and waiting for their results; two slaves have one individual more than "
        "the others\n"
        "  {:5.2f} ms  exchange with the other islands and new samples\n",
        generation, ideal, ideal * 16 / 12, all("P_time2"), one("P_time2") / 16, all("S_time2"), one("S_time2") / 16,
        all("T_sr") - all("P_time2"), generation - all("T_sr") - all("S_time2"));
}

Replay replay_table_e2(const ReplayContext& context) {
    const StudyReplay study(context, "thesis/figure-e2/table-e2.toml");
    Replay replay = study.replay();
    study.table(replay, "reading 120: Table E.1 was measured with 120 individuals")
        .notes.insert(0, print_where_it_goes(study, "120"));
    study.table(replay, "reading 30: Table E.1 was measured with 30 individuals")
        .notes.insert(0, print_where_it_goes(study, "30"));
    study.table(replay, "as the thesis prints it").judged = context.printed;
    return replay;
}

} // namespace

extern const Experiment table_e2_experiment{
    .name = "table-e2",
    .about = "the speedup of algorithms B, A, and A + B on the machine of Figure E.2",
    .chapter = "E",
    .number = 2,
    .run = replay_table_e2,
    .has_printed = true,
};

} // namespace placedpar
