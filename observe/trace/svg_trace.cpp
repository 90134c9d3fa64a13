#include "observe/trace/svg_trace.hpp"

#include "picture/boxes.hpp"
#include "picture/svg_pen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace placedpar {

namespace {

using picture::Box;
using picture::svg_number;
using picture::SvgPen;
using At = picture::Point;

constexpr double border = 16, title_height = 30, heading_height = 20, row_height = 16, axis_height = 26,
                 legend_height = 26, time_width = 860, label_size = 10, joined_below = 0.4;

/// The style of the drawing. Bars of different activities differ in height and filling, so that the drawing is readable
/// in grey, too.
constexpr const char* style = R"(.title { font-size: 14px; font-weight: bold; }
.node { font-size: 11px; font-weight: bold; }
.row, .key { font-size: 10px; }
.row, .tick { text-anchor: end; }
.tick, .inside { font-size: 9px; }
.tick { text-anchor: middle; }
.inside { fill: #ffffff; }
.grid { stroke: #d5dce3; stroke-width: 0.6; }
.wait { fill: #8898a8; }
.ready { fill: #ffffff; stroke: #3b5b7a; stroke-width: 0.8; }
.compute { fill: #3b6ea5; }
.execute { fill: #3b4b5a; }
.carry { fill: #5b9a6b; stroke: #2b5a3b; stroke-width: 0.5; }
.message { stroke: #b0562b; stroke-width: 0.7; fill: none; }
.head { fill: #b0562b; }
)";
constexpr const char* head_of_messages =
    R"(<marker id="message" viewBox="0 0 8 8" refX="8" refY="4" markerWidth="5" markerHeight="5" orient="auto">)"
    R"(<path class="head" d="M0 1 L8 4 L0 7 Z"/></marker>)";

/// The meanings of bars, in the order in which bars are painted.
enum class Look : unsigned char { wait, ready, compute, execute, carry };

struct LookStyle {
    const char* style_class;
    double height;
    const char* meaning;
};
constexpr LookStyle look_styles[]{{"wait", 1.6, "process waits"},
                                  {"ready", 6, "waits for its processor"},
                                  {"compute", 11, "computes"},
                                  {"execute", 11, "processor or bus is busy"},
                                  {"carry", 6, "link carries bytes"}};
constexpr LookStyle style_of(Look look) { return look_styles[static_cast<std::size_t>(look)]; }

Look look_of(Activity activity) {
    switch (activity) {
    case Activity::executing: return Look::execute;
    case Activity::carrying: return Look::carry;
    case Activity::computing: return Look::compute;
    case Activity::ready: return Look::ready;
    default: return Look::wait;
    }
}

/// A bar of a row, in pixels from the beginning of the time axis.
struct Bar {
    double from, to;
    std::string subject; ///< the process that a processor executes
};

/// Sorts the bars by time, and joins bars that follow each other closely.
std::vector<Bar> joined(std::vector<Bar> bars) {
    std::ranges::stable_sort(bars, {}, &Bar::from);
    std::vector<Bar> out;
    for (Bar& bar : bars)
        if (!out.empty() && bar.from - out.back().to < joined_below && bar.subject == out.back().subject)
            out.back().to = std::max(out.back().to, bar.to);
        else
            out.push_back(std::move(bar));
    return out;
}

struct Row {
    std::string label;
    double y = 0; ///< coordinate of the row's middle
    std::map<Look, std::vector<Bar>> bars = {};
};

/// Returns a label that does not repeat the node's name.
std::string label_of(const Track& track) {
    if (track.place.kind == Track::Kind::processor)
        return "processor";
    std::size_t dot = track.name.find(".link[");
    return track.place.kind == Track::Kind::link && dot != std::string::npos ? track.name.substr(dot + 1) : track.name;
}

struct Unit {
    const char* name;
    double picoseconds;
};

Unit unit_for(double span_ps) {
    return span_ps >= 1e13  ? Unit{"s", 1e12}
           : span_ps >= 2e9 ? Unit{"ms", 1e9}
           : span_ps >= 2e6 ? Unit{"us", 1e6}
                            : Unit{"ns", 1e3};
}

/// Returns a step of 1, 2 or 5 times a power of ten that divides the span into at most ten parts.
double step_for(double span) {
    double power = std::pow(10, std::floor(std::log10(span / 10)));
    for (double factor : {1., 2., 5.})
        if (factor * power * 10 >= span)
            return factor * power;
    return 10 * power;
}

class TimelineDrawing {
public:
    TimelineDrawing(const Tracks& tracks, Time begin, Time end)
        : tracks_(tracks), begin_(begin), span_ps_(std::max(1., static_cast<double>((end - begin).count()))) {}

    void add(const Slice& slice) {
        const Track& track = tracks_.all()[slice.track];
        Row& row = rows_[track.outermost];
        bool named = slice.activity == Activity::executing;
        row.bars[look_of(slice.activity)].push_back({x(slice.begin), x(slice.end), named ? slice.subject : ""});
    }

    /// Places the rows. REQUIRES: all slices have been added.
    void place() {
        double y = title_height;
        std::size_t node = Tracks::none;
        for (std::size_t number : tracks_.drawn()) {
            auto found = rows_.find(number);
            if (found == rows_.end())
                continue;
            const Track& track = tracks_.all()[number];
            if (std::exchange(node, track.place.node) != track.place.node)
                headings_.emplace_back(y += heading_height, tracks_.nodes()[node]);
            found->second.label = label_of(track);
            left_ = std::max(left_, picture::width_of(found->second.label, label_size) + 8);
            found->second.y = y + row_height / 2;
            y += row_height;
        }
        bottom_ = y + 4;
    }

    std::string print(const std::string& title, const std::vector<std::pair<At, At>>& messages) {
        pen_.text({0, 14}, "title", title);
        for (const auto& [y, name] : headings_)
            pen_.text({0, y - 6}, "node", name);
        print_axis();
        for (const auto& [number, row] : rows_)
            print_row(row);
        for (const auto& [from, to] : messages)
            pen_.line(from, to, {{"class", "message"}, {"marker-end", "url(#message)"}});
        print_legend();
        double width = left_ + time_width + 3 * border, height = bottom_ + axis_height + legend_height + border;
        return pen_.document({{width / 2 - border, height / 2 - border / 2}, width, height}, style, head_of_messages);
    }

    /// Returns the point at this time in the middle of the track's row.
    At at(std::size_t track, Time time) const {
        auto found = rows_.find(tracks_.all()[track].outermost);
        return {left_ + x(time), found == rows_.end() ? 0 : found->second.y};
    }

private:
    double x(Time time) const { return time_width * static_cast<double>((time - begin_).count()) / span_ps_; }

    void print_axis() {
        Unit unit = unit_for(span_ps_);
        double from = static_cast<double>(begin_.count()) / unit.picoseconds, span = span_ps_ / unit.picoseconds;
        double step = step_for(span);
        for (double at = std::ceil(from / step - 1e-9) * step + 0.0; at <= from + span * (1 + 1e-9); at += step) {
            double column = left_ + time_width * (at - from) / span;
            pen_.line({column, title_height}, {column, bottom_}, {{"class", "grid"}});
            pen_.text({column, bottom_ + 12}, "tick", fmt::format("{:g} {}", at, unit.name));
        }
    }

    void print_row(const Row& row) {
        pen_.text({left_ - 6, row.y + 3.5}, "row", row.label);
        for (const auto& [look, bars] : row.bars)
            print_bars(row.y, style_of(look), joined(bars));
    }

    /// Draws the bars of one look as one path, and writes names into bars that have room.
    void print_bars(double y, const LookStyle& look, const std::vector<Bar>& bars) {
        std::string data;
        for (const Bar& bar : bars)
            data += fmt::format("M{} {}h{}v{}h-{}z", svg_number(left_ + bar.from), svg_number(y - look.height / 2),
                                svg_number(std::max(bar.to - bar.from, 0.3)), svg_number(look.height),
                                svg_number(std::max(bar.to - bar.from, 0.3)));
        pen_.path(data, {{"class", look.style_class}});
        for (const Bar& bar : bars)
            if (!bar.subject.empty() && picture::width_of(bar.subject, 9) + 6 < bar.to - bar.from)
                pen_.text({left_ + bar.from + 3, y + 3}, "inside", bar.subject);
    }

    void print_legend() {
        At at{left_, bottom_ + axis_height + 6};
        for (const LookStyle& look : look_styles) {
            pen_.rect({{at.x + 12, at.y}, 24, look.height}, {{"class", look.style_class}});
            pen_.text({at.x + 30, at.y + 3.5}, "key", look.meaning);
            at.x += 48 + picture::width_of(look.meaning, label_size);
        }
        pen_.line(at, at + At{24, 0}, {{"class", "message"}, {"marker-end", "url(#message)"}});
        pen_.text(at + At{30, 3.5}, "key", "message");
    }

    const Tracks& tracks_;
    Time begin_;
    double span_ps_, left_ = 60, bottom_ = 0;
    std::map<std::size_t, Row> rows_; ///< key: track of the outermost process
    std::vector<std::pair<double, std::string>> headings_;
    SvgPen pen_;
};

} // namespace

void SvgTrace::write(const MessageArrow& arrow) {
    messages_.push_back({arrow.from, arrow.to, arrow.left, arrow.arrived});
}

void SvgTrace::finish(Time begin, Time end, const std::string& why) {
    TimelineDrawing drawing(tracks_, begin, end);
    for (const Slice& slice : slices_)
        drawing.add(slice);
    drawing.place();
    std::vector<std::pair<At, At>> messages;
    for (const Message& message : messages_)
        if (At from = drawing.at(message.from, message.left), to = drawing.at(message.to, message.arrived);
            from.y != to.y && (message.left > begin || begin == Time{}))
            messages.emplace_back(from, to);
    Unit unit = unit_for(static_cast<double>((end - begin).count()));
    auto shown = [unit](Time time) { return static_cast<double>(time.count()) / unit.picoseconds; };
    file_.write(drawing.print(fmt::format("{:g} to {:g} {}: {}", shown(begin), shown(end), unit.name, why), messages));
}

} // namespace placedpar
