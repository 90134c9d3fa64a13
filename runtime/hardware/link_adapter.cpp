#include "runtime/hardware/link_adapter.hpp"

#include "runtime/channel.hpp"
#include "runtime/executive.hpp"
#include "runtime/kernel.hpp"

#include <stdexcept>
#include <utility>

namespace placedpar::hardware {

namespace {

/// The last part of a message that is not empty: empty parts do not travel.
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
    compute(master_.program().byte_access);
    master_.access_byte(adapter_);
}

/// The status is that at the end of the access.
template <class Ready>
void AdapterProgram::poll(LinkAdapter::Register& data, Activity activity, AnyChannel& channel,
                          const SourceLocation& where, Ready ready) {
    for (std::int64_t polls = 1;; ++polls) {
        access();
        if (ready())
            return;
        if (polls % master_.program().most_polls == 0) {
            data.sleeper = &kernel_.running();
            kernel_.running().wait_for(activity, &channel, where);
            compute(master_.program().interrupt);
        }
    }
}

void AdapterProgram::wait_until_writable(AnyChannel& channel, const SourceLocation& where) {
    poll(adapter_.output_, Activity::outputting, channel, where, [&] { return adapter_.to_link().can_be_written(); });
}

void AdapterProgram::wait_until_readable(AnyChannel& channel, const SourceLocation& where) {
    poll(adapter_.input_, Activity::inputting, channel, where, [&] { return adapter_.from_link().can_be_read(); });
}

void AdapterProgram::ToLink::output(AnyChannel& channel, const WireForm& form, const SourceLocation& where) {
    LinkDirection& link = program.adapter_.to_link();
    std::size_t last = last_part_on_wire(form, channel);
    for (std::size_t part = 0; part <= last; ++part) {
        if (form[part] == 0)
            continue;
        charge(program.kernel_.running(), &OperationCosts::hard_communication);
        link.begin_part(channel, form[part], part == last);
        for (std::uint32_t byte = 0; byte < form[part]; ++byte) {
            program.wait_until_writable(channel, where);
            program.access();
            link.write_byte();
        }
        program.wait_until_writable(channel, where);
    }
}

void AdapterProgram::ToLink::input(AnyChannel& channel, const SourceLocation& where) {
    program.adapter_.to_link().input(channel, where);
}

bool AdapterProgram::ToLink::message_waits(const AnyChannel& channel) const {
    return program.adapter_.to_link().message_waits(channel);
}

void AdapterProgram::FromLink::output(AnyChannel& channel, const WireForm& form, const SourceLocation& where) {
    program.adapter_.from_link().output(channel, form, where);
}

void AdapterProgram::FromLink::input(AnyChannel& channel, const SourceLocation& where) {
    LinkDirection& link = program.adapter_.from_link();
    link.begin_reading(channel);
    charge(program.kernel_.running(), &OperationCosts::hard_communication);
    LinkDirection::Ended ended{};
    while (ended != LinkDirection::Ended::message) {
        if (ended == LinkDirection::Ended::part)
            charge(program.kernel_.running(), &OperationCosts::hard_communication);
        program.wait_until_readable(channel, where);
        program.access();
        ended = link.read_byte();
    }
}

bool AdapterProgram::FromLink::message_waits(const AnyChannel& channel) const {
    return program.adapter_.from_link().message_waits(channel);
}

AdapterBroadcast::AdapterBroadcast(Kernel& kernel, const std::vector<AdapterProgram*>& programs) : kernel_(kernel) {
    for (AdapterProgram* program : programs) {
        if (&program->master_ != &programs.front()->master_)
            throw std::logic_error("one master broadcasts, not " + program->master_.name() + " with " +
                                   programs.front()->master_.name());
        lanes_.emplace_back(*this, *program);
    }
    if (lanes_.empty())
        throw std::logic_error("a broadcast reaches at least one adapter");
}

void AdapterBroadcast::Lane::output(AnyChannel& to, const WireForm& form, const SourceLocation& where) {
    Process& self = broadcast.kernel_.running();
    charge(self, &OperationCosts::hard_communication);
    last_part_on_wire(form, to);
    channel = &to;
    outputter = &self;
    broadcast.forms_.push_back(form);
    if (!same(form, broadcast.forms_.front()))
        throw std::logic_error("channel " + to.name() + " is broadcast with others, and its message has another form");
    if (++broadcast.waiting_ < broadcast.lanes_.size())
        return self.wait_for(Activity::outputting, &to, where);
    broadcast.write_all(form, where);
    broadcast.let_others_go_on();
}

void AdapterBroadcast::Lane::input(AnyChannel& to, const SourceLocation& where) { program.to_link().input(to, where); }

bool AdapterBroadcast::Lane::message_waits(const AnyChannel& to) const { return program.to_link().message_waits(to); }

void AdapterBroadcast::write_all(const WireForm& form, const SourceLocation& where) {
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
    waiting_ = 0;
    forms_.clear();
    for (Lane& lane : lanes_)
        if (Process* process = std::exchange(lane.outputter, nullptr); process != &kernel_.running())
            kernel_.make_ready(*process);
}

} // namespace placedpar::hardware
