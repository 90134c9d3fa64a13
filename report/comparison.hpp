#pragma once

#include "report/cell.hpp"

#include <string>
#include <vector>

namespace placedpar {

/// One table of an experiment or a study: simulated figures beside known ones.
struct Comparison {
    std::string name;
    std::vector<Cell> cells = {};
    std::string notes = {};         ///< for people, below the table
    std::string against = "thesis"; ///< the source of the cells' references; 7 letters at most
    bool judged = false;            ///< even where it is not an experiment's first
    bool names_origins = false;     ///< each row says the origin of its first cell, instead of each cell by a letter

    void add(Cell cell);
    bool within_tolerance() const;
};

/// A table for people: each cell as simulated, known and error: in percent, or in the cell's unit where its tolerance
/// is or that is percent itself; a cell judged from one side shows its bound instead of an error, and one beside a
/// claim, which is a bound in words, none. Behind a row stand the tolerances of its cells. What no cell of a column has
/// is left out. Rows and columns come in the order of the cells. A row with a column that the rows above it do not have
/// begins a table of its own.
std::string print_comparison(const Comparison&);

/// Whether the first is within its tolerances, and the others that are judged.
bool are_within_tolerance(const std::vector<Comparison>&);
/// Whether these have a cell with a tolerance or bound.
bool is_any_judged(const std::vector<Comparison>&);
/// For people: that every judged cell of them is within its tolerance, or that one is not. The first of several is
/// `called` the first reading, or table.
std::string print_verdict(const std::vector<Comparison>&, const std::string& called = "reading");
/// For people: how far the outcomes are from what is known, of those in the first cell's unit.
std::string print_fit(const std::vector<Cell>&);

} // namespace placedpar
