#include "occam/network/image_text.hpp"

#include "netlist/kinds/file_kinds.hpp"
#include "netlist/network/names.hpp"
#include "occam/network/kind.hpp"

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

constexpr int first_input = 4; ///< the link words of inputs follow those of outputs

std::string without_array(const Type& channel) {
    return channel.kind == Type::Kind::array ? without_array(*channel.element) : name_of(channel);
}

std::string items_text(const std::vector<ProtocolItem>& items) {
    std::string text;
    for (const ProtocolItem& item : items)
        text += (text.empty() ? "" : "; ") + (item.count ? name_of(*item.count) + "::" : "") + name_of(*item.type);
    return text;
}

std::string declaration_of(const ProtocolType& protocol) {
    if (protocol.kind == ProtocolType::Kind::sequence)
        return fmt::format("PROTOCOL {} IS {}:\n", protocol.declared->name, items_text(protocol.items));
    std::string text = fmt::format("PROTOCOL {}\n  CASE\n", protocol.declared->name);
    for (const ProtocolTag& tag : protocol.tags)
        text += fmt::format("    {}{}{}\n", tag.name, tag.items.empty() ? "" : "; ", items_text(tag.items));
    return text + ":\n";
}

/// Returns a text in quotes, with the escapes of the language.
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
    using ProgramOf = std::function<ProgramOfProcess(const ProcessInstance&)>;
    ImageText(const Network& network, std::size_t node, const ProgramOf& program_of)
        : n_(network), node_(node), program_of_(program_of) {}

    std::string write() {
        std::string high, low;
        int highs = 0, lows = 0;
        for (const ProcessInstance& process : n_.processes)
            if (process.is_code && process.node == node_) {
                ++(process.high_priority ? highs : lows);
                (process.high_priority ? high : low) += component(process, highs_and_lows() ? "      " : "    ");
            }
        std::string text;
        for (const auto& [name, declaration] : protocols_)
            text += declaration;
        text += "PROC node ()\n" + declarations_;
        if (highs == 0)
            return text + "  PAR\n" + low + ":\n";
        return text + "  PRI PAR\n    PAR\n" + high + (lows == 0 ? "    SKIP\n" : "    PAR\n" + low) + ":\n";
    }

private:
    bool highs_and_lows() const {
        return std::ranges::any_of(n_.processes, [&](const ProcessInstance& process) {
            return process.is_code && process.node == node_ && process.high_priority;
        });
    }

    std::string component(const ProcessInstance& process, const std::string& indentation) {
        const ProgramOfProcess program = program_of_(process);
        bool has_terminal = false, reads = false;
        for (const DeclarationBox& each : std::get<Procedure>(program.procedure->form).parameters)
            if (leads_to_terminal(*each) && !is_connected(process, *each)) {
                has_terminal = true;
                reads |= each->name == "keyboard" && each->direction != Direction::unused;
            }
        if (!has_terminal)
            return instance(process, program, indentation);
        declare_server("netlist.fs", first_input);
        declare_server("netlist.ts", 0);
        return fmt::format("{0}CHAN OF BYTE netlist.keyboard, netlist.screen, netlist.error:\n"
                           "{0}CHAN OF BOOL netlist.ended:\n"
                           "{0}PAR\n"
                           "{0}  #USE \"terminal.lib\"\n"
                           "{0}  terminal (netlist.fs, netlist.ts, netlist.keyboard, netlist.screen, netlist.error, "
                           "netlist.ended, {1})\n"
                           "{0}  SEQ\n{2}"
                           "{0}    netlist.ended ! TRUE\n",
                           indentation, reads ? "TRUE" : "FALSE", instance(process, program, indentation + "    "));
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

    std::string argument(const ProcessInstance& process, const Declaration& parameter) {
        const Type& type = *parameter.type;
        const std::string name = netlist_name(parameter.name);
        const bool is_array = type.kind == Type::Kind::array && type.element->kind == Type::Kind::channel;
        if (type.kind != Type::Kind::channel && !is_array)
            return value_text(process.parameters.find(name)->second, type);
        std::vector<std::string> ends;
        for (const PortBinding& port : process.ports)
            if (base_name(port.port) == name)
                ends.push_back(channel(port.channel, type));
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
            throw UserError(fmt::format("two protocols on this processor have the name {}, and differ", known->first));
    }

    /// Returns the name of a channel of the network. Declares the channel at its first end.
    std::string channel(std::size_t index, const Type& type) {
        const std::string name = fmt::format("netlist.channel.{}", index);
        const NetworkChannel& channel = n_.channels[index];
        if (!std::exchange(declared_[index], true))
            declare(name, type, channel);
        return name;
    }

    void declare(const std::string& name, const Type& type, const NetworkChannel& channel) {
        declare_protocol(protocol_of(type));
        declarations_ += fmt::format("  {} {}:\n", without_array(type), name);
        if (channel.placement.kind == ChannelPlacement::Kind::soft)
            return;
        const RouteHop& hop = channel.placement.route.front();
        const bool is_output = channel.from.node == node_;
        const LinkEnd& end = is_output ? begin_of(hop, n_.connections) : end_of(hop, n_.connections);
        place(name, is_output ? end.link : first_input + end.link);
    }

    void place(const std::string& name, int address) {
        declarations_ += fmt::format("  PLACE {} AT {}:\n", name, address);
    }

    /// Returns the name of the channel from or to the host.
    std::string server_channel(const ProcessInstance& process, const Declaration& parameter) {
        const bool is_input = is_input_of_server(process, parameter);
        const std::string name = is_input ? "netlist.fs" : "netlist.ts";
        declare_server(name, is_input ? first_input : 0);
        return name;
    }

    void declare_server(const std::string& name, int first_address) {
        if (!servers_.insert(name).second)
            return;
        protocols_.try_emplace("SP", "PROTOCOL SP IS INT16::[]BYTE:\n");
        declarations_ += fmt::format("  CHAN OF SP {}:\n", name);
        place(name, *link_to_host(n_, node_) + first_address);
    }

    /// Returns whether a channel of the server's protocol is an input. The first of two is, if the procedure uses none.
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
    std::map<std::string, std::string> protocols_; ///< declarations by name
    std::map<std::size_t, bool> declared_;         ///< channels
    std::set<std::string> servers_;                ///< channels to and from the host that are declared
    std::string declarations_;
};

} // namespace

std::string text_of_image(const Network& network, std::size_t node,
                          const std::function<ProgramOfProcess(const ProcessInstance&)>& program_of) {
    return ImageText(network, node, program_of).write();
}

} // namespace placedpar::occam
