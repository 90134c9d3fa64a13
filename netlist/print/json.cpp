#include "netlist/kinds/device_kind.hpp"
#include "netlist/print/print.hpp"
#include "netlist/print/text.hpp"

#include <boost/json.hpp>

#include <fmt/format.h>

namespace placedpar {

namespace json = boost::json;

namespace {

json::value to_json(const Value& value) {
    if (const auto* text = std::get_if<std::string>(&value))
        return json::value(as_utf8(*text));
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
    return object;
}

/// Names, not positions: a reader of the document need not count.
class JsonPrinter {
public:
    explicit JsonPrinter(const Network& network) : n_(network) {}

    json::object print() const {
        json::object document;
        document["source"] = as_utf8(n_.source_path);
        document["hash"] = fmt::format("{:016x}", n_.hash);
        document["nodes"] = list(n_.nodes, [](const Node& node) { return to_json(node); });
        document["connections"] =
            list(n_.connections, [&](const auto& connection) { return connection_object(connection); });
        document["processes"] = list(n_.processes, [&](const auto& process) { return process_object(process); });
        document["channels"] = list(n_.channels, [&](const auto& channel) { return channel_object(channel); });
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
        json::object object;
        object["node"] = n_.nodes[end.node].name;
        if (!end.at_edge())
            object["link"] = end.link;
        return object;
    }

    json::object connection_object(const LinkConnection& connection) const {
        json::object object;
        object["name"] = connection.name;
        object["a"] = link_object(connection.a);
        object["b"] = link_object(connection.b);
        object["bits_per_second"] = connection.bits_per_second;
        object["metres"] = connection.metres;
        object["crossings"] = list(connection.crossings, [&](const SwitchCrossing& crossing) {
            json::object crossed;
            crossed["node"] = n_.nodes[crossing.node].name;
            crossed["from_link"] = crossing.from_link;
            crossed["to_link"] = crossing.to_link;
            return crossed;
        });
        return object;
    }

    json::object process_object(const ProcessInstance& process) const {
        json::object object;
        object["name"] = process.name;
        object["kind"] = as_utf8(process.kind);
        object["stand_in"] = process.stand_in;
        object["node"] = n_.nodes[process.node].name;
        object["high_priority"] = process.high_priority;
        object["parameters"] = to_json(process.parameters);
        object["ports"] = list(process.ports, [&](const PortBinding& binding) {
            json::object port;
            port["port"] = binding.port;
            port["direction"] = word(binding.direction);
            port["channel"] = n_.channels[binding.channel].name;
            return port;
        });
        if (!process.other.empty())
            object["other"] = to_json(process.other);
        return object;
    }

    json::object end_object(const ChannelEnd& end) const {
        json::object object;
        if (end.at_edge())
            object["edge"] = n_.nodes[end.node].name;
        else
            object["process"] = n_.processes[end.process].name;
        object["port"] = end.port;
        return object;
    }

    json::object channel_object(const NetworkChannel& channel) const {
        json::object object;
        object["name"] = channel.name;
        object["from"] = end_object(channel.from);
        object["to"] = end_object(channel.to);
        json::object carrier;
        carrier["kind"] = channel.placement.kind == ChannelPlacement::Kind::soft   ? "soft"
                          : channel.placement.kind == ChannelPlacement::Kind::link ? "link"
                                                                                   : "edge";
        if (channel.placement.kind != ChannelPlacement::Kind::soft) {
            const auto& connection = n_.connections[channel.placement.connection];
            carrier["connection"] = channel.placement.connection;
            carrier["from"] = link_object(channel.placement.from_a_to_b ? connection.a : connection.b);
            carrier["to"] = link_object(channel.placement.from_a_to_b ? connection.b : connection.a);
            carrier["shared"] = channel.placement.shared;
        }
        object["carrier"] = carrier;
        return object;
    }

    const Network& n_;
};

/// Objects and arrays of objects on lines of their own, what is flat on one line.
void write(const json::value& value, std::string& out, const std::string& indent) {
    auto is_flat = [](const auto& container, auto element) {
        for (const auto& entry : container)
            if (element(entry).is_structured())
                return false;
        return true;
    };
    auto of_pair = [](const json::key_value_pair& pair) -> const json::value& { return pair.value(); };
    auto of_value = [](const json::value& entry) -> const json::value& { return entry; };
    const auto inner = indent + "  ";
    bool first = true;
    auto begin_entry = [&] {
        out.append(first ? "\n" : ",\n").append(inner);
        first = false;
    };
    if (value.is_object() && !is_flat(value.get_object(), of_pair)) {
        out += "{";
        for (const auto& pair : value.get_object()) {
            begin_entry();
            out.append(json::serialize(json::string_view(pair.key()))).append(": ");
            write(pair.value(), out, inner);
        }
        out.append("\n").append(indent).append("}");
    } else if (value.is_array() && !is_flat(value.get_array(), of_value)) {
        out += "[";
        for (const auto& entry : value.get_array()) {
            begin_entry();
            write(entry, out, inner);
        }
        out.append("\n").append(indent).append("]");
    } else {
        out += json::serialize(value);
    }
}

} // namespace

std::string print_json(const Network& network) {
    std::string out;
    write(JsonPrinter(network).print(), out, "");
    return out + "\n";
}

} // namespace placedpar
