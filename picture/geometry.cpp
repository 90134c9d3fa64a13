#include "picture/geometry.hpp"

#include <algorithm>
#include <cmath>

namespace placedpar::picture {

Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
Point operator*(double factor, Point p) { return {factor * p.x, factor * p.y}; }

double distance(Point a, Point b) { return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y)); }

Box grown(const Box& box, double by) { return {box.centre, box.width + 2 * by, box.height + 2 * by}; }

bool overlap(const Box& a, const Box& b) {
    return a.left() < b.right() && b.left() < a.right() && a.top() < b.bottom() && b.top() < a.bottom();
}

namespace {

/// The part of a line that lies between two parallel borders; 0 is the line's start, and 1 its end.
struct Part {
    double from = 0, to = 1;

    void cut(double start, double change, double least, double most) {
        if (change == 0) {
            if (start <= least || start >= most)
                to = -1;
            return;
        }
        double one = (least - start) / change, other = (most - start) / change;
        from = std::max(from, std::min(one, other));
        to = std::min(to, std::max(one, other));
    }
};

} // namespace

bool crosses(const Box& box, Point a, Point b) {
    Part part;
    part.cut(a.x, b.x - a.x, box.left(), box.right());
    part.cut(a.y, b.y - a.y, box.top(), box.bottom());
    return part.from < part.to;
}

Point way_out(const Box& box, Point inside, Point outside) {
    Point way = outside - inside;
    Part part;
    part.cut(inside.x, way.x, box.left(), box.right());
    part.cut(inside.y, way.y, box.top(), box.bottom());
    return inside + std::max(part.to, 0.) * way;
}

Box around(const std::vector<Box>& boxes) {
    double left = boxes.front().left(), right = boxes.front().right(), top = boxes.front().top(),
           bottom = boxes.front().bottom();
    for (const Box& box : boxes) {
        left = std::min(left, box.left());
        right = std::max(right, box.right());
        top = std::min(top, box.top());
        bottom = std::max(bottom, box.bottom());
    }
    return {{(left + right) / 2, (top + bottom) / 2}, right - left, bottom - top};
}

Box around(const std::vector<Point>& points) {
    std::vector<Box> boxes;
    for (const Point each : points)
        boxes.push_back({each, 0, 0});
    return around(boxes);
}

} // namespace placedpar::picture
