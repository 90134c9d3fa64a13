#pragma once

#include "runtime/carrier.hpp"

#include <string>

namespace placedpar {
class Kernel;
} // namespace placedpar

namespace placedpar::hardware {

class LinkDirection;

/// One engine of a processor's link. A switch connects it with different partners, one after another. It carries one
/// message at a time, and stores the channel of this message.
struct SharedEngine {
    std::string name; ///< name of the link in error messages
    const AnyChannel* channel = nullptr;
};

/// A direction of a link through a switch. The switch is set during the run, so other links share the engines at the
/// ends of this link. Throws std::logic_error if a process uses an engine while it carries a message of another
/// channel. On the real machine these channels would be one channel, with one process at each end.
class SwitchedLane final : public Carrier {
public:
    /// REQUIRES: the arguments outlive the lane.
    SwitchedLane(Kernel&, LinkDirection& direction, SharedEngine& sender, SharedEngine& receiver)
        : direction_(direction), sender_(sender), receiver_(receiver) {}

    void output(AnyChannel&, const WireForm&, const SourceLocation&) override;
    void input(AnyChannel&, const SourceLocation&) override;
    bool message_waits(const AnyChannel&) const override;
    bool output_is_lost(const AnyChannel&) const override;
    bool input_is_lost(const AnyChannel&) const override;
    bool output_must_be_reset(const AnyChannel&) const override;
    bool input_must_be_reset(const AnyChannel&) const override;
    std::string why_not_given_up() const override { return ""; }
    bool give_up_output(AnyChannel&) override;
    bool give_up_input(AnyChannel&) override;
    std::uint64_t reset_output(AnyChannel&) override;
    std::uint64_t reset_input(AnyChannel&) override;

private:
    LinkDirection& direction_;
    SharedEngine &sender_, &receiver_;
};

} // namespace placedpar::hardware
