#pragma once

#include "python/module/channel_end.hpp"
#include "runtime/time.hpp"

#include <cstdint>
#include <memory>

namespace placedpar::python {

/// An operation that the body of a process in Python yields, such as an input. The body's `yield` returns the
/// operation's result.
struct Operation {
    /// `skip` and `never` are only guards of an ALT. `input`, `wait`, `until` and `after` may be guards, too.
    enum class Kind : unsigned char { output, input, compute, wait, until, after, alt, par, stop, skip, never };

    Kind kind = Kind::stop;
    std::shared_ptr<ChannelEnd> end = nullptr;
    std::int64_t number = 0;        ///< processor cycles (`compute`), ticks of the clock (`after`), or picoseconds
    std::int64_t words_outside = 0; ///< words in external memory that `compute` accesses
    pybind11::object value = {};    ///< message of an output; tuple of guards (ALT) or components (PAR)
};

} // namespace placedpar::python
