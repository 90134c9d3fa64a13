#include "occam/network/image_text.hpp"

#include "netlist/kinds/file_kinds.hpp"
#include "netlist/network/names.hpp"
#include "occam/network/kind.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace placedpar::occam {

namespace {

std::string without_array(const Type& channel) {
    return channel.kind == Type::Kind::array ? without_array(*channel.element) : name_of(channel);
}

std::string declaration_of(const ProtocolType& protocol) {
    if (protocol.kind == ProtocolType::Kind::sequence)
        return fmt::format("PROTOCOL {} IS {}:\n", protocol.declared->name, text_of_items(protocol.items));
    std::string text = fmt::format("PROTOCOL {}\n  CASE\n", protocol.declared->name);
    for (const ProtocolTag& tag : protocol.tags)
        text += fmt::format("    {}{}{}\n", tag.name, tag.items.empty() ? "" : "; ", text_of_items(tag.items));
    return text + ":\n";
}

/// Returns the text as a string of occam, in quotes and with escapes.
std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < ' ' || byte > 126 || c == '*' || c == '"' || c == '\'')
            result += fmt::format("*#{:02X}", byte);
        else
            result += c;
    }
    return result + '"';
}

std::string real_text(double value, Basic basic) {
    return fmt::format("{}({})", basic == Basic::real32 ? fmt::format("{:.9E}", value) : fmt::format("{:.17E}", value),
                       name_of(basic));
}

std::string value_text(const Value& value, const Type& type) {
    if (type.kind == Type::Kind::derived)
        return value_text(value, *type.element);
    if (const auto* text = std::get_if<std::string>(&value))
        return quoted(*text);
    if (const auto* real = std::get_if<double>(&value))
        return real_text(*real, type.basic);
    const std::int64_t integer = std::get<std::int64_t>(value);
    if (type.is(Basic::boolean))
        return integer != 0 ? "TRUE" : "FALSE";
    return fmt::format("{}({})", integer, name_of(type.basic));
}

class ImageText {
public:
    ImageText(const Network& network, std::size_t node, const ProgramOf& program_of)
        : n_(network), node_(node), program_of_(program_of), ways_(ways_over(network, node, program_of)),
          carries_(!ways_.shared.empty() || !ways_.relays.empty()) {}

    TextOfImage write() {
        const std::string indentation = carries_ || has_high_priority() ? "      " : "    ";
        for (const ProcessInstance& process : n_.processes)
            if (process.is_code && process.node == node_)
                add(process, indentation);
        for (const CarriedChannel& each : ways_.passing)
            pass_on(each);
        for (const auto& [connection, wire] : ways_.shared)
            add_carriers(text_of_shared_wire(wire));
        for (const NodeRoutes::Relay& each : ways_.relays)
            add_relay(each);
        if (!ends_.empty())
            low_.add({"", fmt::format("SEQ\n{}", ends_), true}, indentation);
        std::string text;
        for (const auto& [name, declaration] : protocols_)
            text += declaration;
        image_.carries = carries_;
        image_.text = text + wire_protocols_ + "PROC node ()\n" + declarations_ + body() + ":\n";
        for (const Components* each : {&high_, &low_})
            image_.components.insert(image_.components.end(), each->all.begin(), each->all.end());
        return std::move(image_);
    }

private:
    /// Holds the components of one priority.
    struct Components {
        std::vector<Component> all;
        std::string text;

        void add(Component component, const std::string& indentation) {
            text += indented(component.text, indentation.size());
            component.text.clear();
            all.push_back(std::move(component));
        }
    };

    bool has_high_priority() const {
        return std::ranges::any_of(n_.processes, [&](const ProcessInstance& process) {
            return process.is_code && process.node == node_ && process.high_priority;
        });
    }

    std::string body() {
        if (high_.all.empty())
            return "  PAR\n" + low_.text;
        if (low_.all.empty())
            low_.all.push_back({"", "", true});
        return "  PRI PAR\n    PAR\n" + high_.text + (low_.text.empty() ? "    SKIP\n" : "    PAR\n" + low_.text);
    }

    /// Adds a process of the netlist. Processes that pass on messages have high priority and never end. A program with
    /// such processes therefore ends when its processes of low priority have ended. One of these waits until the other
    /// processes of high priority have ended.
    void add(const ProcessInstance& process, const std::string& indentation) {
        Components& to = process.high_priority ? high_ : low_;
        const bool is_awaited = process.high_priority && carries_;
        if (has_terminal(process) && !is_awaited)
            to.all.push_back({"terminal of " + process.name, "", false});
        std::string text = component(process);
        if (is_awaited) {
            const std::string ended = fmt::format("netlist.ended.{}", to.all.size());
            declarations_ += fmt::format("  CHAN OF BYTE {}:\n", ended);
            text = fmt::format("SEQ\n{}  {} ! 0(BYTE)\n", indented(text, 2), ended);
            ends_ += fmt::format("  BYTE any:\n  {} ? any\n", ended);
        }
        to.add({process.name, std::move(text), false}, indentation);
    }

    void add_carriers(CarrierText carriers) {
        wire_protocols_ += carriers.protocols;
        declarations_ += indented(carriers.declarations, 2);
        for (Component& each : carriers.components)
            high_.add(std::move(each), "      ");
    }

    /// Declares the protocol of a channel that only passes this node.
    void pass_on(const CarriedChannel& channel) {
        declare_protocol(*channel.protocol);
        declare(channel.number, "CHAN OF " + protocol_name(*channel.protocol));
    }

    void add_relay(const NodeRoutes::Relay& relay) {
        const std::string in = name_of_channel(relay.channel.number), out = in + ".on";
        declarations_ += fmt::format("  CHAN OF {} {}:\n", protocol_name(*relay.channel.protocol), out);
        place(out, relay.out);
        high_.add(text_of_relay(relay.channel, in, out), "      ");
    }

    static std::string protocol_name(const ProtocolType& protocol) {
        return protocol.declared ? protocol.declared->name : text_of(protocol);
    }

    static bool uses_terminal(const ProcessInstance& process, const Declaration& parameter) {
        return leads_to_terminal(parameter) && !is_connected(process, parameter);
    }

    bool has_terminal(const ProcessInstance& process) const {
        return std::ranges::any_of(std::get<Procedure>(program_of_(process).procedure->form).parameters,
                                   [&](const DeclarationBox& each) { return uses_terminal(process, *each); });
    }

    std::string component(const ProcessInstance& process) {
        const ProgramOfProcess program = program_of_(process);
        if (!has_terminal(process))
            return instance(process, program, "");
        const bool reads = std::ranges::any_of(std::get<Procedure>(program.procedure->form).parameters,
                                               [&](const DeclarationBox& each) {
                                                   return uses_terminal(process, *each) && each->name == "keyboard" &&
                                                          each->direction != Direction::unused;
                                               });
        declare_server("netlist.fs", first_input_link);
        declare_server("netlist.ts", 0);
        return fmt::format("CHAN OF BYTE netlist.keyboard, netlist.screen, netlist.error:\n"
                           "CHAN OF BOOL netlist.ended:\n"
                           "PAR\n"
                           "  #USE \"terminal.lib\"\n"
                           "  terminal (netlist.fs, netlist.ts, netlist.keyboard, netlist.screen, netlist.error, "
                           "netlist.ended, {})\n"
                           "  SEQ\n{}"
                           "    netlist.ended ! TRUE\n",
                           reads ? "TRUE" : "FALSE", instance(process, program, "    "));
    }

    static bool is_connected(const ProcessInstance& process, const Declaration& parameter) {
        return std::ranges::find(process.ports, netlist_name(parameter.name), &PortBinding::port) !=
               process.ports.end();
    }

    std::string instance(const ProcessInstance& process, const ProgramOfProcess& program,
                         const std::string& indentation) {
        std::vector<std::string> arguments;
        for (const DeclarationBox& each : std::get<Procedure>(program.procedure->form).parameters)
            arguments.push_back(argument(process, *each));
        return fmt::format("{0}#USE \"{1}\"\n{0}{2} (\n{0}  {3})\n", indentation, program.path, program.procedure->name,
                           fmt::join(arguments, ",\n" + indentation + "  "));
    }

    std::vector<std::string> channels_at(const ProcessInstance& process, const std::string& name, const Type& type) {
        std::vector<std::string> ends;
        for (const PortBinding& port : process.ports)
            if (base_name(port.port) == name)
                ends.push_back(channel(port.channel, type));
        return ends;
    }

    std::string argument(const ProcessInstance& process, const Declaration& parameter) {
        const Type& type = *parameter.type;
        const std::string name = netlist_name(parameter.name);
        const bool is_array = type.kind == Type::Kind::array && type.element->kind == Type::Kind::channel;
        if (type.kind != Type::Kind::channel && !is_array)
            return value_text(process.parameters.find(name)->second, type);
        const std::vector<std::string> ends = channels_at(process, name, type);
        if (is_array)
            return fmt::format("[{}]", fmt::join(ends, ", "));
        if (!ends.empty())
            return ends.front();
        return leads_to_terminal(parameter) ? "netlist." + parameter.name : server_channel(process, parameter);
    }

    void declare_protocol(const ProtocolType& protocol) {
        if (!protocol.declared)
            return;
        const std::string declaration = declaration_of(protocol);
        const auto [known, is_new] = protocols_.try_emplace(protocol.declared->name, declaration);
        if (known->second != declaration)
            throw UserError(fmt::format("two different protocols on this processor have the name {}", known->first));
    }

    /// Returns the name of a channel of the network. Declares the channel at its first end.
    std::string channel(std::size_t number, const Type& type) {
        if (!image_.channels.contains(name_of_channel(number))) {
            declare_protocol(protocol_of(type));
            declare(number, without_array(type));
        }
        return name_of_channel(number);
    }

    void declare(std::size_t number, const std::string& type) {
        const std::string name = name_of_channel(number);
        image_.channels[name] = n_.channels[number].name;
        declarations_ += fmt::format("  {} {}:\n", type, name);
        if (const auto found = ways_.addresses.find(number); found != ways_.addresses.end())
            place(name, found->second);
    }

    void place(const std::string& name, int address) {
        declarations_ += fmt::format("  PLACE {} AT {}:\n", name, address);
    }

    /// Returns the name of the channel from or to the host.
    std::string server_channel(const ProcessInstance& process, const Declaration& parameter) {
        const bool is_input = is_input_of_server(process, parameter);
        const std::string name = is_input ? "netlist.fs" : "netlist.ts";
        declare_server(name, is_input ? first_input_link : 0);
        return name;
    }

    void declare_server(const std::string& name, int first_address) {
        if (!servers_.insert(name).second)
            return;
        protocols_.try_emplace("SP", "PROTOCOL SP IS INT16::[]BYTE:\n");
        declarations_ += fmt::format("  CHAN OF SP {}:\n", name);
        place(name, *link_to_host(n_, node_) + first_address);
    }

    /// Returns whether a channel of the protocol SP, which leads to the host's server, is an input. If the procedure
    /// uses neither of its two channels, the first is the input.
    bool is_input_of_server(const ProcessInstance& process, const Declaration& parameter) const {
        if (const Direction direction = direction_of(parameter); direction != Direction::unused)
            return direction == Direction::input;
        const ProgramOfProcess program = program_of_(process);
        for (const DeclarationBox& each : std::get<Procedure>(program.procedure->form).parameters)
            if (leads_to_server(*each))
                return each.get() == &parameter;
        return true;
    }

    const Network& n_;
    std::size_t node_;
    const ProgramOf& program_of_;
    NodeRoutes ways_;
    bool carries_; ///< whether this node has processes that pass on messages of other processes
    TextOfImage image_;
    Components high_, low_;
    std::map<std::string, std::string> protocols_; ///< declarations of protocols; key: name
    std::set<std::string> servers_;                ///< declared channels to and from the host
    std::string wire_protocols_, declarations_;
    std::string ends_; ///< inputs that wait until the processes of high priority have ended
};

} // namespace

TextOfImage text_of_image(const Network& network, std::size_t node, const ProgramOf& program_of) {
    return ImageText(network, node, program_of).write();
}

} // namespace placedpar::occam
