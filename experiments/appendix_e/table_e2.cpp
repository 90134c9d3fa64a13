#include "experiments/kit/experiment.hpp"

#include "experiments/kit/experiment_runs.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace placedpar {

namespace {

/// A column of Table E.2.
struct Column {
    const char* name;
    int clusters, slaves; // 120 individuals in all, divided between the clusters
    double thesis_speedup, thesis_efficiency;
    std::optional<double> thesis_rate;
    bool measured_in_thesis; // the combined speedup was computed from the others (equation E.2)

    int processors() const { return clusters * (slaves + 1); }
};

const std::vector<Column>& columns() {
    static const std::vector<Column> all{{"GA", 1, 0, 1, 1, 9.8, true},
                                         {"B", 4, 0, 4, 1, {}, true},
                                         {"A", 1, 3, 3, 0.74, {}, true},
                                         {"A + B", 4, 3, 12, 0.74, 117.6, false}};
    return all;
}

constexpr double tolerance_percent = 5;
/// See the note that is printed.
constexpr double rate_tolerance_percent = 6;

RunReport run_column(const Column& column, const std::string& reading, const ReplayContext& context) {
    context.progress(fmt::format("reading {}: {} on {} transputers", reading, column.name, column.processors()));
    Overrides overrides{{"reading", reading},
                        {"clusters", std::to_string(column.clusters)},
                        {"slaves", std::to_string(column.slaves)},
                        {"population", std::to_string(120 / column.clusters)}};
    return run_to_the_end(context.examples / "04-figure-e2" / "figure-e2.cfs", overrides, context.seed);
}

/// Where the time of a generation on sixteen transputers goes, against a sixteenth of the traditional one's.
std::string print_where_it_goes(const RunReport& traditional, const RunReport& combined) {
    auto one = [&](const char* name) { return traditional.measured("master[0]", name); };
    auto all = [&](const char* name) { return combined.measured("master[0]", name); };
    double generation = 1000 / all("generations_per_second");
    double ideal = 1000 / one("generations_per_second") / 16;
    return fmt::format(
        "A + B: a generation takes {:.2f} ms; a sixteenth of the traditional one's would be {:.2f}, a twelfth {:.2f}:\n"
        "  {:5.2f} ms  the master's own error evaluations (a sixteenth: {:.2f})\n"
        "  {:5.2f} ms  genetic operators, a quarter of the population on each master (a sixteenth: {:.2f})\n"
        "  {:5.2f} ms  sending to the slaves and waiting for their results, two of them having one individual more\n"
        "  {:5.2f} ms  exchange with the other islands and new samples\n",
        generation, ideal, ideal * 16 / 12, all("P_time2"), one("P_time2") / 16, all("S_time2"), one("S_time2") / 16,
        all("T_sr") - all("P_time2"), generation - all("T_sr") - all("S_time2"));
}

Reading run_reading(const std::string& name, const ReplayContext& context, Fingerprint& fingerprint) {
    Reading reading{fmt::format("reading {}: Table E.1 was measured with {} individuals", name, name), {}, ""};
    std::vector<RunReport> reports;
    std::vector<Cell> rates, speedups, efficiencies, compliances;
    for (const Column& column : columns()) {
        reports.push_back(run_column(column, name, context));
        fingerprint.mix(reports.back().result.fingerprint);
        double rate = reports.back().measured("master[0]", "generations_per_second");
        double speedup = rate / reports.front().measured("master[0]", "generations_per_second");
        std::optional<double> tolerance;
        if (column.measured_in_thesis)
            tolerance = tolerance_percent;
        bool judged = column.thesis_rate && column.measured_in_thesis;
        rates.push_back({"generations of 120 a second", column.name, "1/s", column.thesis_rate, rate,
                         judged ? std::optional(rate_tolerance_percent) : std::nullopt, Origin::outcome});
        speedups.push_back({"speedup", column.name, "", column.thesis_speedup, speedup, tolerance, Origin::outcome});
        efficiencies.push_back({"efficiency", column.name, "", column.thesis_efficiency, speedup / column.processors(),
                                tolerance, Origin::outcome});
        compliances.push_back(compliance_cell(column.name, reports.back(), "master[0]"));
    }
    for (auto* row : {&rates, &speedups, &efficiencies, &compliances})
        reading.cells.insert(reading.cells.end(), row->begin(), row->end());
    reading.notes = print_where_it_goes(reports.front(), reports.back());
    return reading;
}

} // namespace

Replay replay_table_e2(const ReplayContext& context) {
    Replay replay;
    Fingerprint fingerprint;
    for (const char* reading : {"120", "30"})
        replay.readings.push_back(run_reading(reading, context, fingerprint));
    replay.readings.front().notes += print_compliance_note();
    replay.constants =
        fmt::format("   The thesis computed the combined speedup from the others (equation E.2: 117.6 is 12 x 9.8); it "
                    "is printed,\n"
                    "   not judged. The rest is judged at {} %, the GA's rate at {} %: the thesis's own tables are "
                    "that far apart, for\n"
                    "   the 97.0 ms of Table E.1 are 10.3 generations a second, 5.2 % more than Table E.2's 9.8.\n",
                    tolerance_percent, rate_tolerance_percent);
    replay.fingerprint = fingerprint.value();
    return replay;
}

} // namespace placedpar
