#pragma once

#include "explore/study/expression.hpp"
#include "report/cell.hpp"

#include <string>
#include <vector>

namespace placedpar {

/// What a table calls some runs of a study, and what is set for them.
struct StudyVariant {
    std::string name;
    Overrides set = {};
};

/// How far a figure may be from the known one.
struct StudyTolerance {
    StudyExpression amount{""}; ///< over what is set, and `known`; none: the figure is not judged by it
    bool in_percent = false;    ///< of the known one; else in the unit of the figure
};

/// A row of a table. Lists have a member for each column, or none at all.
struct StudyRow {
    StudyVariant runs;
    std::string measure = "";   ///< the figure is this one, as the study names it; "": the next
    StudyExpression figure{""}; ///< over what is set, measures by their last names, and the rows above by their names
    std::string unit = "";
    int decimals = 2;
    std::vector<StudyExpression> known = {}; ///< over what is set
    std::vector<StudyTolerance> tolerances = {};
    std::vector<Origin> origins = {};
    Overrides relative_to = {}; ///< measures are divided by those of the same run with these settings
};

/// Figures of a study beside known ones: a cell for each row and column.
struct StudyTable {
    std::string name, against = "known", notes = "";
    bool judged = false;   ///< even where it is not the first
    bool fit = false;      ///< whether a line below it says how far its outcomes are from what is known
    Overrides shared = {}; ///< what is set in all its runs, unless a row or column sets it
    std::vector<StudyVariant> columns = {};
    std::vector<StudyRow> rows = {};

    /// What is set for a cell.
    Overrides set(const StudyRow&, const StudyVariant& column) const;
};

} // namespace placedpar
