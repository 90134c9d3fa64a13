#include "runtime/executive.hpp"

#include "runtime/kernel.hpp"
#include "runtime/replay_log.hpp"

namespace placedpar {

namespace {

/// Records the computation in the process's history. Returns whether the process only repeats the history, in which
/// computations take no time. The function is not inlined, so that the stack frames of processes without a history stay
/// small.
[[gnu::noinline]] bool only_repeats(ReplayLog& history, Cycles cycles, const CodeShape& grain) {
    auto word = [](Cycles number) { return static_cast<std::uint64_t>(number); };
    if (cycles < Cycles{0} || grain.between_points < Cycles{1} || grain.instruction < Cycles{1} ||
        grain.words_outside < 0)
        history.record_unrepeatable();
    history.record(
        ReplayLog::Action::computation, word(cycles),
        {word(grain.between_points) << 32 ^ word(grain.instruction), static_cast<std::uint64_t>(grain.words_outside)});
    return history.repeats();
}

} // namespace

void compute(Cycles cycles, const CodeShape& grain) {
    Kernel& kernel = Kernel::here();
    Process& self = kernel.running();
    if (ReplayLog* history = kernel.begin_operation(self); history && only_repeats(*history, cycles, grain))
        [[unlikely]]
        return;
    if (self.executive())
        self.compute(cycles, grain);
    else
        kernel.count_timeless_operation();
}

void stop(const SourceLocation& where) {
    Process& self = Kernel::here().running();
    for (;;)
        self.wait_for(Activity::stopped, nullptr, where);
}

} // namespace placedpar
