#include "runtime/hardware/link_adapter.hpp"

#include "runtime/channel.hpp"
#include "runtime/executive.hpp"
#include "runtime/hardware/bus_programs.hpp"
#include "runtime/kernel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace placedpar::hardware {

namespace {

/// Returns the index of the last part that is not empty. Only parts with bytes are sent.
std::size_t last_part_on_wire(const WireForm& form, const AnyChannel& channel) {
    if (form.total() == 0)
        throw std::logic_error("a message without bytes cannot travel on channel " + channel.name());
    std::size_t part = form.parts() - 1;
    while (form[part] == 0)
        --part;
    return part;
}

bool same(const WireForm& a, const WireForm& b) {
    bool equal = a.parts() == b.parts();
    for (std::size_t part = 0; equal && part < a.parts(); ++part)
        equal = a[part] == b[part];
    return equal;
}

/// Returns a text such as "4 + 148 bytes".
std::string bytes_in_words(const WireForm& form) {
    std::string text;
    for (std::size_t part = 0; part < form.parts(); ++part)
        text += fmt::format("{}{}", part == 0 ? "" : " + ", form[part]);
    return text + " bytes";
}

} // namespace

LinkAdapter::LinkAdapter(Kernel& kernel, std::string name, Link& link, End end)
    : name_(std::move(name)), to_link_(end == End::a ? link.from_a_to_b() : link.from_b_to_a()),
      from_link_(end == End::a ? link.from_b_to_a() : link.from_a_to_b()), output_(kernel), input_(kernel) {
    to_link_.is_written_by(output_);
    from_link_.is_read_by(input_);
}

void LinkAdapter::Register::register_ready() {
    if (Process* process = std::exchange(sleeper, nullptr))
        kernel.make_ready(*process);
}

AdapterProgram::AdapterProgram(Kernel& kernel, VmeMaster& master, LinkAdapter& adapter)
    : kernel_(kernel), master_(master), adapter_(adapter) {}

void AdapterProgram::access() {
    bus_programs::spend(kernel_, master_.program().byte_access);
    master_.access_byte(adapter_);
}

/// Reads the status register until the data register is ready or the message is given up. An access takes time, and
/// reads the status that the register has at the end of the access.
template <class Over>
void AdapterProgram::poll(LinkAdapter::Register& data, Activity activity, AnyChannel& channel,
                          const SourceLocation& where, Over over) {
    for (std::int64_t polls = 1;; ++polls) {
        access();
        if (over())
            return;
        if (polls % master_.program().most_polls == 0) {
            data.sleeper = &kernel_.running();
            kernel_.running().wait_for(activity, &channel, where);
            bus_programs::spend(kernel_, master_.program().interrupt);
        }
    }
}

void AdapterProgram::wait_until_writable(AnyChannel& channel, const SourceLocation& where) {
    const LinkDirection& link = adapter_.to_link();
    poll(adapter_.output_, Activity::outputting, channel, where,
         [&] { return link.can_be_written() || link.output_is_given_up(); });
}

void AdapterProgram::wait_until_readable(AnyChannel& channel, const SourceLocation& where) {
    const LinkDirection& link = adapter_.from_link();
    poll(adapter_.input_, Activity::inputting, channel, where,
         [&] { return link.can_be_read() || link.input_is_given_up(); });
}

void AdapterProgram::ToLink::output(AnyChannel& channel, const WireForm& form, const SourceLocation& where) {
    std::size_t last = last_part_on_wire(form, channel);
    link.begin_writing(channel);
    for (std::size_t part = 0; part <= last && !link.output_is_given_up(); ++part)
        if (form[part] > 0) {
            charge(program.kernel_.running(), &OperationCosts::hard_communication);
            if (!link.output_is_given_up())
                write_part(channel, form[part], part == last, where);
        }
}

void AdapterProgram::ToLink::write_part(AnyChannel& channel, std::uint32_t bytes, bool last,
                                        const SourceLocation& where) {
    link.begin_part(channel, bytes, last);
    for (std::uint32_t byte = 0; byte < bytes; ++byte) {
        program.wait_until_writable(channel, where);
        if (!link.output_is_given_up())
            program.access();
        if (link.output_is_given_up())
            return;
        link.write_byte();
    }
    program.wait_until_writable(channel, where);
}

void AdapterProgram::FromLink::input(AnyChannel& channel, const SourceLocation& where) {
    link.begin_reading(channel);
    charge(program.kernel_.running(), &OperationCosts::hard_communication);
    LinkDirection::Ended ended{};
    while (ended != LinkDirection::Ended::message && !link.input_is_given_up()) {
        if (ended == LinkDirection::Ended::part)
            charge(program.kernel_.running(), &OperationCosts::hard_communication);
        program.wait_until_readable(channel, where);
        if (!link.input_is_given_up())
            program.access();
        ended = LinkDirection::Ended::nothing;
        if (!link.input_is_given_up() && link.can_be_read()) // if neither holds, the sender has given up the message
            ended = link.read_byte();
    }
}

AdapterBroadcast::AdapterBroadcast(Kernel& kernel, const std::vector<AdapterProgram*>& programs) : kernel_(kernel) {
    for (AdapterProgram* program : programs) {
        if (&program->master_ != &programs.front()->master_)
            throw std::logic_error("a broadcast has one master, but its channels are used by " +
                                   program->master_.name() + " and " + programs.front()->master_.name());
        lanes_.emplace_back(*this, *program);
    }
    if (lanes_.empty())
        throw std::logic_error("a broadcast must reach at least one adapter");
}

void AdapterBroadcast::carry(AnyChannel& channel, std::size_t i) {
    lanes_.at(i).channel = &channel;
    channel.put_on(lanes_[i]);
}

void AdapterBroadcast::Lane::output(AnyChannel& to, const WireForm& form, const SourceLocation& where) {
    Process& self = broadcast.kernel_.running();
    charge(self, &OperationCosts::hard_communication);
    last_part_on_wire(form, to);
    broadcast.require_same(to, form);
    outputter = &self;
    ++broadcast.waiting_;
    if (!broadcast.is_written())
        return self.wait_for(Activity::outputting, &to, where);
    broadcast.write_all(form, where);
    broadcast.let_others_go_on();
}

void AdapterBroadcast::Lane::input(AnyChannel& to, const SourceLocation& where) { program.to_link().input(to, where); }

bool AdapterBroadcast::Lane::message_waits(const AnyChannel& to) const { return program.to_link().message_waits(to); }

/// Returns whether the output is lost on any lane, that is, on the way of the broadcast over one of the link adapters.
/// The output is then lost on all lanes.
bool AdapterBroadcast::Lane::output_is_lost(const AnyChannel&) const {
    return broadcast.is_written() && std::ranges::any_of(broadcast.lanes_, [](const Lane& lane) {
               return lane.link().output_is_lost(*lane.channel);
           });
}

bool AdapterBroadcast::Lane::input_is_lost(const AnyChannel& to) const { return link().input_is_lost(to); }

/// Returns whether the other lanes wait for this lane. Before the message is written they wait for the outputter of
/// this lane, afterwards for its inputter.
bool AdapterBroadcast::Lane::holds_others_up() const {
    if (!broadcast.is_written())
        return outputter == nullptr;
    return !link().can_be_written() && channel->output_waits() && !channel->input_waits();
}

std::vector<const AnyChannel*> AdapterBroadcast::Lane::held_up_by(const AnyChannel& to) const {
    std::vector<const AnyChannel*> others;
    for (const Lane& lane : broadcast.lanes_)
        if (outputter && lane.channel && lane.channel != &to && lane.holds_others_up())
            others.push_back(lane.channel);
    return others;
}

void AdapterBroadcast::require_same(const AnyChannel& channel, const WireForm& form) {
    if (waiting_ == 0) {
        first_ = &channel;
        form_ = form;
        return;
    }
    std::string both = fmt::format("channel {} is broadcast with {}", channel.name(), first_->name());
    if (!same(form, *form_))
        throw BroadcastError(fmt::format("{}, but the lengths of their messages differ: {} and {}", both,
                                         bytes_in_words(form), bytes_in_words(*form_)));
    auto is_same = channel.has_message_of(*first_);
    if (!is_same)
        throw BroadcastError(both + ", and the messages cannot be compared: their type has no ==");
    if (!*is_same)
        throw BroadcastError(both + ", but their messages differ");
}

void AdapterBroadcast::write_all(const WireForm& form, const SourceLocation& where) {
    for (Lane& lane : lanes_)
        lane.program.adapter_.to_link().begin_writing(*lane.channel);
    std::size_t last = last_part_on_wire(form, *lanes_.front().channel);
    for (std::size_t part = 0; part <= last; ++part)
        if (form[part] > 0)
            write_part(form[part], part == last, where);
}

void AdapterBroadcast::write_part(std::uint32_t bytes, bool last, const SourceLocation& where) {
    for (Lane& lane : lanes_)
        lane.program.adapter_.to_link().begin_part(*lane.channel, bytes, last);
    for (std::uint32_t byte = 0; byte < bytes; ++byte) {
        wait_for_all(where);
        lanes_.front().program.access();
        for (Lane& lane : lanes_)
            lane.program.adapter_.to_link().write_byte();
    }
    wait_for_all(where);
}

void AdapterBroadcast::wait_for_all(const SourceLocation& where) {
    for (Lane& lane : lanes_)
        lane.program.wait_until_writable(*lane.channel, where);
}

void AdapterBroadcast::let_others_go_on() {
    ++messages_;
    bytes_ += static_cast<std::uint64_t>(form_->total());
    waiting_ = 0;
    for (Lane& lane : lanes_)
        if (Process* process = std::exchange(lane.outputter, nullptr); process != &kernel_.running())
            kernel_.make_ready(*process);
}

} // namespace placedpar::hardware
