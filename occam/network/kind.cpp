#include "occam/network/kind.hpp"

#include "netlist/kinds/description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <typeindex>
#include <utility>
#include <variant>
#include <vector>

namespace placedpar::occam {

namespace {

/// Serves as the C++ type of the messages at all ports of processes in occam.
struct BytesOfItems {};

const Type& plain_type(const Type& type) { return type.kind == Type::Kind::derived ? plain_type(*type.element) : type; }

bool is_channel_array(const Type& type) {
    return type.kind == Type::Kind::array && type.element->kind == Type::Kind::channel;
}

template <class T>
std::vector<std::type_index> single_or_counted(bool counted) {
    return {counted ? std::type_index(typeid(std::vector<T>)) : std::type_index(typeid(T))};
}

/// Returns the C++ types whose messages have the same bytes as a value of this type, or as a counted array of such
/// values.
std::vector<std::type_index> types_of_basic(Basic basic, bool counted) {
    switch (basic) {
    case Basic::boolean: return counted ? std::vector<std::type_index>{} : single_or_counted<bool>(false);
    case Basic::byte: return single_or_counted<std::uint8_t>(counted);
    case Basic::int16: return single_or_counted<std::int16_t>(counted);
    case Basic::int64: return single_or_counted<std::int64_t>(counted);
    case Basic::real32: return single_or_counted<float>(counted);
    case Basic::real64: return single_or_counted<double>(counted);
    case Basic::integer:
    case Basic::int32: break;
    }
    return single_or_counted<std::int32_t>(counted);
}

/// Returns the C++ types whose packets consist of the same bytes as the messages of the protocol.
std::vector<std::type_index> byte_types_of(const ProtocolType& protocol) {
    if (protocol.kind != ProtocolType::Kind::sequence || protocol.items.size() != 1)
        return {};
    const ProtocolItem& item = protocol.items.front();
    if (!item.count) {
        const Type& type = plain_type(*item.type);
        return type.kind == Type::Kind::basic ? types_of_basic(type.basic, false) : std::vector<std::type_index>{};
    }
    const Type& count = plain_type(*item.count);
    const Type& element = plain_type(*plain_type(*item.type).element);
    const bool has_word = count.is(Basic::integer) || count.is(Basic::int32);
    return has_word && element.kind == Type::Kind::basic ? types_of_basic(element.basic, true)
                                                         : std::vector<std::type_index>{};
}

/// Makes a kind from the parameters of a procedure.
class KindMaker {
public:
    KindMaker(const Program& program, const Declaration& procedure, Reporter& reporter)
        : program_(program), procedure_(procedure), reporter_(reporter) {}

    std::optional<ProcessKind> make() {
        kind_.is_code = true;
        kind_.about = fmt::format("The PROC {} of a file in occam: the processor executes its code.", procedure_.name);
        for (const DeclarationBox& each : std::get<Procedure>(procedure_.form).parameters)
            add(*each);
        return failed_ ? std::nullopt : std::optional(std::move(kind_));
    }

private:
    void refuse(const Declaration& parameter, const std::string& why, const std::string& hint) {
        failed_ = true;
        reporter_.error(program_.location(parameter.at), why, hint);
    }

    void add(const Declaration& parameter) {
        const Type& type = *parameter.type;
        if (type.kind == Type::Kind::channel || is_channel_array(type))
            return add_port(parameter);
        const bool is_value = std::get<Parameter>(parameter.form).passing == Parameter::Passing::value;
        if (is_value && plain_type(type).kind == Type::Kind::basic)
            kind_.parameters.push_back(value(parameter, plain_type(type).basic));
        else if (is_value && type.kind == Type::Kind::array && !type.count && plain_type(*type.element).is(Basic::byte))
            kind_.parameters.push_back(description::text(netlist_name(parameter.name), {}, about(parameter)));
        else
            refuse(parameter,
                   fmt::format("a netlist cannot set the parameter \"{}\" of PROC {}: its type is {}{}", parameter.name,
                               procedure_.name, is_value ? "VAL " : "", name_of(type)),
                   "a netlist can connect channels, and can set VAL scalars, and VAL []BYTE to a text");
    }

    static std::string about(const Declaration& parameter) {
        return fmt::format("VAL {} {}", name_of(*parameter.type), parameter.name);
    }

    static ParameterDescription value(const Declaration& parameter, Basic basic) {
        const std::string name = netlist_name(parameter.name);
        switch (basic) {
        case Basic::boolean: return description::integer(name, {.least = 0, .most = 1}, about(parameter));
        case Basic::byte: return description::integer(name, {.least = 0, .most = 255}, about(parameter));
        case Basic::int16: return description::integer(name, {.least = -32768, .most = 32767}, about(parameter));
        case Basic::int64: return description::integer(name, {}, about(parameter));
        case Basic::real32: {
            constexpr double most = std::numeric_limits<float>::max();
            return description::real(name, {.least = -most, .most = most}, about(parameter));
        }
        case Basic::real64: return description::real(name, {}, about(parameter));
        case Basic::integer:
        case Basic::int32: break;
        }
        return description::integer(name, {.least = -2147483648.0, .most = 2147483647}, about(parameter));
    }

    void add_port(const Declaration& parameter) {
        const bool to_server = leads_to_server(parameter);
        Direction direction = direction_of(parameter);
        if (direction == Direction::unused && to_server) // a procedure may use only one of its two channels to the host
            direction = servers_++ == 0 ? Direction::input : Direction::output;
        else
            servers_ += to_server;
        if (direction == Direction::unused)
            return refuse(parameter,
                          fmt::format("PROC {} does not use its channel \"{}\", so its direction is unknown",
                                      procedure_.name, parameter.name),
                          fmt::format("declare it as {0}? for input, or {0}! for output", parameter.name));
        const ProtocolType& protocol = protocol_of(*parameter.type);
        const bool is_input = direction == Direction::input;
        PortDescription port{.name = netlist_name(parameter.name),
                             .direction = is_input ? placedpar::Direction::input : placedpar::Direction::output,
                             .optional = to_server || leads_to_terminal(parameter),
                             .protocol = text_of(protocol),
                             .type = typeid(BytesOfItems),
                             .make_channel = {},
                             .about = fmt::format("{} {}", name_of(*parameter.type), parameter.name)};
        port.byte_types = byte_types_of(protocol);
        port.has_byte_form = true;
        port.to_host = port.optional;
        port.elements = is_channel_array(*parameter.type) ? parameter.type->count.value_or(0) : 1;
        kind_.ports.push_back(std::move(port));
    }

    const Program& program_;
    const Declaration& procedure_;
    Reporter& reporter_;
    ProcessKind kind_;
    int servers_ = 0; ///< number of channels with the server's protocol so far
    bool failed_ = false;
};

} // namespace

std::string netlist_name(const std::string& name) {
    std::string result = name;
    std::ranges::replace(result, '.', '_');
    return result;
}

const ProtocolType& protocol_of(const Type& type) {
    return type.kind == Type::Kind::array ? protocol_of(*type.element) : *type.protocol;
}

bool leads_to_server(const Declaration& parameter) {
    if (parameter.type->kind != Type::Kind::channel)
        return false;
    const ProtocolType& protocol = *parameter.type->protocol;
    return protocol.declared && protocol.declared->name == "SP" && text_of(protocol) == "SP IS INT16::[]BYTE";
}

bool leads_to_terminal(const Declaration& parameter) {
    const bool has_name = parameter.name == "keyboard" || parameter.name == "screen" || parameter.name == "error";
    return has_name && parameter.type->kind == Type::Kind::channel && text_of(*parameter.type->protocol) == "BYTE";
}

Direction direction_of(const Declaration& parameter) {
    if (parameter.direction != Direction::unused)
        return parameter.direction;
    if (const auto& written = std::get<Parameter>(parameter.form).written_output)
        return *written ? Direction::output : Direction::input;
    if (!leads_to_terminal(parameter))
        return Direction::unused;
    return parameter.name == "keyboard" ? Direction::input : Direction::output;
}

std::string text_of_items(const std::vector<ProtocolItem>& items) {
    std::string text;
    for (const ProtocolItem& item : items)
        text += (text.empty() ? "" : "; ") + (item.count ? name_of(*item.count) + "::" : "") + name_of(*item.type);
    return text;
}

std::string text_of(const ProtocolType& protocol) {
    const std::string name = protocol.declared ? protocol.declared->name : "";
    if (protocol.kind == ProtocolType::Kind::any)
        return "ANY";
    if (protocol.kind == ProtocolType::Kind::sequence)
        return (name.empty() ? "" : name + " IS ") + text_of_items(protocol.items);
    std::string text = name + " CASE";
    for (const ProtocolTag& tag : protocol.tags)
        text += (&tag == protocol.tags.data() ? " " : ", ") + tag.name +
                (tag.items.empty() ? "" : "; " + text_of_items(tag.items));
    return text;
}

std::optional<ProcessKind> kind_of(const Program& program, const Declaration& procedure, Reporter& reporter) {
    return KindMaker(program, procedure, reporter).make();
}

} // namespace placedpar::occam
