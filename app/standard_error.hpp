#pragma once

#include <string>

namespace placedpar {

// These functions write to standard error while the program works.

/// Prints the warnings unchanged; this function is a WarningSink.
void print_warnings(const std::string& warnings);

/// Shows one line about the work in progress; shows nothing if standard error is not a terminal.
class ProgressLine {
public:
    ProgressLine();
    ~ProgressLine() { clear(); }
    void show(const std::string& what);
    void clear();

private:
    bool terminal_;
    std::string shown_;
};

} // namespace placedpar
