#pragma once

#include <stdexcept>

namespace placedpar {

/// A file of the user's that was refused; what() is the rendered diagnostics, whole lines.
class RefusedInput : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

} // namespace placedpar
