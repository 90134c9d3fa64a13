#pragma once

#include "explore/study/expression.hpp"
#include "report/cell.hpp"

#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// A row or column of a study's table: its name, and the settings of its runs.
struct StudyVariant {
    std::string name;
    Overrides set = {};
};

struct StudyTolerance {
    StudyExpression amount{""}; ///< expression of the settings and `known`; empty: no tolerance
    bool in_percent = false;    ///< percent of the known figure; otherwise in the unit of the figure
};

/// A row of a table. Each list is empty or has a member for each column.
struct StudyRow {
    StudyVariant runs;
    std::string measure = ""; ///< the measure that the row shows; "" if the row shows the value of `figure`
    StudyExpression figure{
        ""}; ///< expression of the settings, the measures by their last names, and the rows above by their names
    std::string unit = "";
    int decimals = 2;
    std::vector<StudyExpression> known = {}; ///< expressions of the settings
    std::vector<StudyTolerance> tolerances = {};
    std::vector<StudyExpression> at_least = {}, at_most = {}; ///< bounds of the figure, as expressions of the settings
    bool interval = false; ///< whether two rows below give the 95 % intervals of the figures
    std::vector<Origin> origins = {};
    std::optional<Judge> judge = {}; ///< empty: the judge that `against` of the table names
    Overrides relative_to = {};      ///< each measure is divided by the measure of a reference run, which has these
                                     ///< settings, and otherwise the settings of the row
};

/// A table of a study's figures beside known figures, with a cell for each row and column.
struct StudyTable {
    std::string name, against = "known", notes = "";
    bool judged = false;   ///< whether misses of the table's figures count; misses of the first table always count
    bool fit = false;      ///< whether a line below the table states how far its figures deviate from the known figures
    Overrides shared = {}; ///< settings of all runs of the table, unless a row or column sets them
    std::vector<StudyVariant> columns = {};
    std::vector<StudyRow> rows = {};

    /// Returns the settings of the cell in this row and column.
    Overrides set(const StudyRow&, const StudyVariant& column) const;
};

} // namespace placedpar
