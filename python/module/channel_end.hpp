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

/// An end of a channel that a process in Python uses. A message passes between Python, which needs Python's global
/// lock, and the channel, which must be used without the lock. In between, this object holds the message. A Python
/// variable may refer to the end even after its process has ended.
class ChannelEnd {
public:
    ChannelEnd(std::string port, Direction direction) : port_(std::move(port)), direction_(direction) {}
    virtual ~ChannelEnd() = default;
    /// Ends the use of the channel. Call this function when the process ends.
    void detach() { is_detached_ = true; }
    /// Throws UserError if the process that uses this end has ended.
    void require_attached() const;
    /// Throws pybind11::type_error for an end of the other direction, and UserError if the process has ended.
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

/// Describes how a channel carries messages of one type, such as "INT32" or "[]REAL64". protocol_named() knows these
/// types.
struct Protocol {
    std::function<PortDescription(std::string name, Direction, std::string about)> port;
    std::function<std::vector<std::shared_ptr<ChannelEnd>>(const ProcessEnvironment&, const std::string& port,
                                                           Direction)>
        ends;
};

/// Returns the protocol of this name. Throws UserError for an unknown name. The message lists all names.
const Protocol& protocol_named(const std::string& name);

/// A message that is any Python object. The sender states how many bytes the message has on a link, for the simulated
/// time of the transfer.
struct ObjectMessage {
    SharedObject object;
    std::uint32_t bytes = 4;
    WireForm wire_form() const { return WireForm(bytes); }
};

} // namespace placedpar::python
