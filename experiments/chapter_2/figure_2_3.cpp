#include "experiments/kit/experiment.hpp"
#include "hydraulics/plant/bulk_modulus.hpp"
#include "hydraulics/plant/link_mechanics.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace placedpar {

using namespace hydraulics;

namespace {

constexpr std::array pressures_psia{100.0, 500.0, 1000.0, 2000.0};

/// Moduli in 1e3 psi, computed independently of this program and rounded to the digits given.
struct ModulusRow {
    double air_fraction, exponent;
    std::array<double, 4> modulus_kpsi;
};

constexpr ModulusRow known_moduli[]{
    {.air_fraction = .001, .exponent = 1, .modulus_kpsi = {166.2, 217.2, 219.3, 219.8}},
    {.air_fraction = .01, .exponent = 1, .modulus_kpsi = {51.6, 194.6, 213.1, 218.2}},
    {.air_fraction = .05, .exponent = 1, .modulus_kpsi = {12.3, 131.1, 188.1, 211.1}},
    {.air_fraction = .05, .exponent = 1.4, .modulus_kpsi = {10.1, 94.7, 156.9, 196.1}},
    {.air_fraction = .10, .exponent = 1.4, .modulus_kpsi = {5.0, 58.2, 119.1, 175.0}},
};

/// The absolute pressures at which the mixture's compliance is a given multiple of oil's compliance, also computed
/// independently.
struct ComplianceRow {
    const char* name;
    double share; ///< modulus of the mixture divided by the modulus of oil
    std::array<double, 4> psia;
};

constexpr std::array air_fractions{.01, .02, .05, .10};
constexpr ComplianceRow known_softer[]{
    {.name = "pressure where C is 10 times oil's C", .share = 0.1, .psia = {60, 85, 137, 199}},
    {.name = "pressure where C is twice oil's C", .share = 0.5, .psia = {181, 257, 412, 598}},
};

std::string percent(double fraction) { return fmt::format("{:g} % air", 100 * fraction); }

std::string psia_column(double psia) { return fmt::format("{} psia", psia); }

void add_moduli(Comparison& comparison) {
    for (const ModulusRow& row : known_moduli)
        for (std::size_t i = 0; i < pressures_psia.size(); ++i) {
            double modulus = bulk_modulus_psi(air_oil_mixture(row.air_fraction, row.exponent), pressures_psia[i]);
            comparison.add(judged_cell(
                fmt::format("{}, {}", percent(row.air_fraction), row.exponent == 1 ? "isothermal" : "N = 1.4"),
                psia_column(pressures_psia[i]), "1e3 psi", row.modulus_kpsi[i], modulus / 1000, 0.051, 1));
        }
}

/// Adds the compliance of the mixture, C = V / beta, relative to the compliance of the same volume of oil.
void add_compliances(Comparison& comparison) {
    for (double air : air_fractions)
        for (double psia : pressures_psia)
            comparison.add(plain_cell(
                "C over that of oil, " + percent(air), psia_column(psia), "",
                bulk_modulus_psi(air_oil_mixture(0), psia) / bulk_modulus_psi(air_oil_mixture(air), psia), 3));
}

void add_softer(Comparison& comparison) {
    for (const ComplianceRow& row : known_softer)
        for (std::size_t i = 0; i < air_fractions.size(); ++i)
            comparison.add(judged_cell(row.name, percent(air_fractions[i]), "psia", row.psia[i],
                                       psia_at_modulus(air_oil_mixture(air_fractions[i]), row.share), 0.51, 1));
}

/// Adds the volume of oil that would have the boom's compliance.
void add_volume(Comparison& comparison) {
    double compliance = single_boom_mechanics().inlet_compliance_in3_per_psi;
    comparison.add(judged_cell(fmt::format("oil that alone has C = {}", compliance), "no air", "in^3", 1892,
                               compliance * bulk_modulus_psi(air_oil_mixture(0), 1800), 0.51, 1));
}

constexpr std::array plotted_fractions{0.0, .001, .01, .02, .05, .10};

template <class Value>
Series over_pressure(double air, double from_psia, double to_psia, Value value) {
    constexpr int steps = 200;
    return curve({.name = air == 0 ? "no air" : percent(air)}, steps, [&](int i) -> Point {
        double psia = from_psia * std::pow(to_psia / from_psia, static_cast<double>(i) / steps);
        return {psia, value(air, psia)};
    });
}

Panel modulus_panel() {
    Panel panel{.title = "Bulk modulus of an air-oil mixture (isothermal; the air is free)",
                .x = {"absolute pressure [psi]", 0, 3000},
                .y = {"bulk modulus [1000 psi]", 0, 240}};
    auto modulus = [](double air, double psia) { return bulk_modulus_psi(air_oil_mixture(air), psia) / 1000; };
    for (double air : plotted_fractions)
        panel.series.push_back(over_pressure(air, 10, 3000, modulus));
    return panel;
}

Panel compliance_panel() {
    Panel panel{.title = "Compliance C = V / β, divided by that of the same volume of oil alone",
                .x = {"absolute pressure [psi]", 20, 3000, true},
                .y = {"C with air / C without", 0.8, 100, true},
                .marks = {{"an order of magnitude", 10}}};
    auto softer = [](double air, double psia) {
        return bulk_modulus_psi(air_oil_mixture(0), psia) / bulk_modulus_psi(air_oil_mixture(air), psia);
    };
    for (double air : plotted_fractions)
        panel.series.push_back(over_pressure(air, 20, 3000, softer));
    return panel;
}

Replay replay_figure_2_3(const ReplayContext&) {
    Comparison comparison{.name = "bulk modulus of oil (220 000 psi) with free air, and the compliance C = V / beta",
                          .against = "known"};
    add_moduli(comparison);
    add_compliances(comparison);
    add_softer(comparison);
    add_volume(comparison);
    Plot plot{"Figure 2.3: what free air does to oil", {modulus_panel(), compliance_panel()}};
    return replay_of({comparison}, {{"figure-2-3", plot}});
}

} // namespace

extern const Experiment figure_2_3_experiment{
    .name = "figure-2-3",
    .about = "the bulk modulus of oil with free air over the pressure",
    .chapter = "2",
    .number = 2,
    .run = replay_figure_2_3,
};

} // namespace placedpar
