#include "runtime/executive.hpp"

#include "runtime/kernel.hpp"

namespace placedpar {

void compute(Cycles cycles) {
    if (Executive* executive = Kernel::current()->running().executive())
        executive->compute(cycles);
}

} // namespace placedpar
