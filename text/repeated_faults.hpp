#pragma once

#include "text/diagnostic.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace placedpar {

/// Merges faults that occur in many lines. Two faults are of one kind if their messages differ only in digits, and
/// their lines differ.
class RepeatedFaults {
public:
    /// Returns the first fault of each new kind; its message has the number of such faults among `faults`. Faults of
    /// earlier kinds are only counted.
    std::vector<Diagnostic> take(std::vector<Diagnostic> faults);
    /// Returns the faults that were only counted, as one line a kind; "" if there are none.
    std::string later() const;

private:
    struct Kind {
        std::string message; ///< of the first
        std::size_t line, more = 0, last = 0;
    };
    std::map<std::string, Kind> kinds_; ///< by message with all digits replaced
};

} // namespace placedpar
