#pragma once

#include "runtime/protocol.hpp"
#include "runtime/source_location.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace placedpar {

class AnyChannel;
class Process;

/// Carries the messages of hard channels from one processor to another. Examples are a direction of a link, a route of
/// packets over several links, and a buffer in the memory of a bus master. output() and input() return when the calling
/// process can continue. Each call makes the process compute for the cycles OperationCosts::hard_communication.
class Carrier {
public:
    virtual ~Carrier() = default;

    /// Sends the message that waits in the channel. REQUIRES: called by the outputting process.
    virtual void output(AnyChannel&, const WireForm&, const SourceLocation&) = 0;
    /// Receives a message into the slot of the process that waits in the channel. REQUIRES: called by the inputting
    /// process.
    virtual void input(AnyChannel&, const SourceLocation&) = 0;
    /// Returns whether a message has begun to arrive while no process is inputting it.
    virtual bool message_waits(const AnyChannel&) const = 0;
    /// Reserves the waiting message for the next input, because an ALT has chosen it. Returns false if the sender has
    /// given up the message in the meantime. Only a carrier between threads returns false.
    virtual bool keep_message(const AnyChannel&) { return true; }

    // The next functions are for reports.
    /// Return whether the process in output (input) can never continue. A part of the message was lost, or one of the
    /// two processes has given up the message.
    virtual bool output_is_lost(const AnyChannel&) const { return false; }
    virtual bool input_is_lost(const AnyChannel&) const { return false; }
    /// Return whether the other end has given up a message that this end is still transferring. Nothing is transferred
    /// until this end, too, gives up the message and is reset.
    virtual bool output_must_be_reset(const AnyChannel&) const { return false; }
    virtual bool input_must_be_reset(const AnyChannel&) const { return false; }
    /// Returns the channels that keep an outputting process waiting although its partner inputs. They belong to the
    /// same broadcast, which sends one message on several channels. On these channels the message has not been output,
    /// or the receiver does not input it.
    virtual std::vector<const AnyChannel*> held_up_by(const AnyChannel&) const { return {}; }
    /// Returns the name of a device that uses one end of the channel in place of a process; "" if processes use both.
    virtual std::string partner_device() const { return ""; }

    // The next functions are for carriers whose messages can be given up (runtime/recovery.hpp).
    /// Returns the reason why messages cannot be given up, or "" if they can. The text follows the channel's name, as
    /// in "travels in packets".
    virtual std::string why_not_given_up() const { return "is on a connection that transfers only whole messages"; }
    /// Make the process in output (input) continue without its message. Return false and do nothing if the process's
    /// part of the transfer is already complete. REQUIRES: called by an event, while a process is in output (input).
    virtual bool give_up_output(AnyChannel&) { return false; }
    virtual bool give_up_input(AnyChannel&) { return false; }
    /// Clear the end after its message was given up. Return how many bytes of the message this end has transferred.
    /// REQUIRES: no process is in output (input) at this end.
    virtual std::uint64_t reset_output(AnyChannel&) { return 0; }
    virtual std::uint64_t reset_input(AnyChannel&) { return 0; }
};

} // namespace placedpar
