#pragma once

#include "text/diagnostic.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace placedpar {

/// Shortens the report of a file in which many lines have the same fault: only the first fault of each kind is shown.
/// Faults are of one kind if their messages differ only in numbers.
class RepeatedFaults {
public:
    /// Takes the faults of the next part of the file. Returns the first fault of each kind that is new, and further
    /// faults of this kind in the same line. The message of the first fault states how many other lines of this part
    /// have such faults. If a fault's kind was new in an earlier part, the fault is only counted, for later().
    /// REQUIRES: the faults of a kind are in the order of their lines.
    std::vector<Diagnostic> take(std::vector<Diagnostic> faults);
    /// Returns a text about the faults that were only counted, with one line for each kind; "" if there are none.
    std::string later() const;

private:
    struct Kind {
        std::string message; ///< message of the first fault
        std::size_t line, more = 0, last = 0;
    };
    std::map<std::string, Kind> kinds_; ///< key: the message with each number replaced by "#"
};

} // namespace placedpar
