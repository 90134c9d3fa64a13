#pragma once

#include "explore/optimise/machine_search.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace placedpar {

/// Makes machines whose run times form a random landscape (S. Kauffman's NK landscape with K = 1). The time is a sum
/// with one part for each val and one part for each two neighbouring vals. The simulated run is one process that
/// computes for this time. With `four_links`, a machine is refused if the values of its first two settings add up to
/// more than four.
struct Landscape {
    std::size_t vals = 4, values = 4; ///< number of vals, and number of values of each val
    std::uint64_t seed = 1;
    bool four_links = false;

    std::string netlist() const;
};

/// A search over a landscape that keeps its runs in a file.
class LandscapeSearch {
public:
    LandscapeSearch(const std::string& folder, const Landscape&, const StudySearch&, const std::string& where = "",
                    std::size_t workers = 1);

    MachineSearch search() {
        return {study_, *space_, *trials_, [](const CourseProgress&) {}};
    }
    const MachineSpace& space() const { return *space_; }
    StudyResults& results() { return *results_; }
    Interruption& interruption() { return interruption_; }

private:
    Study study_;
    Interruption interruption_;
    std::optional<MachineSpace> space_;
    std::optional<StudyResults> results_;
    std::optional<MachineTrials> trials_;
};

} // namespace placedpar
