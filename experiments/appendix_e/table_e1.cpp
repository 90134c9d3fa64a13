#include "experiments/kit/experiment.hpp"
#include "experiments/kit/experiment_runs.hpp"
#include "explore/problems.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace placedpar {

namespace {

constexpr int slave_counts = 4; // 0 to 3

struct MeasuredTime {
    const char* name;
    std::array<double, slave_counts> thesis_ms; ///< with 0, 1, 2 and 3 slaves
};

/// Table E.1 of the thesis, in milliseconds.
constexpr MeasuredTime table_e1[]{
    {.name = "T_exe", .thesis_ms = {97.0, 54.0, 39.7, 32.8}},
    {.name = "T_sr", .thesis_ms = {86.4, 43.3, 29.5, 22.5}},
    {.name = "P_time2", .thesis_ms = {86.4, 43.3, 29.0, 21.8}},
    {.name = "C_time2", .thesis_ms = {0.0, 0.6, 1.28, 1.89}},
    {.name = "S_time2", .thesis_ms = {10.5, 10.5, 10.5, 10.5}},
};

/// An interpretation of how the thesis measured the table.
struct Interpretation {
    std::string name;
    Overrides overrides = {};
    bool message_an_individual = false; ///< C_time2 is of other messages than those that a constant was fitted to
};

/// What constants were read off, or fitted to; the rest is outcome.
Origin origin_of(std::string_view row, int slaves, const Interpretation& interpretation) {
    if (slaves == 0 && (row == "P_time2" || row == "S_time2"))
        return Origin::workload;
    if (slaves == 3 && row == "C_time2" && !interpretation.message_an_individual)
        return Origin::calibrated;
    return Origin::outcome;
}

std::filesystem::path netlist_in(const ReplayContext& context) {
    return context.examples / "03-table-e1" / "cluster.cfs";
}

/// The default is the one that fits best.
const std::vector<Interpretation>& interpretations() {
    static const std::vector<Interpretation> all{
        {.name = "120 individuals, measurements sent with each new sample"},
        {.name = "120 individuals, measurements sent in every generation",
         .overrides = {{"measurements", "\"generation\""}}},
        {.name = "30 individuals, dealt out whole", .overrides = {{"reading", "30"}}},
        {.name = "30 individuals, dealt out on demand",
         .overrides = {{"reading", "30"}, {"split", "\"demand\""}},
         .message_an_individual = true},
        {.name = "30 individuals, single error evaluations dealt out",
         .overrides = {{"reading", "30"}, {"split", "\"evaluations\""}}},
    };
    return all;
}

/// An outcome with a figure of the thesis that is not 0.
bool shows_fit(const Cell& cell) {
    return cell.origin == Origin::outcome && cell.error_percent() && *cell.reference != 0 && cell.unit == "ms";
}

std::string print_fit(const std::vector<Cell>& cells) {
    double worst = 0, squares = 0;
    int count = 0;
    const Cell* worst_cell = nullptr;
    for (const Cell& cell : cells) {
        if (!shows_fit(cell))
            continue;
        double error = *cell.error_percent();
        squares += error * error;
        ++count;
        if (std::abs(error) > std::abs(worst)) {
            worst = error;
            worst_cell = &cell;
        }
    }
    return fmt::format("outcomes: rms error {:.1f} %, greatest {:+.1f} % ({}, {})\n", std::sqrt(squares / count), worst,
                       worst_cell ? worst_cell->row : "", worst_cell ? worst_cell->column : "");
}

std::string column_name(int slaves) { return fmt::format("{} slave{}", slaves, slaves == 1 ? "" : "s"); }

using Reports = std::array<RunReport, slave_counts>; // with 0, 1, 2 and 3 slaves

Reports run_with_slaves(const Interpretation& interpretation, const ReplayContext& context) {
    Reports reports;
    for (int slaves = 0; slaves < slave_counts; ++slaves) {
        context.progress(fmt::format("{}: {} slaves", interpretation.name, slaves));
        Overrides overrides = interpretation.overrides;
        overrides["slaves"] = std::to_string(slaves);
        reports[static_cast<std::size_t>(slaves)] = run_to_the_end(netlist_in(context), overrides, context);
    }
    return reports;
}

Cell time_cell(const MeasuredTime& row, int slaves, const Interpretation& interpretation, const RunReport& report) {
    Origin origin = origin_of(row.name, slaves, interpretation);
    return {.row = row.name,
            .column = column_name(slaves),
            .unit = "ms",
            .reference = row.thesis_ms[static_cast<std::size_t>(slaves)],
            .simulated = report.measured("master", row.name),
            .tolerance_percent = origin == Origin::outcome ? 3.0 : 1.0,
            .origin = origin};
}

Comparison run_way(const Interpretation& interpretation, const ReplayContext& context, Fingerprint& fingerprint) {
    Comparison comparison{.name = interpretation.name};
    Reports reports = run_with_slaves(interpretation, context);
    for (const RunReport& report : reports)
        fingerprint.mix(report.result.fingerprint);
    for (const MeasuredTime& row : table_e1)
        for (int slaves = 0; slaves < slave_counts; ++slaves)
            comparison.add(time_cell(row, slaves, interpretation, reports[static_cast<std::size_t>(slaves)]));
    for (int slaves = 0; slaves < slave_counts; ++slaves)
        comparison.add(compliance_cell(column_name(slaves), reports[static_cast<std::size_t>(slaves)], "master"));
    comparison.notes = print_fit(comparison.cells);
    return comparison;
}

const ProcessInstance& master_of(const Network& network) {
    for (const ProcessInstance& process : network.processes)
        if (process.name == "master" && process.kind == "ga.master")
            return process;
    throw UserError(fmt::format("{}: there is no process \"master\" of the kind ga.master", network.source_path));
}

/// Which constant is what, with the values that the netlist gave.
std::string print_constants(const ReplayContext& context) {
    auto load = [&](const Overrides& overrides) {
        return load_network(netlist_in(context), overrides, known_problems(context.seed), context.warn);
    };
    Network at_120 = load({}), at_30 = load({{"reading", "30"}});
    auto value = [](const Network& network, const char* parameter) {
        return std::get<std::int64_t>(master_of(network).parameters.at(parameter));
    };
    return fmt::format(
        "w  workload: {} cycles an error evaluation ({} under the reading 30) and {} ({}) cycles of genetic operators\n"
        "   an individual, read off the column without slaves; {} bytes of measurements, 240 of strings and 240 of\n"
        "   fitness (appendix E)\n"
        "c  calibrated: {} cycles to make a word of the measurements ready to send, to C_time2 with three slaves\n"
        "   calibrated to other machines: {} cycles a call of the communication library (a ping-pong on real T805s,\n"
        "   Poznan 2008), a link's pauses between packets (measured rates)\n"
        "   published: 20 MHz, 20 Mbit/s, a link's bits (databook), instruction times, block move 6 cycles a word\n"
        "!  an outcome further from the thesis than 3 %; its own T_exe is off its T_sr + S_time2 by up to 0.9 %\n",
        value(at_120, "cycles_per_error"), value(at_30, "cycles_per_error"), value(at_120, "cycles_per_individual"),
        value(at_30, "cycles_per_individual"), value(at_120, "measurement_bytes"),
        value(at_120, "cycles_per_measurement_word"), at_120.nodes[master_of(at_120).node].integer("channelcall"));
}

Replay replay_table_e1(const ReplayContext& context) {
    Replay replay;
    Fingerprint fingerprint;
    for (const Interpretation& interpretation : interpretations())
        replay.comparisons.push_back(run_way(interpretation, context, fingerprint));
    replay.comparisons.front().notes += print_compliance_note();
    replay.constants = print_constants(context);
    replay.fingerprint = fingerprint.value();
    return replay;
}

} // namespace

extern const Experiment table_e1_experiment{
    .name = "table-e1",
    .about = "what a generation costs on one cluster with 0 to 3 slaves",
    .chapter = "E",
    .number = 1,
    .run = replay_table_e1,
};

} // namespace placedpar
