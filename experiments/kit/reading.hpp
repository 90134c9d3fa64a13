#pragma once

#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// Where the figure in a cell comes from.
enum class Origin {
    outcome,    ///< of the simulation, nothing was fitted to it
    calibrated, ///< one constant was fitted to this cell
    workload    ///< a constant of the program's own cost was read off this cell
};

const char* name_of(Origin);

/// One figure of a table of the thesis beside the simulated one.
struct Cell {
    std::string row, column, unit;
    std::optional<double> thesis; ///< or whatever Reading::against says
    double simulated;
    std::optional<double> tolerance_percent; ///< of the thesis's figure; none: printed, not judged
    Origin origin = Origin::outcome;
    std::optional<double> tolerance = std::nullopt; ///< in the cell's unit; goes before tolerance_percent
    int decimals = 2;                               ///< as printed
    /// One-sided, in the cell's unit; where either is, it judges the cell, and no tolerance does.
    std::optional<double> at_least = std::nullopt, at_most = std::nullopt;

    /// Of the thesis's figure; 0 where both are 0. None without a figure to compare with.
    std::optional<double> error_percent() const;
    /// tolerance_percent, or what `tolerance` is in percent; none where that is not defined.
    std::optional<double> tolerance_in_percent() const;
    bool within_tolerance() const;
};

/// One table of an experiment: a way of reading it, run, or a part of it.
struct Reading {
    std::string name;
    std::vector<Cell> cells;
    std::string notes;              ///< for people, below the table
    std::string against = "thesis"; ///< what the figures are that the simulated ones stand beside; 7 letters at most
    bool judged = false;            ///< even where it is not the first
};

bool within_tolerance(const Reading&);

/// A table for people: each cell as simulated, thesis and error: in percent, or in the cell's unit where its tolerance
/// is or that is percent itself; of a one-sided cell the bound that it is judged by. Rows and columns come in the order
/// of the cells. A row with a column that the rows above it do not have begins a table of its own.
std::string print_reading(const Reading&);

} // namespace placedpar
