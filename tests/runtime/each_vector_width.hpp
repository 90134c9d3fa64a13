#pragma once

#include "runtime/vector_width.hpp"

#include <doctest/doctest.h>

namespace placedpar::test {

/// Calls the function once for each vector width of this machine's processor.
template <class Do>
void in_each_vector_width(const Do& do_it) {
    for (std::size_t width : vector_widths) {
        if (width > widest_vector_width())
            break;
        use_vector_width(width);
        CAPTURE(width);
        do_it();
    }
    use_vector_width(widest_vector_width());
}

} // namespace placedpar::test
