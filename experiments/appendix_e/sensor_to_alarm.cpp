#include "experiments/kit/bootstrap.hpp"
#include "experiments/kit/experiment.hpp"
#include "experiments/kit/experiment_runs.hpp"
#include "experiments/kit/seed_runs.hpp"
#include "netlist/run_report.hpp"
#include "picture/svg_pen.hpp"
#include "report/cell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

namespace {

struct AlarmCase {
    const char* name;
    Overrides set;
};

struct StageShown {
    const char *process, *measure, *row;
};
constexpr std::array stages_shown{StageShown{"host", "from_sensors", "1: bus master to Sun"},
                                  StageShown{"host", "to_masters", "2: Sun to all islands"},
                                  StageShown{"host", "response", "3: generations, and back to the Sun"},
                                  StageShown{"alarm", "from_host", "4: Sun to the other bus master"},
                                  StageShown{"alarm", "from_sensors", "sensors to alarm, mean of all samples"},
                                  StageShown{"alarm", "longest_from_sensors", "  the longest"}};
constexpr std::size_t first_stage = 2; // index of the first stage in the figures of a run; the two figures before it
                                       // are whether the alarm was raised, and the bus's load

Figures run_to_alarm(const AlarmCase& way, const ReplayContext& context, std::uint64_t seed) {
    ReplayContext own = context;
    own.seed = seed;
    const RunReport report =
        run_to_the_end(context.examples / "machine/figure-d1" / "sensor-to-alarm.cfs", way.set, own);
    const bool raised = std::ranges::any_of(
        report.measurements, [](const Measurement& each) { return each.process == "alarm" && each.name == "sample"; });
    Figures figures{raised ? 1. : 0., 100 * report.share(report.buses.front().busy).value_or(0)};
    for (const StageShown& stage : stages_shown)
        figures.push_back(report.measured(stage.process, stage.measure));
    figures.push_back(raised ? report.measured("alarm", "raised_after") : 0);
    return figures;
}

void add_alarm_case(Comparison& comparison, const AlarmCase& way, const std::vector<Figures>& runs, bool leaks) {
    const auto raised = static_cast<std::size_t>(std::ranges::count(column(runs, 0), 1.));
    const Cell share = share_cell("alarm raised", way.name, raised, runs.size());
    comparison.add(leaks ? at_least(95, share) : at_most(5, share));
    const Interval interval = success_interval(raised, runs.size());
    comparison.add(plain_cell("  from", way.name, "%", interval.low, 1));
    comparison.add(plain_cell("  to", way.name, "%", interval.high, 1));
    for (std::size_t i = 0; i < stages_shown.size(); ++i)
        comparison.add(plain_cell(stages_shown[i].row, way.name, "ms", lower_median_of(runs, first_stage + i), 3));
    if (leaks)
        comparison.add(plain_cell("last reading to alarm", way.name, "ms",
                                  lower_median_of(runs, first_stage + stages_shown.size()), 3));
    comparison.add(plain_cell("bus busy", way.name, "%", lower_median_of(runs, 1), 1));
}

using picture::SvgPen;
using Spot = picture::Point;

constexpr const char* alarm_style = R"(text { font-size: 13px; }
.title { font-size: 17px; font-weight: bold; }
.block { fill: #eef3f7; stroke: #16324a; stroke-width: 1.5; }
.bus { fill: #f6f1e4; stroke: #16324a; stroke-width: 1.5; }
.inside { text-anchor: middle; }
.wire { stroke: #16324a; stroke-width: 1.5; fill: none; marker-end: url(#head); }
)";
constexpr const char* alarm_arrow =
    R"(<marker id="head" viewBox="0 0 10 10" refX="9" refY="5" markerWidth="8" markerHeight="8" orient="auto">)"
    R"(<path d="M0 0L10 5L0 10z" fill="#16324a"/></marker>)";

void draw_board(SvgPen& pen, double x, std::string_view name, std::string_view process) {
    pen.rect({{x, 90}, 170, 56}, {{"class", "block"}, {"rx", "4"}});
    pen.text({x, 86}, "inside", name).text({x, 104}, "inside", process);
}

/// Draws the path of a message from the board at `from` down to the bus, along the bus at the height `y`, and up to the
/// board at `to`.
void draw_stage(SvgPen& pen, double from, double to, double y, const std::string& label) {
    pen.path(picture::svg_corners(std::vector<Spot>{{from, 118}, {from, y}, {to, y}, {to, 118}}), {{"class", "wire"}});
    pen.text({std::max(from, to) - 62, y - 6}, "inside", label);
}

/// Draws Figure D.1 with the delays of each stage on an idle and on a full bus.
std::string draw_delays(const std::vector<Figures>& idle, const std::vector<Figures>& full) {
    SvgPen pen;
    pen.text({24, 30}, "title",
             "Figure D.1: delays from the sensors to the alarm, in ms, on the idle bus / on the busy bus");
    pen.rect({{460, 230}, 870, 150}, {{"class", "bus"}});
    pen.text({40, 298}, "label",
             fmt::format("VMEbus, busy {:.1f} % / {:.1f} %", lower_median_of(idle, 1), lower_median_of(full, 1)));
    auto label = [&](std::size_t stage) {
        return fmt::format("{}: {:.2f} / {:.2f}", stage + 1, lower_median_of(idle, first_stage + stage),
                           lower_median_of(full, first_stage + stage));
    };
    constexpr double sensors = 120, sun = 345, islands = 570, alarm = 795;
    draw_board(pen, sensors, "BBK-V2", "sensors, every 20 ms");
    draw_board(pen, sun, "Sun 3/280", "host");
    draw_board(pen, islands, "4 VMTM, 16 T800", "islands and slaves");
    draw_board(pen, alarm, "BBK-V2", "alarm");
    draw_stage(pen, sensors + 20, sun - 60, 190, label(0));
    draw_stage(pen, sun - 20, islands - 20, 190, label(1));
    draw_stage(pen, islands + 20, sun + 20, 230, label(2));
    draw_stage(pen, sun + 60, alarm, 270, label(3));
    return pen.document({{460, 165}, 920, 330}, alarm_style, alarm_arrow, "From the sensors to the alarm");
}

Replay replay_sensor_to_alarm(const ReplayContext& context) {
    const Overrides busy{{"trials", "2"}, {"bus_masters", "4"}, {"load", "6000"}};
    const std::array ways{AlarmCase{"leak", {{"trials", "2"}}},
                          AlarmCase{"sound", {{"trials", "2"}, {"problem", "\"boom\""}}},
                          AlarmCase{"leak, busy bus", busy}, AlarmCase{"leak, 5 generations", {}}};
    Comparison comparison{.name = fmt::format("a sample every 20 ms, 2 generations for each, {} seeds", context.seeds),
                          .notes = "from, to: 95 % interval (Clopper and Pearson); delays: medians over the seeds\n",
                          .against = "asked"};
    std::vector<std::vector<Figures>> runs;
    for (const AlarmCase& way : ways) {
        runs.push_back(
            run_seeds(context, way.name, [&](std::uint64_t seed) { return run_to_alarm(way, context, seed); }));
        add_alarm_case(comparison, way, runs.back(), std::string_view(way.name) != "sound");
    }
    Replay replay = replay_of({std::move(comparison)}, {});
    replay.drawings = {{"sensor-to-alarm", draw_delays(runs[0], runs[2])}};
    return replay;
}

} // namespace

extern const Experiment sensor_to_alarm_experiment{
    .name = "sensor-to-alarm",
    .about = "from a leak to the alarm over the VMEbus of Figure D.1, with the delay of each stage",
    .chapter = "E",
    .number = 4,
    .run = replay_sensor_to_alarm,
    .seeds = 60,
};

} // namespace placedpar
