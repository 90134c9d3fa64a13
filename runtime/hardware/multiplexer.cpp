#include "runtime/hardware/multiplexer.hpp"

#include "runtime/executive.hpp"
#include "runtime/kernel.hpp"

#include <functional>
#include <utility>

namespace placedpar::hardware {

Multiplexer::Multiplexer(Kernel& kernel, const std::string& name, Link& link, Executive* a, Executive* b)
    : a_to_b_(name + " packets from a to b"), b_to_a_(name + " packets from b to a"),
      a_(kernel, name + " multiplexer a", a, a_to_b_, b_to_a_),
      b_(kernel, name + " multiplexer b", b, b_to_a_, a_to_b_) {
    a_to_b_.put_on(link.from_a_to_b());
    b_to_a_.put_on(link.from_b_to_a());
}

Carrier& Multiplexer::add_channel(bool from_a_to_b) {
    return from_a_to_b ? lanes_.emplace_back(a_, b_) : lanes_.emplace_back(b_, a_);
}

Multiplexer::End::End(Kernel& kernel, const std::string& name, Executive* executive, Channel<Packet>& out,
                      Channel<Packet>& in)
    : out_(out), in_(in),
      sender_(kernel, name + " sender", std::bind_front(&End::send_packets, this), executive, Priority::high),
      receiver_(kernel, name + " receiver", std::bind_front(&End::receive_packets, this), executive, Priority::high) {
    for (Process* process : {&sender_, &receiver_}) {
        process->serve_machine();
        kernel.make_ready(*process);
    }
}

void Multiplexer::End::post(const Packet& packet) {
    queue_.push_back(packet);
    if (std::exchange(sender_idle_, false))
        sender_.kernel().make_ready(sender_);
}

void Multiplexer::End::send_packets() {
    for (;;) {
        while (queue_.empty()) {
            sender_idle_ = true;
            sender_.wait_for(Activity::inputting, nullptr, SourceLocation::current());
        }
        Packet packet = queue_.front();
        queue_.pop_front();
        compute(packet_handling);
        out_.out().output(packet);
    }
}

void Multiplexer::End::receive_packets() {
    for (;;) {
        Packet packet = in_.in().input();
        compute(packet_handling);
        packet.lane->packet_came(packet);
    }
}

void Multiplexer::Lane::output(AnyChannel& channel, const WireForm& form, const SourceLocation& where) {
    Process& self = Kernel::current()->running();
    charge(self, &OperationCosts::hard_communication);
    channel_ = &channel;
    outputter_ = &self;
    near_.post({this, false, form.total()});
    self.wait_for(Activity::outputting, &channel, where);
}

void Multiplexer::Lane::input(AnyChannel& channel, const SourceLocation& where) {
    Process& self = Kernel::current()->running();
    charge(self, &OperationCosts::hard_communication);
    if (std::exchange(message_here_, false)) {
        take_message();
        return;
    }
    inputter_ = &self;
    self.wait_for(Activity::inputting, &channel, where);
}

void Multiplexer::Lane::packet_came(const Packet& packet) {
    if (packet.acknowledge) {
        outputter_->kernel().make_ready(*outputter_);
    } else if (inputter_) {
        take_message();
        Process& inputter = *std::exchange(inputter_, nullptr);
        inputter.kernel().make_ready(inputter);
    } else {
        message_here_ = true;
        channel_->announce();
    }
}

void Multiplexer::Lane::take_message() {
    channel_->hand_over();
    far_.post({this, true, 0});
}

} // namespace placedpar::hardware
