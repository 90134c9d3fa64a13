#pragma once

#include "explore/study/summary.hpp"

#include <vector>

namespace placedpar::test {

/// Makes the cell of runs with these values.
inline StudyCell cell_of(const std::vector<double>& values) {
    StudyCell cell;
    for (double each : values)
        cell.add(each);
    cell.close();
    return cell;
}

} // namespace placedpar::test
