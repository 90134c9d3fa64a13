#include "app/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace placedpar {

namespace {

std::vector<std::string> in_order_of_appearance(const std::vector<Cell>& cells, std::string Cell::*name) {
    std::vector<std::string> names;
    for (const Cell& cell : cells)
        if (std::ranges::find(names, cell.*name) == names.end())
            names.push_back(cell.*name);
    return names;
}

std::string mark(const Cell& cell) {
    switch (cell.origin) {
    case Origin::outcome: return cell.within_tolerance() ? " " : "!";
    case Origin::calibrated: return "c";
    case Origin::workload: return "w";
    }
    return "";
}

std::string print_cell(const Cell& cell) {
    std::string thesis = cell.thesis ? fmt::format("{:7.5g}", *cell.thesis) : std::string(7, ' ');
    auto error = cell.error_percent();
    return fmt::format("{:7.2f} {} {:>7}{}", cell.simulated, thesis, error ? fmt::format("{:+.1f}%", *error) : "",
                       mark(cell));
}

} // namespace

std::optional<double> Cell::error_percent() const {
    if (!thesis)
        return std::nullopt;
    if (*thesis == 0)
        return simulated == 0 ? std::optional(0.0) : std::nullopt;
    return 100 * (simulated - *thesis) / *thesis;
}

bool Cell::within_tolerance() const {
    if (!tolerance_percent)
        return true;
    auto error = error_percent();
    return error && std::abs(*error) <= *tolerance_percent;
}

const std::vector<Experiment>& experiments() {
    static const std::vector<Experiment> all{
        {"table-e1", "what a generation costs on one cluster with 0 to 3 slaves", replay_table_e1},
        {"table-e2", "the speedup of algorithms B, A, and A + B on the machine of Figure E.2", replay_table_e2},
    };
    return all;
}

const char* name_of(Origin origin) {
    switch (origin) {
    case Origin::outcome: return "outcome";
    case Origin::calibrated: return "calibrated";
    case Origin::workload: return "workload";
    }
    return "";
}

std::string print_reading(const Reading& reading) {
    auto rows = in_order_of_appearance(reading.cells, &Cell::row);
    auto columns = in_order_of_appearance(reading.cells, &Cell::column);
    std::size_t width = 0;
    for (const Cell& cell : reading.cells)
        width = std::max(width, fmt::format("{} [{}]", cell.row, cell.unit).size());
    std::string out = fmt::format("{}\n{:<{}}", reading.name, "", width);
    for (const auto& column : columns)
        out += fmt::format("  {:>24}", column);
    out += fmt::format("\n{:<{}}", "", width);
    for (std::size_t i = 0; i < columns.size(); ++i)
        out += "  simulat.  thesis   error ";
    out.pop_back();
    for (const auto& row : rows) {
        bool first = true;
        for (const Cell& cell : reading.cells)
            if (cell.row == row) {
                if (first)
                    out += fmt::format("\n{:<{}}", cell.unit.empty() ? row : fmt::format("{} [{}]", row, cell.unit),
                                       width);
                first = false;
                out += "  " + print_cell(cell);
            }
        if (out.back() == ' ')
            out.pop_back();
    }
    return out + "\n" + reading.notes;
}

} // namespace placedpar
