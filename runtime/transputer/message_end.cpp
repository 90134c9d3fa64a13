#include "runtime/transputer/message_end.hpp"

#include "runtime/channel.hpp"
#include "runtime/kernel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace placedpar::transputer {

void MessageEnd::carry(AnyChannel& channel, Transfer& transfer, MessageEnd& end, ByteLane& lane) {
    if (transfer.channel)
        throw std::logic_error(fmt::format("channels {} and {} use the same direction of the link to {}",
                                           transfer.channel->name(), channel.name(), end.partner_));
    if (!channel.byte_form())
        throw std::logic_error(
            fmt::format("messages of channel {} have no form in bytes, which {} moves", channel.name(), end.partner_));
    transfer.channel = &channel;
    lane.wire().carries_bytes_of(channel);
    channel.put_on(end);
}

void MessageEnd::carry_outputs(AnyChannel& channel) { carry(channel, outputs_, *this, *out); }
void MessageEnd::carry_inputs(AnyChannel& channel) { carry(channel, inputs_, *this, *in); }

bool MessageEnd::Transfer::begin(Process& self) noexcept {
    ended = false;
    if (activity == Activity::outputting)
        end.out->give(part);
    else
        end.in->take(part);
    if (ended) // the only byte of the part was here
        return false;
    process = &self;
    self.begin_wait(activity, channel, where);
    return true;
}

void MessageEnd::Transfer::has_ended() {
    ended = true;
    if (Process* waiting = std::exchange(process, nullptr))
        waiting->kernel().make_ready(*waiting);
}

/// Lets the running process move a part of a message, and waits for the end.
void MessageEnd::Transfer::move(AnyChannel& on, std::uint32_t bytes, const SourceLocation& place) {
    if (channel != &on)
        throw std::logic_error(
            fmt::format("channel {} is not the channel of its direction of the link to {}", on.name(), end.partner_));
    part = bytes;
    where = place;
    charge_and_communicate(Kernel::here().running(), &OperationCosts::hard_communication, *this);
}

void MessageEnd::output(AnyChannel& channel, const WireForm& form, const SourceLocation& where) {
    outputs_.message = channel.message_in_bytes();
    bytes_read_ = 0;
    if (form.total() == 0 || std::cmp_not_equal(form.total(), outputs_.message.size()))
        throw std::logic_error(fmt::format("a message of channel {} has {} bytes, but its form on a wire has {}",
                                           channel.name(), outputs_.message.size(), form.total()));
    for (std::size_t part = 0; part < form.parts(); ++part)
        if (form[part] > 0)
            outputs_.move(channel, form[part], where);
    channel.note_taken_by_device();
}

void MessageEnd::input(AnyChannel& channel, const SourceLocation& where) {
    inputs_.message.clear();
    try {
        const AnyByteForm& form = *channel.byte_form();
        while (const std::uint32_t bytes = form.next_part(inputs_.message))
            inputs_.move(channel, bytes, where);
        channel.hand_over(inputs_.message);
    } catch (const NoMessage& what) {
        throw NoMessage(fmt::format("{} sent no message of channel {}, but {}", partner_, channel.name(), what.what()));
    }
}

void MessageEnd::read(std::span<std::uint8_t> to) {
    std::ranges::copy(std::span(outputs_.message).subspan(bytes_read_, to.size()), to.begin());
    bytes_read_ += to.size();
}

void MessageEnd::write(std::span<const std::uint8_t> bytes) {
    inputs_.message.insert(inputs_.message.end(), bytes.begin(), bytes.end());
}

void MessageEnd::byte_waits() {
    if (inputs_.channel)
        inputs_.channel->announce();
}

} // namespace placedpar::transputer
