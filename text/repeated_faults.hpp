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
    /// Returns the first fault of each new kind; its message states how many other lines have such faults. Lines with
    /// faults of earlier kinds are only counted. REQUIRES: the faults of a kind are in the order of their lines.
    std::vector<Diagnostic> take(std::vector<Diagnostic> faults);
    /// Returns a text about the lines that were only counted, with one line for each kind of fault; "" if there are
    /// none.
    std::string later() const;

private:
    struct Kind {
        std::string message; ///< message of the first fault
        std::size_t line, more = 0, last = 0;
    };
    std::map<std::string, Kind> kinds_; ///< by message with all digits replaced
};

} // namespace placedpar
