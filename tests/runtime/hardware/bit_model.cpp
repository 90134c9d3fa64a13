#include "bit_model.hpp"

#include <algorithm>
#include <stdexcept>

namespace placedpar::test {

namespace {
std::int64_t whole_ns(Time t) { return t.count() / 1000; }

/// Returns the transfers of the sender (or the receiver) for the messages.
std::vector<Traffic::Transfer> transfers_of(const std::vector<Traffic::Message>& messages, bool sender) {
    std::vector<Traffic::Transfer> transfers;
    for (const auto& message : messages)
        for (std::size_t part = 0; part < message.parts.size(); ++part) {
            std::int64_t pause = sender ? message.sender_pause : message.receiver_pause;
            transfers.push_back({.pause = part == 0 ? pause : 0,
                                 .bytes = message.parts[part],
                                 .alternates = message.alternates && part == 0,
                                 .ends_message = part + 1 == message.parts.size()});
        }
    return transfers;
}
} // namespace

BitModel::BitModel(const hardware::LinkTiming& timing, const std::array<Traffic, 2>& traffic,
                   const std::vector<hardware::LinkFault>& faults)
    : bit_(1'000'000'000 / timing.bits_per_second), delay_(whole_ns(timing.wire_delay)),
      overlapped_(timing.overlapped_acknowledge), faults_(faults) {
    for (std::size_t d : {0u, 1u}) {
        const auto& [messages, given, taken] = traffic[d];
        sender_[d].transfers = messages.empty() ? given : transfers_of(messages, true);
        receiver_[d].transfers = messages.empty() ? taken : transfers_of(messages, false);
        sender_[d].wakes_at = sender_[d].is_done() ? 0 : sender_[d].transfers[0].pause;
        receiver_[d].wakes_at = receiver_[d].is_done() ? 0 : receiver_[d].transfers[0].pause;
    }
}

std::array<Course, 2> BitModel::run(std::int64_t limit) {
    while (!over()) {
        if (now_ > limit)
            throw std::runtime_error("the link is stuck");
        step();
    }
    return course_;
}

std::array<Course, 2> BitModel::run_until(std::int64_t end) {
    while (now_ <= end)
        step();
    return course_;
}

std::array<Course, 2> BitModel::run_until_quiet(std::int64_t limit) {
    while (!is_quiet()) {
        if (now_ > limit)
            throw std::runtime_error("the link never falls quiet");
        for (int i = 0; i < 20; ++i) // 20 steps at once, because the test for the end takes as long as a step
            step();
    }
    return course_;
}

void BitModel::step() {
    for (std::size_t d : {0u, 1u})
        if (receiver_[d].notice_at == now_)
            notice(d);
    for (std::size_t end : {0u, 1u})
        if (transmitter_[end].idle_from <= now_)
            transmit(end);
    for (std::size_t d : {0u, 1u}) {
        if (receiver_[d].arrives_at == now_)
            byte_arrived(d);
        if (sender_[d].ends_at == now_)
            given(d);
    }
    for (std::size_t d : {0u, 1u}) {
        if (sender_[d].wakes_at == now_)
            begin_output(d);
        if (receiver_[d].wakes_at == now_)
            begin_input(d);
    }
    for (std::size_t end : {0u, 1u})
        drive(end);
    for (std::size_t end : {0u, 1u})
        decode(end);
    ++now_;
}

std::int64_t BitModel::bit_at(std::int64_t time) const {
    std::int64_t factor = 1;
    for (const auto& fault : faults_)
        if (fault.kind == hardware::LinkFault::Kind::slow && whole_ns(fault.from) <= time &&
            (fault.until == Time::max() || time < whole_ns(fault.until)))
            factor = std::max(factor, fault.factor);
    return bit_ * factor;
}

/// Returns whether a fault loses the packet that begins now on the wire that leaves `end`.
bool BitModel::loses_packet(std::size_t end, bool acknowledge) {
    for (auto fault = faults_.begin(); fault != faults_.end(); ++fault) {
        bool strikes = (end == 0 ? fault->wire_from_a : fault->wire_from_b) && whole_ns(fault->from) <= now_ &&
                       (fault->until == Time::max() || now_ < whole_ns(fault->until));
        if (strikes && fault->kind == hardware::LinkFault::Kind::silent)
            return true;
        if (strikes && acknowledge && fault->kind == hardware::LinkFault::Kind::loses_acknowledge) {
            faults_.erase(fault);
            return true;
        }
    }
    return false;
}

bool BitModel::over() const {
    for (std::size_t d : {0u, 1u})
        if (!sender_[d].is_done() || !receiver_[d].is_done())
            return false;
    return true;
}

/// Returns whether nothing travels, waits to be sent or noticed, or is about to resume.
bool BitModel::is_quiet() const {
    for (std::size_t d : {0u, 1u}) {
        const Sender& sender = sender_[d];
        const Receiver& receiver = receiver_[d];
        if (now_ < transmitter_[d].idle_from + delay_ || decoder_[d].in_packet)
            return false;
        bool sends = transmitter_[d].acknowledge_wanted || (sender.to_start > 0 && !sender.awaits_acknowledge);
        bool arrives = receiver.notice_at >= now_ || receiver.arrives_at >= now_ || sender.ends_at >= now_;
        bool wakes = (!sender.is_done() && !sender.sending && sender.wakes_at >= now_) ||
                     (!receiver.is_done() && !receiver.receiving && receiver.wakes_at >= now_);
        if (sends || arrives || wakes)
            return false;
    }
    return true;
}

/// Reads the wire that leaves `end` at its far side. A packet begins with a 1. Its second bit distinguishes data (11
/// bits) from an acknowledge (2 bits).
void BitModel::decode(std::size_t end) {
    Decoder& decoder = decoder_[end];
    if (now_ < delay_)
        return;
    bool level = transmitter_[end].level[static_cast<std::size_t>(now_ - delay_)];
    if (decoder.in_packet && decoder.bits && now_ >= decoder.began + decoder.bits * decoder.bit)
        decoder = {};
    if (!decoder.in_packet && level)
        decoder = {true, now_, 0, bit_at(now_ - delay_)};
    else if (decoder.in_packet && now_ == decoder.began + decoder.bit * 3 / 2) {
        decoder.bits = level ? 11 : 2;
        packet_known(end, level);
    }
}

void BitModel::packet_known(std::size_t end, bool data) {
    std::int64_t began = decoder_[end].began, bit = decoder_[end].bit;
    if (data) {
        ++receiver_[end].seen;
        receiver_[end].notice_at = began + bit * 52 / 10 + (overlapped_ ? 0 : 11 * bit);
        receiver_[end].arrives_at = began + 11 * bit;
        return;
    }
    Sender& sender = sender_[1 - end]; // the acknowledge belongs to a byte of the other direction
    sender.awaits_acknowledge = false;
    ++sender.acknowledged;
    sender.may_start = began + bit * 36 / 10 + 120 + (overlapped_ ? 0 : 2 * bit);
    if (sender.to_start == 0)
        sender.ends_at = began + 2 * bit;
}

/// Acknowledges the byte of direction `d` if it arrived long enough ago and its process has asked for it.
void BitModel::notice(std::size_t d) {
    Receiver& receiver = receiver_[d];
    if (receiver.asked >= receiver.seen)
        transmitter_[1 - d].acknowledge_wanted = true;
    else
        receiver.owed = true;
}

void BitModel::transmit(std::size_t end) {
    Transmitter& transmitter = transmitter_[end];
    Sender& sender = sender_[end];
    if (now_ < transmitter.idle_from)
        return;
    if (transmitter.acknowledge_wanted) {
        transmitter.acknowledge_wanted = false;
        transmitter.packet = {true, false};
    } else if (sender.sending && sender.to_start > 0 && !sender.awaits_acknowledge && now_ >= sender.may_start) {
        transmitter.packet = {true, true};
        for (int bit = 0; bit < 8; ++bit)
            transmitter.packet.push_back((sender.to_start * 0x9d >> bit) & 1);
        transmitter.packet.push_back(false);
        --sender.to_start;
        sender.awaits_acknowledge = true;
    } else {
        return;
    }
    bool acknowledge = transmitter.packet.size() == 2, lost = loses_packet(end, acknowledge);
    packets_.push_back({now_, end, acknowledge, lost});
    if (lost)
        transmitter.packet.assign(transmitter.packet.size(), false);
    transmitter.bit_sent = 0;
    transmitter.bit = bit_at(now_);
    transmitter.bit_ends = now_ + transmitter.bit;
    transmitter.idle_from = now_ + transmitter.bit * static_cast<std::int64_t>(transmitter.packet.size());
}

void BitModel::drive(std::size_t end) {
    Transmitter& transmitter = transmitter_[end];
    if (now_ >= transmitter.idle_from)
        return transmitter.level.push_back(false);
    if (now_ == transmitter.bit_ends) {
        ++transmitter.bit_sent;
        transmitter.bit_ends += transmitter.bit;
    }
    transmitter.level.push_back(transmitter.packet[transmitter.bit_sent]);
}

void BitModel::byte_arrived(std::size_t d) {
    Receiver& receiver = receiver_[d];
    ++receiver.arrived;
    if (receiver.arrived > receiver.asked)
        receiver.byte_waited.push_back(now_);
    if (receiver.receiving && receiver.arrived == receiver.asked)
        taken(d);
    else if (receiver.alternating)
        take(d);
}

void BitModel::begin_output(std::size_t d) {
    if (!sender_[d].sending && !sender_[d].is_done())
        give(d);
}

void BitModel::give(std::size_t d) {
    Sender& sender = sender_[d];
    sender.sending = true;
    sender.ends_at = -1;
    sender.to_start = sender.transfers[sender.transfer].bytes;
    transmit(d);
}

void BitModel::given(std::size_t d) {
    Sender& sender = sender_[d];
    sender.sending = false;
    if (sender.transfers[sender.transfer].ends_message)
        course_[d].output_ended.push_back(now_);
    ++sender.transfer;
    if (sender.is_done())
        return;
    sender.wakes_at = now_ + sender.transfers[sender.transfer].pause;
    if (sender.wakes_at == now_)
        give(d);
}

void BitModel::begin_input(std::size_t d) {
    Receiver& receiver = receiver_[d];
    if (receiver.receiving || receiver.is_done())
        return;
    receiver.alternating = receiver.transfers[receiver.transfer].alternates && receiver.arrived == receiver.asked;
    if (!receiver.alternating)
        take(d);
}

void BitModel::take(std::size_t d) {
    Receiver& receiver = receiver_[d];
    receiver.alternating = false;
    receiver.receiving = true;
    receiver.asked += receiver.transfers[receiver.transfer].bytes;
    if (receiver.owed) {
        receiver.owed = false;
        transmitter_[1 - d].acknowledge_wanted = true;
        transmit(1 - d);
    }
    if (receiver.arrived == receiver.asked)
        taken(d);
}

void BitModel::taken(std::size_t d) {
    Receiver& receiver = receiver_[d];
    receiver.receiving = false;
    if (receiver.transfers[receiver.transfer].ends_message)
        course_[d].input_ended.push_back(now_);
    ++receiver.transfer;
    if (receiver.is_done())
        return;
    receiver.wakes_at = now_ + receiver.transfers[receiver.transfer].pause;
    if (receiver.wakes_at == now_)
        begin_input(d);
}

} // namespace placedpar::test
