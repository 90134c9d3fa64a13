#pragma once

#include "gaprocs/processes/messages.hpp"
#include "runtime/channel.hpp"
#include "runtime/source_location.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace placedpar {

/// The order in which a master sends over its channels to slaves.
enum class Sending {
    in_turn, ///< the master sends one message after another
    at_once  ///< each channel has a sending process of high priority, so the master can prepare the next message during
             ///< the transfer
};

/// A master's channels to its slaves, for sending tasks (strings to be evaluated).
class TaskOutlets {
public:
    TaskOutlets(std::vector<Output<Task>> channels, Sending sending)
        : channels_(std::move(channels)), sending_(sending) {}

    std::size_t count() const { return channels_.size(); }
    /// Runs `body`, which calls send(). Returns when all tasks have been sent. REQUIRES: only `body` calls send().
    void during(const std::function<void()>& body, const SourceLocation& = SourceLocation::current());
    void send(std::size_t channel, Task);

private:
    using Handed = InPlace<std::optional<Task>>; ///< an absent task ends the sending process

    void send_all_handed(std::size_t channel);

    std::vector<Output<Task>> channels_;
    Sending sending_;
    std::vector<Channel<Handed>*> handed_; ///< channels from the master to the sending processes
};

} // namespace placedpar
