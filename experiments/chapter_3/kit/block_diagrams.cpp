#include "experiments/chapter_3/kit/block_diagrams.hpp"

#include "picture/svg_pen.hpp"

#include <cstddef>
#include <string_view>
#include <vector>

namespace placedpar {

namespace {

// Sizes are in pixels.
constexpr int block_height = 52, line_height = 17, title_room = 46, margin = 24;

constexpr const char* block_style =
    R"(text { font-size: 13px; }
.title { font-size: 17px; font-weight: bold; }
.block { fill: #eef3f7; stroke: #16324a; stroke-width: 1.5; }
.plant { fill: #ffffff; stroke-width: 2.5; }
.inside { text-anchor: middle; }
.signal { font-style: italic; }
.wire { stroke: #16324a; stroke-width: 1.5; fill: none; marker-end: url(#head); }
)";

constexpr const char* head_of_wires =
    R"(<marker id="head" viewBox="0 0 10 10" refX="9" refY="5" markerWidth="8" markerHeight="8" orient="auto">)"
    R"(<path d="M0 0L10 5L0 10z" fill="#16324a"/></marker>)";

using picture::SvgPen;
using Position = picture::Point;

/// A box with lines of text. Wires end at the middle of the box's left side and begin at the middle of its right side.
struct Block {
    Position at; ///< top left
    double width;
    std::vector<std::string_view> lines;
    bool plant = false; ///< a real or simulated machine

    Position left(double down = block_height / 2) const { return {at.x, at.y + down}; }
    Position right(double down = block_height / 2) const { return {at.x + width, at.y + down}; }
    Position top() const { return {at.x + width / 2, at.y}; }
    Position bottom() const { return {at.x + width / 2, at.y + block_height}; }
};

Block add(SvgPen& pen, const Block& block) {
    pen.rect({{block.at.x + block.width / 2, block.at.y + block_height / 2}, block.width, block_height},
             {{"class", block.plant ? "block plant" : "block"}, {"rx", "4"}});
    // `y` is the baseline of the first line. It is chosen such that all lines together are centred in the box.
    double y = block.at.y + block_height / 2 + 5 - (static_cast<int>(block.lines.size()) - 1) * line_height / 2;
    for (std::string_view line : block.lines) {
        pen.text({block.at.x + block.width / 2, y}, "inside", line);
        y += line_height;
    }
    return block;
}

/// Draws a wire through the corners, with an arrow at its end. The name of the signal is drawn above the segment that
/// begins at the corner with the index `named_at`.
void wire(SvgPen& pen, const std::vector<Position>& corners, std::string_view signal = "", std::size_t named_at = 0) {
    pen.path(picture::svg_corners(corners), {{"class", "wire"}});
    if (!signal.empty())
        pen.text(corners[named_at] + Position{7, -6}, "signal", signal);
}

std::string finish(SvgPen& pen, double height, const std::string& title) {
    pen.text({margin, 30}, "title", title);
    return pen.document({{450, height / 2}, 900, height}, block_style, head_of_wires, title);
}

} // namespace

std::string draw_figure_3_4() {
    constexpr int row = 84, first = title_room + 10;
    SvgPen pen;
    auto y = [](int number) -> double { return first + number * row; };
    const Block pressure = add(pen, {{200, y(0)}, 190, {"line of 5 samples", "by least squares"}});
    const Block angle = add(pen, {{200, y(1)}, 190, {"line of 5 samples", "by least squares"}});
    const Block dynamics = add(pen, {{200, y(3)}, 190, {"spool of the voltage", "and its lag (A.1, A.2)"}});
    const Block piston = add(pen, {{470, y(1)}, 150, {"area times", "moment arm"}});
    const Block orifices = add(pen, {{470, y(2)}, 150, {"orifices", "(A.3 to A.9)"}});
    const Block search = add(pen, {{740, y(1)}, 130, {"genetic", "algorithm"}});
    wire(pen, {{margin, pressure.left().y}, pressure.left()}, "pressure P_BOi [psi]");
    wire(pen, {{margin, angle.left().y}, angle.left()}, "boom angle [deg]");
    wire(pen, {{margin, orifices.left().y}, orifices.left()}, "spool [in] (experiment 1)");
    wire(pen, {{margin, dynamics.left().y}, dynamics.left()}, "voltage [V] (exp. 2)");
    wire(pen, {angle.right(), piston.left()}, "[rad/s]");
    wire(pen, {dynamics.right(),
               {430, dynamics.right().y},
               {430, orifices.left().y + 14},
               orifices.left(block_height / 2 + 14)});
    wire(pen, {pressure.right(), {805, pressure.right().y}, search.top()}, "P_BOi and dP_BOi/dt [psi/s]");
    wire(pen, {piston.right(), search.left()}, "A_i dX/dt");
    wire(pen, {orifices.right(), {805, orifices.right().y}, search.bottom()}, "a_i, a_e [in²]");
    return finish(pen, first + 4 * row + 6, "Figure 3.4: from the measured data to the genetic algorithm");
}

std::string draw_figure_3_7() {
    constexpr int first = title_room + 12, row = 110;
    SvgPen pen;
    const Block excavator = add(pen, {{230, first}, 150, {"excavator"}, true});
    const Block search = add(pen, {{560, first}, 150, {"genetic algorithm", "(Figure 3.4)"}});
    const Block other = add(pen, {{230, first + 2 * row - 20}, 150, {"excavator,", "another motion"}, true});
    const Block simulator = add(pen, {{560, first + row + 10}, 150, {"simulator of the", "boom's pressure"}, true});
    const Block comparison = add(pen, {{560, first + 2 * row + 10}, 150, {"comparison", "(Figure 3.8)"}});
    wire(pen, {{margin, excavator.left().y}, excavator.left()}, "servo-valve's voltage");
    wire(pen, {excavator.right(), search.left()}, "pressure, angle, spool");
    wire(pen, {search.right(), {800, search.right().y}, {800, simulator.right().y}, simulator.right()}, "C_BOi found");
    wire(pen, {{margin, other.left().y}, other.left()}, "servo-valve's voltage");
    wire(pen, {other.right(14), {430, other.right(14).y}, {430, simulator.left().y}, simulator.left()},
         "voltage, angle", 2);
    wire(pen, {other.right(38), {470, other.right(38).y}, {470, comparison.left().y}, comparison.left()}, "pressure",
         2);
    wire(pen, {simulator.bottom(), comparison.top()});
    wire(pen, {comparison.right(), {876, comparison.right().y}}, "difference");
    return finish(pen, first + 3 * row, "Figure 3.7: identification, and the simulator that checks it");
}

} // namespace placedpar
