#include "report/run_report.hpp"

#include "netlist/run_report.hpp"
#include "report/clocks.hpp"
#include "report/fault_report.hpp"
#include "report/field.hpp"
#include "report/search_report.hpp"
#include "text/counted.hpp"
#include "text/paint.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace placedpar {

namespace {

std::string print_value(const Measurement& m) {
    if (const auto* text = std::get_if<std::string>(&m.value))
        return *text;
    return fmt::format("{:.6g}", std::get<double>(m.value));
}

boost::json::value value_json(const Measurement& m) {
    return std::visit([](const auto& value) { return boost::json::value(value); }, m.value);
}

Table measurements_of(const std::vector<Measurement>& rows) {
    return table_of(rows, [](const Measurement& m) -> Row {
        return {Field::left(0, "process", m.process).as("process"), Field::left(0, "measured", m.name).as("name"),
                Field::right(16, "value", print_value(m)).as("value", value_json(m)),
                Field::left(0, "unit", m.unit).as("unit")};
    });
}

/// Lists at most the first eight of the nodes, wires or processes in which an option has set a value. Returns "" if the
/// option has set a constant (`val`) instead.
std::string print_reached(std::vector<std::string> elements) {
    constexpr std::size_t most = 8;
    if (elements.empty())
        return "";
    std::size_t more = elements.size() - std::min(elements.size(), most);
    elements.resize(elements.size() - more);
    return fmt::format(", for {}{}", fmt::join(elements, ", "), more == 0 ? "" : fmt::format(" and {} more", more));
}

std::string print_set(const Network& network) {
    std::string out;
    for (const SetByOption& each : network.set)
        out += fmt::format("set: {} = {}{}\n", each.name, each.value, print_reached(each.elements));
    return out;
}

/// Prints a time in the largest unit that is not longer than the time: "12.345 us".
std::string print_time(Time time) {
    constexpr std::pair<Time, const char*> units[] = {{std::chrono::seconds{1}, "s"},
                                                      {std::chrono::milliseconds{1}, "ms"},
                                                      {std::chrono::microseconds{1}, "us"},
                                                      {std::chrono::nanoseconds{1}, "ns"}};
    for (const auto& [unit, name] : units)
        if (time >= unit)
            return fmt::format("{:.3f} {}", static_cast<double>(time.count()) / static_cast<double>(unit.count()),
                               name);
    return to_string(time);
}

/// Prints a part of the run's time in percent, or as a time if the run ended in a deadlock.
std::string print_part(const RunReport& report, Time part) {
    auto share = report.share(part);
    return share ? fmt::format("{:.1f}%", 100 * *share) : print_time(part);
}

/// Returns a part of the run's time as a fraction. Returns null if the run ended in a deadlock.
boost::json::value part_json(const RunReport& report, Time part) {
    auto share = report.share(part);
    return share ? boost::json::value(*share) : boost::json::value();
}

Field part_of(const RunReport& report, std::size_t width, const std::string& name, Time part) {
    return Field::right(width, name, print_part(report, part)).as(name, part_json(report, part));
}

Table processors_of(const RunReport& report) {
    bool routes = std::ranges::any_of(report.processors, [](const ProcessorUse& p) { return p.packets_passed_on > 0; });
    return table_of(report.processors, [&](const ProcessorUse& p) -> Row {
        return {Field::left(0, "processor", p.name).as("name"),
                Field::left(6, "type", p.type).as("type"),
                part_of(report, 6, "busy", p.busy),
                Field::member_ps("busy", p.busy),
                Field::member_ps("memory_taken_by_links", p.memory_taken_by_links),
                Field::right(10, "passing on", print_part(report, p.passing_on)).shown_if(routes),
                Field::count(8, "packets", p.packets_passed_on)
                    .as("packets_passed_on", p.packets_passed_on)
                    .shown_if(routes),
                Field::member_ps("passing_on", p.passing_on)};
    });
}

Table programs_of(const RunReport& report) {
    return table_of(report.programs, [&](const ProgramUse& p) -> Row {
        return {Field::left(0, "booted", p.name).as("name"), Field::count(12, "instructions", p.instructions),
                Field::count(8, "requests", p.requests), Field::left(0, "its program", p.state).as("state")};
    });
}

/// Lists the processes that errors have stopped.
std::string print_stops(const std::vector<ProgramUse>& programs) {
    std::string out;
    for (const ProgramUse& program : programs) {
        for (const ProgramUse::Stop& stop : program.stops)
            out +=
                fmt::format("{} stopped at {}: {}, at {}\n", stop.process, stop.place, stop.error, to_string(stop.at));
        if (const std::uint64_t others = program.count_of_stops - program.stops.size(); others > 0)
            out += fmt::format("{}: errors also stopped {}\n", program.name, counted(others, "process", "processes"));
    }
    return out.empty() ? "" : "\n" + out;
}

boost::json::array stops_json(const std::vector<ProgramUse>& programs) {
    boost::json::array all;
    for (const ProgramUse& program : programs)
        for (const ProgramUse::Stop& stop : program.stops)
            all.push_back(boost::json::object{{"process", stop.process},
                                              {"program", stop.place},
                                              {"error", stop.error},
                                              {"time_ps", stop.at.count()}});
    return all;
}

/// Returns a table of these links. The columns are wide enough for all links of the report.
Table links_of(const RunReport& report, const std::vector<LinkUse>& links) {
    std::size_t width = 13;
    for (const LinkUse& each : report.links)
        width = std::max(width, each.from.size() + each.to.size() + 4);
    return table_of(links, [&, width](const LinkUse& l) -> Row {
        return {Field::left(width, "link", l.from + " -> " + l.to),
                Field::member("from", l.from),
                Field::member("to", l.to),
                Field::count(10, "bytes", l.bytes),
                part_of(report, 9, "occupied", l.occupied),
                Field::member_ps("occupied", l.occupied)};
    });
}

Table messages_of(const std::vector<MessagesBetween>& messages) {
    return table_of(messages, [](const MessagesBetween& m) -> Row {
        return {Field::left(0, "messages between", m.from + " -> " + m.to), Field::member("from", m.from),
                Field::member("to", m.to), Field::count(10, "messages", m.messages),
                Field::count(10, "bytes", m.bytes)};
    });
}

std::string print_links(const RunReport& report) {
    std::vector<LinkUse> used = report.links;
    std::erase_if(used, [](const LinkUse& link) { return link.bytes == 0; });
    return used.empty() ? "" : links_of(report, used).text("\n");
}

Table broadcasts_of(const std::vector<BroadcastUse>& rows) {
    return table_of(rows, [](const BroadcastUse& b) -> Row {
        return {Field::left(0, "broadcast", b.from).as("from"), Field::count(8, "adapters", b.adapters),
                Field::count(9, "messages", b.messages), Field::count(9, "bytes", b.bytes)};
    });
}

Table masters_of(const RunReport& report, const BusUse& bus) {
    return table_of(bus.masters, [&](const BusMasterUse& m) -> Row {
        return {
            Field::left(0, "master", m.name).as("name"),
            Field::count(5, "level", m.level),
            Field::count(9, "words", m.words),
            Field::count(9, "bytes", m.bytes),
            Field::count(9, "grants", m.grants),
            Field::member("bus_errors", m.bus_errors),
            Field::right(7, "waiting", print_part(report, m.waited)).as("waited_ps", m.waited.count()),
            Field::right(12, "longest wait", print_time(m.longest_wait)).as("longest_wait_ps", m.longest_wait.count()),
            Field::right(6, "errors", fmt::format("{}", m.bus_errors))};
    });
}

std::string print_buses(const RunReport& report) {
    std::string out;
    for (const BusUse& bus : report.buses)
        out += painted(Paint::heading, fmt::format("\nbus {}, busy {}\n", bus.name, print_part(report, bus.busy))) +
               masters_of(report, bus).text() + (bus.broadcasts.empty() ? "" : broadcasts_of(bus.broadcasts).text());
    return out;
}

Field figure_of(const RunReport& report, const std::string& name, const std::variant<std::uint64_t, Time>& figure) {
    if (const auto* time = std::get_if<Time>(&figure))
        return Field::right(9, name, print_part(report, *time)).as(name + "_ps", time->count());
    return Field::count(9, name, std::get<std::uint64_t>(figure));
}

Table rows_of(const RunReport& report, const DeviceUse& device) {
    const std::size_t figures = device.columns.size() - 1;
    return table_of(device.rows, [&](DeviceUse::Row each) {
        if (each.figures.empty()) // the row of headings
            each.figures.resize(figures);
        if (each.figures.size() != figures)
            throw UserError(
                fmt::format("{} reports {} figures of \"{}\", expected {}: one for each column but the first",
                            device.title, each.figures.size(), each.name, figures));
        Row row{Field::left(0, device.columns.front(), each.name).as(device.columns.front())};
        for (std::size_t i = 0; i < each.figures.size(); ++i)
            row.push_back(figure_of(report, device.columns[i + 1], each.figures[i]));
        return row;
    });
}

std::string print_devices(const RunReport& report) {
    std::string out;
    for (const DeviceUse& device : report.devices)
        out += painted(Paint::heading, fmt::format("\n{}, busy {}\n", device.title, print_part(report, device.busy))) +
               rows_of(report, device).text();
    return out;
}

/// Prints a process's waiting time, and the beginning of a wait that is still open. In a deadlock such a wait lasts for
/// ever.
std::string print_wait(const RunReport& report, const ProcessUse& process) {
    if (!process.waits_since)
        return print_part(report, process.waiting);
    std::string since = print_time(*process.waits_since);
    if (report.result.ending == Ending::stuck)
        return fmt::format("for ever, from {} on", since);
    return fmt::format("{:>7}, the last wait since {}", print_part(report, process.waiting), since);
}

Table processes_of(const RunReport& report) {
    return table_of(report.processes, [&](const ProcessUse& p) -> Row {
        return {Field::left(0, "process", p.name).as("name"), Field::left(0, "on", p.processor).as("on"),
                Field::right(7, "waiting", print_wait(report, p)).as("waiting", part_json(report, p.waiting)),
                Field::member_ps("waiting", p.waiting), Field::member_ps("waits_since", p.waits_since)};
    });
}

boost::json::array texts_of(const std::vector<std::string>& texts) {
    return boost::json::array(texts.begin(), texts.end());
}

boost::json::object json_of(const RunReport& report, const BusUse& b) {
    boost::json::object json{{"name", b.name},
                             {"busy", part_json(report, b.busy)},
                             {"busy_ps", b.busy.count()},
                             {"masters", json_of(masters_of(report, b).rows)}};
    if (!b.broadcasts.empty())
        json["broadcasts"] = json_of(broadcasts_of(b.broadcasts).rows);
    return json;
}

boost::json::object json_of(const RunReport& report, const DeviceUse& d) {
    return {{"title", d.title},
            {"busy", part_json(report, d.busy)},
            {"busy_ps", d.busy.count()},
            {"rows", json_of(rows_of(report, d).rows)}};
}

/// Returns an array with the JSON form of each row.
template <class Row, class Json>
boost::json::array array_of(const std::vector<Row>& rows, Json json_of_row) {
    boost::json::array array;
    for (const Row& row : rows)
        array.push_back(json_of_row(row));
    return array;
}

boost::json::object deadlock_json(const Deadlock& deadlock) {
    boost::json::array processes, channels;
    for (const auto& process : deadlock.processes)
        processes.push_back(boost::json::object{{"process", process.path},
                                                {"operation", name_of(process.activity)},
                                                {"channels", texts_of(process.channels)},
                                                {"program", process.where},
                                                {"netlist", process.netlist}});
    for (const auto& channel : deadlock.channels)
        channels.push_back(boost::json::object{{"channel", channel.name},
                                               {"outputter", channel.outputter},
                                               {"inputter", channel.inputter},
                                               {"waiting", channel.waiting},
                                               {"netlist", channel.netlist}});
    boost::json::object json{
        {"cycle", texts_of(deadlock.cycle)}, {"processes", std::move(processes)}, {"channels", std::move(channels)}};
    if (!deadlock.held_up.empty())
        json["held_up"] = texts_of(deadlock.held_up);
    return json;
}

boost::json::value fingerprint_json(const RunReport& report) {
    if (report.is_native)
        return nullptr;
    return boost::json::value(hex(report.result.fingerprint));
}

std::string print_outcome(const RunReport& report) {
    const RunOutcome outcome = report.outcome();
    const bool well = outcome == RunOutcome::completed || outcome == RunOutcome::time_limit;
    return painted(well ? Paint::success : Paint::failure, name_of(outcome));
}

/// Prints the errors that have halted processors of a network. These errors stand before the list of processes that
/// wait for ever as a result.
std::string print_halts(const RunReport& report) {
    std::string out;
    if (report.programs.size() > 1)
        for (const ProgramUse& each : report.programs)
            if (each.halted)
                out += fmt::format("\n{} {}\n", each.name, each.state);
    return out;
}

/// Lists the first processes that never ran; the JSON document lists all of them.
std::string print_never_ran(const std::vector<std::string>& names) {
    constexpr std::size_t most = 12;
    std::size_t shown = std::min(names.size(), most), left_out = names.size() - shown;
    return fmt::format("\nnever ran: {}{}\n",
                       fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(shown), ", "),
                       left_out > 0 ? " and " + counted(left_out, "other") : "");
}

} // namespace

std::string print_report(const RunReport& report, const Network& network, const GenerationLog& searches) {
    bool stopped = report.result.ending == Ending::time_limit;
    std::string out = fmt::format("{}: {} {} {}{}\n", network.source_path, print_outcome(report),
                                  report.is_native ? "natively, after" : "at", to_string(report.result.time),
                                  stopped ? "; the figures below cover the time until then" : "") +
                      (report.is_native ? "" : fmt::format("fingerprint: {:016x}\n", report.result.fingerprint)) +
                      print_set(network) + print_faults(report.faults) + print_switches(report.switches) +
                      print_halts(report);
    if (report.result.deadlock)
        out +=
            (report.result.ending == Ending::stuck ? "\n" : "\nin a deadlock while other processes could continue:\n") +
            report.result.deadlock->text();
    if (!report.result.never_ran.empty())
        out += print_never_ran(report.result.never_ran);
    if (!report.measurements.empty())
        out += measurements_of(report.measurements).text("\n");
    out += print_searches(searches);
    if (!report.programs.empty())
        out += print_stops(report.programs) + programs_of(report).text("\n");
    if (!report.processors.empty())
        out += processors_of(report).text("\n");
    if (!report.messages.empty())
        out += messages_of(report.messages).text("\n");
    out += print_links(report) + print_buses(report) + print_devices(report);
    if (!report.clocks.empty())
        out += clocks_of(report.clocks).text("\n");
    return report.processes.empty() ? out : out + processes_of(report).text("\n");
}

boost::json::object report_json(const RunReport& report, const Network& network, const Manifest& manifest,
                                const GenerationLog& searches) {
    boost::json::object json{{"manifest", manifest_json(manifest, network)},
                             {"outcome", name_of(report.outcome())},
                             {"time_ps", report.result.time.count()},
                             {"fingerprint", fingerprint_json(report)},
                             {"measurements", json_of(measurements_of(report.measurements).rows)},
                             {"processors", json_of(processors_of(report).rows)},
                             {"links", json_of(links_of(report, report.links).rows)},
                             {"processes", json_of(processes_of(report).rows)}};
    if (!report.buses.empty())
        json["buses"] = array_of(report.buses, [&](const BusUse& bus) { return json_of(report, bus); });
    if (!report.devices.empty())
        json["devices"] = array_of(report.devices, [&](const DeviceUse& device) { return json_of(report, device); });
    if (!searches.searches().empty())
        json["searches"] = searches_json(searches);
    if (!report.faults.empty())
        json["faults"] = array_of(report.faults, json_of_fault);
    if (!report.programs.empty())
        json["programs"] = json_of(programs_of(report).rows);
    if (boost::json::array stops = stops_json(report.programs); !stops.empty())
        json["stops"] = std::move(stops);
    if (!report.messages.empty())
        json["messages"] = json_of(messages_of(report.messages).rows);
    if (!report.clocks.empty())
        json["clocks"] = json_of(clocks_of(report.clocks).rows);
    if (!report.switches.empty())
        json["switches"] = array_of(report.switches, json_of_switch);
    if (report.result.deadlock)
        json["deadlock"] = deadlock_json(*report.result.deadlock);
    if (!report.result.never_ran.empty())
        json["never_ran"] = texts_of(report.result.never_ran);
    return json;
}

} // namespace placedpar
