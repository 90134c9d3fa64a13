#pragma once

#include "netlist/kinds/process_kind.hpp"
#include "runtime/channel.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <typeindex>
#include <utility>
#include <vector>

/// These functions describe the parameters and ports of kinds of processes and devices, for checks and help texts. For
/// example, a kind has these parameters:
///
///     using namespace description;
///     return {integer("count", {.unit = "packets", .by_default = 1000, .least = 1}, "packets that pass before it
///     ends"),
///             text("coding", {.by_default = "natural", .choices = {"natural", "gray"}}, "how a field is coded")};
namespace placedpar::description {

/// In the structures below, an empty `by_default` means that the netlist must give the parameter.
struct IntegerTraits {
    std::string unit = "";
    std::optional<std::int64_t> by_default = {};
    std::optional<double> least = {}, most = {}; ///< range of the value, both ends allowed; empty: no limit
};
struct RealTraits {
    std::string unit = "";
    std::optional<double> by_default = {};
    std::optional<double> least = {}, most = {}; ///< range of the value, both ends allowed; empty: no limit
};
struct TextTraits {
    std::optional<std::string> by_default = {};
    std::vector<std::string> choices = {}; ///< the allowed words; empty: any text
    std::function<void(const std::string&)> check =
        {}; ///< checks a text that has its own syntax: see ParameterDescription::check
};

ParameterDescription integer(std::string name, IntegerTraits traits, std::string about);
ParameterDescription real(std::string name, RealTraits traits, std::string about);
ParameterDescription text(std::string name, TextTraits traits, std::string about);

/// Returns the parameter with `noun` as its ParameterDescription::noun, the topic of the help text that lists its
/// values.
ParameterDescription deciding(std::string noun, ParameterDescription parameter);

/// Returns the C++ type whose messages have the same bytes on a wire as those of T: the type that ByteForm<T> names, or
/// T itself.
template <class T>
std::type_index bytes_as() {
    if constexpr (requires { typename ByteForm<T>::SameAs; })
        return typeid(typename ByteForm<T>::SameAs);
    else
        return typeid(T);
}

/// Describes a port, that is, a channel end in the interface of a process, for messages of type T.
template <class T>
PortDescription port(std::string name, Direction direction, std::string protocol, std::string about) {
    return {.name = std::move(name),
            .direction = direction,
            .optional = false,
            .protocol = std::move(protocol),
            .type = typeid(T),
            .make_channel = [](std::string channel) { return std::make_unique<Channel<T>>(std::move(channel)); },
            .about = std::move(about),
            .has_byte_form = HasByteForm<T>,
            .bytes_as = bytes_as<T>()};
}

template <class T>
PortDescription input(std::string name, std::string protocol, std::string about) {
    return port<T>(std::move(name), Direction::input, std::move(protocol), std::move(about));
}

template <class T>
PortDescription output(std::string name, std::string protocol, std::string about) {
    return port<T>(std::move(name), Direction::output, std::move(protocol), std::move(about));
}

/// Returns the port, changed so that netlists may leave it unconnected.
inline PortDescription optional(PortDescription port) {
    port.optional = true;
    return port;
}

/// Returns the port with a second name, its name in older netlists. A hint then tells the user the present name.
inline PortDescription formerly(std::string name, PortDescription port) {
    port.formerly = std::move(name);
    return port;
}

} // namespace placedpar::description
