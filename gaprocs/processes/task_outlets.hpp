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

/// How a master sends over several channels to slaves.
enum class Sending {
    in_turn, ///< one message after the other: the master waits until each is gone
    at_once  ///< a process of high priority for each channel sends, while the master makes the next message ready
};

/// A master's channels to its slaves.
class TaskOutlets {
public:
    TaskOutlets(std::vector<Output<Task>> channels, Sending sending)
        : channels_(std::move(channels)), sending_(sending) {}

    std::size_t count() const { return channels_.size(); }
    /// Runs the body, in which send() may be called, and waits until all is gone.
    void during(const std::function<void()>& body, const SourceLocation& = SourceLocation::current());
    void send(std::size_t channel, Task);

private:
    using Handed = InPlace<std::optional<Task>>; ///< empty: the last

    void send_all_handed(std::size_t channel);

    std::vector<Output<Task>> channels_;
    Sending sending_;
    std::vector<Channel<Handed>*> handed_; ///< to the process that sends, by channel
};

} // namespace placedpar
