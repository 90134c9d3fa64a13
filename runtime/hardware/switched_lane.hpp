#pragma once

#include "runtime/carrier.hpp"

#include <string>

namespace placedpar {
class Kernel;
} // namespace placedpar

namespace placedpar::hardware {

class LinkDirection;

/// One end of a link at a processor, for one direction, if a switch connects it with different partners, one after
/// another. `channel` is the channel of the message that the link engine moves now; null if there is none.
struct SharedEngine {
    std::string name; ///< name of the link in error messages
    const AnyChannel* channel = nullptr;
};

/// Carries messages over a direction of a link that leads through a switch. The switch is set during the run, so a link
/// engine serves several simulated links, one for each partner. Throws std::logic_error if a process uses an engine
/// while it moves a message of another channel.
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
