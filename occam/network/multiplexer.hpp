#pragma once

#include "occam/language/type.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// Processes in occam that carry messages of other processes between processors.
///
/// A wire that carries several channels in a direction is shared. At each of its ends are these processes, which all
/// are of high priority:
/// - For each channel that leaves, a process takes a message, puts its number into a queue, and takes no other one
///   until the far end has said that the message was taken.
/// - One process outputs what the queue has: messages, and the news that a message was taken here.
/// - One process inputs all this. It never waits for a process of the user, so the wire never stops.
/// - For each channel that arrives, a process outputs the messages to the process that inputs them.
///
/// One message at most is under way on each channel, so the queue has room for all, and no channel waits for another
/// one. The processes share variables: no process of high priority is interrupted between two communications.
namespace placedpar::occam {

struct Program; // occam/language/tree.hpp

inline constexpr int first_input_link = 4; ///< the link words of inputs follow those of outputs

/// A channel of the network, as a process on a node carries it.
struct CarriedChannel {
    std::size_t number = 0;                 ///< in the network
    std::string name;                       ///< in the network
    const ProtocolType* protocol = nullptr; ///< never ANY
    const Program* program = nullptr;       ///< of the process that outputs to it
    std::uint64_t longest_text = 0;         ///< bytes of the texts that this process gets as parameters
};

/// A wire that carries several channels in a direction, as one of its two nodes sees it.
struct SharedWire {
    int link = 0;                                  ///< of the node
    std::vector<CarriedChannel> leaving, arriving; ///< by number
};

/// A process of a text, with the name that reports give it.
struct Component {
    std::string name;
    std::string text;     ///< without indentation
    bool carries = false; ///< it carries messages of other processes
};

/// Texts of occam that belong together.
struct CarrierText {
    std::string protocols;    ///< declarations for all
    std::string declarations; ///< of the variables and channels that the components share
    std::vector<Component> components;
};

/// Returns the lines of a text, moved to the right.
std::string indented(const std::string& text, std::size_t by);

/// Returns how many elements a counted array on the channel has at most: as many as an array of the program has, since
/// an array that a process outputs is one of its arrays, or a part of one.
std::uint64_t longest_array(const CarriedChannel&, const ProtocolItem&);

/// Returns how many kinds of messages a wire has in one of its directions: at most 256 are possible.
std::size_t count_of_messages(const std::vector<CarriedChannel>& with, const std::vector<CarriedChannel>& against);

/// Returns the name of a channel of the network in the text of a node.
std::string name_of_channel(std::size_t number);

/// Returns the processes at one end of a wire. They use the channels by the names of name_of_channel().
CarrierText text_of_shared_wire(const SharedWire&);

/// Returns a process that inputs messages from a channel, and outputs them to another one.
Component text_of_relay(const CarriedChannel&, const std::string& in, const std::string& out);

} // namespace placedpar::occam
