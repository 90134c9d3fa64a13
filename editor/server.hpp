#pragma once

#include <functional>
#include <iosfwd>
#include <memory>
#include <string>

namespace placedpar::editor {

/// Serves the Language Server Protocol for netlists, configurations, occam and studies. The class does not depend on
/// how messages are transported.
class LanguageServer {
public:
    /// `send` sends a message to the editor.
    explicit LanguageServer(std::function<void(const std::string&)> send);
    ~LanguageServer();

    /// Handles a message from the editor. Answers a request with its result, and an invalid message with an error.
    void take(const std::string& message);
    /// Sends an error for input that is not a message.
    void refuse(const std::string& why);
    /// Checks the texts that have changed, and sends their diagnostics. Call it when no message waits, so that several
    /// quick changes are checked only once.
    void publish();

    bool has_ended() const; ///< the editor has sent "exit"
    bool was_shut_down() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Serves an editor until it sends "exit" or the input ends. Returns whether the editor has sent "shutdown" before.
bool serve_editor(std::istream&, std::ostream&);

} // namespace placedpar::editor
