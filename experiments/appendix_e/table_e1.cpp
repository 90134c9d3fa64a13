#include "experiments/kit/experiment.hpp"

#include "experiments/kit/experiment_runs.hpp"
#include "workbench/netlist_run.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>

namespace placedpar {

namespace {

constexpr int columns = 4;

struct Row {
    const char* name;
    std::array<double, columns> thesis; // with 0, 1, 2 and 3 slaves
};

/// Table E.1 of the thesis, in milliseconds.
constexpr std::array<Row, 5> table{{{"T_exe", {97.0, 54.0, 39.7, 32.8}},
                                    {"T_sr", {86.4, 43.3, 29.5, 22.5}},
                                    {"P_time2", {86.4, 43.3, 29.0, 21.8}},
                                    {"C_time2", {0.0, 0.6, 1.28, 1.89}},
                                    {"S_time2", {10.5, 10.5, 10.5, 10.5}}}};

struct Way {
    std::string name;
    Overrides overrides;
    bool message_an_individual = false; ///< C_time2 is of other messages than those that a constant was fitted to
};

/// What constants were read off, or fitted to; the rest is outcome.
Origin origin_of(std::string_view row, int slaves, const Way& way) {
    if (slaves == 0 && (row == "P_time2" || row == "S_time2"))
        return Origin::workload;
    if (slaves == 1 && row == "C_time2" && !way.message_an_individual)
        return Origin::calibrated;
    return Origin::outcome;
}

std::filesystem::path netlist_in(const ReplayContext& context) {
    return context.examples / "03-table-e1" / "cluster.cfs";
}

/// The default is the one that fits best.
const std::vector<Way>& ways() {
    static const std::vector<Way> all{
        {"120 individuals, measurements sent with each new sample", {}},
        {"120 individuals, measurements sent in every generation", {{"measurements", "\"generation\""}}},
        {"30 individuals, dealt out whole", {{"reading", "30"}}},
        {"30 individuals, dealt out on demand", {{"reading", "30"}, {"split", "\"demand\""}}, true},
        {"30 individuals, single error evaluations dealt out", {{"reading", "30"}, {"split", "\"evaluations\""}}},
    };
    return all;
}

/// Of the outcomes with a figure of the thesis that is not 0.
std::string print_fit(const std::vector<Cell>& cells) {
    double worst = 0, squares = 0;
    int count = 0;
    const Cell* worst_cell = nullptr;
    for (const Cell& cell : cells) {
        auto error = cell.error_percent();
        if (cell.origin != Origin::outcome || !error || *cell.thesis == 0 || cell.unit != "ms")
            continue;
        squares += *error * *error;
        ++count;
        if (std::abs(*error) > std::abs(worst)) {
            worst = *error;
            worst_cell = &cell;
        }
    }
    return fmt::format("outcomes: rms error {:.1f} %, greatest {:+.1f} % ({}, {})\n", std::sqrt(squares / count), worst,
                       worst_cell ? worst_cell->row : "", worst_cell ? worst_cell->column : "");
}

std::string column_name(int slaves) { return fmt::format("{} slave{}", slaves, slaves == 1 ? "" : "s"); }

Reading run_way(const Way& way, const ReplayContext& context, Fingerprint& fingerprint) {
    Reading reading{way.name, {}, ""};
    std::array<RunReport, columns> reports;
    for (int slaves = 0; slaves < columns; ++slaves) {
        context.progress(fmt::format("{}: {} slaves", way.name, slaves));
        Overrides overrides = way.overrides;
        overrides["slaves"] = std::to_string(slaves);
        reports[static_cast<std::size_t>(slaves)] = run_to_the_end(netlist_in(context), overrides, context.seed);
        fingerprint.mix(reports[static_cast<std::size_t>(slaves)].result.fingerprint);
    }
    for (const Row& row : table)
        for (int slaves = 0; slaves < columns; ++slaves) {
            auto column = static_cast<std::size_t>(slaves);
            Origin origin = origin_of(row.name, slaves, way);
            reading.cells.push_back({row.name, column_name(slaves), "ms", row.thesis[column],
                                     reports[column].measured("master", row.name),
                                     origin == Origin::outcome ? 3.0 : 1.0, origin});
        }
    for (int slaves = 0; slaves < columns; ++slaves)
        reading.cells.push_back(
            compliance_cell(column_name(slaves), reports[static_cast<std::size_t>(slaves)], "master"));
    reading.notes = print_fit(reading.cells);
    return reading;
}

/// Which constant is what, with the values that the netlist gave.
std::string print_constants(const std::filesystem::path& netlist) {
    Network at_120 = load_network(netlist, {}), at_30 = load_network(netlist, {{"reading", "30"}});
    auto value = [](const Network& network, const char* parameter) {
        for (const ProcessInstance& process : network.processes)
            if (process.name == "master")
                return std::get<std::int64_t>(process.parameters.at(parameter));
        throw std::logic_error("the netlist has no process master");
    };
    return fmt::format(
        "w  workload: {} cycles an error evaluation ({} under the reading 30) and {} ({}) cycles of genetic operators\n"
        "   an individual, read off the column without slaves; {} bytes of measurements, 240 of strings and 240 of\n"
        "   fitness (appendix E)\n"
        "c  calibrated: {} cycles to make a word of the measurements ready to send, to C_time2 with one slave\n"
        "   published: 20 MHz, 20 Mbit/s, the link's bits and latencies (databook), instruction times, {} cycles a "
        "call\n"
        "   of the communication library (a ping-pong on real T805s, Poznan 2008), block move 6 cycles a word\n"
        "!  an outcome further from the thesis than 3 %; its own T_exe is off its T_sr + S_time2 by up to 0.9 %\n",
        value(at_120, "cycles_per_error"), value(at_30, "cycles_per_error"), value(at_120, "cycles_per_individual"),
        value(at_30, "cycles_per_individual"), value(at_120, "measurement_bytes"),
        value(at_120, "cycles_per_measurement_word"), at_120.nodes.front().integer("channelcall"));
}

} // namespace

Replay replay_table_e1(const ReplayContext& context) {
    Replay replay;
    Fingerprint fingerprint;
    for (const Way& way : ways())
        replay.readings.push_back(run_way(way, context, fingerprint));
    replay.readings.front().notes += print_compliance_note();
    replay.constants = print_constants(netlist_in(context));
    replay.fingerprint = fingerprint.value();
    return replay;
}

} // namespace placedpar
