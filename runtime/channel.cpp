#include "runtime/channel.hpp"

#include "runtime/executive.hpp"
#include "runtime/kernel.hpp"
#include "runtime/trace.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace placedpar {

namespace {

[[noreturn]] void refuse_second_user(const char* verb, const Process& self, const AnyChannel& channel) {
    throw std::logic_error(
        fmt::format("process {} {} channel {} while another process is doing so: a channel joins two processes only",
                    self.path(), verb, channel.name()));
}

AnyChannel::User user(const Process& process) { return {&process, &process.outermost(), process.ordinal()}; }

/// The second process to arrive at a soft channel copies the message.
void charge_copy(const Process& self, const WireForm& form) {
    charge(self, [&](const OperationCosts& cost) { return cost.copy(form.total()); });
}

} // namespace

void AnyChannel::put_on(Carrier& carrier) {
    if (message_ || slot_ || alternation_)
        throw std::logic_error("channel " + name_ + " cannot be put on a link while a process is in it");
    carrier_ = &carrier;
}

void AnyChannel::expect(const Process* outputter, const Process* inputter) {
    outputter_ = outputter ? user(*outputter) : User{};
    inputter_ = inputter ? user(*inputter) : User{};
}

void AnyChannel::enable(Alternation& alternation) {
    if (slot_ || (alternation_ && alternation_ != &alternation))
        refuse_second_user("alternates on", Kernel::current()->running(), *this);
    alternation_ = &alternation;
}

void AnyChannel::note_inputter(const Process& process) { inputter_ = user(process); }

void AnyChannel::output_any(void* message, const WireForm& form, const SourceLocation& where) {
    Process& self = Kernel::current()->running();
    if (!carrier_)
        charge(self, &OperationCosts::soft_communication);
    if (message_)
        refuse_second_user("outputs to", self, *this);
    outputter_ = user(self);
    message_ = message;
    if (carrier_)
        carrier_->output(*this, form, where);
    else
        output_soft(self, form, where);
}

void AnyChannel::input_any(void* slot, const SourceLocation& where) {
    Process& self = Kernel::current()->running();
    if (!carrier_)
        charge(self, &OperationCosts::soft_communication);
    if (slot_ || alternation_)
        refuse_second_user("inputs from", self, *this);
    inputter_ = user(self);
    slot_ = slot;
    if (carrier_)
        carrier_->input(*this, where);
    else
        input_soft(self, where);
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

void AnyChannel::output_soft(Process& self, const WireForm& form, const SourceLocation& where) {
    Kernel& kernel = self.kernel();
    if (slot_) {
        Process& inputter = *waiting_;
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

void AnyChannel::input_soft(Process& self, const SourceLocation& where) {
    Kernel& kernel = self.kernel();
    if (message_) {
        Process& outputter = *waiting_;
        hand_over();
        charge_copy(self, waiting_form_);
        kernel.make_ready(outputter);
        return;
    }
    waiting_ = &self;
    self.wait_for(Activity::inputting, this, where);
}

} // namespace placedpar
