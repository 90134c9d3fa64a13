#pragma once

#include "runtime/carrier.hpp"

#include <string>

namespace placedpar {
class Kernel;
} // namespace placedpar

namespace placedpar::hardware {

class LinkDirection;

/// One engine of a processor's link, which a switch leads to one partner after the other. It is in one message at a
/// time: whose?
struct SharedEngine {
    std::string name; ///< of the link, for messages
    const AnyChannel* channel = nullptr;
};

/// A direction of a link that leads through a switch set during the run, so that other links have the same engines at
/// their ends. Throws std::logic_error when a process uses an engine that is in a message of another channel: on the
/// machine these would be one channel, of one process.
class SwitchedLane final : public Carrier {
public:
    /// REQUIRES: they outlive it.
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
