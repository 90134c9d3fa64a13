#include "runtime/executive.hpp"

#include "runtime/kernel.hpp"

namespace placedpar {

void compute(Cycles cycles, const Grain& grain) {
    Kernel& kernel = Kernel::here();
    Process& self = kernel.running();
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
