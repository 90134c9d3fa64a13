#pragma once

#include "occam/language/type.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// Makes processes in occam that carry messages of other processes between processors.
///
/// A wire that carries several channels in one direction is shared. At each end of a shared wire run the following
/// processes, all at high priority:
/// - For each channel that leaves, a process inputs a message and puts the channel's number into a queue. It inputs the
///   next message after the far end has reported that the message was taken.
/// - One process outputs the messages in the queue, and reports that messages were taken at this end.
/// - One process inputs the messages and reports from the far end. It never waits for a process of the user, so the
///   wire never stops.
/// - For each channel that arrives, a process outputs the messages to the receiving process.
///
/// Each channel has at most one message under way. The queue therefore has room for all of them, and no channel waits
/// for another channel. The processes share variables safely, since a process of high priority is not interrupted
/// between two communications.
namespace placedpar::occam {

struct Program; // occam/language/tree.hpp

inline constexpr int first_input_link = 4; ///< memory word of the input of link 0; words 0 to 3 are the outputs

/// Describes a channel of the network that processes on a node carry.
struct CarriedChannel {
    std::size_t number = 0;                 ///< index in Network::channels
    std::string name;                       ///< name in the network
    const ProtocolType* protocol = nullptr; ///< never ANY
    const Program* program = nullptr;       ///< program of the process that outputs to the channel
    std::uint64_t longest_text = 0;         ///< bytes of the texts that are parameters of this process
};

/// Describes a shared wire from the view of one of its two nodes.
struct SharedWire {
    int link = 0;                                  ///< number of the node's link
    std::vector<CarriedChannel> leaving, arriving; ///< in ascending order of number
};

/// Describes a process in the text, and its name in reports.
struct Component {
    std::string name;
    std::string text;     ///< text of the process, without indentation
    bool carries = false; ///< it carries messages of other processes
};

/// Holds the parts of a text in occam.
struct CarrierText {
    std::string protocols;    ///< declarations of the protocols for all processes
    std::string declarations; ///< declarations of the variables and channels that the components share
    std::vector<Component> components;
};

/// Returns the text with each line moved to the right by `by` blanks.
std::string indented(const std::string& text, std::size_t by);

/// Returns the greatest possible length of a counted array on the channel: the length of the longest array in the
/// program, since a process outputs one of its arrays, or a part of one.
std::uint64_t longest_array(const CarriedChannel&, const ProtocolItem&);

/// Returns the number of kinds of messages that a wire carries in one direction; at most 256 are possible.
std::size_t count_of_messages(const std::vector<CarriedChannel>& with, const std::vector<CarriedChannel>& against);

/// Returns the name that the texts of nodes give to a channel of the network.
std::string name_of_channel(std::size_t number);

/// Returns the processes at one end of a wire. They refer to channels by name_of_channel().
CarrierText text_of_shared_wire(const SharedWire&);

/// Returns a process that inputs messages from a channel, and outputs them to another channel.
Component text_of_relay(const CarriedChannel&, const std::string& in, const std::string& out);

} // namespace placedpar::occam
