#include "netlist/kinds/device_kind.hpp"
#include "netlist/print/print.hpp"
#include "text/utf8.hpp"

#include <boost/json.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

namespace json = boost::json;

namespace {

json::value to_json(const Value& value) {
    if (const auto* text = std::get_if<std::string>(&value))
        return json::value(*text);
    if (const auto* integer = std::get_if<std::int64_t>(&value))
        return json::value(*integer);
    return json::value(std::get<double>(value));
}

json::object to_json(const std::map<std::string, Value>& values) {
    json::object object;
    for (const auto& [name, value] : values)
        object[name] = to_json(value);
    return object;
}

json::object to_json(const Node& node) {
    json::object object;
    object["name"] = node.name;
    object["type"] = node.type;
    object["kind"] = node.kind->name;
    for (const auto& attribute : node.kind->attributes)
        object[attribute.json_name] = to_json(node.attributes.at(attribute.value.name));
    if (!node.other.empty())
        object["other"] = to_json(node.other);
    if (node.rank)
        object["rank"] = *node.rank;
    if (node.runs_own_code)
        object["executes_own_code"] = true;
    if (!node.boot_file.empty()) {
        object["boot_file"] = node.boot_file;
        object["boot_hash"] = fmt::format("{:016x}", boot_hash(node));
    }
    return object;
}

/// Writes a network as JSON. Nodes, processes and channels are referred to by name. Connections are referred to by
/// position, since a connection may have no name.
class JsonPrinter {
public:
    explicit JsonPrinter(const Network& network) : n_(network) {}

    json::object print() const {
        json::object document;
        document["source"] = n_.source_path;
        document["hash"] = fmt::format("{:016x}", n_.hash);
        document["nodes"] = list(n_.nodes, [](const Node& node) { return to_json(node); });
        document["connections"] =
            list(n_.connections, [&](const auto& connection) { return connection_object(connection); });
        if (!n_.attachments.empty())
            document["attachments"] =
                list(n_.attachments, [&](const auto& attachment) { return attachment_object(attachment); });
        document["processes"] = list(n_.processes, [&](const auto& process) { return process_object(process); });
        document["channels"] = list(n_.channels, [&](const auto& channel) { return channel_object(channel); });
        if (!n_.faults.empty())
            document["faults"] = list(n_.faults, [&](const auto& fault) { return fault_object(fault); });
        return document;
    }

private:
    template <typename Things, typename Convert>
    static json::array list(const Things& things, Convert convert) {
        json::array array;
        for (const auto& thing : things)
            array.push_back(convert(thing));
        return array;
    }

    json::object link_object(const LinkEnd& end) const {
        json::object object{{"node", n_.nodes[end.node].name}};
        if (end.link == bus_port)
            object["bus"] = 0;
        else if (end.link == configuration_link)
            object["config"] = 0;
        else if (!end.at_edge())
            object["link"] = end.link;
        return object;
    }

    json::object fault_object(const Fault& fault) const {
        json::object object{{"kind", fault.kind}, {"node", n_.nodes[fault.node].name}};
        if (fault.link >= 0) {
            object["link"] = fault.link;
            object["connection"] = fault.connection;
        }
        for (const auto& [name, value] : fault.attributes)
            object[name] = to_json(value);
        return object;
    }

    json::object crossing_object(const SwitchCrossing& crossing) const {
        return {
            {"node", n_.nodes[crossing.node].name}, {"from_link", crossing.from_link}, {"to_link", crossing.to_link}};
    }

    json::object connection_object(const LinkConnection& connection) const {
        json::object object{
            {"name", connection.name},
            {"a", link_object(connection.a)},
            {"b", link_object(connection.b)},
            {"bits_per_second", connection.bits_per_second},
            {"metres", connection.metres},
            {"crossings", list(connection.crossings, [&](const auto& each) { return crossing_object(each); })}};
        if (connection.at_run_time)
            object["at_run_time"] = true;
        if (connection.over_bus)
            object["over_bus"] = way_object(*connection.over_bus);
        return object;
    }

    json::object way_object(const BusWay& way) const {
        const BusAttachment& slave = n_.attachments[way.slave];
        return {{"bus", n_.nodes[slave.bus].name},
                {"master", n_.nodes[n_.attachments[way.master].node].name},
                {"to", n_.nodes[slave.node].name}};
    }

    json::object attachment_object(const BusAttachment& attachment) const {
        return {{"name", attachment.name},
                {"node", n_.nodes[attachment.node].name},
                {"bus", n_.nodes[attachment.bus].name},
                {"slot", attachment.slot},
                {"level", attachment.level},
                {"release", attachment.on_request ? "ROR" : "RWD"}};
    }

    json::object port_object(const PortBinding& binding) const {
        return {{"port", binding.port},
                {"direction", placedpar::word(binding.direction)},
                {"channel", n_.channels[binding.channel].name}};
    }

    json::object process_object(const ProcessInstance& process) const {
        json::object object{{"name", process.name},
                            {"kind", process.kind},
                            {"stand_in", process.stand_in},
                            {"node", n_.nodes[process.node].name},
                            {"high_priority", process.high_priority},
                            {"parameters", to_json(process.parameters)},
                            {"ports", list(process.ports, [&](const auto& each) { return port_object(each); })}};
        if (!process.other.empty())
            object["other"] = to_json(process.other);
        return object;
    }

    json::object end_object(const ChannelEnd& end) const {
        if (end.at_edge() && n_.nodes[end.node].runs_own_code)
            return {{"node", n_.nodes[end.node].name}};
        if (end.at_edge())
            return {{"edge", n_.nodes[end.node].name}, {"port", end.port}};
        return {{"process", n_.processes[end.process].name}, {"port", end.port}};
    }

    json::object channel_object(const NetworkChannel& channel) const {
        return {{"name", channel.name},
                {"from", end_object(channel.from)},
                {"to", end_object(channel.to)},
                {"carrier", carrier_object(channel.placement)}};
    }

    static const char* word(ChannelPlacement::Kind kind) {
        return kind == ChannelPlacement::Kind::soft ? "soft" : kind == ChannelPlacement::Kind::link ? "link" : "edge";
    }

    json::object hop_object(const RouteHop& hop) const {
        return {{"connection", hop.connection},
                {"from", link_object(begin_of(hop, n_.connections))},
                {"to", link_object(end_of(hop, n_.connections))}};
    }

    json::object carrier_object(const ChannelPlacement& placement) const {
        json::object carrier;
        carrier["kind"] = word(placement.kind);
        if (placement.kind == ChannelPlacement::Kind::soft)
            return carrier;
        carrier["connection"] = placement.route.front().connection;
        carrier["from"] = link_object(begin_of(placement.route.front(), n_.connections));
        carrier["to"] = link_object(end_of(placement.route.back(), n_.connections));
        carrier["in_packets"] = placement.in_packets;
        if (placement.broadcast_on != nowhere)
            carrier["broadcast_on"] = n_.nodes[placement.broadcast_on].name;
        if (placement.route.size() > 1)
            carrier["route"] = list(placement.route, [&](const RouteHop& hop) { return hop_object(hop); });
        return carrier;
    }

    const Network& n_;
};

bool is_flat(const json::value& value) {
    auto plain = [](const json::value& entry) { return !entry.is_structured(); };
    if (const auto* object = value.if_object())
        return std::ranges::all_of(*object, [&](const auto& pair) { return plain(pair.value()); });
    return !value.is_array() || std::ranges::all_of(value.get_array(), plain);
}

void write(const json::value& value, std::string& out, const std::string& indent);

/// Writes each entry on a separate line by `write_entry`.
template <class Entries, class WriteEntry>
void write_lines(const Entries& entries, std::string_view brackets, std::string& out, const std::string& indent,
                 WriteEntry write_entry) {
    std::string_view before = "\n";
    out += brackets[0];
    for (const auto& entry : entries) {
        out.append(before).append(indent).append("  ");
        write_entry(entry);
        before = ",\n";
    }
    out.append("\n").append(indent) += brackets[1];
}

/// Writes the value: flat objects and arrays on one line, nested objects and arrays over several lines.
void write(const json::value& value, std::string& out, const std::string& indent) {
    const auto inner = indent + "  ";
    if (is_flat(value))
        out += json::serialize(value);
    else if (value.is_object())
        write_lines(value.get_object(), "{}", out, indent, [&](const json::key_value_pair& pair) {
            out.append(json::serialize(json::string_view(pair.key()))).append(": ");
            write(pair.value(), out, inner);
        });
    else
        write_lines(value.get_array(), "[]", out, indent, [&](const json::value& entry) { write(entry, out, inner); });
}

} // namespace

std::string print_json(const Network& network) {
    std::string out;
    write(JsonPrinter(network).print(), out, "");
    return as_json(out + "\n");
}

} // namespace placedpar
