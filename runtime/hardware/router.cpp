#include "runtime/hardware/router.hpp"

#include "runtime/executive.hpp"
#include "runtime/kernel.hpp"

#include <algorithm>
#include <cassert>
#include <functional>
#include <stdexcept>
#include <utility>

namespace placedpar::hardware {

Router::Router(Kernel& kernel, Executive* executive, const RouterCosts& costs)
    : kernel_(kernel), executive_(executive), costs_(costs) {
    if (costs.handling < Cycles{0})
        throw std::logic_error("the cycles in which a router handles a packet must not be negative");
}

Cycles Router::cycles_of_passing_on() const {
    Cycles communication = executive_ ? executive_->costs().hard_communication : Cycles{0};
    return static_cast<std::int64_t>(packets_passed_on_) * 2 * (costs_.handling + communication);
}

Router::Port::Port(Router& router, const std::string& to, const std::string& from, Channel<RouterPacket>& out,
                   Channel<RouterPacket>& in)
    : router_(router), out_(out), in_(in),
      sender_(router.kernel_, "router sender " + to, std::bind_front(&Port::send_packets, this), router.executive_,
              router.costs_.priority),
      receiver_(router.kernel_, "router receiver " + from, std::bind_front(&Port::receive_packets, this),
                router.executive_, router.costs_.priority) {
    for (Process* process : {&sender_, &receiver_}) {
        process->serve_machine();
        router.kernel_.start(*process);
    }
}

void Router::Port::post(const RouterPacket& packet) {
    auto turn = std::ranges::find_if(turns_, [&](const auto& each) { return each.front().route == packet.route; });
    if (turn == turns_.end())
        turns_.push_back({packet});
    else
        turn->push_back(packet);
    assert(turn == turns_.end() || turn->size() <= Route::most_under_way);
    if (std::exchange(sender_idle_, false))
        router_.kernel_.make_ready(sender_);
}

/// Returns the next packet to send. REQUIRES: a packet waits.
RouterPacket Router::Port::take_turn() {
    auto turn = std::move(turns_.front());
    turns_.pop_front();
    RouterPacket packet = turn.front();
    turn.pop_front();
    if (!turn.empty())
        turns_.push_back(std::move(turn));
    return packet;
}

void Router::Port::send_packets() {
    for (;;) {
        while (turns_.empty()) {
            sender_idle_ = true;
            sender_.wait_for(Activity::inputting, nullptr, SourceLocation::current());
        }
        RouterPacket packet = take_turn();
        being_sent_ = packet.route;
        compute(router_.costs_.handling);
        on_link_ = true;
        out_.carries({packet.route->channel_, packet.acknowledge});
        out_.out().output(packet);
        on_link_ = false;
        being_sent_ = nullptr;
    }
}

bool Router::Port::halted() const { return router_.executive_ && router_.executive_->halted(); }

bool Router::Port::stands_still() const { return out_.output_is_lost() || halted() || opposite_->halted(); }

/// Returns whether this port still holds a packet of the route. A packet has left if it has crossed the link, even if
/// the acknowledge of its last byte was lost.
bool Router::Port::holds_packet_of(const Route& route) const {
    bool has_got_over = on_link_ && !out_.output_waits();
    return (being_sent_ == &route && !has_got_over) ||
           std::ranges::any_of(turns_, [&](const auto& each) { return each.front().route == &route; });
}

void Router::Port::receive_packets() {
    for (;;) {
        RouterPacket packet = in_.in().input();
        compute(router_.costs_.handling);
        if (Port* port = packet.route->onward(packet)) {
            ++router_.packets_passed_on_;
            port->post(packet);
        } else {
            packet.route->arrived(packet);
        }
    }
}

RouterLink::RouterLink(Kernel& kernel, Link& link, Router& a, Router& b)
    : RouterLink(kernel, {link.from_a_to_b(), link.from_a_to_b().name()},
                 {link.from_b_to_a(), link.from_b_to_a().name()}, a, b) {}

RouterLink::RouterLink(Kernel&, const RouterLane& a_to_b, const RouterLane& b_to_a, Router& a, Router& b)
    : a_to_b_("packets " + a_to_b.name), b_to_a_("packets " + b_to_a.name),
      a_(a.ports_.emplace_back(a, a_to_b.name, b_to_a.name, a_to_b_, b_to_a_)),
      b_(b.ports_.emplace_back(b, b_to_a.name, a_to_b.name, b_to_a_, a_to_b_)) {
    a_.is_opposite(b_);
    b_.is_opposite(a_);
    a_to_b_.put_on(a_to_b.carrier);
    b_to_a_.put_on(b_to_a.carrier);
}

Route::Route(Kernel&, const std::vector<Hop>& hops) {
    for (const Hop& hop : hops) {
        forth_.push_back(hop.from_a_to_b ? &hop.link.a_ : &hop.link.b_);
        back_.push_back(hop.from_a_to_b ? &hop.link.b_ : &hop.link.a_);
    }
    std::ranges::reverse(back_);
}

void Route::output(AnyChannel& channel, const WireForm& form, const SourceLocation& where) {
    Process& self = Kernel::current()->running();
    charge(self, &OperationCosts::hard_communication);
    channel_ = &channel;
    outputter_ = &self;
    bytes_left_ = form.total();
    all_sent_ = false;
    while (!all_sent_ && under_way_ < most_under_way)
        send_packet();
    self.wait_for(Activity::outputting, &channel, where);
    outputter_ = nullptr;
}

bool Route::is_stopped() const {
    return outputter_ && any_port([this](const Router::Port* each) {
               return each->halted() || (each->stands_still() && each->holds_packet_of(*this));
           });
}

bool Route::is_stopped_at(const RouterLink& link) const {
    auto stands_there = [this](const Router::Port& port) { return port.stands_still() && port.holds_packet_of(*this); };
    return outputter_ && (stands_there(link.a_) || stands_there(link.b_));
}

bool Route::is_stopped_by(const Executive& executive) const {
    return outputter_ && any_port([&](const Router::Port* each) { return each->is_on(executive) && each->halted(); });
}

void Route::send_packet() {
    std::int64_t bytes = std::min(bytes_left_, RouterPacket::most_bytes);
    bytes_left_ -= bytes;
    all_sent_ = bytes_left_ == 0;
    ++under_way_;
    forth_.front()->post({this, false, all_sent_, 0, bytes});
}

void Route::input(AnyChannel& channel, const SourceLocation& where) {
    Process& self = Kernel::current()->running();
    charge(self, &OperationCosts::hard_communication);
    inputter_ = &self;
    while (!here_.empty()) {
        RouterPacket packet = here_.front();
        here_.pop_front();
        take(packet);
    }
    if (inputter_)
        self.wait_for(Activity::inputting, &channel, where);
}

Router::Port* Route::onward(RouterPacket& packet) const {
    const auto& ports = packet.acknowledge ? back_ : forth_;
    return ++packet.hop < ports.size() ? ports[packet.hop] : nullptr;
}

void Route::arrived(const RouterPacket& packet) {
    if (packet.acknowledge) {
        --under_way_;
        if (!all_sent_)
            send_packet();
        else if (under_way_ == 0)
            outputter_->kernel().make_ready(*outputter_);
    } else if (Process* inputter = inputter_) {
        take(packet);
        if (!inputter_)
            inputter->kernel().make_ready(*inputter);
    } else {
        here_.push_back(packet);
        assert(here_.size() <= most_under_way);
        if (here_.size() == 1)
            channel_->announce();
    }
}

/// Takes a packet for the inputting process, and acknowledges it. The last packet of a message completes the message.
void Route::take(const RouterPacket& packet) {
    if (packet.last) {
        channel_->hand_over();
        inputter_ = nullptr;
    }
    back_.front()->post({this, true, packet.last, 0, 0});
}

} // namespace placedpar::hardware
