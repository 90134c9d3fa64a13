#pragma once

#include "netlist/kinds/environment.hpp"
#include "netlist/kinds/process_kind.hpp"
#include "python/module/interpreter.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace placedpar::python {

/// An end of a channel that a process in Python uses. It keeps the message between Python, which needs the lock, and
/// the channel, which must not have it. Python may keep the end for longer than the process has the channel.
class ChannelEnd {
public:
    ChannelEnd(std::string port, Direction direction) : port_(std::move(port)), direction_(direction) {}
    virtual ~ChannelEnd() = default;
    /// Ends the use of the channel: its process has ended.
    void detach() { is_detached_ = true; }
    /// Throws UserError if the process of the end has ended.
    void require_attached() const;
    /// Throws pybind11::type_error for an end of the other direction, and what require_attached() throws.
    void require(Direction) const;

    /// Takes the next message to be output. Throws pybind11::type_error if the object is not a message of the channel.
    /// REQUIRES: the caller holds the lock.
    virtual void take(pybind11::handle message) = 0;
    /// Returns the message of the last input. REQUIRES: the caller holds the lock.
    virtual pybind11::object give() = 0;
    virtual void output() = 0;
    virtual void input() = 0;
    virtual AnyChannel& channel() const = 0;

private:
    std::string port_;
    Direction direction_;
    bool is_detached_ = false;
};

/// How a channel carries the messages of a type of Python, such as "INT32" or "[]REAL64" (protocols()).
struct Protocol {
    std::function<PortDescription(std::string name, Direction, std::string about)> port;
    std::function<std::vector<std::shared_ptr<ChannelEnd>>(const ProcessEnvironment&, const std::string& port,
                                                           Direction)>
        ends;
};

/// Returns the protocol of this name. Throws UserError for another name, with the names of all.
const Protocol& protocol_named(const std::string& name);

/// A message that is any object of Python. On a link it has the length that its sender states.
struct ObjectMessage {
    SharedObject object;
    std::uint32_t bytes = 4;
    WireForm wire_form() const { return WireForm(bytes); }
};

} // namespace placedpar::python
