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
    in_turn, ///< one message after another: the master waits until each message has been sent
    at_once  ///< a process of high priority sends on each channel, while the master prepares the next message
};

/// A master's channels to its slaves.
class TaskOutlets {
public:
    TaskOutlets(std::vector<Output<Task>> channels, Sending sending)
        : channels_(std::move(channels)), sending_(sending) {}

    std::size_t count() const { return channels_.size(); }
    /// Runs the body, which may call send(). Returns when all tasks have been sent.
    void during(const std::function<void()>& body, const SourceLocation& = SourceLocation::current());
    void send(std::size_t channel, Task);

private:
    using Handed = InPlace<std::optional<Task>>; ///< empty: no more tasks

    void send_all_handed(std::size_t channel);

    std::vector<Output<Task>> channels_;
    Sending sending_;
    std::vector<Channel<Handed>*> handed_; ///< channels to the sending processes, by channel to slaves
};

} // namespace placedpar
