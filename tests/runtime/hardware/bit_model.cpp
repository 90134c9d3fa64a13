#include "bit_model.hpp"

#include <algorithm>
#include <stdexcept>

namespace placedpar::test {

namespace {
std::int64_t whole_ns(Time t) { return t.count() / 1000; }
} // namespace

BitModel::BitModel(const hardware::LinkTiming& timing, const std::array<Traffic, 2>& traffic,
                   const std::vector<hardware::LinkFault>& faults)
    : bit_(1'000'000'000 / timing.bits_per_second), delay_(whole_ns(timing.wire_delay)),
      overlapped_(timing.overlapped_acknowledge), faults_(faults), traffic_(traffic) {
    for (std::size_t direction : {0u, 1u})
        if (!traffic_[direction].messages.empty()) {
            sender_[direction].wakes_at = traffic_[direction].messages[0].sender_pause;
            receiver_[direction].wakes_at = traffic_[direction].messages[0].receiver_pause;
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

void BitModel::step() {
    for (std::size_t end : {0u, 1u})
        notice(end);
    for (std::size_t end : {0u, 1u})
        transmit(end);
    for (std::size_t direction : {0u, 1u})
        processes(direction);
    for (std::size_t direction : {0u, 1u})
        timers(direction);
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

/// The packet that begins now on the wire that leaves `end`.
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
        if (sender_[d].message < traffic_[d].messages.size() || receiver_[d].message < traffic_[d].messages.size())
            return false;
    return true;
}

/// Reads the wire that leaves `end`, at its far side: a packet starts with a one, its second bit tells data
/// (11 bits) from an acknowledge (2 bits).
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
    Sender& sender = sender_[1 - end]; // the acknowledge of the other direction's byte
    sender.awaits_acknowledge = false;
    sender.may_start = began + bit * 36 / 10 + 120 + (overlapped_ ? 0 : 2 * bit);
    if (sender.to_start == 0)
        sender.ends_at = began + 2 * bit;
}

/// Direction `d` has had a byte for long enough to acknowledge it, if its process has asked for it.
void BitModel::notice(std::size_t d) {
    Receiver& receiver = receiver_[d];
    if (receiver.notice_at != now_)
        return;
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
    if (loses_packet(end, transmitter.packet.size() == 2))
        transmitter.packet.assign(transmitter.packet.size(), false);
    transmitter.packet_began = now_;
    transmitter.bit = bit_at(now_);
    transmitter.idle_from = now_ + transmitter.bit * static_cast<std::int64_t>(transmitter.packet.size());
}

void BitModel::drive(std::size_t end) {
    transmit(end); // what a process asked for in this nanosecond
    Transmitter& transmitter = transmitter_[end];
    bool level = now_ < transmitter.idle_from &&
                 transmitter.packet[static_cast<std::size_t>((now_ - transmitter.packet_began) / transmitter.bit)];
    transmitter.level.push_back(level);
}

void BitModel::processes(std::size_t d) {
    Receiver& receiver = receiver_[d];
    if (receiver.arrives_at == now_) {
        ++receiver.arrived;
        if (receiver.receiving && receiver.arrived == receiver.asked)
            next_input(d);
        else if (receiver.alternating)
            ask_part(d);
    }
    if (sender_[d].ends_at == now_)
        next_output(d);
}

void BitModel::timers(std::size_t d) {
    if (!sender_[d].sending && sender_[d].message < traffic_[d].messages.size() && sender_[d].wakes_at == now_)
        begin_part(d);
    if (!receiver_[d].receiving && receiver_[d].message < traffic_[d].messages.size() && receiver_[d].wakes_at == now_)
        begin_input(d);
}

void BitModel::begin_part(std::size_t d) {
    Sender& sender = sender_[d];
    sender.sending = true;
    sender.ends_at = -1;
    sender.to_start = traffic_[d].messages[sender.message].parts[sender.part];
    transmit(d);
}

void BitModel::next_output(std::size_t d) {
    Sender& sender = sender_[d];
    const auto& messages = traffic_[d].messages;
    if (++sender.part < messages[sender.message].parts.size())
        return begin_part(d);
    course_[d].output_ended.push_back(now_);
    sender.sending = false;
    sender.part = 0;
    if (++sender.message == messages.size())
        return;
    sender.wakes_at = now_ + messages[sender.message].sender_pause;
    if (sender.wakes_at == now_)
        begin_part(d);
}

void BitModel::begin_input(std::size_t d) {
    Receiver& receiver = receiver_[d];
    receiver.alternating = traffic_[d].messages[receiver.message].alternates && receiver.arrived == receiver.asked;
    if (!receiver.alternating)
        ask_part(d);
}

void BitModel::ask_part(std::size_t d) {
    Receiver& receiver = receiver_[d];
    receiver.alternating = false;
    receiver.receiving = true;
    receiver.asked += traffic_[d].messages[receiver.message].parts[receiver.part];
    if (receiver.owed) {
        receiver.owed = false;
        transmitter_[1 - d].acknowledge_wanted = true;
        transmit(1 - d);
    }
    if (receiver.arrived == receiver.asked)
        next_input(d);
}

void BitModel::next_input(std::size_t d) {
    Receiver& receiver = receiver_[d];
    const auto& messages = traffic_[d].messages;
    if (++receiver.part < messages[receiver.message].parts.size())
        return ask_part(d);
    course_[d].input_ended.push_back(now_);
    receiver.receiving = false;
    receiver.part = 0;
    if (++receiver.message == messages.size())
        return;
    receiver.wakes_at = now_ + messages[receiver.message].receiver_pause;
    if (receiver.wakes_at == now_)
        begin_input(d);
}

} // namespace placedpar::test
