#include "runtime/transputer/byte_lane.hpp"

#include "runtime/channel.hpp"

#include <algorithm>
#include <array>

namespace placedpar::transputer {

ByteLane::ByteLane(hardware::LinkDirection& wire, ByteEnd& source, ByteEnd& sink)
    : wire_(wire), source_(source), sink_(sink) {
    wire_.move_by_counts(*this, *this);
    source_.out = this;
    sink_.in = this;
}

void ByteLane::carry_bytes_of(AnyChannel& channel) {
    wire_.carries_bytes_of(channel);
    channel_ = &channel;
}

const std::string& ByteLane::name() const { return channel_ ? channel_->name() : wire_.name(); }

void ByteLane::give(std::uint32_t bytes) {
    gives_ = true;
    to_give_ = bytes;
    wire_.give(bytes);
}

void ByteLane::take(std::uint32_t bytes) {
    takes_ = true;
    to_take_ = bytes;
    wire_.take(bytes);
}

void ByteLane::reset_giving() {
    move(std::min({wire_.reset_giving(), to_give_, to_take_}));
    gives_ = false;
    to_give_ = 0;
}

std::uint32_t ByteLane::reset_taking() {
    const std::uint32_t arrived = wire_.reset_taking();
    move(std::min({arrived, to_give_, to_take_}));
    takes_ = false;
    to_take_ = 0;
    return arrived;
}

bool ByteLane::store_early() {
    if (!wire_.is_taken())
        return false;
    move(to_take_);
    return true;
}

void ByteLane::move(std::uint32_t bytes) {
    std::array<std::uint8_t, 1024> buffer;
    to_give_ -= bytes;
    to_take_ -= bytes;
    while (bytes > 0) {
        const std::span<std::uint8_t> some{buffer.data(), std::min<std::size_t>(bytes, buffer.size())};
        source_.read(some);
        sink_.write(some);
        bytes -= static_cast<std::uint32_t>(some.size());
    }
}

// The acknowledge of a byte may arrive before the whole byte has been sent. In this case, sent() stores the byte
// slightly too early.
void ByteLane::sent() {
    move(to_give_);
    gives_ = false;
    source_.given();
}

void ByteLane::taken() {
    move(to_take_);
    takes_ = false;
    sink_.taken();
}

} // namespace placedpar::transputer
