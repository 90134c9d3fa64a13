#include "runtime/replay_log.hpp"

namespace placedpar {

namespace {

/// Returns an identity for the object with this number that the process `maker` makes, the same in each run.
std::uint64_t name_of(std::uint64_t maker, std::uint64_t number) {
    Fingerprint both;
    both.mix(maker);
    both.mix(number);
    return both.value();
}

} // namespace

void ReplayLog::diverge() {
    diverge_quietly();
    throw ReplayDivergence{};
}

void ReplayLog::diverge_quietly() {
    course_.has_diverged = true;
    course_.on_divergence();
}

void ReplayLog::record_quietly(Action action, std::uint64_t what) {
    if (is_silent_)
        return;
    if (original_ && actions_ == original_->actions_)
        diverge_quietly();
    note(action, what);
}

void ReplayLog::record_unrepeatable() {
    course_.can_be_repeated = false;
    if (repeats())
        diverge_quietly();
}

ReplayLog& ReplayLog::component() {
    std::uint64_t name = name_of(name_, ++begun_);
    if (!original_) {
        constexpr std::size_t readings = 20; // a history takes about as much memory as 20 observations
        take_room(readings);
        return components_.emplace_back(course_, name);
    }
    if (next_component_ == original_->components_.end())
        diverge();
    return components_.emplace_back(course_, *next_component_++);
}

void ReplayLog::components_have_ended() {
    if (original_ || !course_.can_be_repeated)
        components_.clear();
}

std::uint64_t ReplayLog::next_channel() { return name_of(~name_, ++channels_); }

void ReplayLog::end() {
    if (original_ && (actions_ != original_->actions_ || fingerprint_.value() != original_->fingerprint_.value()))
        diverge();
}

/// Subtracts the number of observations from `room`, the number that may still be recorded in this run. If `room` is
/// too small, marks the run as one that cannot be repeated, and stops recording.
void ReplayLog::take_room(std::size_t readings) {
    if (course_.room < readings)
        course_.can_be_repeated = false;
    if (!course_.can_be_repeated)
        seen_ = {};
    else
        course_.room -= readings;
}

void ReplayLog::note_observation(Action what, std::int64_t seen) {
    take_room(1);
    if (course_.can_be_repeated)
        seen_.push_back({when_and_what(what), seen});
    note(what, 0);
}

std::int64_t ReplayLog::observed_then(Action what) {
    const bool asked_then =
        seen_again_ < original_->seen_.size() && original_->seen_[seen_again_].when_and_what == when_and_what(what);
    if (asked_then && !course_.has_diverged) {
        note(what, 0);
        return original_->seen_[seen_again_++].value;
    }
    constexpr std::uint64_t very_often = 100'000; // the same as Kernel::unchecked_readings
    if (what != Action::now || ++asked_in_vain_ > very_often)
        diverge();
    diverge_quietly();
    return 0;
}

} // namespace placedpar
