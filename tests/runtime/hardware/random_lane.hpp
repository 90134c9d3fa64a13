#pragma once

#include "runtime/channel.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace placedpar::test {

/// A message of up to three parts.
struct Letter {
    int number = 0;
    std::uint32_t head = 0, body = 1, tail = 0;
    WireForm wire_form() const { return WireForm(head, body, tail); }
};

/// A channel of a random machine, with the numbers of its letters: letters that the sender knows to be sent, and
/// letters received.
struct Lane {
    Lane(const std::string& name, bool can_be_given_up_)
        : channel(name), output_fails(name + " output fails"), input_fails(name + " input fails"),
          can_be_given_up(can_be_given_up_) {}
    /// Returns whether all sent letters arrived once and in order. The last letter may be missing, since its receiver
    /// may not have looked for it.
    bool is_whole() const;

    Channel<Letter> channel;
    Channel<int> output_fails, input_fails; ///< soft channels; a message on one ends an attempt
    bool can_be_given_up, failures_are_told = false;
    std::vector<int> gone, came;
};

} // namespace placedpar::test
