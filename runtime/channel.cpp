#include "runtime/channel.hpp"

#include "runtime/replay_log.hpp"
#include "runtime/trace.hpp"

#include <fmt/format.h>

#include <functional>
#include <stdexcept>

namespace placedpar {

void refuse_end_without_channel() { throw std::logic_error("a channel end that belongs to no channel is used"); }

namespace {

AnyChannel::User user(const Process& process) { return {&process, &process.outermost(), process.ordinal()}; }

/// Returns whether the process may use a channel end after another user of this end. The process and the last user must
/// belong to the same outermost process, and must not be two components of one PAR.
bool may_follow(const AnyChannel::User& last, const Process& process) {
    return last.outermost == &process.outermost() && !process.is_beside(last.ordinal);
}

void require_can_be_given_up(const Carrier* carrier, const AnyChannel& channel) {
    if (std::string reason = carrier ? carrier->why_not_given_up() : ""; !reason.empty())
        throw std::logic_error(fmt::format(
            "channel {} {}: its messages cannot be given up, and its ends cannot be reset", channel.name(), reason));
}

void require_unused(const void* end, const AnyChannel& channel) {
    if (end)
        throw std::logic_error("channel " + channel.name() + " cannot be reset while a process communicates on it");
}

} // namespace

/// Returns the identity of a new channel. In a run that keeps histories (runtime/replay_log.hpp), the identity is
/// derived from the process that makes the channel, otherwise from the channel's name.
std::uint64_t AnyChannel::new_identity(const std::string& name) {
    const Kernel* kernel = Kernel::current();
    if (!kernel || !kernel->keeps_histories())
        return std::hash<std::string>()(name);
    const Process* maker = kernel->who_runs();
    ReplayLog* history = maker ? maker->history() : nullptr;
    return history ? history->next_channel() : 0;
}

void AnyChannel::put_on(Carrier& carrier) {
    if (message_ || slot_ || listener_)
        throw std::logic_error("channel " + name_ + " cannot be put on a link while a process communicates on it");
    carrier_ = &carrier;
    note_particulars();
}

void AnyChannel::note_particulars() { is_particular_ = carrier_ || output_attempt_ || input_attempt_; }

void AnyChannel::expect_outputter(const Process& process) { own(outputter_, process, "outputs to"); }

void AnyChannel::expect_inputter(const Process& process) { own_input(process); }

[[gnu::cold]] void AnyChannel::change_owner(User& end, const Process& process, const char* verb) {
    const bool inside = &end == &outputter_ ? outputter_inside_ : inputter_inside_;
    if (end.process && (inside || !may_follow(end, process)))
        throw std::logic_error(fmt::format("process {} {} channel {}, but this end belongs to {}: a channel has one "
                                           "outputting and one inputting process",
                                           process.path(), verb, name_,
                                           end.outermost == &process.outermost() ? "another component of a PAR"
                                                                                 : "process " + end.outermost->path()));
    end = user(process);
}

/// Throws, because the process gave up a message at this end and did not reset the end.
void AnyChannel::refuse_unreset(const Process& self, const char* verb) const {
    throw std::logic_error(
        fmt::format("process {} {} channel {}, on which it gave up a message: reset this end of the channel first",
                    self.path(), verb, name_));
}

void AnyChannel::refuse_without_carrier(const Process& self, const Process& other) const {
    throw std::logic_error(fmt::format("channel {} joins process {} on {} and process {} on {}, and no link carries it",
                                       name_, other.path(), other.executive()->name(), self.path(),
                                       self.executive()->name()));
}

void AnyChannel::tell_trace(const Kernel& kernel) const { kernel.trace()->communicated(*this, kernel.now()); }

void AnyChannel::attempt_output(AttemptObserver* attempt) {
    if (attempt)
        require_can_be_given_up(carrier_, *this);
    output_attempt_ = attempt;
    note_particulars();
}

void AnyChannel::attempt_input(AttemptObserver* attempt) {
    if (attempt)
        require_can_be_given_up(carrier_, *this);
    input_attempt_ = attempt;
    note_particulars();
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
    own(outputter_, Kernel::here().running(), "resets");
    require_unused(message_, *this);
    output_out_of_order_ = false;
    return carrier_ ? carrier_->reset_output(*this) : 0;
}

std::uint64_t AnyChannel::reset_input() {
    require_can_be_given_up(carrier_, *this);
    own(inputter_, Kernel::here().running(), "resets");
    require_unused(slot_, *this);
    input_out_of_order_ = false;
    return carrier_ ? carrier_->reset_input(*this) : 0;
}

namespace {

/// Packs the lengths of two consecutive parts of a message into one word.
std::uint64_t two_parts(const WireForm& form, std::size_t first) {
    return std::uint64_t{form[first]} << 32 | form[first + 1];
}

} // namespace

void AnyChannel::note_output(ReplayLog& history, const WireForm& form) const {
    if (form.total() == 0)
        history.record_unrepeatable(); // a link refuses a message without bytes
    history.record(ReplayLog::Action::output, identity() ^ form.parts(), {two_parts(form, 0), two_parts(form, 2)});
}

void AnyChannel::note_input(ReplayLog& history) const { history.record(ReplayLog::Action::input, identity()); }

void AnyChannel::hand_over() {
    note_communication(inputter_.process->kernel());
    move_message(message_, slot_);
    message_ = slot_ = nullptr;
}

void AnyChannel::take_from(AnyChannel& other) {
    note_communication(inputter_.process->kernel());
    move_message(other.message_, slot_);
    slot_ = nullptr;
}

MessageBytes AnyChannel::message_in_bytes() const {
    MessageBytes bytes;
    byte_form()->write(message_, bytes);
    return bytes;
}

void AnyChannel::hand_over(std::span<const std::uint8_t> bytes) {
    byte_form()->read(bytes, slot_);
    note_communication(inputter_.process->kernel());
    slot_ = nullptr;
}

void AnyChannel::hand_over_packed(std::span<const std::uint8_t> bytes) {
    packed_form()->read(bytes, slot_);
    note_communication(inputter_.process->kernel());
    slot_ = nullptr;
}

} // namespace placedpar
