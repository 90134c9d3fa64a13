#include "runtime/executive.hpp"

#include "runtime/history.hpp"
#include "runtime/kernel.hpp"

namespace placedpar {

namespace {

/// Notes it, if the process keeps a history. Not inlined: few do, and the frames of those that compute are to be small.
[[gnu::noinline]] bool only_repeats(const Process& self, Cycles cycles, const Grain& grain) {
    self.kernel().heed_interruption();
    auto word = [](Cycles number) { return static_cast<std::uint64_t>(number); };
    History* history = self.history();
    if (history && (cycles < Cycles{0} || grain.between_points < Cycles{1} || grain.instruction < Cycles{1} ||
                    grain.words_outside < 0))
        history->does_what_is_not_noted();
    if (history)
        history->does(History::Action::computation, word(cycles),
                      {word(grain.between_points) << 32 ^ word(grain.instruction),
                       static_cast<std::uint64_t>(grain.words_outside)});
    return history && history->repeats();
}

} // namespace

void compute(Cycles cycles, const Grain& grain) {
    Kernel& kernel = Kernel::here();
    Process& self = kernel.running();
    if (kernel.is_attentive() && only_repeats(self, cycles, grain)) [[unlikely]]
        return;
    if (self.executive())
        self.compute(cycles, grain);
    else
        kernel.takes_no_time();
}

void stop(const SourceLocation& where) {
    Process& self = Kernel::here().running();
    for (;;)
        self.wait_for(Activity::stopped, nullptr, where);
}

} // namespace placedpar
