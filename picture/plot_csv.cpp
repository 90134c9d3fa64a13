#include "picture/plot.hpp"

#include "text/utf8.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>

namespace placedpar {

namespace {

/// Returns the text in quotes, since labels may contain commas.
std::string quoted_cell(const std::string& text) {
    std::string quoted;
    for (char character : escaped(text))
        quoted += character == '"' ? "\"\"" : std::string(1, character);
    return '"' + quoted + '"';
}

/// Writes the rows of one panel.
class Rows {
public:
    Rows(std::string& out, const Panel& panel) : out_(out), panel_(panel) {}

    void add(const std::string& curve, double x, double y) {
        if (!std::isfinite(x) || !std::isfinite(y)) // there is no interval at this point
            return;
        out_ += fmt::format("{},{},{},{},{},{}\n", quoted_cell(panel_.title), quoted_cell(curve),
                            quoted_cell(panel_.x.label), x, quoted_cell(panel_.y.label), y);
    }

    void add(const Series& series) {
        for (const Point& point : series.points)
            add(series.name, point.x, point.y);
        for (std::size_t i = 0; i < series.intervals.size(); ++i) {
            add(series.name + ", lower end", series.points[i].x, series.intervals[i].low);
            add(series.name + ", upper end", series.points[i].x, series.intervals[i].high);
        }
        for (std::size_t i = 0; i < series.x_intervals.size(); ++i) {
            add(series.name + ", left end", series.x_intervals[i].low, series.points[i].y);
            add(series.name + ", right end", series.x_intervals[i].high, series.points[i].y);
        }
    }

private:
    std::string& out_;
    const Panel& panel_;
};

} // namespace

std::string curves_csv(const Plot& plot) {
    std::string out = "panel,curve,x axis,x,y axis,y\n";
    for (const Panel& panel : plot.panels) {
        Rows rows(out, panel);
        for (const Series& series : panel.series)
            rows.add(series);
        for (const Band& band : panel.bands)
            for (const BandPoint& point : band.points) {
                rows.add(band.name + ", lower end", point.x, point.low);
                rows.add(band.name + ", upper end", point.x, point.high);
            }
    }
    return out;
}

} // namespace placedpar
