#include "runtime/channel.hpp"

#include "runtime/executive.hpp"
#include "runtime/kernel.hpp"
#include "runtime/trace.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace placedpar {

void refuse_end_without_channel() { throw std::logic_error("an end that belongs to no channel is used"); }

namespace {

AnyChannel::User user(const Process& process) { return {&process, &process.outermost(), process.ordinal()}; }

/// Whether the last user of an end and the process are of one outermost process, and not two components of a PAR.
bool may_follow(const AnyChannel::User& last, const Process& process) {
    return last.outermost == &process.outermost() && !process.is_beside(last.ordinal);
}

[[gnu::cold]] void change_owner(AnyChannel::User& end, const Process& process, const char* verb,
                                const AnyChannel& channel) {
    if (end.process && !may_follow(end, process))
        throw std::logic_error(fmt::format("process {} {} channel {}, as {} does: a channel joins two processes only",
                                           process.path(), verb, channel.name(),
                                           end.outermost == &process.outermost() ? "another component of a PAR"
                                                                                 : "process " + end.outermost->path()));
    end = user(process);
}

/// `verb`: "outputs to", "inputs from".
void own(AnyChannel::User& end, const Process& process, const char* verb, const AnyChannel& channel) {
    if (end.process != &process || end.ordinal != process.ordinal())
        change_owner(end, process, verb, channel);
}

/// The link was left in the middle of a message.
[[noreturn]] void refuse_unreset(const Process& self, const char* verb, const AnyChannel& channel) {
    throw std::logic_error(fmt::format("process {} {} channel {}, on which it gave up a message: reset it first",
                                       self.path(), verb, channel.name()));
}

/// Notes that a process is in the channel, for as long as it is.
class Stay {
public:
    Stay(void*& place, void* mine) : place_(place) { place_ = mine; }
    ~Stay() { place_ = nullptr; }
    Stay(const Stay&) = delete;
    Stay& operator=(const Stay&) = delete;

private:
    void*& place_;
};

[[noreturn]] void refuse_without_carrier(const Process& self, const Process& other, const AnyChannel& channel) {
    throw std::logic_error(fmt::format("channel {} joins process {} on {} and process {} on {}, and no link carries it",
                                       channel.name(), other.path(), other.executive()->name(), self.path(),
                                       self.executive()->name()));
}

void require_carrier_between(const Process& self, const Process& other, const AnyChannel& channel) {
    if (self.executive() != other.executive() && self.executive() && other.executive())
        refuse_without_carrier(self, other, channel);
}

/// The second process to arrive at a soft channel copies the message.
void charge_copy(const Process& self, const WireForm& form) {
    charge(self, [&](const OperationCosts& cost) { return cost.copy(form.total()); });
}

void require_can_be_given_up(const Carrier* carrier, const AnyChannel& channel) {
    if (std::string reason = carrier ? carrier->why_not_given_up() : ""; !reason.empty())
        throw std::logic_error(
            fmt::format("channel {} {}: it cannot give up a message, nor be reset", channel.name(), reason));
}

void require_nobody_in(const void* end, const AnyChannel& channel) {
    if (end)
        throw std::logic_error("channel " + channel.name() + " cannot be reset while a process is in it");
}

} // namespace

void AnyChannel::put_on(Carrier& carrier) {
    if (message_ || slot_ || listener_)
        throw std::logic_error("channel " + name_ + " cannot be put on a link while a process is in it");
    carrier_ = &carrier;
}

void AnyChannel::expect_outputter(const Process& process) { own(outputter_, process, "outputs to", *this); }

void AnyChannel::expect_inputter(const Process& process) { own_input(process); }

void AnyChannel::own_input(const Process& process) {
    own(inputter_, process, "inputs from", *this);
    if (input_out_of_order_)
        refuse_unreset(process, "inputs from", *this);
}

inline void AnyChannel::output_soft(Process& self, const WireForm& form, const SourceLocation& where) {
    Kernel& kernel = self.kernel();
    if (slot_) {
        Process& inputter = *waiting_;
        require_carrier_between(self, inputter, *this);
        hand_over();
        charge_copy(self, form);
        kernel.make_ready(inputter);
        return;
    }
    waiting_ = &self;
    waiting_form_ = form;
    announce();
    self.wait_for(Activity::outputting, this, where);
}

inline void AnyChannel::input_soft(Process& self, const SourceLocation& where) {
    Kernel& kernel = self.kernel();
    if (message_) {
        Process& outputter = *waiting_;
        require_carrier_between(self, outputter, *this);
        hand_over();
        charge_copy(self, waiting_form_);
        kernel.make_ready(outputter);
        return;
    }
    waiting_ = &self;
    self.wait_for(Activity::inputting, this, where);
}

void AnyChannel::output_any(void* message, const WireForm& form, const SourceLocation& where) {
    Process& self = Kernel::here().running();
    if (!carrier_)
        charge(self, &OperationCosts::soft_communication);
    own(outputter_, self, "outputs to", *this);
    if (output_out_of_order_)
        refuse_unreset(self, "outputs to", *this);
    Stay stay(message_, message);
    if (output_attempt_)
        output_attempt_->entered();
    if (carrier_)
        carrier_->output(*this, form, where);
    else
        output_soft(self, form, where);
}

void AnyChannel::input_any(void* slot, const SourceLocation& where) {
    Process& self = Kernel::here().running();
    if (!carrier_)
        charge(self, &OperationCosts::soft_communication);
    own_input(self);
    Stay stay(slot_, slot);
    if (input_attempt_)
        input_attempt_->entered();
    if (carrier_)
        carrier_->input(*this, where);
    else
        input_soft(self, where);
}

void AnyChannel::attempt_output(Entrant* attempt) {
    if (attempt)
        require_can_be_given_up(carrier_, *this);
    output_attempt_ = attempt;
}

void AnyChannel::attempt_input(Entrant* attempt) {
    if (attempt)
        require_can_be_given_up(carrier_, *this);
    input_attempt_ = attempt;
}

bool AnyChannel::give_up_output() {
    if (carrier_)
        return output_out_of_order_ = carrier_->give_up_output(*this);
    if (!message_)
        return false;
    message_ = nullptr;
    waiting_->kernel().make_ready(*waiting_);
    return true;
}

bool AnyChannel::give_up_input() {
    if (carrier_)
        return input_out_of_order_ = carrier_->give_up_input(*this);
    if (!slot_)
        return false;
    slot_ = nullptr;
    waiting_->kernel().make_ready(*waiting_);
    return true;
}

std::uint64_t AnyChannel::reset_output() {
    require_can_be_given_up(carrier_, *this);
    own(outputter_, Kernel::here().running(), "resets", *this);
    require_nobody_in(message_, *this);
    output_out_of_order_ = false;
    return carrier_ ? carrier_->reset_output(*this) : 0;
}

std::uint64_t AnyChannel::reset_input() {
    require_can_be_given_up(carrier_, *this);
    own(inputter_, Kernel::here().running(), "resets", *this);
    require_nobody_in(slot_, *this);
    input_out_of_order_ = false;
    return carrier_ ? carrier_->reset_input(*this) : 0;
}

void AnyChannel::hand_over() {
    Kernel& kernel = inputter_.process->kernel();
    kernel.fingerprint().mix(static_cast<std::uint64_t>(kernel.now().count()));
    kernel.fingerprint().mix(std::uint64_t{outputter_.ordinal} << 32 | inputter_.ordinal);
    if (TraceSink* trace = kernel.trace())
        trace->communicated(*this, kernel.now());
    move_message(message_, slot_);
    message_ = slot_ = nullptr;
}

} // namespace placedpar
