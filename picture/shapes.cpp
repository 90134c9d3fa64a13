#include "picture/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace placedpar::picture {

namespace {

double as_cells(std::size_t count) { return static_cast<double>(count); }

/// Returns the points point_of(0) to point_of(count - 1).
template <class PointOf>
Shape shape_of(std::size_t count, PointOf point_of) {
    Shape shape;
    for (std::size_t i = 0; i < count; ++i)
        shape.push_back(point_of(i));
    return shape;
}

/// Rounds to an eighth of a cell, so that the results of all compilers are equal.
double to_eighths(double cells) { return std::round(cells * 8) / 8; }

Shape circle_of_radius(std::size_t count, double radius) {
    using std::numbers::pi;
    double step = 2 * pi / as_cells(count), start = -pi / 2 - (count > 3 ? step / 2 : 0);
    return shape_of(count, [&](std::size_t i) -> Point {
        double angle = start + as_cells(i) * step;
        return {to_eighths(radius * std::cos(angle)), to_eighths(radius * std::sin(angle))};
    });
}

bool a_cell_apart(Point a, Point b) { return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)) >= 1; }

bool neighbours_have_room(const Shape& shape) {
    for (std::size_t i = 0; i < shape.size(); ++i)
        if (!a_cell_apart(shape[i], shape[(i + 1) % shape.size()]))
            return false;
    return true;
}

bool centre_has_room(const Shape& shape) {
    return std::ranges::all_of(shape, [](Point each) { return a_cell_apart(each, {}); });
}

/// Returns the smallest circle that satisfies the condition.
template <class Condition>
Shape smallest_circle(std::size_t count, Condition condition) {
    double radius = std::max(0.5, std::floor(as_cells(count) / 8) - 1);
    Shape shape = circle_of_radius(count, radius);
    while (!condition(shape))
        shape = circle_of_radius(count, radius += 0.125);
    return shape;
}

/// Returns the distance, in cells, between consecutive elements in each dimension of an array. The drawing has two
/// directions: the last dimension takes one direction, the last but one the other, and so on in turn.
std::vector<double> strides(const std::vector<std::int64_t>& sizes) {
    std::vector<double> result(sizes.size(), 1);
    for (std::size_t i = sizes.size(); i-- > 0;)
        if (i + 2 < sizes.size())
            result[i] = result[i + 2] * static_cast<double>(sizes[i + 2]) + 0.5;
    return result;
}

std::size_t gray_rank(std::size_t code) {
    std::size_t rank = 0;
    for (; code != 0; code >>= 1)
        rank ^= code;
    return rank;
}

class TreeShape {
public:
    explicit TreeShape(const std::vector<std::size_t>& hangs_from) : shape_(hangs_from.size()) {
        for (std::size_t i = 0; i < hangs_from.size(); ++i)
            below_[hangs_from[i]].push_back(i);
    }

    Shape find() {
        put(below_[no_node].front(), 0);
        return std::move(shape_);
    }

private:
    void put(std::size_t node, double depth) {
        for (auto each : below_[node])
            put(each, depth + 1);
        const auto& below = below_[node];
        double x = below.empty() ? next_ : (shape_[below.front()].x + shape_[below.back()].x) / 2;
        next_ = std::max(next_, x + 1);
        shape_[node] = {x, depth};
    }

    Shape shape_;
    std::map<std::size_t, std::vector<std::size_t>> below_;
    double next_ = 0; ///< x of the next leaf
};

Shape cube() {
    return shape_of(8, [](std::size_t i) -> Point {
        double x = i & 1 ? 2 : 0, y = i & 2 ? 2 : 0, behind = i & 4 ? 1 : 0;
        return {x + behind, y - behind};
    });
}

} // namespace

Shape row(std::size_t count) {
    return shape_of(count, [](std::size_t i) -> Point { return {as_cells(i), 0}; });
}

Shape column(std::size_t count) {
    return shape_of(count, [](std::size_t i) -> Point { return {0, as_cells(i)}; });
}

Shape snake(std::size_t count, std::size_t longest) {
    std::size_t rows = (count + longest - 1) / longest, length = (count + rows - 1) / rows;
    return shape_of(count, [&](std::size_t i) -> Point {
        std::size_t y = i / length, x = i % length;
        return {as_cells(y % 2 == 0 ? x : length - 1 - x), as_cells(y)};
    });
}

Shape rectangle(std::size_t count) {
    std::size_t length = 1;
    while (length * length < count)
        ++length;
    return shape_of(count, [&](std::size_t i) -> Point { return {as_cells(i % length), as_cells(i / length)}; });
}

bool is_circle(const Shape& shape) {
    double least = 1e9, most = 0;
    Point c{};
    for (Point each : shape)
        c = c + 1 / as_cells(shape.size()) * each;
    for (Point each : shape) {
        double radius = std::hypot(each.x - c.x, each.y - c.y);
        least = std::min(least, radius);
        most = std::max(most, radius);
    }
    return most - least < 0.5;
}

Shape circle(std::size_t count) { return smallest_circle(count, neighbours_have_room); }

Shape star(std::size_t count) {
    return smallest_circle(count,
                           [](const Shape& shape) { return neighbours_have_room(shape) && centre_has_room(shape); });
}

Shape tree(const std::vector<std::size_t>& hangs_from) { return TreeShape(hangs_from).find(); }

Shape grid(const std::vector<std::vector<std::int64_t>>& subscripts) {
    std::vector<std::int64_t> sizes(subscripts.front().size(), 1);
    for (const auto& each : subscripts)
        for (std::size_t i = 0; i < sizes.size(); ++i)
            sizes[i] = std::max(sizes[i], each[i] + 1);
    auto stride = strides(sizes);
    return shape_of(subscripts.size(), [&](std::size_t element) {
        Point at;
        for (std::size_t i = 0; i < sizes.size(); ++i)
            ((sizes.size() - i) % 2 == 1 ? at.x : at.y) += static_cast<double>(subscripts[element][i]) * stride[i];
        return at;
    });
}

Shape hypercube(std::size_t dimensions) {
    if (dimensions == 3)
        return cube();
    std::size_t across = (dimensions + 1) / 2, mask = (std::size_t{1} << across) - 1;
    return shape_of(std::size_t{1} << dimensions, [&](std::size_t i) -> Point {
        return {as_cells(gray_rank(i & mask)), as_cells(gray_rank(i >> across))};
    });
}

Shape cube_connected_cycles(std::size_t dimensions) {
    Shape corners = hypercube(dimensions), cycle = circle(dimensions), shape;
    double largest = 0;
    for (Point each : cycle)
        largest = std::max({largest, std::abs(each.x), std::abs(each.y)});
    double apart = std::ceil(2 * largest + 1);
    for (Point corner : corners)
        for (Point each : cycle)
            shape.push_back(apart * corner + each);
    return shape;
}

} // namespace placedpar::picture
