#pragma once

#include "occam/language/type.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// Makes the text of processes in occam that pass messages of other processes between processors.
///
/// A shared wire is a wire that carries several channels in one of its directions. At each end of a shared wire run the
/// following processes, all at high priority:
/// - For each channel that leaves, a process inputs a message and puts the channel's number into a queue. It inputs the
///   next message only after the far end has reported that the previous message was taken.
/// - One process outputs the messages in the queue, and reports that messages were taken at this end.
/// - One process inputs the messages and reports from the far end. It never waits for a process of the user, so no
///   message on the wire waits for such a process.
/// - For each channel that arrives, a process outputs the messages to the receiving process.
///
/// Each channel has at most one message under way. The queue therefore has room for all messages, and no channel waits
/// for another channel. The processes share variables safely, since a process of high priority is not interrupted
/// between two communications.
namespace placedpar::occam {

struct Program; // occam/language/tree.hpp

inline constexpr int first_input_link =
    4; ///< word of memory that is the input of link 0; words 0 to 3 are the outputs of the links

/// Describes a channel of the network whose messages such processes pass on.
struct CarriedChannel {
    std::size_t number = 0;                 ///< index in Network::channels
    std::string name;                       ///< name in the network
    const ProtocolType* protocol = nullptr; ///< never ANY
    const Program* program = nullptr;       ///< program of the process that outputs to the channel
    std::uint64_t longest_text =
        0; ///< length in bytes of the longest text that the netlist gives to this process as a parameter
};

/// Describes a shared wire as seen from one of its two nodes.
struct SharedWire {
    int link = 0;                                  ///< number of the node's link
    std::vector<CarriedChannel> leaving, arriving; ///< in ascending order of number
};

/// Holds the text of a process, and its name in reports.
struct Component {
    std::string name;
    std::string text;     ///< in occam, without indentation
    bool carries = false; ///< the process only passes on messages of other processes
};

/// Holds the text of the processes at one end of a shared wire, in occam.
struct CarrierText {
    std::string protocols;    ///< declarations of protocols
    std::string declarations; ///< declarations of variables and channels that the components share
    std::vector<Component> components;
};

/// Returns the text with each line moved to the right by `by` blanks.
std::string indented(const std::string& text, std::size_t by);

/// Returns the greatest possible length of a counted array on the channel, for the size of a buffer. The result is the
/// length of the longest array in the sender's program, since a process outputs one of its arrays, or a part of it.
std::uint64_t longest_array(const CarriedChannel&, const ProtocolItem&);

/// Returns the number of kinds of messages that a wire carries in one direction: those of the channels in this
/// direction (`with`), and the reports that messages of the other direction (`against`) were taken. At most 256 kinds
/// are possible, since a byte tells the kind.
std::size_t count_of_messages(const std::vector<CarriedChannel>& with, const std::vector<CarriedChannel>& against);

/// Returns the name of a channel of the network in these texts. `number` is its index in Network::channels.
std::string name_of_channel(std::size_t number);

/// Returns the processes at one end of a shared wire. They refer to channels by name_of_channel().
CarrierText text_of_shared_wire(const SharedWire&);

/// Returns a process that inputs the messages of a channel from `in` and outputs them to `out`.
Component text_of_relay(const CarriedChannel&, const std::string& in, const std::string& out);

} // namespace placedpar::occam
