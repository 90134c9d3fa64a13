#include "picture/labels.hpp"

#include <algorithm>
#include <cmath>

namespace placedpar::picture {

namespace {

constexpr double tile_size = 128, clearance = 2;

int tile_of(double length) { return static_cast<int>(std::floor(length / tile_size)); }

} // namespace

LabelRoom::LabelRoom(const std::vector<Box>& boxes) {
    for (const Box& box : boxes)
        take(box);
}

template <class Visit>
void LabelRoom::each_tile(const Box& box, Visit visit) {
    for (int y = tile_of(box.top()); y <= tile_of(box.bottom()); ++y)
        for (int x = tile_of(box.left()); x <= tile_of(box.right()); ++x)
            visit(Tile{x, y});
}

void LabelRoom::take(const Box& box) {
    each_tile(box, [&](Tile tile) { taken_[tile].push_back(box); });
}

void LabelRoom::add_wire(std::size_t wire, const Path& path) {
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        Box extent = around({path[i], path[i + 1]});
        each_tile(extent, [&](Tile tile) { lines_[tile].push_back({wire, path[i], path[i + 1]}); });
    }
}

bool LabelRoom::is_free(const Box& label) const {
    bool free = true;
    each_tile(label, [&](Tile tile) {
        if (auto found = taken_.find(tile); found != taken_.end())
            free = free && std::ranges::none_of(found->second, [&](const Box& box) { return overlap(box, label); });
    });
    return free;
}

bool LabelRoom::is_crossed(const Box& label, std::size_t but_for) const {
    bool crossed = false;
    each_tile(label, [&](Tile tile) {
        if (auto found = lines_.find(tile); found != lines_.end())
            crossed = crossed || std::ranges::any_of(found->second, [&](const Line& line) {
                          return line.wire != but_for && crosses(label, line.from, line.to);
                      });
    });
    return crossed;
}

std::optional<Box> LabelRoom::first_free(const std::vector<Box>& candidates, std::size_t wire) {
    for (bool crossed_too : {false, true})
        for (const Box& label : candidates)
            if (is_free(grown(label, clearance)) && (crossed_too || !is_crossed(label, wire))) {
                take(label);
                return label;
            }
    return std::nullopt;
}

std::optional<Box> LabelRoom::beside_start(std::size_t wire, const Path& path, double width, double height) {
    double length = distance(path[0], path[1]);
    if (length == 0)
        return std::nullopt;
    Point along = (1 / length) * (path[1] - path[0]), aside{-along.y, along.x};
    double reach_along = std::abs(along.x) * width / 2 + std::abs(along.y) * height / 2,
           reach_aside = std::abs(aside.x) * width / 2 + std::abs(aside.y) * height / 2;
    std::vector<Box> candidates;
    for (double way : {3., 7., 12., 18., 26.})
        for (double side : {along.x < 0 || along.y > 0 ? 1. : -1., along.x < 0 || along.y > 0 ? -1. : 1.})
            if (way + reach_along <= length)
                candidates.push_back(
                    {path[0] + (way + reach_along) * along + side * (reach_aside + 2) * aside, width, height});
    return first_free(candidates, wire);
}

std::optional<Box> LabelRoom::on_middle(std::size_t wire, const Path& path, double width, double height) {
    std::size_t from = longest_line(path);
    std::vector<Box> candidates;
    for (double part : {0.5, 0.46, 0.54, 0.4, 0.6, 0.34, 0.66, 0.28, 0.72, 0.2, 0.8})
        candidates.push_back({path[from] + part * (path[from + 1] - path[from]), width, height});
    return first_free(candidates, wire);
}

std::size_t longest_line(const Path& path) {
    std::size_t longest = 0;
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
        if (distance(path[i], path[i + 1]) > distance(path[longest], path[longest + 1]))
            longest = i;
    return longest;
}

} // namespace placedpar::picture
