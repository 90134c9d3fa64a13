#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace placedpar {

/// Where the figure in a cell comes from.
enum class Origin {
    outcome,    ///< of the simulation, nothing was fitted to it
    calibrated, ///< one constant was fitted to this cell
    workload,   ///< a constant of the program's own cost was read off this cell
    fitted,     ///< constants were fitted to several cells, this one among them
    constant    ///< one constant of the model comes back: the cell misses only by an error of the program
};

inline constexpr std::array every_origin{Origin::outcome, Origin::calibrated, Origin::workload, Origin::fitted,
                                         Origin::constant};

const char* name_of(Origin);

/// A simulated figure beside a known one, and how far apart the two may be.
struct Cell {
    std::string row, column, unit = {};
    std::optional<double> reference = {};         ///< the known figure: Comparison::against names its source
    double simulated = 0;                         ///< not a number: there is none, which meets no tolerance
    std::optional<double> tolerance_percent = {}; ///< of the reference; none: printed, not judged
    Origin origin = Origin::outcome;
    std::optional<double> tolerance = {}; ///< in the cell's unit; replaces tolerance_percent
    int decimals = 2;                     ///< as printed
    /// Bounds from one side, in the cell's unit. With either of them the tolerances play no part.
    std::optional<double> at_least = {}, at_most = {};
    std::optional<double> reference_to = {}; ///< of a claim with two bounds, which is printed only: the upper one
    std::string source = {};                 ///< of the known figure, where those of a comparison have several

    /// How far the simulated figure is from the reference, in percent of it; 0 where both are 0. None without a
    /// reference.
    std::optional<double> error_percent() const;
    /// tolerance_percent, or `tolerance` in percent of the reference; none where that is not defined.
    std::optional<double> tolerance_in_percent() const;
    bool is_judged() const { return at_least || at_most || tolerance || tolerance_percent; }
    bool within_tolerance() const;
};

/// A figure that is judged by how far it is from the known one, in the cell's unit.
Cell judged_cell(std::string row, std::string column, std::string unit, double known, double value, double tolerance,
                 int decimals);
/// A figure that is printed, beside a known one or alone.
Cell compared_cell(std::string row, std::string column, std::string unit, double known, double value, int decimals);
Cell plain_cell(std::string row, std::string column, std::string unit, double value, int decimals);
/// Judged where both a known figure and a tolerance are given; printed otherwise.
Cell cell_of(std::string row, std::string column, std::string unit, std::optional<double> known, double value,
             std::optional<double> tolerance, int decimals);
/// A figure that is judged from one side: beside a known one that it need not meet, or alone.
Cell at_least(double bound, Cell cell);
Cell at_most(double bound, Cell cell);

/// Tolerances of figures that scatter with the seed are four of their standard deviations. A replay judges some ten of
/// them by known figures that are samples, too, and off by up to two deviations of their own: what is left makes it
/// miss in less than one of a hundred seeds (docs/hydraulics.md has what was counted).
inline constexpr double deviations_allowed = 4;

/// Of the difference of two shares, in percent (n records each): deviations of sqrt(2 p (1 - p) / n); p by Agresti and
/// Coull's two successes and two failures more, so that a share of 0 or 100 % scatters too. A known share from 50 to
/// 300 seeds counts as n.
double share_tolerance(double known_percent, std::size_t records);
/// How far the standard deviation of n Gaussian values may be from a known one that was rounded by up to `rounding`:
/// deviations of known / sqrt(n - 1), and the rounding.
double deviation_tolerance(double known, std::size_t records, double rounding);
/// How far the mean of n values of that standard deviation may be from the truth, where `bias` may be systematic.
double mean_tolerance(double deviation, std::size_t records, double bias);

} // namespace placedpar
