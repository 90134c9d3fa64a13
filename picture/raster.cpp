#include "picture/raster.hpp"

#include "picture/boxes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <tuple>

namespace placedpar::picture {

namespace {

/// The costs of a path; the cheapest path is chosen. Each step of a pitch costs `step_cost`. The other costs are added
/// for a bend, a crossing with a wire, and a point close to a box.
constexpr unsigned step_cost = 1, bend_cost = 4, crossing_cost = 1, near_cost = 2;
constexpr std::size_t most_points = 4'000'000, most_steps = 40'000'000;

constexpr std::ptrdiff_t across_of[] = {1, 0, -1, 0}, down_of[] = {0, 1, 0, -1};

} // namespace

Raster::Raster(const Box& area, const std::vector<Box>& boxes)
    : origin_{std::floor(area.left() / pitch) * pitch, std::floor(area.top() / pitch) * pitch},
      columns_(static_cast<std::ptrdiff_t>(area.width / pitch) + 2),
      lines_(static_cast<std::ptrdiff_t>(area.height / pitch) + 2), steps_left_(most_steps) {
    auto points = static_cast<std::size_t>(columns_ * lines_);
    if (points <= most_points)
        marks_.resize(points);
    for (const Box& box : boxes)
        mark(grown(box, pitch), [](Cell& each) { each.near = true; });
    for (const Box& box : boxes)
        block(box);
}

bool Raster::holds(std::ptrdiff_t column, std::ptrdiff_t line) const {
    return column >= 0 && line >= 0 && column < columns_ && line < lines_;
}

std::size_t Raster::index_of(Point p) const {
    auto column = std::lround((p.x - origin_.x) / pitch), line = std::lround((p.y - origin_.y) / pitch);
    return static_cast<std::size_t>(line * columns_ + column);
}

Point Raster::point_of(std::size_t index) const {
    auto column = static_cast<std::ptrdiff_t>(index) % columns_, line = static_cast<std::ptrdiff_t>(index) / columns_;
    return origin_ + pitch * Point{static_cast<double>(column), static_cast<double>(line)};
}

template <class Change>
void Raster::mark(const Box& box, Change change) {
    auto first = [](double from, double origin) {
        return static_cast<std::ptrdiff_t>(std::ceil((from - origin) / pitch));
    };
    auto last = [](double to, double origin) { return static_cast<std::ptrdiff_t>(std::floor((to - origin) / pitch)); };
    for (auto line = first(box.top(), origin_.y); line <= last(box.bottom(), origin_.y); ++line)
        for (auto column = first(box.left(), origin_.x); column <= last(box.right(), origin_.x); ++column)
            if (holds(column, line) && !marks_.empty())
                change(marks_[static_cast<std::size_t>(line * columns_ + column)]);
}

void Raster::block(const Box& box) {
    mark(box, [](Cell& each) { each.blocked = true; });
}

void Raster::add(const Path& path) {
    for (std::size_t i = 0; i + 1 < path.size() && !marks_.empty(); ++i) {
        Point way = path[i + 1] - path[i];
        double steps = std::ceil(distance(path[i], path[i + 1]) / pitch);
        for (double step = 0; step <= steps; ++step) {
            Box here{path[i] + (step / steps) * way, pitch, pitch};
            mark(way.x == 0 || way.y == 0 ? Box{here.centre, 1, 1} : here, [&](Cell& each) {
                (way.y == 0 ? each.across : way.x == 0 ? each.down : each.slanting) = true;
            });
        }
    }
}

namespace {

Box around_ports(const std::vector<Port>& ports) {
    std::vector<Point> points;
    for (const Port& port : ports)
        points.push_back(port.at);
    return around(points);
}

} // namespace

/// Finds the cheapest path by the A* algorithm. A state is a point and the direction in which the path reaches it.
class Raster::Search {
public:
    Search(Raster& raster, const std::vector<Port>& to)
        : r_(raster), goal_(around_ports(to)), costs_(raster.costs_), before_(raster.before_) {
        costs_.resize(4 * raster.marks_.size(), unreached);
        before_.resize(4 * raster.marks_.size(), from_nowhere);
        for (const Port& port : to)
            if (auto index = r_.index_of(port.at); !r_.marks_[index].has_wire())
                entries_.emplace(index, opposite(way_of(port.outward)));
    }

    ~Search() {
        for (State state : reached_)
            costs_[state] = unreached;
    }
    Search(const Search&) = delete;
    Search& operator=(const Search&) = delete;

    std::optional<Path> find(const std::vector<Port>& from) {
        for (const Port& port : from)
            if (auto index = r_.index_of(port.at); !r_.marks_[index].has_wire())
                reach(index, from_nowhere, way_of(port.outward), 0);
        while (!open_.empty() && r_.steps_left_ > 0) {
            auto [bound, order, state] = open_.top();
            open_.pop();
            --r_.steps_left_;
            if (is_entry(state))
                return trace(state);
            if (bound == costs_[state] + at_least(state / 4))
                go_on(state);
        }
        return std::nullopt;
    }

private:
    /// The directions of a step. (direction + 2) % 4 is the opposite direction.
    enum Way : unsigned char { right, below, left, above, from_nowhere };
    using State = std::size_t;
    static constexpr unsigned unreached = std::numeric_limits<unsigned>::max();

    static Way opposite(Way way) { return static_cast<Way>((way + 2) % 4); }
    static Way way_of(Point outward) {
        return outward.x > 0 ? right : outward.y > 0 ? below : outward.x < 0 ? left : above;
    }
    static Way way_to(State state) { return static_cast<Way>(state % 4); }

    bool is_entry(State state) const {
        auto found = entries_.find(state / 4);
        return found != entries_.end() && found->second == way_to(state);
    }

    /// Returns a lower bound of the cost from this point to the goal.
    unsigned at_least(std::size_t index) const {
        Point p = r_.point_of(index);
        double dx = std::max({goal_.left() - p.x, p.x - goal_.right(), 0.}),
               dy = std::max({goal_.top() - p.y, p.y - goal_.bottom(), 0.});
        return static_cast<unsigned>((dx + dy) / pitch);
    }

    std::optional<std::size_t> step(std::size_t index, Way way) const {
        auto column = static_cast<std::ptrdiff_t>(index) % r_.columns_ + across_of[way],
             line = static_cast<std::ptrdiff_t>(index) / r_.columns_ + down_of[way];
        return r_.holds(column, line) ? std::optional(static_cast<std::size_t>(line * r_.columns_ + column))
                                      : std::nullopt;
    }

    /// Returns whether a wire may enter the state: it must not run along another wire, and may enter a box only at its
    /// end.
    bool may_enter(State state) const {
        const Cell& mark = r_.marks_[state / 4];
        bool across = way_to(state) == left || way_to(state) == right;
        return (across ? !mark.across : !mark.down) && (!mark.blocked || is_entry(state));
    }

    void reach(std::size_t index, Way before, Way way, unsigned cost) {
        auto next = step(index, way);
        if (!next || !may_enter(*next * 4 + way))
            return;
        State state = *next * 4 + way;
        const Cell& mark = r_.marks_[*next];
        cost += step_cost + (mark.has_wire() ? crossing_cost : 0) + (mark.near ? near_cost : 0);
        if (cost >= costs_[state])
            return;
        if (costs_[state] == unreached)
            reached_.push_back(state);
        costs_[state] = cost;
        before_[state] = before;
        open_.emplace(cost + at_least(*next), order_++, state);
    }

    /// Continues the search at the neighbours of the state. A wire does not bend where it crosses another wire.
    void go_on(State state) {
        Way way = way_to(state);
        bool may_bend = !r_.marks_[state / 4].has_wire();
        for (Way next : {right, below, left, above})
            if (next == way)
                reach(state / 4, way, next, costs_[state]);
            else if (may_bend && next != opposite(way))
                reach(state / 4, way, next, costs_[state] + bend_cost);
    }

    Path trace(State state) const {
        Path path{r_.point_of(state / 4)};
        while (true) {
            Way way = way_to(state), before = static_cast<Way>(before_[state]);
            auto back = step(state / 4, opposite(way)).value();
            if (before != way)
                path.push_back(r_.point_of(back));
            if (before == from_nowhere)
                break;
            state = back * 4 + before;
        }
        std::ranges::reverse(path);
        return path;
    }

    /// Lower bound of the whole cost, order of insertion, state.
    using Entry = std::tuple<unsigned, std::size_t, State>;

    Raster& r_;
    Box goal_;
    /// The points at which the search may end, and the direction in which the path must arrive there.
    std::map<std::size_t, Way> entries_;
    /// The raster keeps these arrays from search to search. A search resets only the points that it has reached.
    std::vector<unsigned>& costs_;
    std::vector<unsigned char>& before_;
    std::vector<State> reached_;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
    std::size_t order_ = 0;
};

std::optional<Path> Raster::find(const std::vector<Port>& from, const std::vector<Port>& to) {
    if (marks_.empty() || from.empty() || to.empty())
        return std::nullopt;
    return Search(*this, to).find(from);
}

} // namespace placedpar::picture
