#include "experiments/chapter_5/kit/plant_study.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace placedpar;

namespace {

/// Returns the legend of a panel whose rows have these names, without the true pole's entry.
std::vector<std::string> legend_with(const std::vector<std::string>& names) {
    PlantStudy study;
    study.runs = {{PlantTrack{}}};
    study.runs[0][0].poles = {Pole{0.75, 0.37}, Pole{0.5, 0.6}};
    std::vector<TrackRow> rows;
    for (const std::string& name : names)
        rows.push_back({name, &study});
    std::vector<std::string> legend;
    for (const Series& series : pole_panel("", rows).series)
        if (!series.name.empty() && series.name != "truth")
            legend.push_back(series.name);
    return legend;
}

} // namespace

TEST_CASE("the legend of poles states only differences") {
    using Names = std::vector<std::string>;
    CHECK(legend_with({"islands, printed", "islands, row"}) == Names{"printed", "row"});
    CHECK(legend_with({"distributed, window 30", "  window 24"}) == Names{"window 30", "window 24"});
    CHECK(legend_with({"traditional, island 0", "  an island at random", "GA of equal cost, window 20"}) ==
          Names{"traditional, island 0", "traditional, an island at random", "GA of equal cost, window 20"});
    CHECK(legend_with({"islands, printed"}) == Names{"islands, printed"});
    CHECK(legend_with({"25 individuals", "50 individuals"}) == Names{"25 individuals", "50 individuals"});
}
