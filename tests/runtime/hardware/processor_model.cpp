#include "processor_model.hpp"

#include <utility>

namespace placedpar::test {

ProcessorModel::ProcessorModel(const std::vector<Load>& loads)
    : loads_(loads), states_(loads.size()), ended_(loads.size()) {}

std::vector<std::vector<std::int64_t>> ProcessorModel::run() {
    for (std::size_t p = 0; p < loads_.size(); ++p) {
        states_[p].wakes = loads_[p].steps[0].rest;
        states_[p].rest_began = rests_++;
    }
    for (; !all_over(); ++now_) {
        step_ended();
        slice_over();
        wake_sleepers();
        slice_over();
        if (current_) {
            --states_[*current_].left;
            ++busy_;
        }
    }
    return ended_;
}

bool ProcessorModel::all_over() const {
    for (std::size_t p = 0; p < loads_.size(); ++p)
        if (states_[p].step < loads_[p].steps.size())
            return false;
    return true;
}

void ProcessorModel::step_ended() {
    while (current_ && states_[*current_].left == 0)
        go_on(*current_);
}

/// Continues a process at the end of a computation. The process begins the next computation, rests, or ends.
void ProcessorModel::go_on(std::size_t p) {
    ended_[p].push_back(now_);
    const auto& steps = loads_[p].steps;
    State& state = states_[p];
    if (++state.step < steps.size() && steps[state.step].rest == 0) {
        state.left = steps[state.step].compute;
        return;
    }
    if (state.step < steps.size()) {
        state.wakes = now_ + steps[state.step].rest;
        state.rest_began = rests_++;
    }
    current_.reset();
    take_next();
}

void ProcessorModel::wake_sleepers() {
    for (;;) {
        std::optional<std::size_t> first;
        for (std::size_t p = 0; p < states_.size(); ++p)
            if (states_[p].wakes == now_ && (!first || states_[p].rest_began < states_[*first].rest_began))
                first = p;
        if (!first)
            return;
        states_[*first].wakes = -1;
        become_ready(*first);
        slice_over();
    }
}

void ProcessorModel::become_ready(std::size_t p) {
    states_[p].left = loads_[p].steps[states_[p].step].compute;
    if (loads_[p].high && current_ && !loads_[*current_].high) {
        interrupted_ = std::exchange(current_, p);
        states_[p].left += interrupt;
        return;
    }
    (loads_[p].high ? high_ : low_).push_back(p);
    if (!current_)
        take_next();
}

void ProcessorModel::take_next() {
    if (!high_.empty()) {
        current_ = high_.front();
        high_.pop_front();
    } else if (interrupted_) {
        current_ = std::exchange(interrupted_, std::nullopt);
    } else if (!low_.empty()) {
        current_ = low_.front();
        low_.pop_front();
        since_ = now_;
    }
}

/// At the end of a timeslice period, a low-priority process that has run for a whole period yields at its next
/// descheduling point.
void ProcessorModel::slice_over() {
    if (!current_ || loads_[*current_].high || low_.empty())
        return;
    const State& state = states_[*current_];
    std::int64_t last_end = (now_ - 1) / slice * slice;
    bool at_point = state.left % loads_[*current_].steps[state.step].between_points == 0;
    if (!at_point || last_end - since_ < slice)
        return;
    low_.push_back(*current_);
    current_.reset();
    take_next();
}

} // namespace placedpar::test
