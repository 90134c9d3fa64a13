#pragma once

#include "python/module/channel_end.hpp"
#include "runtime/time.hpp"

#include <cstdint>
#include <memory>

namespace placedpar::python {

/// What a body yields: something that its process does. The result is what the `yield` returns.
struct Operation {
    /// `skip` and `never` are only guards of an ALT. `input`, `wait`, `until` and `after` may be guards, too.
    enum class Kind : unsigned char { output, input, compute, wait, until, after, alt, par, stop, skip, never };

    Kind kind = Kind::stop;
    std::shared_ptr<ChannelEnd> end = nullptr;
    std::int64_t number = 0;        ///< cycles of `compute`, picoseconds, or ticks of the clock (`after`)
    std::int64_t words_outside = 0; ///< of `compute`
    pybind11::object value = {};    ///< message of an output; tuple of guards (ALT) or components (PAR)
};

/// Declares the operations in the module. See python/placedpar/process.py for their use.
void add_operations(pybind11::module_&);

} // namespace placedpar::python
