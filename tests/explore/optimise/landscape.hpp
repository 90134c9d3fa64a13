#pragma once

#include "explore/optimise/machine_search.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace placedpar {

/// Machines whose times are a random landscape: the time of setting each of some vals adds up, with a part for each two
/// that are neighbours (S. Kauffman's NK landscapes with K = 1). What is simulated is one process that computes for
/// that long. With `four_links`, a machine is refused where its first two settings want more than four links together.
struct Landscape {
    std::size_t vals = 4, values = 4; ///< of each val
    std::uint64_t seed = 1;
    bool four_links = false;

    std::string netlist() const;
};

/// A search over a landscape, whose runs are kept in a file.
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
