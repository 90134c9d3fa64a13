#include "experiments/chapter_3/kit/block_diagrams.hpp"

#include "picture/svg_pen.hpp"

#include <cstddef>
#include <string_view>
#include <vector>

namespace placedpar {

namespace {

// Sizes in pixels.
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

using Place = picture::Point;

/// A box with its lines of text; wires end at the middle of its left side and begin at that of its right side.
struct Block {
    Place at; ///< top left
    double width;
    std::vector<std::string_view> lines;
    bool plant = false; ///< a machine, real or simulated

    Place left(double down = block_height / 2) const { return {at.x, at.y + down}; }
    Place right(double down = block_height / 2) const { return {at.x + width, at.y + down}; }
    Place top() const { return {at.x + width / 2, at.y}; }
    Place bottom() const { return {at.x + width / 2, at.y + block_height}; }
};

/// A picture that grows.
class Diagram {
public:
    Block add(const Block& block) {
        pen_.rect({{block.at.x + block.width / 2, block.at.y + block_height / 2}, block.width, block_height},
                  {{"class", block.plant ? "block plant" : "block"}, {"rx", "4"}});
        // Where the first of the lines stands, for all to be in the middle.
        double y = block.at.y + block_height / 2 + 5 - (static_cast<int>(block.lines.size()) - 1) * line_height / 2;
        for (std::string_view line : block.lines) {
            pen_.text({block.at.x + block.width / 2, y}, "inside", line);
            y += line_height;
        }
        return block;
    }

    /// Along the corners, with an arrow at the end; the signal's name stands above the stretch that begins at the
    /// corner of this number.
    void wire(const std::vector<Place>& corners, std::string_view signal = "", std::size_t named_at = 0) {
        pen_.path(picture::svg_corners(corners), {{"class", "wire"}});
        if (!signal.empty())
            pen_.text(corners[named_at] + Place{7, -6}, "signal", signal);
    }

    std::string finish(double height, const std::string& title) {
        pen_.text({margin, 30}, "title", title);
        return pen_.document({{450, height / 2}, 900, height}, block_style, head_of_wires, title);
    }

private:
    picture::SvgPen pen_;
};

} // namespace

std::string draw_figure_3_4() {
    constexpr int row = 84, first = title_room + 10;
    Diagram diagram;
    auto y = [](int number) -> double { return first + number * row; };
    const Block pressure = diagram.add({{200, y(0)}, 190, {"line of 5 samples", "by least squares"}});
    const Block angle = diagram.add({{200, y(1)}, 190, {"line of 5 samples", "by least squares"}});
    const Block dynamics = diagram.add({{200, y(3)}, 190, {"spool of the voltage", "and its lag (A.1, A.2)"}});
    const Block piston = diagram.add({{470, y(1)}, 150, {"area times", "moment arm"}});
    const Block orifices = diagram.add({{470, y(2)}, 150, {"orifices", "(A.3 to A.9)"}});
    const Block search = diagram.add({{740, y(1)}, 130, {"genetic", "algorithm"}});
    diagram.wire({{margin, pressure.left().y}, pressure.left()}, "pressure P_BOi [psi]");
    diagram.wire({{margin, angle.left().y}, angle.left()}, "boom angle [deg]");
    diagram.wire({{margin, orifices.left().y}, orifices.left()}, "spool [in] (experiment 1)");
    diagram.wire({{margin, dynamics.left().y}, dynamics.left()}, "voltage [V] (exp. 2)");
    diagram.wire({angle.right(), piston.left()}, "[rad/s]");
    diagram.wire({dynamics.right(),
                  {430, dynamics.right().y},
                  {430, orifices.left().y + 14},
                  orifices.left(block_height / 2 + 14)});
    diagram.wire({pressure.right(), {805, pressure.right().y}, search.top()}, "P_BOi and dP_BOi/dt [psi/s]");
    diagram.wire({piston.right(), search.left()}, "A_i dX/dt");
    diagram.wire({orifices.right(), {805, orifices.right().y}, search.bottom()}, "a_i, a_e [in²]");
    return diagram.finish(first + 4 * row + 6, "Figure 3.4: from the measured data to the genetic algorithm");
}

std::string draw_figure_3_7() {
    constexpr int first = title_room + 12, row = 110;
    Diagram diagram;
    const Block excavator = diagram.add({{230, first}, 150, {"excavator"}, true});
    const Block search = diagram.add({{560, first}, 150, {"genetic algorithm", "(Figure 3.4)"}});
    const Block other = diagram.add({{230, first + 2 * row - 20}, 150, {"excavator,", "another motion"}, true});
    const Block simulator = diagram.add({{560, first + row + 10}, 150, {"simulator of the", "boom's pressure"}, true});
    const Block comparison = diagram.add({{560, first + 2 * row + 10}, 150, {"comparison", "(Figure 3.8)"}});
    diagram.wire({{margin, excavator.left().y}, excavator.left()}, "servo-valve's voltage");
    diagram.wire({excavator.right(), search.left()}, "pressure, angle, spool");
    diagram.wire({search.right(), {800, search.right().y}, {800, simulator.right().y}, simulator.right()},
                 "C_BOi found");
    diagram.wire({{margin, other.left().y}, other.left()}, "servo-valve's voltage");
    diagram.wire({other.right(14), {430, other.right(14).y}, {430, simulator.left().y}, simulator.left()},
                 "voltage, angle", 2);
    diagram.wire({other.right(38), {470, other.right(38).y}, {470, comparison.left().y}, comparison.left()}, "pressure",
                 2);
    diagram.wire({simulator.bottom(), comparison.top()});
    diagram.wire({comparison.right(), {876, comparison.right().y}}, "difference");
    return diagram.finish(first + 3 * row, "Figure 3.7: identification, and the simulator that checks it");
}

} // namespace placedpar
