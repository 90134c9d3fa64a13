#include "experiments/kit/replay_report.hpp"

#include "report/manifest.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <string_view>

namespace placedpar {

namespace {

boost::json::value or_null(std::optional<double> number) {
    return number ? boost::json::value(*number) : boost::json::value(nullptr);
}

/// Adds a figure that only some cells have.
void add_if(boost::json::object& json, std::string_view key, std::optional<double> figure) {
    if (figure)
        json[key] = *figure;
}

boost::json::object cell_json(const Cell& cell, const Comparison& comparison) {
    const std::string& against = comparison.against;
    boost::json::object json{{"row", cell.row},
                             {"column", cell.column},
                             {"unit", cell.unit},
                             {"thesis", against == "thesis" ? or_null(cell.reference) : nullptr},
                             {"simulated", cell.simulated},
                             {"error_percent", or_null(cell.error_percent())},
                             {"tolerance_percent", or_null(cell.tolerance_in_percent())},
                             {"origin", name_of(cell.origin)}};
    if (against != "thesis")
        json[against] = or_null(cell.reference);
    add_if(json, against + "_to", cell.reference_to);
    add_if(json, "tolerance", cell.tolerance); // in the cell's unit
    add_if(json, "at_least", cell.at_least);
    add_if(json, "at_most", cell.at_most);
    if (cell.interval)
        json["interval"] = {cell.interval->low, cell.interval->high};
    if (cell.is_judged())
        json["judged_by"] = name_of(comparison.judge_of(cell));
    if (!cell.source.empty())
        json["source"] = cell.source;
    return json;
}

boost::json::object constant_json(const hardware::Constant& constant) {
    return {{"group", constant.group}, {"name", constant.name},          {"value", constant.value},
            {"unit", constant.unit},   {"mark", name_of(constant.mark)}, {"source", constant.source}};
}

boost::json::array constants_json(const std::vector<hardware::Constant>& constants) {
    boost::json::array all;
    for (const hardware::Constant& each : constants)
        all.push_back(constant_json(each));
    return all;
}

boost::json::array cells_json(const Comparison& comparison) {
    boost::json::array cells;
    for (const Cell& cell : comparison.cells)
        cells.push_back(cell_json(cell, comparison));
    return cells;
}

boost::json::object other_json(const Comparison& other) {
    return {{"reading", other.name},
            {"cells", cells_json(other)},
            {"judged", other.judged},
            {"within_tolerance", other.within_tolerance()}};
}

boost::json::object judged_json(const JudgedCells& cells) {
    return {{"thesis", cells.thesis},
            {"set_from_thesis", cells.set_from_thesis},
            {"published", cells.published},
            {"own", cells.own},
            {"not_judged", cells.not_judged}};
}

boost::json::array others_json(const Replay& replay) {
    boost::json::array others;
    for (std::size_t i = 1; i < replay.comparisons.size(); ++i)
        others.push_back(other_json(replay.comparisons[i]));
    return others;
}

std::string constant_row(std::string_view name, std::string_view value, std::string_view unit, std::string_view mark,
                         std::string_view source) {
    return fmt::format("{:<46}  {:>6} {:<7}  {:<10}  {}\n", name, value, unit, mark, source);
}

/// Prints the name of each group, and below it the constants of the group.
std::string print_constants(const std::vector<hardware::Constant>& constants) {
    if (constants.empty())
        return "";
    std::string out = constant_row("constants", "value", "", "mark", "source");
    std::string_view group;
    for (const hardware::Constant& each : constants) {
        if (each.group != group)
            out += fmt::format("{}\n", group = each.group);
        out += constant_row(fmt::format("  {}", each.name), fmt::format("{:.6g}", each.value), each.unit,
                            name_of(each.mark), each.source);
    }
    return out;
}

} // namespace

std::string print_replay(const Replay& replay) {
    std::string out;
    for (const Comparison& comparison : replay.comparisons)
        out += print_comparison(comparison) + "\n";
    out += print_judged(count_judged(replay.comparisons)) + "\n";
    return out + print_constants(replay.constant_table) + replay.constants +
           fmt::format("fingerprint: {:016x}\n{}", replay.fingerprint, print_verdict(replay.comparisons));
}

boost::json::object replay_json(const Replay& replay, std::string_view experiment, std::uint64_t seed,
                                const std::string& command) {
    boost::json::object json{{"experiment", experiment},
                             {"version", version},
                             {"commit", commit},
                             {"seed", seed},
                             {"fingerprint", hex(replay.fingerprint)},
                             {"command", command},
                             {"reading", replay.comparisons.front().name},
                             {"cells", cells_json(replay.comparisons.front())},
                             {"within_tolerance", replay.within_tolerance()},
                             {"judged", judged_json(count_judged(replay.comparisons))},
                             {"other_readings", others_json(replay)}};
    if (!replay.constant_table.empty())
        json["constants"] = constants_json(replay.constant_table);
    return json;
}

} // namespace placedpar
