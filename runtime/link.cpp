#include "runtime/link.hpp"

#include "runtime/channel.hpp"
#include "runtime/instructions.hpp"
#include "runtime/kernel.hpp"
#include "runtime/processor.hpp"

#include <utility>

namespace placedpar {

namespace {

/// The part of a message that ends it on the wire; an empty part does not travel.
std::size_t last_travelling_part(const WireForm& form) {
    std::size_t part = form.parts() - 1;
    while (part > 0 && form[part] == 0)
        --part;
    return part;
}

} // namespace

Link::Link(Kernel& kernel, const LinkTiming& timing)
    : timing_(timing), wire_from_a_(kernel, timing_), wire_from_b_(kernel, timing_),
      a_to_b_(kernel, timing_, wire_from_a_, wire_from_b_), b_to_a_(kernel, timing_, wire_from_b_, wire_from_a_) {}

LinkDirection::LinkDirection(Kernel& kernel, const LinkTiming& timing, Wire& out, Wire& back)
    : kernel_(kernel), timing_(timing), out_(out), back_(back) {}

void LinkDirection::schedule(Event& event, Time at) { kernel_.future().schedule(event, at, EventQueue::wire); }

void LinkDirection::output(AnyChannel& channel, const WireForm& form, const std::source_location& where) {
    channel_ = &channel;
    std::size_t last = last_travelling_part(form);
    for (std::size_t part = 0; part <= last; ++part)
        if (form[part] > 0) {
            charge_channel_call();
            send(form[part], part == last, where);
        }
}

void LinkDirection::input(AnyChannel& channel, const std::source_location& where) {
    channel_ = &channel;
    bool last;
    do {
        charge_channel_call();
        last = receive(where);
    } while (!last);
}

void LinkDirection::send(std::uint32_t bytes, bool last_part, const std::source_location& where) {
    sender_ = &kernel_.running();
    bytes_in_part_ = bytes_left_ = bytes;
    last_part_ = last_part;
    taken_ = false;
    ++part_;
    began_ = kernel_.now();
    if (kernel_.now() >= may_start_)
        start_byte();
    else
        schedule(start_byte_, may_start_);
    sender_->wait_for(Activity::outputting, channel_, where);
}

bool LinkDirection::receive(const std::source_location& where) {
    receiver_ = &kernel_.running();
    bool first_byte_here = std::exchange(first_byte_waits_, false);
    if (std::exchange(acknowledge_owed_, false))
        back_.ask_for_acknowledge(*this);
    if (first_byte_here && bytes_left_ == 0) {
        take_part();
        receiver_ = nullptr;
    } else {
        receiver_->wait_for(Activity::inputting, channel_, where);
    }
    return took_last_part_;
}

/// From here on the receiver is sure to get the whole part, and the sender's copy is not needed.
void LinkDirection::take_part() {
    if (std::exchange(taken_, true))
        return;
    took_last_part_ = last_part_;
    if (last_part_)
        channel_->hand_over();
}

void LinkDirection::start_byte() { out_.ask_for_byte(*this); }

void LinkDirection::byte_started() {
    Time seen = kernel_.now() + timing_.wire_delay;
    schedule(byte_noticed_, seen + timing_.acknowledge_latency());
    if (bytes_left_ == bytes_in_part_) {
        kernel_.future().cancel(first_byte_arrived_); // of a part that was taken: it changes nothing
        schedule(first_byte_arrived_, seen + timing_.data());
    }
    if (--bytes_left_ == 0) {
        LastByte& arrival = last_byte_arrived_[part_ % 2];
        arrival.part = part_;
        schedule(arrival, seen + timing_.data());
    }
    ++bytes_carried_;
}

void LinkDirection::byte_noticed() {
    if (receiver_)
        back_.ask_for_acknowledge(*this);
    else
        acknowledge_owed_ = true;
}

void LinkDirection::first_byte_arrived() {
    if (!receiver_) {
        first_byte_waits_ = true;
        channel_->announce();
    }
}

void LinkDirection::last_byte_arrived(std::uint32_t part) {
    if (receiver_) {
        if (part == part_) // else its acknowledge is under way: the sender has begun the next part
            take_part();
        kernel_.make_ready(*std::exchange(receiver_, nullptr));
    }
}

void LinkDirection::acknowledge_started() {
    Time seen = kernel_.now() + timing_.wire_delay;
    may_start_ = seen + timing_.restart_latency();
    if (bytes_left_ > 0) {
        schedule(start_byte_, may_start_);
    } else {
        take_part();
        schedule(sending_ended_, seen + timing_.acknowledge());
    }
}

void LinkDirection::sending_ended() {
    time_occupied_ += kernel_.now() - began_;
    kernel_.make_ready(*sender_);
}

} // namespace placedpar
