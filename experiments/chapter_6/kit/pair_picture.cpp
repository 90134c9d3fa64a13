#include "experiments/chapter_6/kit/pair_picture.hpp"

#include "picture/svg_pen.hpp"

#include <fmt/format.h>

namespace placedpar {

namespace {

using picture::SvgPen, picture::svg_corners;

constexpr double string_left = 250, bit_width = 17, field_gap = 8, row_height = 26, box_left = 20, box_width = 200;
constexpr double coarse_row = 80, problem_row = 230, fine_row = 380, picture_height = 470;

constexpr const char* pair_style = R"(text { font-size: 13px; }
.title { font-size: 17px; font-weight: bold; }
.name { font-size: 14px; font-weight: bold; text-anchor: middle; }
.middle { text-anchor: middle; }
.box { fill: #f3f6f9; stroke: #16324a; stroke-width: 1.6; }
.bit { stroke: #16324a; stroke-width: 1; }
.coarse { fill: #7fb3dc; }
.fine { fill: #f4b183; }
.zero { fill: #ffffff; }
.arrow { stroke: #445566; stroke-width: 2; fill: none; marker-end: url(#head); }
)";

constexpr const char* arrow_head = R"(<marker id="head" markerWidth="9" markerHeight="8" refX="8" refY="4" )"
                                   R"(orient="auto"><path d="M0,0 L9,4 L0,8 Z" fill="#445566"/></marker>)";

/// Draws a box. The middle of the box is at the height `y`.
void pair_box(SvgPen& pen, double y, const std::string& name, const std::string& about) {
    const picture::Box box{{box_left + box_width / 2, y}, box_width, 56};
    pen.rect(box, {{"class", "box"}, {"rx", "6"}});
    pen.text(box.centre - picture::Point{0, 6}, "name", name).text(box.centre + picture::Point{0, 14}, "middle", about);
}

/// Draws `count` bits of a field, beginning with the bit number `first`.
void bit_cells(SvgPen& pen, double left, std::size_t first, std::size_t count, double y, const std::string& look) {
    for (std::size_t i = first; i < first + count; ++i)
        pen.rect({{left + bit_width * (static_cast<double>(i) + 0.5), y + row_height / 2}, bit_width, row_height},
                 {{"class", "bit " + look}});
}

/// A field of the problem's string. The field of the coarse search, which has the first bits, is drawn above. The field
/// of the fine search, whose steps are in the last bits, is drawn below.
struct PairField {
    std::string name;
    double left;
    std::size_t bits, coarse, fine;

    double middle() const { return left + bit_width * static_cast<double>(bits) / 2; }

    void draw(SvgPen& pen) const {
        bit_cells(pen, left, 0, coarse, coarse_row, "coarse");
        bit_cells(pen, left, 0, coarse, problem_row, "coarse");
        bit_cells(pen, left, coarse, bits - coarse, problem_row, "zero");
        bit_cells(pen, left, bits - fine, fine, fine_row, "fine");
        pen.text({middle(), coarse_row - 8}, "middle", name);
        pen.text({middle(), fine_row + row_height + 18}, "middle", steps());
    }

private:
    std::string steps() const {
        std::size_t below = std::size_t{1} << (fine - 1);
        return fine == bits ? "all" : fmt::format("−{} ... +{}", below, below - 1);
    }
};

std::vector<PairField> pair_fields(const CoarseFineSettings& settings, const std::vector<std::string>& names) {
    std::vector<PairField> fields;
    double left = string_left;
    for (std::size_t i = 0; i < names.size(); ++i) {
        std::size_t bits = settings.coarse_reading.problem_bits[i];
        fields.push_back({names[i], left, bits, settings.coarse_reading.bits[i], settings.fine_bits[i]});
        left += bit_width * static_cast<double>(bits) + field_gap;
    }
    return fields;
}

/// Draws the arrows from the coarse search to the bias point, from the bias point to the fine search, and from the fine
/// search to the answer. `right` is the right end of the strings.
void both_ways(SvgPen& pen, double right) {
    double middle = (string_left + right) / 2, below = problem_row + row_height, answer = fine_row + row_height / 2;
    pen.path(svg_corners({{middle, coarse_row + row_height}, {middle, problem_row - 6}}), {{"class", "arrow"}});
    pen.text({middle + 10, (coarse_row + problem_row + row_height) / 2 + 4}, "",
             "best of the generation, its other bits 0");
    pen.path(svg_corners({{middle, below}, {middle, fine_row - 6}}), {{"class", "arrow"}});
    pen.text({middle + 10, (below + fine_row) / 2 + 4}, "", "bias point: around it, in steps of the last bit");
    pen.path(svg_corners({{right, answer}, {right + 46, answer}}), {{"class", "arrow"}});
    pen.text({right + 52, answer + 5}, "", "answer");
}

} // namespace

std::string draw_pair(const CoarseFineSettings& settings, const std::vector<std::string>& fields) {
    Recoding fine = settings.coarse_reading;
    fine.bits = settings.fine_bits;
    SvgPen pen;
    pen.text({20, 30}, "title", "A coarse and a fine genetic algorithm (Figure 6.6)");
    const double half = row_height / 2, middle = box_left + box_width / 2, window = problem_row + half;
    pair_box(pen, coarse_row + half, "coarse",
             fmt::format("{} strings of {} bits", settings.coarse.population, settings.coarse_reading.length()));
    pair_box(pen, fine_row + half, "fine",
             fmt::format("{} strings of {} bits", settings.fine.population, fine.length()));
    pair_box(pen, window, "window", fmt::format("newest {} samples", settings.coarse.window.length));
    pen.path(svg_corners({{middle, window - 28}, {middle, coarse_row + half + 30}}), {{"class", "arrow"}});
    pen.path(svg_corners({{middle, window + 28}, {middle, fine_row + half - 30}}), {{"class", "arrow"}});
    double right = string_left;
    for (const PairField& field : pair_fields(settings, fields)) {
        field.draw(pen);
        right = field.left + bit_width * static_cast<double>(field.bits);
    }
    both_ways(pen, right);
    pen.text({right + 8, window + 5}, "",
             fmt::format("{} bits of the problem", settings.coarse_reading.problem_length()));
    double width = right + 170;
    return pen.document({{width / 2, picture_height / 2}, width, picture_height}, pair_style, arrow_head);
}

} // namespace placedpar
