#include "experiments/kit/study_replay.hpp"
#include "explore/load.hpp"
#include "explore/problems.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

namespace placedpar {

namespace {

const ProcessInstance& master_of(const Network& network) {
    for (const ProcessInstance& process : network.processes)
        if (process.name == "master" && process.kind == "ga.master")
            return process;
    throw UserError(fmt::format("{}: expected a process \"master\" of the kind ga.master", network.source_path));
}

/// Returns a text with the origin of each constant and the constant's value in the netlist.
std::string print_constants(const ReplayContext& context) {
    auto load = [&](const Overrides& overrides) {
        return load_network(context.examples / "thesis/table-e1" / "cluster.cfs", overrides,
                            known_problems(context.seed), context.warn);
    };
    Network at_120 = load({}), at_30 = load({{"reading", "30"}});
    auto value = [](const Network& network, const char* parameter) {
        return std::get<std::int64_t>(master_of(network).parameters.at(parameter));
    };
    return fmt::format(
        "w  workload: {} cycles for an error evaluation ({} under the reading 30) and {} ({}) cycles of genetic "
        "operators\n   for an individual, from the column without slaves; {} bytes of measurements, 240 of strings and "
        "240 of\n   fitness (appendix E)\nc  calibrated: {} cycles to prepare a word of the measurements for sending, "
        "from C_time2 with three slaves\n   calibrated on other machines: {} cycles for a call of the communication "
        "library (a ping-pong on real T805s,\n   Poznan 2008), a link's pauses between packets (measured rates)\n   "
        "published: 20 MHz, 20 Mbit/s, a link's bits (databook), instruction times, 6 cycles for a word of a block "
        "move\n!  an outcome that is off by more than 3 %; in the thesis T_exe differs from T_sr + S_time2 by up to "
        "0.9 %\n",
        value(at_120, "cycles_per_error"), value(at_30, "cycles_per_error"), value(at_120, "cycles_per_individual"),
        value(at_30, "cycles_per_individual"), value(at_120, "measurement_bytes"),
        value(at_120, "cycles_per_measurement_word"), at_120.nodes[master_of(at_120).node].integer("channelcall"));
}

/// A column of Table E.1. Each function throws UserError if the study's file lacks the cell that the function reads.
struct TimingColumn {
    const StudyReplay& study;
    const Comparison& table;
    std::string name;

    const Cell& cell(const char* row) const {
        auto found = std::ranges::find_if(
            table.cells, [&](const Cell& each) { return each.row == row && each.column == name && each.reference; });
        if (found == table.cells.end())
            study.refuse(
                fmt::format("the table \"{}\" has no known value in row \"{}\", column \"{}\"", table.name, row, name));
        return *found;
    }
    double known(const char* row) const { return *cell(row).reference; }
    double simulated(const char* row) const { return cell(row).simulated; }
};

/// Adds cells for the communication time that one additional slave costs, and for the communication time during which
/// the master does not evaluate.
void add_communication(Comparison& comparison, const TimingColumn& slaves, const TimingColumn& fewer) {
    // In the thesis, T_exe differs from T_sr + S_time2 by up to 0.3 ms, and each figure has a rounding error of up to
    // 0.05 ms.
    constexpr double noise_of_thesis_ms = 0.3 + 2 * 0.05;
    Cell more = compared_cell("increase of C_time2 with one more slave", slaves.name, "ms",
                              slaves.known("C_time2") - fewer.known("C_time2"),
                              slaves.simulated("C_time2") - fewer.simulated("C_time2"), 2);
    more.tolerance_percent = 15;
    more.origin = slaves.cell("C_time2").origin;
    comparison.add(more);
    comparison.add(judged_cell("T_sr - P_time2", slaves.name, "ms", slaves.known("T_sr") - slaves.known("P_time2"),
                               slaves.simulated("T_sr") - slaves.simulated("P_time2"), noise_of_thesis_ms, 2));
    auto rest = [](auto of) { return of("T_exe") - of("P_time2") - of("S_time2"); };
    comparison.add(compared_cell("T_exe - P_time2 - S_time2", slaves.name, "ms",
                                 rest([&](const char* row) { return slaves.known(row); }),
                                 rest([&](const char* row) { return slaves.simulated(row); }), 2));
}

/// Compares differences that depend only on the communication. Communication is only 1 to 3 % of the times in Table
/// E.1, so even without communication most times in the table would be within their tolerances.
Comparison communication_table(const StudyReplay& study, const Comparison& table_e1) {
    Comparison comparison{.name = "cells that judge the communication", .judged = true};
    const std::array columns{"0 slaves", "1 slave", "2 slaves", "3 slaves"};
    for (std::size_t i = 1; i < columns.size(); ++i)
        add_communication(comparison, {study, table_e1, columns[i]}, {study, table_e1, columns[i - 1]});
    comparison.notes = "both differences are the communication time that does not overlap with evaluation; in the "
                       "thesis they differ by up to\n0.3 ms, so the second is not judged\n";
    return comparison;
}

/// Returns the study's tables, the table of the communication, and the constants of the netlist. The notes of the
/// tables refer to these constants.
Replay replay_table_e1(const ReplayContext& context) {
    const StudyReplay study(context, "thesis/table-e1/table-e1.toml");
    Replay replay = study.replay();
    replay.comparisons.insert(replay.comparisons.begin() + 1, communication_table(study, replay.comparisons.front()));
    replay.constants = print_constants(context);
    return replay;
}

} // namespace

extern const Experiment table_e1_experiment{
    .name = "table-e1",
    .about = "time of a generation on one cluster with 0 to 3 slaves",
    .chapter = "E",
    .number = 1,
    .run = replay_table_e1,
};

} // namespace placedpar
