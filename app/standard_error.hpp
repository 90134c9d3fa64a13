#pragma once

#include <string>

namespace placedpar {

// These functions write to standard error while the program works.

/// Prints the warnings unchanged. This function can be used as a WarningSink.
void print_warnings(const std::string& warnings);

/// Shows one line about the work in progress. If standard error is not a terminal, shows nothing.
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
