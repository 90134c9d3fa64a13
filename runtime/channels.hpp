#pragma once

#include "runtime/channel.hpp"

#include <cstddef>
#include <deque>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

/// occam's `[n]CHAN OF T`. It moves, into a container or out of a function; its channels stay where they are, so that
/// their ends remain theirs, and what it has been moved from is an array of none.
template <class T>
class Channels {
public:
    /// Of none.
    Channels() = default;
    /// "name[0]" to "name[count - 1]".
    Channels(const std::string& name, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i)
            channels_.emplace_back(element(name, i));
    }
    /// Hard channels, one on each carrier, such as a direction of each link. The carriers outlive them.
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
    /// Throws std::out_of_range where there is none, as occam's subscripts are checked.
    Channel<T>& operator[](std::size_t i) { return channels_.at(i); }
    auto begin() { return channels_.begin(); }
    auto end() { return channels_.end(); }

    /// All ends, as a replicated ALT, or a process that has them, takes them.
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
    /// The ends of channels that are gone at the end of the statement.
    std::vector<Input<T>> in() && = delete;
    std::vector<Output<T>> out() && = delete;

private:
    static std::string element(const std::string& name, std::size_t i) { return name + "[" + std::to_string(i) + "]"; }

    std::deque<Channel<T>> channels_;
};

} // namespace placedpar
