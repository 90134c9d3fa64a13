#include "occam/network/ways.hpp"

#include "netlist/network/names.hpp"
#include "occam/network/kind.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <variant>

namespace placedpar::occam {

namespace {

/// Describes the links over which a channel arrives at a node and leaves the node.
struct LinksOfChannel {
    std::optional<std::size_t> arrives_over, leaves_over; ///< connections
    int in = 0, out = 0;                                  ///< numbers of these links at the node
};

class WaySearch {
public:
    WaySearch(const Network& network, std::size_t node, const ProgramOf& program_of)
        : n_(network), node_(node), program_of_(program_of), loads_(2 * network.connections.size(), 0) {
        for (const NetworkChannel& channel : n_.channels)
            if (is_between_code(n_, channel))
                for (const RouteHop& hop : channel.placement.route)
                    ++loads_[2 * hop.connection + (hop.from_a_to_b ? 1 : 0)];
    }

    NodeRoutes find() {
        for (std::size_t i = 0; i < n_.channels.size(); ++i)
            if (n_.channels[i].placement.kind == ChannelPlacement::Kind::link)
                add(i);
        for (const auto& [connection, wire] : ways_.shared)
            check(wire);
        return std::move(ways_);
    }

private:
    bool is_shared(const std::optional<std::size_t>& connection) const {
        return connection && std::max(loads_[2 * *connection], loads_[2 * *connection + 1]) > 1;
    }

    LinksOfChannel passage(const NetworkChannel& channel) const {
        LinksOfChannel result;
        for (const RouteHop& hop : channel.placement.route) {
            const LinkEnd &begin = begin_of(hop, n_.connections), &end = end_of(hop, n_.connections);
            if (begin.node == node_) {
                result.leaves_over = hop.connection;
                result.out = begin.link;
            } else if (end.node == node_) {
                result.arrives_over = hop.connection;
                result.in = end.link;
            }
        }
        return result;
    }

    void add(std::size_t number) {
        const NetworkChannel& channel = n_.channels[number];
        const LinksOfChannel way = passage(channel);
        if (!way.arrives_over && !way.leaves_over)
            return;
        const bool arrives_alone = way.arrives_over && !is_shared(way.arrives_over);
        const bool leaves_alone = way.leaves_over && !is_shared(way.leaves_over);
        if (arrives_alone || leaves_alone)
            ways_.addresses[number] = arrives_alone ? first_input_link + way.in : way.out;
        if (!is_between_code(n_, channel))
            return;
        const CarriedChannel carried = carried_channel(number);
        const bool is_carried =
            is_shared(way.arrives_over) || is_shared(way.leaves_over) || (way.arrives_over && way.leaves_over);
        if (is_carried && carried.protocol->kind == ProtocolType::Kind::any)
            refuse_any(channel);
        if (is_shared(way.arrives_over))
            shared(*way.arrives_over, way.in).arriving.push_back(carried);
        if (is_shared(way.leaves_over))
            shared(*way.leaves_over, way.out).leaving.push_back(carried);
        if (arrives_alone && leaves_alone)
            ways_.relays.push_back({carried, way.out});
        if (way.arrives_over && way.leaves_over)
            ways_.passing.push_back(carried);
    }

    SharedWire& shared(std::size_t connection, int link) {
        SharedWire& wire = ways_.shared[connection];
        wire.link = link;
        return wire;
    }

    CarriedChannel carried_channel(std::size_t number) const {
        const NetworkChannel& channel = n_.channels[number];
        const ProcessInstance& sender = n_.processes[channel.from.process];
        const ProgramOfProcess program = program_of_(sender);
        CarriedChannel result{number, channel.name, nullptr, program.program, 0};
        for (const DeclarationBox& each : std::get<Procedure>(program.procedure->form).parameters)
            if (netlist_name(each->name) == base_name(channel.from.port))
                result.protocol = &protocol_of(*each->type);
        for (const auto& [name, value] : sender.parameters)
            if (const auto* text = std::get_if<std::string>(&value))
                result.longest_text = std::max<std::uint64_t>(result.longest_text, text->size());
        return result;
    }

    [[noreturn]] static void refuse_any(const NetworkChannel& channel) {
        throw UserError(fmt::format(
            "the channel \"{}\" carries ANY, whose messages have no known length, so it needs a wire of its own",
            channel.name));
    }

    void check(const SharedWire& wire) const {
        for (const auto& [with, against] :
             {std::pair(&wire.leaving, &wire.arriving), std::pair(&wire.arriving, &wire.leaving)})
            if (const std::size_t count = count_of_messages(*with, *against); count > 256)
                throw UserError(fmt::format(
                    "{}.link[{}] carries {} channels in one direction and {} in the other, with {} kinds of messages "
                    "and acknowledgements, but at most 256 are possible: use more wires, or fewer channels",
                    n_.nodes[node_].name, wire.link, wire.leaving.size(), wire.arriving.size(), count));
    }

    const Network& n_;
    std::size_t node_;
    const ProgramOf& program_of_;
    std::vector<std::size_t>
        loads_; ///< number of channels on each connection i: element 2 i from b to a, element 2 i + 1 from a to b
    NodeRoutes ways_;
};

} // namespace

NodeRoutes ways_over(const Network& network, std::size_t node, const ProgramOf& program_of) {
    return WaySearch(network, node, program_of).find();
}

} // namespace placedpar::occam
