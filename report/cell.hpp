#pragma once

#include "text/interval.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace placedpar {

/// States where the figure in a cell comes from.
enum class Origin {
    outcome,    ///< result of the simulation; no constant was fitted to the cell
    calibrated, ///< one constant was fitted to this cell
    workload,   ///< the netlist states a cost of the simulated program that was taken from this cell
    fitted,     ///< constants were fitted to several cells, including this cell
    constant    ///< the cell repeats a constant of the model; any difference is an error of PlacedPar
};

inline constexpr std::array every_origin{Origin::outcome, Origin::calibrated, Origin::workload, Origin::fitted,
                                         Origin::constant};

const char* name_of(Origin);

/// States the source of the figure or bound by which a cell is judged.
enum class Judge {
    thesis,    ///< a figure, an equation or a claim of the thesis
    published, ///< a figure that others have published
    own ///< an earlier figure of PlacedPar, the true value of a simulated machine, or a bound chosen for PlacedPar
};

inline constexpr std::array every_judge{Judge::thesis, Judge::published, Judge::own};

const char* name_of(Judge);

/// One figure of an experiment: the simulated figure, the known figure, and the tolerance of their difference.
struct Cell {
    std::string row, column, unit = {};
    std::optional<double> reference = {};         ///< the known figure: Comparison::against names its source
    double simulated = 0;                         ///< NaN if there is no figure; NaN meets no tolerance
    std::optional<double> tolerance_percent = {}; ///< in percent of the reference; empty: no such tolerance
    Origin origin = Origin::outcome;
    std::optional<double> tolerance = {}; ///< in the cell's unit; replaces `tolerance_percent`
    int decimals = 2;                     ///< number of decimals that are printed
    /// One-sided bounds, in the cell's unit. If either is set, the tolerances are not used.
    std::optional<double> at_least = {}, at_most = {};
    std::optional<double> reference_to = {}; ///< upper bound of a claim with two bounds; it is only printed
    std::string source = {}; ///< source of the known figure, if the figures of a comparison have several sources
    std::optional<Judge> judge = {};       ///< empty: the judge that Comparison::against names
    std::optional<Interval> interval = {}; ///< 95 % interval of a simulated share; the cell misses a bound only if the
                                           ///< whole interval misses it

    /// Returns the deviation of the simulated figure from the reference, in percent of the reference; 0 if both are 0;
    /// nothing if a figure is missing, or if only the reference is 0.
    std::optional<double> error_percent() const;
    /// Returns `tolerance_percent`, or `tolerance` in percent of the reference; nothing if neither is defined.
    std::optional<double> tolerance_in_percent() const;
    bool is_judged() const { return at_least || at_most || tolerance || tolerance_percent; }
    bool within_tolerance() const;
};

/// Makes a cell that is judged by its distance from the known figure, in the cell's unit.
Cell judged_cell(std::string row, std::string column, std::string unit, double known, double value, double tolerance,
                 int decimals);
/// Makes a cell that is only printed, beside a known figure or alone.
Cell compared_cell(std::string row, std::string column, std::string unit, double known, double value, int decimals);
Cell plain_cell(std::string row, std::string column, std::string unit, double value, int decimals);
/// Makes a cell that is judged if both a known figure and a tolerance are given, and only printed otherwise.
Cell cell_of(std::string row, std::string column, std::string unit, std::optional<double> known, double value,
             std::optional<double> tolerance, int decimals);
/// Makes a cell that is judged by a bound. The cell may have a known figure, from which it may deviate.
Cell at_least(double bound, Cell cell);
Cell at_most(double bound, Cell cell);
/// Makes a cell that shows a share in percent. The cell misses a bound only if its whole 95 % interval misses the
/// bound, so that few runs do not fail by chance. Without runs the share is 0, and misses no bound. REQUIRES: successes
/// <= runs.
Cell share_cell(std::string row, std::string column, std::size_t successes, std::size_t runs);
Cell judged_by(Judge, Cell);

/// Allowed deviation of a figure that scatters with the seed, in standard deviations. An experiment judges about ten
/// such figures. The known figures are samples, too, and may be wrong by up to two of their own standard deviations.
/// With the remaining two standard deviations, an experiment fails for less than one seed in a hundred
/// (docs/reference/hydraulics.md has the counts).
inline constexpr double deviations_allowed = 4;

/// Returns the tolerance, in percentage points, for the difference between two shares, each of n = `records` records.
/// The standard deviation is sqrt(2 p (1 - p) / n). To estimate p, two successes and two failures are added (Agresti
/// and Coull), so that a share of 0 or 100 % scatters, too. A known share came from 50 to 300 seeds; it is treated as
/// if it came from n records.
double share_tolerance(double known_percent, std::size_t records);
/// Returns how far the standard deviation of n Gaussian values may be from a known standard deviation. The result is
/// `deviations_allowed` times the scatter of the values' standard deviation, plus `rounding`, the largest rounding
/// error of the known figure.
double deviation_tolerance(double known, std::size_t records, double rounding);
/// Returns how far the mean of n values with this standard deviation may be from the true mean, including a systematic
/// error of up to `bias`.
double mean_tolerance(double deviation, std::size_t records, double bias);

} // namespace placedpar
