#pragma once

#include "runtime/channel.hpp"

#include <cstddef>
#include <deque>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

/// An array of channels: occam's `[n]CHAN OF T`. The array can be moved, and the ends of its channels stay valid. An
/// array that was moved from is empty.
template <class T>
class Channels {
public:
    Channels() = default;
    /// Makes the channels "name[0]" to "name[count - 1]".
    Channels(const std::string& name, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i)
            channels_.emplace_back(element(name, i));
    }
    /// Makes one hard channel on each carrier, such as a direction of a link. REQUIRES: the carriers outlive the array.
    Channels(const std::string& name, const std::vector<std::reference_wrapper<Carrier>>& on) {
        for (std::size_t i = 0; i < on.size(); ++i)
            channels_.emplace_back(element(name, i), on[i].get());
    }
    Channels(Channels&& other) : channels_(std::move(other.channels_)) { other.channels_.clear(); }
    Channels& operator=(Channels&& other) {
        channels_ = std::move(other.channels_);
        other.channels_.clear();
        return *this;
    }
    Channels(const Channels&) = delete;
    Channels& operator=(const Channels&) = delete;
    ~Channels() = default;

    std::size_t size() const { return channels_.size(); }
    /// Returns the channel with this subscript. Throws std::out_of_range if the subscript is too large; occam checks
    /// subscripts, too.
    Channel<T>& operator[](std::size_t i) { return channels_.at(i); }
    auto begin() { return channels_.begin(); }
    auto end() { return channels_.end(); }

    /// Returns the ends of all channels, for a replicated ALT or a process.
    std::vector<Input<T>> in() & {
        std::vector<Input<T>> ends;
        for (Channel<T>& each : channels_)
            ends.push_back(each.in());
        return ends;
    }
    std::vector<Output<T>> out() & {
        std::vector<Output<T>> ends;
        for (Channel<T>& each : channels_)
            ends.push_back(each.out());
        return ends;
    }
    // Deleted, because a temporary array's channels are destroyed at the end of the statement.
    std::vector<Input<T>> in() && = delete;
    std::vector<Output<T>> out() && = delete;

private:
    static std::string element(const std::string& name, std::size_t i) { return name + "[" + std::to_string(i) + "]"; }

    std::deque<Channel<T>> channels_;
};

} // namespace placedpar
