#pragma once

#include "runtime/time.hpp"

#include <string>

namespace placedpar {

/// A part of a run's critical path, as a trace draws it.
struct PathMark {
    std::string name;  ///< "computing: master on t[0]"
    std::string place; ///< the processor, direction of a link, or bus that it took; "" for none
    Time begin, end;   ///< begin < end
};

} // namespace placedpar
