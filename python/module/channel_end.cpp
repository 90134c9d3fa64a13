#include "python/module/channel_end.hpp"

#include "netlist/kinds/description.hpp"
#include "netlist/kinds/packet.hpp"
#include "text/user_error.hpp"

#include <pybind11/stl.h>

#include <concepts>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

namespace placedpar::python {

namespace {

/// Throws pybind11::type_error if the object is not a message of this protocol.
template <class T>
T message_from(pybind11::handle object, const AnyChannel& channel, const char* protocol) {
    try {
        if constexpr (std::same_as<T, std::vector<std::uint8_t>>)
            if (pybind11::isinstance<pybind11::bytes>(object)) {
                const auto bytes = object.cast<std::string_view>();
                return {bytes.begin(), bytes.end()};
            }
        return object.cast<T>();
    } catch (const pybind11::cast_error&) {
        throw pybind11::type_error(pybind11::str("channel {} carries {}, not {!r}")
                                       .format(channel.name(), protocol, object)
                                       .cast<std::string>());
    }
}

std::uint32_t wire_bytes_of(pybind11::handle object) {
    const pybind11::object bytes = object.attr("wire_bytes");
    try {
        return bytes.cast<std::uint32_t>();
    } catch (const pybind11::cast_error&) {
        throw pybind11::type_error(pybind11::str("{}.wire_bytes is {!r}, expected a whole number from 0 to {}")
                                       .format(pybind11::type::of(object).attr("__name__"), bytes, UINT32_MAX)
                                       .cast<std::string>());
    }
}

template <>
ObjectMessage message_from(pybind11::handle object, const AnyChannel&, const char*) {
    std::uint32_t bytes = 4;
    if (pybind11::hasattr(object, "wire_bytes"))
        bytes = wire_bytes_of(object);
    return {SharedObject(pybind11::reinterpret_borrow<pybind11::object>(object)), bytes};
}

template <class T>
pybind11::object object_of(const T& message) {
    return pybind11::cast(message);
}
pybind11::object object_of(const std::vector<std::uint8_t>& message) {
    return pybind11::bytes(reinterpret_cast<const char*>(message.data()), message.size());
}
pybind11::object object_of(const ObjectMessage& message) {
    return pybind11::reinterpret_borrow<pybind11::object>(message.object.get());
}

template <class T>
class EndFor final : public ChannelEnd {
public:
    EndFor(const std::string& port, Output<T> to, const char* protocol)
        : ChannelEnd(port, Direction::output), to_(to), protocol_(protocol) {}
    EndFor(const std::string& port, Input<T> from, const char* protocol)
        : ChannelEnd(port, Direction::input), from_(from), protocol_(protocol) {}

    void take(pybind11::handle object) override { message_ = message_from<T>(object, channel(), protocol_); }
    pybind11::object give() override { return object_of(*std::exchange(message_, std::nullopt)); }
    void output() override { to_.output(std::move(*message_)); }
    void input() override { message_ = from_.input(); }
    AnyChannel& channel() const override { return to_ ? to_.channel() : from_.channel(); }

private:
    Output<T> to_;
    Input<T> from_;
    const char* protocol_;
    std::optional<T> message_;
};

template <class T>
std::vector<std::shared_ptr<ChannelEnd>> ends_for(const ProcessEnvironment& environment, const std::string& port,
                                                  Direction direction, const char* protocol) {
    std::vector<std::shared_ptr<ChannelEnd>> ends;
    if (direction == Direction::input)
        for (const Input<T>& each : environment.inputs<T>(port))
            ends.push_back(std::make_shared<EndFor<T>>(port, each, protocol));
    else
        for (const Output<T>& each : environment.outputs<T>(port))
            ends.push_back(std::make_shared<EndFor<T>>(port, each, protocol));
    return ends;
}

template <class T>
std::pair<const std::string, Protocol> protocol_for(const char* name) {
    return {name,
            {[name](std::string port, Direction direction, std::string about) {
                 return description::port<T>(std::move(port), direction, name, std::move(about));
             },
             [name](const ProcessEnvironment& environment, const std::string& port, Direction direction) {
                 return ends_for<T>(environment, port, direction, name);
             }}};
}

} // namespace

void ChannelEnd::require_attached() const {
    if (is_detached_)
        throw UserError("the end " + port_ + " was used after its process had ended");
}

void ChannelEnd::require(Direction direction) const {
    require_attached();
    if (direction == direction_)
        return;
    throw pybind11::type_error(direction_ == Direction::output
                                   ? port_ + " is an output end: use " + port_ + ".output(message)"
                                   : port_ + " is an input end: use " + port_ + ".input()");
}

const Protocol& protocol_named(const std::string& name) {
    static const std::map<std::string, Protocol> protocols{
        protocol_for<std::int16_t>("INT16"),
        protocol_for<std::int32_t>("INT32"),
        protocol_for<std::int64_t>("INT64"),
        protocol_for<std::uint8_t>("BYTE"),
        protocol_for<bool>("BOOL"),
        protocol_for<float>("REAL32"),
        protocol_for<double>("REAL64"),
        protocol_for<std::vector<std::int32_t>>("[]INT32"),
        protocol_for<std::vector<std::int64_t>>("[]INT64"),
        protocol_for<std::vector<std::uint8_t>>("[]BYTE"),
        protocol_for<std::vector<float>>("[]REAL32"),
        protocol_for<std::vector<double>>("[]REAL64"),
        protocol_for<Packet>("packet"),
        protocol_for<ObjectMessage>("object"),
    };
    const auto found = protocols.find(name);
    if (found != protocols.end())
        return found->second;
    std::string names;
    for (const auto& [each, protocol] : protocols)
        names += (names.empty() ? "" : ", ") + each;
    throw UserError("no channel carries messages of the type \"" + name + "\"; the types are " + names);
}

} // namespace placedpar::python
