#include "experiments/chapter_6/kit/pair_picture.hpp"

#include <fmt/format.h>

namespace placedpar {

namespace {

constexpr double string_left = 250, bit_width = 17, field_gap = 8, row_height = 26, box_left = 20, box_width = 200;
constexpr double coarse_row = 80, problem_row = 230, fine_row = 380, picture_height = 470;

constexpr const char* pair_style = R"(text { font-family: Helvetica, Arial, "DejaVu Sans", sans-serif; fill: #16202a;
font-size: 13px; }
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

constexpr const char* arrow_head = R"(<defs><marker id="head" markerWidth="9" markerHeight="8" refX="8" refY="4" )"
                                   R"(orient="auto"><path d="M0,0 L9,4 L0,8 Z" fill="#445566"/></marker></defs>)";

std::string pair_text(double x, double y, const char* look, const std::string& text) {
    return fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\">{}</text>\n", look, x, y, text);
}

std::string pair_arrow(double x, double y, double to_x, double to_y) {
    return fmt::format("<path class=\"arrow\" d=\"M{},{} L{},{}\"/>\n", x, y, to_x, to_y);
}

std::string pair_box(double y, double height, const std::string& name, const std::string& about) {
    double middle = box_left + box_width / 2;
    return fmt::format("<rect class=\"box\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"6\"/>\n", box_left, y,
                       box_width, height) +
           pair_text(middle, y + 22, "name", name) + pair_text(middle, y + 42, "middle", about);
}

/// A search, beside the row of its string.
std::string search_box(double row, const std::string& name, const SearchSettings& settings, const Recoding& reading) {
    return pair_box(row + row_height / 2 - 28, 56, name,
                    fmt::format("{} strings of {} bits", settings.population, reading.length()));
}

std::string bit_cell(double x, double y, const char* look) {
    return fmt::format("<rect class=\"bit {}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n", look, x, y, bit_width,
                       row_height);
}

/// `count` bits of a field, from its bit number `first` on.
std::string bit_cells(double left, std::size_t first, std::size_t count, double y, const char* look) {
    std::string cells;
    for (std::size_t i = first; i < first + count; ++i)
        cells += bit_cell(left + bit_width * static_cast<double>(i), y, look);
    return cells;
}

/// A field of both searches' strings, above and below that of the problem: the coarse one has its first bits, the fine
/// one counts in its last.
struct PairField {
    std::string name;
    double left;
    std::size_t bits, coarse, fine;

    double middle() const { return left + bit_width * static_cast<double>(bits) / 2; }
    bool found_by_itself() const { return fine == bits; }

    std::string text() const {
        return bit_cells(left, 0, coarse, coarse_row, "coarse") + bit_cells(left, 0, coarse, problem_row, "coarse") +
               bit_cells(left, coarse, bits - coarse, problem_row, "zero") +
               bit_cells(left, bits - fine, fine, fine_row, "fine") +
               pair_text(middle(), coarse_row - 8, "middle", name) +
               pair_text(middle(), fine_row + row_height + 18, "middle", steps());
    }

private:
    std::string steps() const {
        std::size_t below = std::size_t{1} << (fine - 1);
        return found_by_itself() ? "all" : fmt::format("−{} ... +{}", below, below - 1);
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

/// What goes from one to the other. `right` is where the strings end.
std::string both_ways(double right) {
    double middle = (string_left + right) / 2, below = problem_row + row_height;
    return pair_arrow(middle, coarse_row + row_height, middle, problem_row - 6) +
           pair_text(middle + 10, (coarse_row + problem_row + row_height) / 2 + 4, "",
                     "best of the generation, its other bits 0") +
           pair_arrow(middle, below, middle, fine_row - 6) +
           pair_text(middle + 10, (below + fine_row) / 2 + 4, "", "bias point: around it, in steps of the last bit") +
           pair_arrow(right, fine_row + row_height / 2, right + 46, fine_row + row_height / 2) +
           pair_text(right + 52, fine_row + row_height / 2 + 5, "", "answer");
}

/// The record's window, which both evaluate over.
std::string window_of(const CoarseFineSettings& settings) {
    double middle = box_left + box_width / 2, row = problem_row + row_height / 2;
    return pair_box(row - 28, 56, "window", fmt::format("newest {} samples", settings.coarse.window.length)) +
           pair_arrow(middle, row - 28, middle, coarse_row + row_height / 2 + 30) +
           pair_arrow(middle, row + 28, middle, fine_row + row_height / 2 - 30);
}

} // namespace

std::string draw_pair(const CoarseFineSettings& settings, const std::vector<std::string>& fields) {
    Recoding fine = settings.coarse_reading;
    fine.bits = settings.fine_bits;
    std::string strings;
    double right = string_left;
    for (const PairField& field : pair_fields(settings, fields)) {
        strings += field.text();
        right = field.left + bit_width * static_cast<double>(field.bits);
    }
    double width = right + 170;
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n"
               "<style>{2}</style>{3}\n<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
               width, picture_height, pair_style, arrow_head) +
           pair_text(20, 30, "title", "A coarse and a fine genetic algorithm (Figure 6.6)") +
           search_box(coarse_row, "coarse", settings.coarse, settings.coarse_reading) +
           search_box(fine_row, "fine", settings.fine, fine) + window_of(settings) + strings + both_ways(right) +
           pair_text(right + 8, problem_row + row_height / 2 + 5, "",
                     fmt::format("{} bits of the problem", settings.coarse_reading.problem_length())) +
           "</svg>\n";
}

} // namespace placedpar
