#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace placedpar::monitor {

/// Sentences for the operator, each a line with its time (UTC). It never waits: what cannot be written at once, since
/// a pipe is not read, a terminal is held or a disk is full, is left out and counted, and the count is told when
/// there is room again. One thread at a time.
class Log {
public:
    /// Writes to an open file, such as standard error; -1: nowhere.
    explicit Log(int file);

    void say(std::string_view sentence);
    /// Tells how many lines were left out, if that can be written now. To be called a few times a second.
    void tick();
    /// Opens the file of the same name, which is made when there is none: the old one was moved away.
    void reopen();
    bool is_terminal() const;

private:
    /// Writes what can be written at once and keeps the rest for later; false: nothing can be.
    bool write(const std::string& text);

    int file_;
    std::string path_; ///< empty: it is not a file that has a name
    std::string rest_; ///< of a line that was begun
    std::size_t left_out_ = 0;
};

} // namespace placedpar::monitor
