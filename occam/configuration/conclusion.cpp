#include "occam/configuration/configurer.hpp"

#include <fmt/format.h>

#include <variant>

namespace placedpar::occam {

/// Runs the checks that need the whole configuration, which describes processors, wires and the processes on each
/// processor.
void Configurer::check_whole() {
    check_nodes();
    if (!reporter_.failed())
        find_processors();
    if (!reporter_.failed() && configured_.processes.empty())
        reporter_.error({program_.files.front(), 0, 0}, "the configuration places no process on a processor");
    visit_channels(&Configurer::follow_arc);
    if (!numbered_.empty())
        visit_channels(&Configurer::connect_placed);
    visit_channels(&Configurer::check_channel);
}

/// Visits the channels that processes use, if no error has been reported.
void Configurer::visit_channels(void (Configurer::*visit)(const Element&, ChannelState&)) {
    if (reporter_.failed())
        return;
    for (const Element& channel : configured_.channel_order)
        (this->*visit)(channel, configured_.channels[channel]);
}

void Configurer::check_nodes() {
    for (std::size_t object = 0; object < configured_.objects.size(); ++object) {
        const Object& each = configured_.objects[object];
        if (innermost(*each.type).kind != Type::Kind::node)
            continue;
        for (std::size_t i = 0; i < count_of_elements(*each.type); ++i)
            check_node({object, i}, configured_.nodes[{object, i}], each.at);
    }
}

/// Checks that a node is either a processor with a type and a memory, or is mapped onto a processor.
void Configurer::check_node(const Element& node, const NodeState& state, const Place& declared) {
    const char* const example = "write SET node (type, memsize := \"T800\", 2097152)";
    const bool has_type = !state.type.empty(), has_memory = state.memory_at.line > 0;
    if (!has_type && !has_memory && !state.onto)
        checker_.report(declared, fmt::format("the node \"{}\" has no type, and is not mapped", text(node)),
                        "NETWORK sets the type of a processor; MAPPING maps other nodes onto processors");
    else if ((has_type || has_memory) && state.onto)
        checker_.report(state.onto_at, fmt::format("\"{}\" is mapped, but it is a processor", text(node)),
                        "remove its type and memory, or its MAP",
                        {{"its type or memory is set here", at(has_type ? state.type_at : state.memory_at)}});
    else if (has_memory && !has_type)
        checker_.report(state.memory_at, fmt::format("the type of \"{}\" is not set", text(node)), example);
    else if (has_type && !has_memory)
        checker_.report(state.type_at, fmt::format("the memory of \"{}\" is not set", text(node)), example);
}

/// Replaces the node of each process by the processor onto which the node is mapped.
void Configurer::find_processors() {
    for (const auto& [node, state] : configured_.nodes)
        if (state.onto && configured_.nodes[*state.onto].onto)
            checker_.report(
                state.onto_at,
                fmt::format("\"{}\" is mapped onto \"{}\", which is not a processor", text(node), text(*state.onto)),
                "map it onto a node that has a type",
                {{"this node is mapped here", at(configured_.nodes[*state.onto].onto_at)}});
    for (const WrittenWire& wire : configured_.wires)
        for (const WireEnd& end : {wire.a, wire.b})
            if (!end.is_edge && configured_.nodes[end.element].onto)
                checker_.report(end.at, fmt::format("\"{}\" is not a processor, so it has no links", text(end.element)),
                                "connect the processor that it is mapped onto",
                                {{"it is mapped here", at(configured_.nodes[end.element].onto_at)}});
    for (PlacedProcess& process : configured_.processes) {
        const NodeState& state = configured_.nodes[process.node];
        process.high_priority |= state.high_priority;
        if (state.onto)
            process.node = *state.onto;
    }
}

bool Configurer::is_local(const ChannelState& state) const {
    return state.output && state.input &&
           configured_.processes[state.output->process].node == configured_.processes[state.input->process].node;
}

/// Finds the links of a channel that is placed on an arc, a named wire. The two processes of the channel must be at the
/// ends of the arc.
void Configurer::follow_arc(const Element& channel, ChannelState& state) {
    if (!state.arc)
        return;
    const auto found = configured_.wire_of_arc.find(*state.arc);
    if (found == configured_.wire_of_arc.end())
        return checker_.report(state.placed_at, fmt::format("no connection uses the arc \"{}\"", text(*state.arc)),
                               fmt::format("write CONNECT ... TO ... WITH {}", text(*state.arc)));
    const WrittenWire& wire = configured_.wires[found->second];
    for (const WireEnd& end : {wire.a, wire.b}) {
        const auto is_at = [&](const std::optional<ChannelEnd>& one) {
            return one && !end.is_edge && configured_.processes[one->process].node == end.element;
        };
        if (is_at(state.output))
            state.leaves = end;
        else if (is_at(state.input))
            state.arrives = end;
    }
    state.leads_to_host = wire.b.is_edge && wire.b.element.object == 0;
    check_arc(channel, state, wire);
}

void Configurer::check_arc(const Element& channel, const ChannelState& state, const WrittenWire& wire) {
    if (is_local(state))
        return checker_.report(state.placed_at,
                               fmt::format("the channel \"{}\" is placed on an arc, but both of its processes are on "
                                           "\"{}\"",
                                           text(channel), text(configured_.processes[state.output->process].node)),
                               "leave the PLACE out: a channel within a processor needs no link");
    if (wire.b.is_edge && state.output && state.input)
        return checker_.report(
            state.placed_at,
            fmt::format("the channel \"{}\" is placed on an arc to an edge, but processes use both ends of the channel",
                        text(channel)),
            "", {{"the other end of the arc is here", at(wire.b.at)}});
    const bool is_stray = state.output && !state.leaves;
    if (!is_stray && (!state.input || state.arrives))
        return;
    const ChannelEnd& end = is_stray ? *state.output : *state.input;
    checker_.report(state.placed_at,
                    fmt::format("the arc \"{}\" does not lead to \"{}\", whose process uses the channel \"{}\"",
                                text(*state.arc), text(configured_.processes[end.process].node), text(channel)),
                    "", {{"the process uses the channel here", at(end.at)}});
}

void Configurer::check_channel(const Element& channel, ChannelState& state) {
    if (state.output && state.input)
        return;
    const ChannelEnd& end = state.output ? *state.output : *state.input;
    if (state.leaves || state.arrives)
        return;
    checker_.report(end.at, fmt::format("only one process uses the channel \"{}\"", text(channel)),
                    "a channel joins two processes; PLACE can also connect it to the host");
}

/// Checks that the process at this end of a channel is on the processor of the stated link. Returns false after an
/// error.
bool Configurer::is_at_its_process(const Element& channel, const std::optional<WireEnd>& link,
                                   const std::optional<ChannelEnd>& end, bool is_output) {
    if (!link || (end && configured_.processes[end->process].node == link->element))
        return true;
    checker_.report(link->at,
                    fmt::format("the channel \"{}\" is placed at the {} of a link, but no process of \"{}\" {} it",
                                text(channel), is_output ? "output" : "input", text(link->element),
                                is_output ? "outputs to" : "inputs from"),
                    "the addresses 0 to 3 are the outputs of the links, 4 to 7 their inputs");
    return false;
}

/// Makes the wire of a channel that is placed at a link. If two processors place the channel, the wire joins their
/// links. If only one processor places it, the wire leads to the host.
void Configurer::connect_placed(const Element& channel, ChannelState& state) {
    if (!is_at_its_process(channel, state.leaves, state.output, true) ||
        !is_at_its_process(channel, state.arrives, state.input, false))
        return;
    const bool is_placed = state.leaves || state.arrives;
    if (!state.output || !state.input) {
        state.leads_to_host = is_placed;
        if (is_placed)
            add_wire(state.leaves ? *state.leaves : *state.arrives, {.element = {0, 0}, .is_edge = true});
    } else if (state.leaves && state.arrives) {
        add_wire(*state.leaves, *state.arrives);
    } else if (is_placed || !is_local(state)) {
        const ChannelEnd& end = state.leaves ? *state.input : *state.output;
        checker_.report(
            end.at, fmt::format("the channel \"{}\" leads to another processor, but is not placed here", text(channel)),
            fmt::format("write PLACE {} AT and the {} of a link in front of the process", text(channel),
                        state.leaves ? "input" : "output"));
    }
}

/// Adds a wire, if no other channel has added it. Reports a link with wires to two places.
void Configurer::add_wire(const WireEnd& a, const WireEnd& b) {
    bool is_known = false;
    for (const auto& [one, other] : {std::pair(a, b), std::pair(b, a)}) {
        if (one.is_edge)
            continue;
        std::vector<WireEnd>& used = links_used_[one.element];
        used.resize(4, WireEnd{.link = -1});
        WireEnd& known = used[static_cast<std::size_t>(one.link)];
        if (known.link >= 0 && (known.element != other.element || known.link != other.link))
            return checker_.report(one.at,
                                   fmt::format("the channels of link {} of \"{}\" lead to two different links",
                                               one.link, text(one.element)),
                                   "", {{"the other channel is placed here", at(known.link_at)}});
        is_known |= known.link >= 0;
        known = other;
        known.link_at = one.at;
    }
    if (!is_known)
        configured_.wires.push_back({a, b});
}

} // namespace placedpar::occam
