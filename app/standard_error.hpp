#pragma once

#include <string>

namespace placedpar {

// What the program says on standard error while it works.

/// A WarningSink: prints them as they are.
void print_warnings(const std::string& warnings);

/// One line that says what is going on; silent when standard error is not a terminal.
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
