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

/// These functions describe kinds. For example, a kind's parameters are
///
///     using namespace description;
///     return {integer("count", {.unit = "packets", .by_default = 1000, .least = 1}, "packets that pass before it
///     ends"),
///             text("coding", {.by_default = "natural", .choices = {"natural", "gray"}}, "how a field is coded")};
namespace placedpar::description {

/// If `by_default` is empty, the netlist must give the parameter.
struct IntegerTraits {
    std::string unit = "";
    std::optional<std::int64_t> by_default = {};
    std::optional<double> least = {}, most = {}; ///< both ends allowed
};
struct RealTraits {
    std::string unit = "";
    std::optional<double> by_default = {};
    std::optional<double> least = {}, most = {}; ///< both ends allowed
};
struct TextTraits {
    std::optional<std::string> by_default = {};
    std::vector<std::string> choices = {};              ///< empty: any text
    std::function<void(const std::string&)> check = {}; ///< ParameterDescription::check
};

ParameterDescription integer(std::string name, IntegerTraits traits, std::string about);
ParameterDescription real(std::string name, RealTraits traits, std::string about);
ParameterDescription text(std::string name, TextTraits traits, std::string about);

/// Returns the parameter with ParameterDescription::noun set to `noun`.
ParameterDescription deciding(std::string noun, ParameterDescription parameter);

/// Returns the C++ type that has the same bytes as T: the type that ByteForm<T> names, or T itself.
template <class T>
std::type_index bytes_as() {
    if constexpr (requires { typename ByteForm<T>::SameAs; })
        return typeid(typename ByteForm<T>::SameAs);
    else
        return typeid(T);
}

/// Describes a channel end for messages of type T.
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

/// Returns the port, made optional: it may stay unconnected.
inline PortDescription optional(PortDescription port) {
    port.optional = true;
    return port;
}

/// Returns the port with PortDescription::formerly set to `name`, its name in older netlists.
inline PortDescription formerly(std::string name, PortDescription port) {
    port.formerly = std::move(name);
    return port;
}

} // namespace placedpar::description
