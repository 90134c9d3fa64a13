#pragma once

#include "runtime/hardware/link.hpp"

#include <cstdint>
#include <span>

namespace placedpar::transputer {

class ByteLane;

/// An end of a link that gives and takes bytes by counts: a node, a host, a process that inputs messages. The functions
/// must not wait or throw.
class ByteEnd {
public:
    /// Copies the next bytes of give().
    virtual void read(std::span<std::uint8_t>) = 0;
    /// Called when all bytes of give() have been acknowledged.
    virtual void given() = 0;
    /// Stores the next requested bytes.
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

/// One direction of a link, with the contents of its bytes. The wire moves bytes by the counts of both ends
/// (LinkDirection::give and take). The contents are moved when a count is done.
class ByteLane final : private hardware::ByteUser {
public:
    /// Leads from `source` to `sink`, and becomes a lane of both. REQUIRES: the run has not begun; the arguments
    /// outlive the run. Throws the exceptions of LinkDirection::move_by_counts.
    ByteLane(hardware::LinkDirection&, ByteEnd& source, ByteEnd& sink);
    ByteLane(const ByteLane&) = delete;
    ByteLane& operator=(const ByteLane&) = delete;

    /// Call LinkDirection::give (take) and throw its exceptions.
    void give(std::uint32_t bytes);
    void take(std::uint32_t bytes);
    /// Cancel the bytes that this end still has to give or take: see LinkDirection::reset_giving.
    void reset_giving();
    /// Returns how many bytes of the current count had arrived; 0 if there is none.
    std::uint32_t reset_taking();
    /// Stores the bytes of take() if the receiver has all of them, although the last bits may still be on the wire.
    /// Returns whether the bytes were stored.
    bool store_early();
    bool has_byte() const { return wire_.byte_waits(); }
    bool is_giving() const { return gives_; }
    bool is_taking() const { return takes_; }
    /// States that the bytes are messages of this channel (LinkDirection::carries_bytes_of).
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
    std::uint32_t to_give_ = 0, to_take_ = 0; ///< bytes of the counts that have not been moved
    bool gives_ = false, takes_ = false;
};

/// A link whose two ends move bytes by counts.
struct ByteLink {
    ByteLink(hardware::Link& link, ByteEnd& a, ByteEnd& b)
        : there(link.from_a_to_b(), a, b), back(link.from_b_to_a(), b, a) {}
    ByteLane there, back;
};

} // namespace placedpar::transputer
