#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace placedpar::iserver {

/// The screen and the keyboard of a transputer program.
class Terminal {
public:
    virtual ~Terminal() = default;

    /// Shows a text. The caller has made it safe for a terminal by VisibleText.
    virtual void write(std::string_view text) = 0;
    /// Waits for a key. The key is not shown. Returns nullopt if the input has ended.
    virtual std::optional<std::uint8_t> wait_for_key() = 0;
    /// Returns a key that has been pressed, without waiting.
    virtual std::optional<std::uint8_t> pressed_key() = 0;
    /// Waits for a line. Returns the line with its newline, if it has one; "" if the input has ended.
    virtual std::string line() = 0;
    /// Returns true if it is known that the input has ended.
    virtual bool at_end() const = 0;
    /// Returns whether a person sees the screen and presses the keys.
    virtual bool is_interactive() const = 0;
};

/// A terminal without a person: a text that is given in advance contains all keys and lines.
class ScriptedTerminal : public Terminal {
public:
    ScriptedTerminal(std::string keys, std::function<void(std::string_view)> screen)
        : keys_(std::move(keys)), screen_(std::move(screen)) {}

    void write(std::string_view text) override { screen_(text); }
    std::optional<std::uint8_t> wait_for_key() override { return pressed_key(); }
    std::optional<std::uint8_t> pressed_key() override;
    std::string line() override;
    bool at_end() const override { return used_ == keys_.size(); }
    bool is_interactive() const override { return false; }

private:
    std::string keys_;
    std::size_t used_ = 0;
    std::function<void(std::string_view)> screen_;
};

/// Makes a program's output safe for a terminal. Unsafe output could send an answer to the keyboard, change a window's
/// title, or leave the terminal in another mode. These pass unchanged: UTF-8, newline, return, tab, backspace, bell,
/// and the ANSI sequences that move the cursor, clear the screen or a line, or set colours. Other control characters
/// become ^A, ^[ and so on; other bytes become \xff and so on.
class VisibleText {
public:
    /// Returns the visible form of the bytes. A sequence or character that is not complete waits for later bytes.
    std::string next(std::string_view bytes);
    /// Call this function at the end of the output. Returns the visible form of an incomplete sequence or character. If
    /// the output has set colours, also returns the sequence that resets them.
    std::string end();

private:
    std::string begun_; ///< an incomplete sequence or character
    bool coloured_ = false;
};

} // namespace placedpar::iserver
