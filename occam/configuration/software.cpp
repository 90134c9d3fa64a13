#include "netlist/print/text.hpp"
#include "occam/check/constant.hpp"
#include "occam/configuration/configurer.hpp"
#include "occam/network/kind.hpp"
#include "occam/network/vals.hpp"
#include "text/counted.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>
#include <variant>

namespace placedpar::occam {

namespace {

/// Lists the short names that old configurations use for types of transputers.
constexpr std::array<std::pair<std::string_view, std::string_view>, 5> short_types = {
    {{"T8", "T800"}, {"T4", "T414"}, {"T5", "T425"}, {"TA", "T414"}, {"TB", "T414"}}};
constexpr std::int64_t usual_memory_bytes = 2 * 1024 * 1024;

std::string full_type(const std::string& word) {
    for (const auto& [brief, full] : short_types)
        if (word == brief)
            return std::string(full);
    static constexpr std::array<std::string_view, 5> full_words = {"T414", "T425", "T400", "T800", "T805"};
    return std::ranges::find(full_words, word) != full_words.end() ? word : "";
}

} // namespace

/// Returns the node that a PROCESSOR statement names. If there is no such node, reports an error, and returns nothing.
std::optional<Element> Configurer::node_of(Processor& processor) {
    checker_.check(processor.number);
    if (processor.number.type->is(Basic::integer))
        return numbered_node(processor);
    const auto node = single(processor.number, Type::Kind::node, "a node");
    if (node && !processor.type.empty()) {
        checker_.report(processor.number.at, "the type of a node is stated by SET, not by PROCESSOR",
                        "leave the type out");
        return std::nullopt;
    }
    return node;
}

/// Returns the processor that a statement such as `PROCESSOR 0 T8` describes: its number and type, without a NETWORK.
std::optional<Element> Configurer::numbered_node(Processor& processor) {
    const auto number = constant(processor.number, "the number of a processor");
    if (!number)
        return std::nullopt;
    const std::string type = full_type(processor.type);
    if (type.empty()) {
        checker_.report(processor.number.at,
                        processor.type.empty() ? "the type of this processor is missing"
                                               : fmt::format("\"{}\" is not a type of processor", processor.type),
                        "write T8 for a T800, T4 for a T414, or T414, T425, T400, T800, T805");
        return std::nullopt;
    }
    if (const auto known = numbered_.find(*number); known != numbered_.end()) {
        checker_.report(processor.number.at, fmt::format("the processor {} is described twice", *number),
                        "put its processes into a PAR below one PROCESSOR",
                        {{"first described here", at(configured_.objects[known->second.object].at)}});
        return std::nullopt;
    }
    const Type* const node = program_.types.hardware(Type::Kind::node);
    const Element element{new_object(fmt::format("p{}", *number), node, processor.number.at), 0};
    numbered_[*number] = element;
    configured_.nodes[element] = {.type = type,
                                  .memory_bytes = usual_memory_bytes,
                                  .type_at = processor.number.at,
                                  .memory_at = processor.number.at};
    return element;
}

/// Returns the kind of a procedure. If a netlist cannot give a value to one of its parameters, reports an error, and
/// returns null.
const ProcessKind* Configurer::kind_of_procedure(const Declaration& procedure) {
    if (const auto known = configured_.kinds.find(&procedure); known != configured_.kinds.end())
        return &known->second;
    auto kind = kind_of(program_, procedure, reporter_);
    return kind ? &configured_.kinds.emplace(&procedure, std::move(*kind)).first->second : nullptr;
}

void Configurer::instance(Process& process, Instance& called) {
    checker_.check(process);
    if (!called.meaning)
        return;
    const auto* const procedure = std::get_if<Procedure>(&called.meaning->form);
    if (!procedure)
        return checker_.report(process.at, fmt::format("\"{}\" is not a PROC of a file", called.name),
                               "write a PROC that calls it");
    if (!here_)
        return checker_.report(process.at, fmt::format("the process \"{}\" is not on a processor", called.name),
                               "write PROCESSOR and a node above it");
    const ProcessKind* const kind = kind_of_procedure(*called.meaning);
    if (!kind || called.arguments.size() != procedure->parameters.size())
        return;
    PlacedProcess placed{.procedure = called.meaning,
                         .node = here_->node,
                         .high_priority = here_->high_priority,
                         .at = process.at,
                         .node_at = here_->at};
    std::size_t port = 0;
    for (std::size_t i = 0; i < called.arguments.size(); ++i)
        argument(called.arguments[i], *procedure->parameters[i], *kind, port, placed);
    configured_.processes.push_back(std::move(placed));
}

void Configurer::argument(Expression& given, const Declaration& parameter, const ProcessKind& kind, std::size_t& port,
                          PlacedProcess& placed) {
    if (innermost(*parameter.type).kind == Type::Kind::channel) {
        const ChannelEnd end{.process = configured_.processes.size(), .port = port, .element = {}, .at = given.at};
        channel_argument(given, kind.ports[port++], end);
    } else if (const auto value = given.constant ? netlist_value(*given.constant, *given.type) : std::nullopt)
        placed.values.push_back({netlist_name(parameter.name), print_constant(*value), given.at});
    else if (innermost(*given.type).kind != Type::Kind::mistaken)
        checker_.report(given.at, fmt::format("the value for \"{}\" must be a constant", parameter.name), "");
}

void Configurer::channel_argument(Expression& argument, const PortDescription& port, ChannelEnd end) {
    const bool is_array = argument.type->kind == Type::Kind::array;
    const std::vector<Element> channels = elements(selection_of(argument), argument.at);
    for (std::size_t i = 0; i < channels.size(); ++i) {
        if (is_array)
            end.element = i;
        add_end(channels[i], port, end);
    }
}

void Configurer::add_end(const Element& channel, const PortDescription& port, const ChannelEnd& end) {
    ChannelState& state = configured_.channels[channel];
    if (!state.output && !state.input)
        configured_.channel_order.push_back(channel);
    const bool is_output = port.direction == placedpar::Direction::output;
    std::optional<ChannelEnd>& known = is_output ? state.output : state.input;
    if (known)
        return checker_.report(
            end.at,
            fmt::format("two processes {} the channel \"{}\"", is_output ? "output to" : "input from", text(channel)),
            "a channel has one process at each end", {{"the other process is here", at(known->at)}});
    known = end;
}

} // namespace placedpar::occam
