#pragma once

#include "iserver/terminal.hpp"

#include <termios.h>

#include <functional>

namespace placedpar::iserver {

/// Writes a text unchanged to standard output, or to standard error if standard output receives a file. Returns false
/// if its reader has gone. Throws UserError if it cannot be written for another reason. REQUIRES: SIGPIPE is ignored.
bool write_to_screen(std::string_view text);

/// The terminal on which PlacedPar was started, or the files and pipes that stand in for it. Keys are read as INMOS's
/// server for Unix reads them: each at once, without echo, Enter as 13. In a file or pipe, a newline stands for Enter.
/// Lines are edited and echoed by the terminal.
class Console : public Terminal {
public:
    /// While the console waits for input, it asks several times a second whether the program was interrupted. If so,
    /// the input has ended. REQUIRES: a handler catches the signals that would end the program, or the terminal stays
    /// as it is for keys. `unread` is called when the reader of what it writes has gone.
    explicit Console(
        std::function<bool()> interrupted, int input = 0, std::function<void()> unread = [] {});
    /// Restores the terminal.
    ~Console() override;
    Console(const Console&) = delete;
    Console& operator=(const Console&) = delete;

    void write(std::string_view text) override {
        if (!write_to_screen(text))
            unread_();
    }
    std::optional<std::uint8_t> wait_for_key() override;
    std::optional<std::uint8_t> pressed_key() override;
    std::string line() override;
    bool at_end() const override { return ended_ && read_.empty(); }
    bool is_interactive() const override { return is_terminal_; }

private:
    enum class Mode { as_found, keys };

    void set_mode(Mode);
    /// Reads what there is. If there is nothing, waits if `waits`.
    void read_more(bool waits);
    std::optional<std::uint8_t> next_key();

    std::function<bool()> interrupted_;
    std::function<void()> unread_;
    int input_;
    termios found_{}; ///< the terminal's settings at the start
    bool is_terminal_;
    Mode mode_ = Mode::as_found;
    bool ended_ = false;
    std::string read_; ///< bytes that were read, and not yet used
};

} // namespace placedpar::iserver
