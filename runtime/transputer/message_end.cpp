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
        throw std::logic_error(fmt::format("messages of channel {} cannot travel as bytes, but {} moves only bytes",
                                           channel.name(), end.partner_));
    transfer.channel = &channel;
    lane.carry_bytes_of(channel);
    channel.put_on(end);
}

void MessageEnd::carry_outputs(AnyChannel& channel) { carry(channel, outputs_, *this, *out); }
void MessageEnd::carry_inputs(AnyChannel& channel) { carry(channel, inputs_, *this, *in); }

bool MessageEnd::Transfer::begin(Process& self) noexcept {
    if (given_up)
        return false;
    ended = false;
    if (activity == Activity::outputting)
        end.out->give(part);
    else
        end.in->take(part);
    if (ended) // the only byte of the part had already arrived
        return false;
    process = &self;
    self.begin_wait(activity, channel, where);
    return true;
}

void MessageEnd::Transfer::has_ended() {
    ended = true;
    moved += part;
    wake();
}

void MessageEnd::Transfer::wake() {
    if (Process* waiting = std::exchange(process, nullptr))
        waiting->kernel().make_ready(*waiting);
}

/// Gives up the message. `of_part` is the number of bytes of the current part that this end has moved.
void MessageEnd::Transfer::give_up(std::uint64_t of_part) {
    given_up = true;
    moved_when_given_up = moved + of_part;
    wake();
}

/// Lets the running process move a part of a message, and waits until the part has been moved.
void MessageEnd::Transfer::move(AnyChannel& on, std::uint32_t bytes, const SourceLocation& place) {
    if (channel != &on)
        throw std::logic_error(fmt::format("channel {} cannot use the link to {}: another channel uses this direction",
                                           on.name(), end.partner_));
    part = bytes;
    where = place;
    charge_and_communicate(Kernel::here().running(), &OperationCosts::hard_communication, *this);
}

void MessageEnd::output(AnyChannel& channel, const WireForm& form, const SourceLocation& where) {
    outputs_.begin_message();
    outputs_.message = channel.message_in_bytes();
    bytes_read_ = 0;
    if (form.total() == 0 || std::cmp_not_equal(form.total(), outputs_.message.size()))
        throw std::logic_error(
            fmt::format("a message of channel {} has {} bytes, but its parts on the wire have {} bytes in all",
                        channel.name(), outputs_.message.size(), form.total()));
    for (std::size_t part = 0; part < form.parts() && !outputs_.given_up; ++part)
        if (form[part] > 0)
            outputs_.move(channel, form[part], where);
    if (!outputs_.given_up)
        channel.note_taken_by_device();
}

void MessageEnd::input(AnyChannel& channel, const SourceLocation& where) {
    inputs_.begin_message();
    inputs_.message.clear();
    try {
        const AnyByteForm& form = *channel.byte_form();
        while (const std::uint32_t bytes = inputs_.given_up ? 0 : form.next_part(inputs_.message))
            inputs_.move(channel, bytes, where);
        if (!inputs_.given_up)
            channel.hand_over(inputs_.message);
    } catch (const NoMessage& what) {
        throw NoMessage(fmt::format("{} sent something other than a message of channel {}: {}", partner_,
                                    channel.name(), what.what()));
    }
}

bool MessageEnd::give_up_output(AnyChannel& channel) {
    if (!channel.output_waits() || outputs_.moved == outputs_.message.size())
        return false;
    out->reset_giving();
    outputs_.give_up(out->wire().reset_output(channel));
    return true;
}

/// Returns whether all bytes of the message have arrived, even if the process has not continued yet.
bool MessageEnd::has_whole_message(const AnyChannel& channel) {
    try {
        return (inputs_.ended || in->store_early()) && channel.byte_form()->next_part(inputs_.message) == 0;
    } catch (const NoMessage&) {
        return true;
    }
}

bool MessageEnd::give_up_input(AnyChannel& channel) {
    if (!channel.input_waits() || has_whole_message(channel))
        return false;
    const bool has_part = in->store_early();
    const std::uint32_t arrived = in->reset_taking();
    inputs_.give_up(has_part ? inputs_.part : arrived);
    return true;
}

std::uint64_t MessageEnd::reset_input(AnyChannel&) {
    const std::uint64_t came = in->reset_taking();
    return std::max(std::exchange(inputs_.moved_when_given_up, 0), came);
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
