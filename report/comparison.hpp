#pragma once

#include "report/cell.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace placedpar {

/// Describes one table of an experiment or a study: simulated figures beside known figures.
struct Comparison {
    std::string name;
    std::vector<Cell> cells = {};
    std::string notes = {};         ///< text printed below the table
    std::string against = "thesis"; ///< the source of the known figures; 7 letters at most
    bool judged = false;            ///< the table is judged even if it is not the first of an experiment
    /// Each row names the origin of its first cell; otherwise each cell shows its origin by a letter.
    bool names_origins = false;

    void add(Cell cell);
    bool within_tolerance() const;
    /// Returns the origin of the figure that judges the cell: the cell's own judge, or the judge that `against` names.
    /// "thesis", "claim" and the number of an equation, "(4.9)" or "eq. 6.2", name the thesis; "publ." and "Poznan"
    /// name published figures.
    Judge judge_of(const Cell&) const;
};

/// The numbers of cells, by the origin of the figure that judges them.
struct JudgedCells {
    std::size_t thesis = 0;
    std::size_t set_from_thesis = 0; ///< cells of `thesis` from which constants were set; such cells test nothing
    std::size_t published = 0, own = 0;
    std::size_t not_judged = 0; ///< cells without a tolerance or bound, and cells of tables that the verdict ignores
};

/// Prints a table for people. Each cell has a simulated figure, a known figure and an error. The error is in percent;
/// it is in the cell's unit if the tolerance is in this unit or the unit is percent. A cell with a one-sided bound
/// shows the bound instead of an error; a cell beside a claim, which is a bound in words, shows no error. The
/// tolerances of a row's cells follow the cells. A part that is empty in all cells of a column is left out. Rows and
/// columns keep the order of the cells. A row begins a new table if it has a column that the rows above do not have.
std::string print_comparison(const Comparison&);

/// Returns whether the first table, and every other judged table, is within its tolerances.
bool are_within_tolerance(const std::vector<Comparison>&);
/// Returns whether the first table, or another judged table, has a cell with a tolerance or bound.
bool is_any_judged(const std::vector<Comparison>&);
/// Counts the cells of all tables.
JudgedCells count_judged(const std::vector<Comparison>&);
/// Prints for people, on one line, the number of cells that are judged against the thesis, and against other figures.
std::string print_judged(const JudgedCells&);
/// Prints for people whether all judged cells are within their tolerances. If only the first table is judged, the text
/// calls this table "the first reading"; `called` can replace the word "reading".
std::string print_verdict(const std::vector<Comparison>&, const std::string& called = "reading");
/// Prints for people how far the outcomes are from the known figures; only cells in the unit of the first cell count.
std::string print_fit(const std::vector<Cell>&);

} // namespace placedpar
