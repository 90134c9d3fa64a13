#pragma once

#include <string>

namespace placedpar {

/// One line on standard error that says what is going on; silent when that is not a terminal.
class Progress {
public:
    Progress();
    ~Progress() { clear(); }
    void show(const std::string& what);
    void clear();

private:
    bool terminal_;
};

} // namespace placedpar
