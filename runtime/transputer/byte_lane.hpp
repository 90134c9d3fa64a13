#pragma once

#include "runtime/hardware/link.hpp"

#include <cstdint>
#include <span>

namespace placedpar::transputer {

class ByteLane;

/// An end of a link that moves bytes, as the user of the link implements it. The user is an emulated transputer, a
/// host, or a MessageEnd, at which C++ processes exchange messages with a transputer's code. An end calls
/// ByteLane::give(n) and take(n) to offer or request n bytes. The functions must not wait or throw.
class ByteEnd {
public:
    /// Copies the next bytes that this end has offered by give() into the span.
    virtual void read(std::span<std::uint8_t>) = 0;
    /// Called when all bytes of give() have been acknowledged.
    virtual void given() = 0;
    /// Stores the next bytes that this end has requested by take().
    virtual void write(std::span<const std::uint8_t>) = 0;
    /// Called when all bytes of take() have arrived.
    virtual void taken() = 0;
    /// Called when a byte has arrived while no take() was under way.
    virtual void byte_waits() = 0;

    /// The lanes that lead from and to this end; null if nothing is connected.
    ByteLane *out = nullptr, *in = nullptr;

protected:
    ~ByteEnd() = default;
};

/// Carries the contents of bytes over one direction of a link. hardware::LinkDirection simulates only the times. The
/// contents are moved when all bytes of a give() or of a take() have been transferred.
class ByteLane final : private hardware::ByteUser {
public:
    /// Leads from `source` to `sink`, and sets source.out and sink.in. REQUIRES: the run has not begun; the arguments
    /// outlive the run. Throws the exceptions of LinkDirection::move_by_counts.
    ByteLane(hardware::LinkDirection&, ByteEnd& source, ByteEnd& sink);
    ByteLane(const ByteLane&) = delete;
    ByteLane& operator=(const ByteLane&) = delete;

    /// Offer (request) bytes for the end at which they are called. Throw the exceptions of LinkDirection::give (take).
    void give(std::uint32_t bytes);
    void take(std::uint32_t bytes);
    /// Cancels the rest of the current give(): see LinkDirection::reset_giving.
    void reset_giving();
    /// Cancels the rest of the current take(). Returns how many of its bytes had arrived; 0 without a current take().
    std::uint32_t reset_taking();
    /// Stores the bytes of take() at the receiver if all of them have been sent, although the last bits may still be on
    /// the wire. Returns whether the bytes were stored.
    bool store_early();
    bool has_byte() const { return wire_.byte_waits(); }
    bool is_giving() const { return gives_; }
    bool is_taking() const { return takes_; }
    /// States that the bytes are messages of this channel, which the trace and reports then name.
    void carry_bytes_of(AnyChannel&);
    /// Returns the name of the channel whose messages travel here; without a channel, the name of the direction.
    const std::string& name() const;
    hardware::LinkDirection& wire() { return wire_; }

private:
    void move(std::uint32_t bytes);
    void sent() override;
    void taken() override;
    void byte_waits() override { sink_.byte_waits(); }

    hardware::LinkDirection& wire_;
    ByteEnd &source_, &sink_;
    const AnyChannel* channel_ = nullptr;     ///< the channel whose messages travel here; null if none does
    std::uint32_t to_give_ = 0, to_take_ = 0; ///< bytes of give() and of take() that have not been moved
    bool gives_ = false, takes_ = false;
};

/// A link between two ends that offer and request bytes: a ByteLane for each direction.
struct ByteLink {
    ByteLink(hardware::Link& link, ByteEnd& a, ByteEnd& b)
        : there(link.from_a_to_b(), a, b), back(link.from_b_to_a(), b, a) {}
    ByteLane there, back;
};

} // namespace placedpar::transputer
