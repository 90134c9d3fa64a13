#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace placedpar::test {

/// A process that alternates between rests and computations. Their lengths are in processor cycles. A rest may be 0. A
/// computation has descheduling points at a fixed distance and at its end.
struct Load {
    bool high = false;
    struct Step {
        std::int64_t rest, compute, between_points = 1;
    };
    std::vector<Step> steps;
};

/// Models a processor cycle by cycle. It looks at its queues in every cycle, and finds the end of each computation. It
/// shares no code with runtime/hardware/processor.cpp, which simulates whole turns.
class ProcessorModel {
public:
    static constexpr std::int64_t slice = 20'480, interrupt = 19;

    explicit ProcessorModel(const std::vector<Load>&);
    /// Returns for each process the cycles at which its computations end.
    std::vector<std::vector<std::int64_t>> run();
    std::int64_t busy() const { return busy_; }

private:
    struct State {
        std::size_t step = 0;
        std::int64_t left = 0, wakes = -1;
        std::int64_t rest_began = 0; ///< orders alarms at the same time
    };
    void step_ended();
    void go_on(std::size_t process);
    void wake_sleepers();
    void become_ready(std::size_t process);
    void take_next();
    void slice_over();
    bool all_over() const;

    std::vector<Load> loads_;
    std::vector<State> states_;
    std::vector<std::vector<std::int64_t>> ended_;
    std::deque<std::size_t> high_, low_;
    std::optional<std::size_t> current_, interrupted_;
    std::int64_t now_ = 0, since_ = 0, busy_ = 0, rests_ = 0;
};

} // namespace placedpar::test
