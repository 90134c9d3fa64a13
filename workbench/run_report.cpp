#include "workbench/run_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace placedpar {

namespace {

const char* describe(Ending ending) {
    switch (ending) {
    case Ending::completed: return "completed";
    case Ending::stuck: return "deadlock";
    case Ending::time_limit: return "stopped at the time limit";
    case Ending::interrupted: return "interrupted";
    }
    return "";
}

std::string print_value(const Measurement& m) {
    if (const auto* text = std::get_if<std::string>(&m.value))
        return *text;
    return fmt::format("{:.6g}", std::get<double>(m.value));
}

/// Of a column that holds these texts of the rows.
template <class Rows, class Text>
std::size_t width_of(const Rows& rows, Text text, std::size_t least) {
    std::size_t width = least;
    for (const auto& row : rows)
        width = std::max(width, std::invoke(text, row).size());
    return width;
}

std::string print_measurements(const std::vector<Measurement>& rows) {
    std::size_t process = width_of(rows, &Measurement::process, 7), name = width_of(rows, &Measurement::name, 8);
    std::string out =
        fmt::format("\n{:<{}}  {:<{}}  {:>16}  {}\n", "process", process, "measured", name, "value", "unit");
    for (const Measurement& m : rows)
        out += fmt::format("{:<{}}  {:<{}}  {:>16}{}{}\n", m.process, process, m.name, name, print_value(m),
                           m.unit.empty() ? "" : "  ", m.unit);
    return out;
}

std::string print_processors(const std::vector<ProcessorUse>& rows) {
    std::size_t name = width_of(rows, &ProcessorUse::name, 9);
    std::string out = fmt::format("\n{:<{}}  {:<6}  {:>6}\n", "processor", name, "type", "busy");
    for (const ProcessorUse& p : rows)
        out += fmt::format("{:<{}}  {:<6}  {:>5.1f}%\n", p.name, name, p.type, 100 * p.busy);
    return out;
}

std::string ends_of(const LinkUse& link) { return link.from + " -> " + link.to; }

std::string print_links(const std::vector<LinkUse>& rows) {
    std::size_t width = width_of(rows, ends_of, 13);
    std::string out = fmt::format("\n{:<{}}  {:>10}  {:>9}\n", "link", width, "bytes", "occupied");
    for (const LinkUse& l : rows)
        if (l.bytes > 0)
            out += fmt::format("{:<{}}  {:>10}  {:>8.1f}%\n", ends_of(l), width, l.bytes, 100 * l.occupied);
    return out;
}

std::string print_processes(const std::vector<ProcessUse>& rows) {
    std::size_t name = width_of(rows, &ProcessUse::name, 7), node = width_of(rows, &ProcessUse::processor, 2);
    std::string out = fmt::format("\n{:<{}}  {:<{}}  {:>7}\n", "process", name, "on", node, "waiting");
    for (const ProcessUse& p : rows)
        out += fmt::format("{:<{}}  {:<{}}  {:>6.1f}%\n", p.name, name, p.processor, node, 100 * p.waiting);
    return out;
}

boost::json::value value_json(const Measurement& m) {
    if (const auto* text = std::get_if<std::string>(&m.value))
        return boost::json::string(*text);
    return std::get<double>(m.value);
}

boost::json::object json_of(const Measurement& m) {
    return {{"process", m.process}, {"name", m.name}, {"value", value_json(m)}, {"unit", m.unit}};
}

boost::json::object json_of(const ProcessorUse& p) { return {{"name", p.name}, {"type", p.type}, {"busy", p.busy}}; }

boost::json::object json_of(const LinkUse& l) {
    return {{"from", l.from}, {"to", l.to}, {"bytes", l.bytes}, {"occupied", l.occupied}};
}

boost::json::object json_of(const ProcessUse& p) {
    return {{"name", p.name}, {"on", p.processor}, {"waiting", p.waiting}};
}

template <class Rows>
boost::json::array array_of(const Rows& rows) {
    boost::json::array array;
    for (const auto& row : rows)
        array.push_back(json_of(row));
    return array;
}

boost::json::array texts_of(const std::vector<std::string>& texts) {
    return boost::json::array(texts.begin(), texts.end());
}

boost::json::object deadlock_json(const Deadlock& deadlock) {
    boost::json::array processes;
    for (const auto& process : deadlock.processes)
        processes.push_back(boost::json::object{{"process", process.path},
                                                {"operation", name_of(process.activity)},
                                                {"channels", texts_of(process.channels)},
                                                {"program", process.where}});
    return {{"cycle", texts_of(deadlock.cycle)}, {"processes", std::move(processes)}};
}

} // namespace

std::string print_report(const RunReport& report, const Network& network) {
    std::string out =
        fmt::format("{}: {} at {}\nfingerprint: {:016x}\n", network.source_path, describe(report.result.ending),
                    to_string(report.result.time), report.result.fingerprint);
    if (report.result.deadlock)
        out += "\n" + report.result.deadlock->text();
    if (!report.measurements.empty())
        out += print_measurements(report.measurements);
    if (!report.processors.empty())
        out += print_processors(report.processors);
    if (!report.links.empty())
        out += print_links(report.links);
    return out + print_processes(report.processes);
}

boost::json::object report_json(const RunReport& report, const Network& network, const Manifest& manifest) {
    boost::json::object json{{"manifest", manifest_json(manifest, network)},
                             {"outcome", describe(report.result.ending)},
                             {"time_ps", report.result.time.count()},
                             {"fingerprint", hex(report.result.fingerprint)},
                             {"measurements", array_of(report.measurements)},
                             {"processors", array_of(report.processors)},
                             {"links", array_of(report.links)},
                             {"processes", array_of(report.processes)}};
    if (report.result.deadlock)
        json["deadlock"] = deadlock_json(*report.result.deadlock);
    return json;
}

} // namespace placedpar
