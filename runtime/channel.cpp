#include "runtime/channel.hpp"

#include "runtime/instructions.hpp"
#include "runtime/kernel.hpp"
#include "runtime/processor.hpp"
#include "runtime/trace.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace placedpar {

namespace {

[[noreturn]] void refuse_second_user(const char* verb, const Process& self, const AnyChannel& channel) {
    throw std::logic_error(fmt::format(
        "process {} {} channel {} while another process is doing so: a channel joins two processes only",
        self.path(), verb, channel.name()));
}

/// What the second process to arrive at a soft channel pays for the copy.
void charge_copy(const Process& self, const WireForm& form) {
    if (Processor* processor = self.processor()) {
        std::int64_t words = (form.total() + instructions::bytes_in_a_word - 1) / instructions::bytes_in_a_word;
        processor->compute(words * instructions::copied_word);
    }
}

} // namespace

void AnyChannel::output_any(void* message, const WireForm& form, const std::source_location& where) {
    Process& self = Kernel::current()->running();
    if (message_)
        refuse_second_user("outputs to", self, *this);
    outputter_ = &self;
    if (carrier_) {
        message_ = message;
        carrier_->output(*this, form, where);
    } else {
        compute(instructions::input_or_output);
        message_ = message;
        output_soft(self, form, where);
    }
}

void AnyChannel::input_any(void* slot, const std::source_location& where) {
    Process& self = Kernel::current()->running();
    if (slot_)
        refuse_second_user("inputs from", self, *this);
    inputter_ = &self;
    if (carrier_) {
        slot_ = slot;
        carrier_->input(*this, where);
    } else {
        compute(instructions::input_or_output);
        slot_ = slot;
        input_soft(self, where);
    }
}

void AnyChannel::hand_over() {
    Kernel& kernel = inputter_->kernel();
    kernel.fingerprint().mix(static_cast<std::uint64_t>(kernel.now().count()));
    kernel.fingerprint().mix(std::uint64_t{outputter_->ordinal()} << 32 | inputter_->ordinal());
    if (TraceSink* trace = kernel.trace())
        trace->communicated(*this, kernel.now());
    move_message(message_, slot_);
    message_ = slot_ = nullptr;
}

void AnyChannel::output_soft(Process& self, const WireForm& form, const std::source_location& where) {
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

void AnyChannel::input_soft(Process& self, const std::source_location& where) {
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
