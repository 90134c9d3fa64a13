#pragma once

#include "runtime/transputer/code_lines.hpp"
#include "runtime/transputer/core.hpp"

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <set>
#include <string>
#include <string_view>

namespace placedpar::transputer {

/// A simple debugger: executes the instructions of an emulated transputer step by step, and shows the state between
/// them. The user's commands are the lines of a stream. The debugger stops before the first instruction. Addresses are
/// hexadecimal, such as #80000070.
class Stepper final : public Core::Watcher {
public:
    /// Begins to watch the core. `lines` names places in the code. `print` is called with lines of text. The command
    /// `quit` and the end of the commands end the run before the next instruction. REQUIRES: the stepper and all
    /// arguments stay at their addresses during the run.
    Stepper(Core&, const CodeLines& lines, std::istream& commands, std::function<void(std::string_view)> print);
    Stepper(const Stepper&) = delete;
    Stepper& operator=(const Stepper&) = delete;

private:
    void begins(Word at) override;
    bool ends_run() const override { return has_left_; }
    void executed(Word, HalfCycles) override {}

    /// Carries out a command. Returns whether the core continues after the command.
    bool obey(const std::string& line);
    void break_at(const std::string& address);

    std::string here() const;
    std::string code(std::uint64_t lines) const;
    std::string workspace(std::uint64_t words) const;
    std::string words(Word address, std::uint64_t count) const;

    Core& core_;
    const CodeLines& lines_;
    std::istream& commands_;
    std::function<void(std::string_view)> print_;
    std::set<Word> breaks_;
    std::uint64_t steps_ = 1; ///< instructions until the next stop
    bool has_left_ = false;
};

} // namespace placedpar::transputer
