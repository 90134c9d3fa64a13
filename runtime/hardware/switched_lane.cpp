#include "runtime/hardware/switched_lane.hpp"

#include "runtime/channel.hpp"
#include "runtime/hardware/link.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace placedpar::hardware {

namespace {

/// Reserves a link engine (an end of a link direction) for a channel, as long as the object exists.
class EngineInUse {
public:
    EngineInUse(SharedEngine& engine, const AnyChannel& channel) : engine_(engine) {
        if (engine.channel)
            throw std::logic_error(fmt::format(
                "channels {} and {} use {} at the same time: a switch connects a link to only one partner at a time",
                engine.channel->name(), channel.name(), engine.name));
        engine.channel = &channel;
    }
    ~EngineInUse() { engine_.channel = nullptr; }
    EngineInUse(const EngineInUse&) = delete;
    EngineInUse& operator=(const EngineInUse&) = delete;

private:
    SharedEngine& engine_;
};

} // namespace

void SwitchedLane::output(AnyChannel& channel, const WireForm& form, const SourceLocation& where) {
    EngineInUse use(sender_, channel);
    direction_.output(channel, form, where);
}

void SwitchedLane::input(AnyChannel& channel, const SourceLocation& where) {
    EngineInUse use(receiver_, channel);
    direction_.input(channel, where);
}

bool SwitchedLane::message_waits(const AnyChannel& channel) const { return direction_.message_waits(channel); }

bool SwitchedLane::output_is_lost(const AnyChannel& channel) const { return direction_.output_is_lost(channel); }

bool SwitchedLane::input_is_lost(const AnyChannel& channel) const { return direction_.input_is_lost(channel); }

bool SwitchedLane::output_must_be_reset(const AnyChannel& channel) const {
    return direction_.output_must_be_reset(channel);
}

bool SwitchedLane::input_must_be_reset(const AnyChannel& channel) const {
    return direction_.input_must_be_reset(channel);
}

bool SwitchedLane::give_up_output(AnyChannel& channel) { return direction_.give_up_output(channel); }

bool SwitchedLane::give_up_input(AnyChannel& channel) { return direction_.give_up_input(channel); }

std::uint64_t SwitchedLane::reset_output(AnyChannel& channel) { return direction_.reset_output(channel); }

std::uint64_t SwitchedLane::reset_input(AnyChannel& channel) { return direction_.reset_input(channel); }

} // namespace placedpar::hardware
