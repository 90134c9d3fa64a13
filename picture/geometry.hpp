#pragma once

#include <cstddef>
#include <vector>

namespace placedpar::picture {

/// x grows to the right, y grows downwards.
struct Point {
    double x = 0, y = 0;

    bool operator==(const Point&) const = default;
};

Point operator+(Point, Point);
Point operator-(Point, Point);
Point operator*(double, Point);
double distance(Point, Point);

struct Box {
    Point centre;
    double width = 0, height = 0;

    double left() const { return centre.x - width / 2; }
    double right() const { return centre.x + width / 2; }
    double top() const { return centre.y - height / 2; }
    double bottom() const { return centre.y + height / 2; }
};

/// Returns the box enlarged by `by` on every side.
Box grown(const Box&, double by);
/// Returns whether the boxes overlap. Boxes that only touch do not overlap.
bool overlap(const Box&, const Box&);
/// Returns whether part of the line from `a` to `b` lies within the box.
bool crosses(const Box&, Point a, Point b);
/// Returns the point at which the line from a point inside the box to a point outside leaves the box.
Point way_out(const Box&, Point inside, Point outside);
/// Returns the smallest box that contains all boxes. REQUIRES: there is at least one box.
Box around(const std::vector<Box>&);
/// Returns the smallest box that contains all points. REQUIRES: there is at least one point.
Box around(const std::vector<Point>&);

} // namespace placedpar::picture
