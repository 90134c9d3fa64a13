#include "workbench/run_report.hpp"

#include <fmt/format.h>

#include <algorithm>

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

/// Widths of columns follow the longest entry.
template <class Rows, class Name>
std::size_t width_of(const Rows& rows, Name name, std::size_t least) {
    std::size_t width = least;
    for (const auto& row : rows)
        width = std::max(width, std::string(name(row)).size());
    return width;
}

std::string print_measurements(const std::vector<Measurement>& rows) {
    std::size_t process = width_of(
        rows, [](auto& m) { return m.process; }, 7);
    std::size_t name = width_of(
        rows, [](auto& m) { return m.name; }, 8);
    std::string out =
        fmt::format("\n{:<{}}  {:<{}}  {:>16}  {}\n", "process", process, "measured", name, "value", "unit");
    for (const Measurement& m : rows)
        out += fmt::format("{:<{}}  {:<{}}  {:>16}{}{}\n", m.process, process, m.name, name, print_value(m),
                           m.unit.empty() ? "" : "  ", m.unit);
    return out;
}

std::string print_processors(const std::vector<ProcessorUse>& rows) {
    std::size_t name = width_of(
        rows, [](auto& p) { return p.name; }, 9);
    std::string out = fmt::format("\n{:<{}}  {:<6}  {:>6}\n", "processor", name, "type", "busy");
    for (const ProcessorUse& p : rows)
        out += fmt::format("{:<{}}  {:<6}  {:>5.1f}%\n", p.name, name, p.type, 100 * p.busy);
    return out;
}

std::string print_links(const std::vector<LinkUse>& rows) {
    std::size_t width = width_of(
                            rows, [](auto& l) { return l.from + l.to; }, 9) +
                        4;
    std::string out = fmt::format("\n{:<{}}  {:>10}  {:>9}\n", "link", width, "bytes", "occupied");
    for (const LinkUse& l : rows)
        if (l.bytes > 0)
            out += fmt::format("{:<{}}  {:>10}  {:>8.1f}%\n", l.from + " -> " + l.to, width, l.bytes, 100 * l.occupied);
    return out;
}

std::string print_processes(const std::vector<ProcessUse>& rows) {
    std::size_t name = width_of(
        rows, [](auto& p) { return p.name; }, 7);
    std::size_t node = width_of(
        rows, [](auto& p) { return p.processor; }, 2);
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

boost::json::object deadlock_json(const Deadlock& deadlock) {
    boost::json::array cycle, processes;
    for (const auto& path : deadlock.cycle)
        cycle.emplace_back(path);
    for (const auto& process : deadlock.processes) {
        boost::json::array channels;
        for (const auto& channel : process.channels)
            channels.emplace_back(channel);
        processes.push_back(boost::json::object{{"process", process.path},
                                                {"operation", name_of(process.activity)},
                                                {"channels", std::move(channels)},
                                                {"program", process.where}});
    }
    return {{"cycle", std::move(cycle)}, {"processes", std::move(processes)}};
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
    boost::json::array measurements, processors, links, processes;
    for (const Measurement& m : report.measurements)
        measurements.push_back(
            boost::json::object{{"process", m.process}, {"name", m.name}, {"value", value_json(m)}, {"unit", m.unit}});
    for (const ProcessorUse& p : report.processors)
        processors.push_back(boost::json::object{{"name", p.name}, {"type", p.type}, {"busy", p.busy}});
    for (const LinkUse& l : report.links)
        links.push_back(
            boost::json::object{{"from", l.from}, {"to", l.to}, {"bytes", l.bytes}, {"occupied", l.occupied}});
    for (const ProcessUse& p : report.processes)
        processes.push_back(boost::json::object{{"name", p.name}, {"on", p.processor}, {"waiting", p.waiting}});
    boost::json::object json{{"manifest", manifest_json(manifest, network)},
                             {"outcome", describe(report.result.ending)},
                             {"time_ps", report.result.time.count()},
                             {"fingerprint", hex(report.result.fingerprint)},
                             {"measurements", std::move(measurements)},
                             {"processors", std::move(processors)},
                             {"links", std::move(links)},
                             {"processes", std::move(processes)}};
    if (report.result.deadlock)
        json["deadlock"] = deadlock_json(*report.result.deadlock);
    return json;
}

} // namespace placedpar
