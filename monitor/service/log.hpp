#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace placedpar::monitor {

/// Writes messages for the operator, each on its own line with the time (UTC). The log never blocks the service. If a
/// pipe is not read, a terminal is stopped or a disk is full, the log drops lines. It counts the dropped lines, and
/// reports their number when writing is possible again. Only one thread may use the log at a time.
class Log {
public:
    /// Writes to an open file, such as standard error; -1 discards everything.
    explicit Log(int file);

    void say(std::string_view sentence);
    /// If lines were dropped and writing is possible again, writes how many. Call this function a few times a second.
    void tick();
    /// Opens the file by its name again, after the old file was moved away, and creates it if needed.
    void reopen();
    bool is_terminal() const;

private:
    /// Writes as much of `text` as possible without waiting, and keeps the rest for later. Returns false if nothing
    /// could be written.
    bool write(const std::string& text);

    int file_;
    std::string path_; ///< "" if the file has no name
    std::string rest_; ///< unwritten rest of a line
    std::size_t left_out_ = 0;
};

} // namespace placedpar::monitor
