#include "report/run_report.hpp"

#include "report/search_report.hpp"
#include "text/counted.hpp"
#include "text/paint.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

namespace placedpar {

namespace {

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
    std::string out = painted(Paint::heading, fmt::format("\n{:<{}}  {:<{}}  {:>16}  {}\n", "process", process,
                                                          "measured", name, "value", "unit"));
    for (const Measurement& m : rows)
        out += fmt::format("{:<{}}  {:<{}}  {:>16}{}{}\n", m.process, process, m.name, name, print_value(m),
                           m.unit.empty() ? "" : "  ", m.unit);
    return out;
}

/// Of a name for many elements, those that it reached; the first of them where they are very many.
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

/// In the largest unit of which there is one: "12.345 us".
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

/// A part of the run's time: in percent, or where there is no whole, as in a deadlock, as it is.
std::string print_part(const RunReport& report, Time part) {
    auto share = report.share(part);
    return share ? fmt::format("{:.1f}%", 100 * *share) : print_time(part);
}

std::string print_passing_on(const RunReport& report, const ProcessorUse& p) {
    return fmt::format("  {:>10}  {:>8}", print_part(report, p.passing_on), p.packets_passed_on);
}

std::string print_processors(const RunReport& report) {
    const auto& rows = report.processors;
    std::size_t name = width_of(rows, &ProcessorUse::name, 9);
    bool routes = std::ranges::any_of(rows, [](const ProcessorUse& p) { return p.packets_passed_on > 0; });
    std::string out = painted(Paint::heading, fmt::format("\n{:<{}}  {:<6}  {:>6}{}\n", "processor", name, "type",
                                                          "busy", routes ? "  passing on   packets" : ""));
    for (const ProcessorUse& p : rows)
        out += fmt::format("{:<{}}  {:<6}  {:>6}{}\n", p.name, name, p.type, print_part(report, p.busy),
                           routes ? print_passing_on(report, p) : "");
    return out;
}

std::string ends_of(const LinkUse& link) { return link.from + " -> " + link.to; }

std::string print_links(const RunReport& report) {
    const auto& rows = report.links;
    if (std::ranges::none_of(rows, [](const LinkUse& link) { return link.bytes > 0; }))
        return "";
    std::size_t width = width_of(rows, ends_of, 13);
    std::string out =
        painted(Paint::heading, fmt::format("\n{:<{}}  {:>10}  {:>9}\n", "link", width, "bytes", "occupied"));
    for (const LinkUse& l : rows)
        if (l.bytes > 0)
            out += fmt::format("{:<{}}  {:>10}  {:>9}\n", ends_of(l), width, l.bytes, print_part(report, l.occupied));
    return out;
}

std::string print_broadcasts(const std::vector<BroadcastUse>& rows) {
    if (rows.empty())
        return "";
    std::size_t from = width_of(rows, &BroadcastUse::from, 9);
    std::string out = painted(Paint::heading, fmt::format("{:<{}}  {:>8}  {:>9}  {:>9}\n", "broadcast", from,
                                                          "adapters", "messages", "bytes"));
    for (const BroadcastUse& b : rows)
        out += fmt::format("{:<{}}  {:>8}  {:>9}  {:>9}\n", b.from, from, b.adapters, b.messages, b.bytes);
    return out;
}

std::string print_buses(const RunReport& report) {
    std::string out;
    for (const BusUse& bus : report.buses) {
        std::size_t name = width_of(bus.masters, &BusMasterUse::name, 6);
        out += painted(Paint::heading, fmt::format("\nbus {}, busy {}\n", bus.name, print_part(report, bus.busy)));
        out += painted(Paint::heading,
                       fmt::format("{:<{}}  {:>5}  {:>9}  {:>9}  {:>9}  {:>7}  {:>12}  {:>6}\n", "master", name,
                                   "level", "words", "bytes", "grants", "waiting", "longest wait", "errors"));
        for (const BusMasterUse& m : bus.masters)
            out += fmt::format("{:<{}}  {:>5}  {:>9}  {:>9}  {:>9}  {:>7}  {:>12}  {:>6}\n", m.name, name, m.level,
                               m.words, m.bytes, m.grants, print_part(report, m.waited), print_time(m.longest_wait),
                               m.bus_errors);
        out += print_broadcasts(bus.broadcasts);
    }
    return out;
}

std::string print_figure(const RunReport& report, const std::variant<std::uint64_t, Time>& figure) {
    const auto* time = std::get_if<Time>(&figure);
    return time ? print_part(report, *time) : fmt::format("{}", std::get<std::uint64_t>(figure));
}

std::string print_devices(const RunReport& report) {
    std::string out;
    for (const DeviceUse& device : report.devices) {
        std::size_t name = width_of(device.rows, &DeviceUse::Row::name, device.columns.front().size());
        out += painted(Paint::heading, fmt::format("\n{}, busy {}\n", device.title, print_part(report, device.busy)));
        std::string heading = fmt::format("{:<{}}", device.columns.front(), name);
        for (std::size_t i = 1; i < device.columns.size(); ++i)
            heading += fmt::format("  {:>9}", device.columns[i]);
        out += painted(Paint::heading, heading + "\n");
        for (const DeviceUse::Row& row : device.rows) {
            out += fmt::format("{:<{}}", row.name, name);
            for (const auto& figure : row.figures)
                out += fmt::format("  {:>9}", print_figure(report, figure));
            out += "\n";
        }
    }
    return out;
}

/// In a deadlock a process that waits does so for ever; where a run was stopped, it waited when it was.
std::string print_wait(const RunReport& report, const ProcessUse& process) {
    if (!process.waits_since)
        return fmt::format("{:>7}", print_part(report, process.waiting));
    std::string since = print_time(*process.waits_since);
    if (report.result.ending == Ending::stuck)
        return fmt::format("for ever, from {} on", since);
    return fmt::format("{:>7}, the last wait since {}", print_part(report, process.waiting), since);
}

std::string print_processes(const RunReport& report) {
    const auto& rows = report.processes;
    std::size_t name = width_of(rows, &ProcessUse::name, 7), node = width_of(rows, &ProcessUse::processor, 2);
    std::string out =
        painted(Paint::heading, fmt::format("\n{:<{}}  {:<{}}  {:>7}\n", "process", name, "on", node, "waiting"));
    for (const ProcessUse& p : rows)
        out += fmt::format("{:<{}}  {:<{}}  {}\n", p.name, name, p.processor, node, print_wait(report, p));
    return out;
}

using MessageStruck = hardware::FaultEffect::Hit::Message;

const char* what_was_struck(MessageStruck message) {
    switch (message) {
    case MessageStruck::whole: return "a message on";
    case MessageStruck::packet: return "a packet of";
    case MessageStruck::acknowledging_packet: return "a packet that acknowledges one of";
    }
    return "";
}

std::string print_hit(const FaultUse::Hit& hit) {
    return fmt::format("at {}: {}byte {} of {} channel {}", to_string(hit.at),
                       hit.acknowledge ? "the acknowledge of " : "", hit.byte, what_was_struck(hit.message),
                       hit.channel);
}

/// What of it was lost; the last loss is the one that nobody has recovered from, if there is such a one.
std::string print_effect(const FaultUse& fault) {
    std::vector<std::string> said;
    if (fault.last)
        said.push_back(fmt::format("lost {} and {}", counted(fault.bytes_lost, "byte"),
                                   counted(fault.acknowledges_lost, "acknowledge")));
    if (!fault.stopped.empty())
        said.push_back(fmt::format("stopped {}", fmt::join(fault.stopped, ", ")));
    if (!fault.stopped_channels.empty())
        said.push_back(fmt::format("stopped the {} {}", fault.stopped_channels.size() > 1 ? "channels" : "channel",
                                   fmt::join(fault.stopped_channels, ", ")));
    if (fault.bus_errors > 0)
        said.push_back(counted(fault.bus_errors, "bus error"));
    if (fault.held_since)
        said.push_back(fmt::format("had the bus from {} on", to_string(*fault.held_since)));
    std::string out = said.empty() ? fault.had_effect() ? "slowed messages down" : "had no effect"
                                   : fmt::format("{}", fmt::join(said, "; "));
    if (fault.first)
        out += fmt::format("\n    first {}", print_hit(*fault.first));
    if (fault.last && fault.first && fault.last->at != fault.first->at)
        out += fmt::format("\n    last {}", print_hit(*fault.last));
    return out;
}

std::string print_faults(const std::vector<FaultUse>& faults) {
    std::string out = faults.empty() ? "" : painted(Paint::heading, "\nfaults\n");
    for (const FaultUse& fault : faults)
        out += fmt::format("  {}: {}\n", fault.fault, print_effect(fault));
    return out;
}

std::string print_loss(const SwitchUse::Loss& loss, const std::string& name) {
    return fmt::format("  {} -> {}: lost {} and {}\n    first {}\n    output {} of {} {}\n", loss.from, loss.to,
                       counted(loss.bytes, "byte"), counted(loss.acknowledges, "acknowledge"), print_hit(loss.first),
                       loss.output, name, loss.state);
}

std::string print_switches(const std::vector<SwitchUse>& switches) {
    std::string out;
    for (const SwitchUse& each : switches) {
        out +=
            painted(Paint::heading, fmt::format("\nswitch {}", each.name)) +
            fmt::format(": {}, {} made\n", counted(each.commands, "command"), counted(each.connections, "connection"));
        for (const SwitchUse::Loss& loss : each.losses)
            out += print_loss(loss, each.name);
    }
    return out;
}

boost::json::array texts_of(const std::vector<std::string>& texts) {
    return boost::json::array(texts.begin(), texts.end());
}

boost::json::value value_json(const Measurement& m) {
    if (const auto* text = std::get_if<std::string>(&m.value))
        return boost::json::string(*text);
    return std::get<double>(m.value);
}

boost::json::object json_of(const RunReport&, const Measurement& m) {
    return {{"process", m.process}, {"name", m.name}, {"value", value_json(m)}, {"unit", m.unit}};
}

/// A fraction of the run; null where there is no whole.
boost::json::value part_json(const RunReport& report, Time part) {
    auto share = report.share(part);
    return share ? boost::json::value(*share) : boost::json::value();
}

boost::json::object json_of(const RunReport& report, const ProcessorUse& p) {
    return {{"name", p.name},
            {"type", p.type},
            {"busy", part_json(report, p.busy)},
            {"busy_ps", p.busy.count()},
            {"memory_taken_by_links_ps", p.memory_taken_by_links.count()},
            {"packets_passed_on", p.packets_passed_on},
            {"passing_on_ps", p.passing_on.count()}};
}

boost::json::object json_of(const RunReport& report, const LinkUse& l) {
    return {{"from", l.from},
            {"to", l.to},
            {"bytes", l.bytes},
            {"occupied", part_json(report, l.occupied)},
            {"occupied_ps", l.occupied.count()}};
}

boost::json::object json_of(const RunReport&, const BusMasterUse& m) {
    return {{"name", m.name},
            {"level", m.level},
            {"words", m.words},
            {"bytes", m.bytes},
            {"grants", m.grants},
            {"bus_errors", m.bus_errors},
            {"waited_ps", m.waited.count()},
            {"longest_wait_ps", m.longest_wait.count()}};
}

template <class Rows>
boost::json::array array_of(const RunReport& report, const Rows& rows);

boost::json::object json_of(const RunReport&, const BroadcastUse& b) {
    return {{"from", b.from}, {"adapters", b.adapters}, {"messages", b.messages}, {"bytes", b.bytes}};
}

boost::json::object json_of(const RunReport& report, const BusUse& b) {
    boost::json::object json{{"name", b.name},
                             {"busy", part_json(report, b.busy)},
                             {"busy_ps", b.busy.count()},
                             {"masters", array_of(report, b.masters)}};
    if (!b.broadcasts.empty())
        json["broadcasts"] = array_of(report, b.broadcasts);
    return json;
}

boost::json::object json_of(const RunReport& report, const DeviceUse& d) {
    boost::json::array rows;
    for (const DeviceUse::Row& row : d.rows) {
        boost::json::object json{{d.columns.front(), row.name}};
        for (std::size_t i = 0; i < row.figures.size(); ++i)
            if (const auto* time = std::get_if<Time>(&row.figures[i]))
                json[d.columns[i + 1] + "_ps"] = time->count();
            else
                json[d.columns[i + 1]] = std::get<std::uint64_t>(row.figures[i]);
        rows.push_back(std::move(json));
    }
    return {{"title", d.title},
            {"busy", part_json(report, d.busy)},
            {"busy_ps", d.busy.count()},
            {"rows", std::move(rows)}};
}

boost::json::object json_of(const RunReport& report, const ProcessUse& p) {
    boost::json::object json{{"name", p.name},
                             {"on", p.processor},
                             {"waiting", part_json(report, p.waiting)},
                             {"waiting_ps", p.waiting.count()}};
    if (p.waits_since)
        json["waits_since_ps"] = p.waits_since->count();
    return json;
}

const char* what_was_struck_json(MessageStruck message) {
    switch (message) {
    case MessageStruck::whole: return "message";
    case MessageStruck::packet: return "packet";
    case MessageStruck::acknowledging_packet: return "acknowledging_packet";
    }
    return "";
}

boost::json::value hit_json(const std::optional<FaultUse::Hit>& hit) {
    if (!hit)
        return nullptr;
    return {{"time_ps", hit->at.count()},
            {"channel", hit->channel},
            {"what", hit->acknowledge ? "acknowledge" : "byte"},
            {"byte", hit->byte},
            {"of", what_was_struck_json(hit->message)}};
}

boost::json::object json_of(const RunReport&, const FaultUse& fault) {
    return {{"fault", fault.fault},
            {"had_effect", fault.had_effect()},
            {"bytes_lost", fault.bytes_lost},
            {"acknowledges_lost", fault.acknowledges_lost},
            {"first", hit_json(fault.first)},
            {"last_lost", hit_json(fault.last)},
            {"stopped", texts_of(fault.stopped)},
            {"stopped_channels", texts_of(fault.stopped_channels)},
            {"bus_errors", fault.bus_errors},
            {"held_since_ps", fault.held_since ? boost::json::value(fault.held_since->count()) : nullptr}};
}

boost::json::object json_of(const RunReport&, const SwitchUse::Loss& loss) {
    return {{"from", loss.from},
            {"to", loss.to},
            {"bytes_lost", loss.bytes},
            {"acknowledges_lost", loss.acknowledges},
            {"first", hit_json(loss.first)},
            {"output", loss.output},
            {"state", loss.state}};
}

boost::json::object json_of(const RunReport& report, const SwitchUse& use) {
    return {{"name", use.name},
            {"commands", use.commands},
            {"connections", use.connections},
            {"losses", array_of(report, use.losses)}};
}

template <class Rows>
boost::json::array array_of(const RunReport& report, const Rows& rows) {
    boost::json::array array;
    for (const auto& row : rows)
        array.push_back(json_of(report, row));
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

std::string print_ending(Ending ending) {
    bool well = ending == Ending::completed || ending == Ending::time_limit;
    return painted(well ? Paint::success : Paint::failure, name_of(ending));
}

/// The first of them; the JSON document has all.
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
    std::string out =
        fmt::format("{}: {} at {}{}\nfingerprint: {:016x}\n", network.source_path, print_ending(report.result.ending),
                    to_string(report.result.time), stopped ? "; what follows is of the time until then" : "",
                    report.result.fingerprint) +
        print_set(network) + print_faults(report.faults) + print_switches(report.switches);
    if (report.result.deadlock)
        out += (report.result.ending == Ending::stuck ? "\n" : "\nin a deadlock, while others could go on:\n") +
               report.result.deadlock->text();
    if (!report.result.never_ran.empty())
        out += print_never_ran(report.result.never_ran);
    if (!report.measurements.empty())
        out += print_measurements(report.measurements);
    out += print_searches(searches);
    if (!report.processors.empty())
        out += print_processors(report);
    return out + print_links(report) + print_buses(report) + print_devices(report) + print_processes(report);
}

boost::json::object report_json(const RunReport& report, const Network& network, const Manifest& manifest,
                                const GenerationLog& searches) {
    boost::json::object json{{"manifest", manifest_json(manifest, network)},
                             {"outcome", name_of(report.result.ending)},
                             {"time_ps", report.result.time.count()},
                             {"fingerprint", hex(report.result.fingerprint)},
                             {"measurements", array_of(report, report.measurements)},
                             {"processors", array_of(report, report.processors)},
                             {"links", array_of(report, report.links)},
                             {"processes", array_of(report, report.processes)}};
    if (!report.buses.empty())
        json["buses"] = array_of(report, report.buses);
    if (!report.devices.empty())
        json["devices"] = array_of(report, report.devices);
    if (!searches.searches().empty())
        json["searches"] = searches_json(searches);
    if (!report.faults.empty())
        json["faults"] = array_of(report, report.faults);
    if (!report.switches.empty())
        json["switches"] = array_of(report, report.switches);
    if (report.result.deadlock)
        json["deadlock"] = deadlock_json(*report.result.deadlock);
    if (!report.result.never_ran.empty())
        json["never_ran"] = texts_of(report.result.never_ran);
    return json;
}

} // namespace placedpar
