#pragma once

#include "iserver/terminal.hpp"

#include <termios.h>

#include <functional>

namespace placedpar::iserver {

/// Writes a text unchanged to standard output, or to standard error if the command writes a file to standard output.
/// Returns false if the reader of the output has gone. Throws UserError if the text cannot be written for another
/// reason. REQUIRES: SIGPIPE is ignored.
bool write_to_screen(std::string_view text);

/// The terminal on which PlacedPar was started, or the files and pipes that replace it, as the screen and keyboard of a
/// transputer program. Like INMOS's server for Unix, the class reads each key at once, without echo, and Enter as 13.
/// In a file or pipe, a newline stands for Enter. When the program asks for a line, the terminal lets the user edit it,
/// with echo.
class Console : public Terminal {
public:
    /// While the console waits for input, it calls `interrupted` several times a second; if the result is true, the
    /// input ends. `unread` is called when the reader of the output has gone. REQUIRES: a handler catches the signals
    /// that would end the program. Otherwise the terminal would keep its settings for keys.
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
    /// Reads the available input. If there is none and `waits` is true, waits for input.
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
