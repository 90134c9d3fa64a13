#include "experiments/chapter_3/kit/two_link_plots.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace placedpar {

using namespace hydraulics;
using namespace identification;

namespace {

constexpr std::size_t states_a_point = 10; // a plotted point for every ten simulated states, which are 1 ms apart
constexpr double transient_shown_s = 2;    // after this time the motion is steady

template <class StateValue>
Series over_time(const TwoLinkMotion& motion, std::string name, StateValue value) {
    Series series{std::move(name), {}};
    for (std::size_t i = 0; i < motion.motion.states.size() && motion.motion.states[i].time_s <= transient_shown_s;
         i += states_a_point)
        series.points.push_back({motion.motion.states[i].time_s, value(motion.motion.states[i])});
    return series;
}

Panel over_time(const char* title, const char* axis, std::vector<Series> series) {
    return {.title = title, .x = {.label = "time [s]"}, .y = {.label = axis}, .series = std::move(series)};
}

constexpr std::array<const char*, InternalStates::count> state_names{"P_11", "P_12", "Q_11", "Q_12", "Q_BUi", "Q_BOi"};

Series simulated_state(const TwoLinkMotion& motion, std::size_t which, int colour) {
    Series series = over_time(motion, std::string(state_names[which]) + " simulated",
                              [which](const ExcavatorState& state) { return true_states(state).values()[which]; });
    series.colour = colour;
    return series;
}

double estimated_state(const ComplianceSearch& prepared, const TransientEstimate& estimate, std::size_t which) {
    auto sample = std::ranges::find(prepared.samples, estimate.index, &CircuitSample::index);
    return estimated_states(*sample, estimate.compliance_in3_per_psi, prepared.flow).values()[which];
}

/// Returns the identified state at the samples.
Series identified_state(const ComplianceSearch& prepared, const SearchRun& run, std::size_t which, int colour) {
    Series series{std::string(state_names[which]) + " identified", {}, Stroke::points, colour};
    for (const TransientEstimate& estimate : run.estimates)
        series.points.push_back({estimate.time_s, estimated_state(prepared, estimate, which)});
    return series;
}

void add_state(Panel& panel, std::size_t which, const TwoLinkMotion& motion, const ComplianceSearch& prepared,
               const SearchRun& run, int colour) {
    panel.series.push_back(simulated_state(motion, which, colour));
    panel.series.push_back(identified_state(prepared, run, which, colour));
}

Panel over_generations(std::string title, Axis y, std::vector<Series> series) {
    return {std::move(title), {"generation (5 for each sample of 20 ms)", 0, 600}, std::move(y), std::move(series)};
}

double generation_of(std::size_t estimate, std::size_t trials) { return static_cast<double>((estimate + 1) * trials); }

Panel panel_of_compliances(std::string title, const SearchRun& run, std::size_t trials) {
    Panel panel = over_generations(std::move(title), {"compliance [0.001 in³/psi]", 0, 20},
                                   {{"C_BUi estimated", {}}, {"C_BOi estimated", {}}});
    for (std::size_t i = 0; i < run.estimates.size(); ++i)
        for (std::size_t j = 0; j < 2; ++j)
            panel.series[j].points.push_back(
                {generation_of(i, trials), 1000 * run.estimates[i].compliance_in3_per_psi[j]});
    panel.marks = {{"C_BUi true", 1000 * Parameters::excavator()["bucket.inlet_compliance"], 0},
                   {"C_BOi true", 1000 * Parameters::excavator()["boom.inlet_compliance"], 1}};
    return panel;
}

Panel panel_of_excitation(const ComplianceSearch& prepared, const SearchRun& run, std::size_t trials) {
    Panel panel = over_generations("c: excitation, the slope of the pressures", {"slope [psi/s]"},
                                   {{"P_BUi", {}}, {"P_BOi", {}}});
    for (std::size_t i = 0; i < run.estimates.size(); ++i) {
        auto sample = std::ranges::find(prepared.samples, run.estimates[i].index, &CircuitSample::index);
        for (std::size_t j = 0; j < 2; ++j)
            panel.series[j].points.push_back({generation_of(i, trials), sample->links[j].inlet_slope_psi_per_s});
    }
    return panel;
}

} // namespace

Plot plot_of_states(const TwoLinkMotion& motion) {
    auto series = [&](const char* name, auto value) { return over_time(motion, name, value); };
    auto pressures = over_time("Pressures", "pressure [psi]",
                               {series("P_11", [](const ExcavatorState& s) { return s.links[0].flow.psi; }),
                                series("P_12", [](const ExcavatorState& s) { return s.links[1].flow.psi; }),
                                series("P_BUi", [](const ExcavatorState& s) { return s.links[0].inlet_psi; }),
                                series("P_BOi", [](const ExcavatorState& s) { return s.links[1].inlet_psi; })});
    auto flows = over_time("Flows", "flow [in³/s]",
                           {series("Q_11", [](const ExcavatorState& s) { return s.links[0].flow.bypass_in3_per_s; }),
                            series("Q_12", [](const ExcavatorState& s) { return s.links[1].flow.bypass_in3_per_s; }),
                            series("Q_BUi", [](const ExcavatorState& s) { return s.links[0].flow.inlet_in3_per_s; }),
                            series("Q_BOi", [](const ExcavatorState& s) { return s.links[1].flow.inlet_in3_per_s; })});
    auto velocities = over_time("Velocities", "velocity [in/s]",
                                {series("bucket", [](const ExcavatorState& s) { return s.links[0].velocity_in_per_s; }),
                                 series("boom", [](const ExcavatorState& s) { return s.links[1].velocity_in_per_s; })});
    return {"Bucket and boom together, simulated (Figure 3.9)", {pressures, flows, velocities}};
}

Plot plot_of_estimated_states(const TwoLinkMotion& motion, const ComplianceSearch& prepared, const SearchRun& run) {
    Panel pressures = over_time("Pressures at the junctions", "pressure [psi]", {});
    Panel flows = over_time("Flows", "flow [in³/s]", {});
    for (int which = 0; which < 2; ++which)
        add_state(pressures, static_cast<std::size_t>(which), motion, prepared, run, which);
    for (int which = 2; which < 6; ++which)
        add_state(flows, static_cast<std::size_t>(which), motion, prepared, run, which);
    return {"Figure 3.10: internal states from the best individual (no noise; elite, 2 samples skipped, Gray code)",
            {pressures, flows}};
}

Plot plot_of_compliances(const ComplianceSearch& prepared, const SearchRun& plain, const SearchRun& gated,
                         std::size_t trials) {
    return {"Two compliances found, and lost again when the motion is steady (Figure 3.11)",
            {panel_of_compliances("a: as the thesis has it", plain, trials),
             panel_of_compliances("b: with an elite, Gray code, and the gate, which stops the search", gated, trials),
             panel_of_excitation(prepared, plain, trials)}};
}

} // namespace placedpar
