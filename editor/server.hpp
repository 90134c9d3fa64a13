#pragma once

#include <functional>
#include <iosfwd>
#include <memory>
#include <string>

namespace placedpar::editor {

/// A server of the Language Server Protocol for netlists, configurations, occam and studies. It knows nothing of how
/// messages travel.
class LanguageServer {
public:
    /// `send` sends a message to the editor.
    explicit LanguageServer(std::function<void(const std::string&)> send);
    ~LanguageServer();

    /// Takes a message from the editor, and sends the answer if it is a request. A wrong message is answered with an
    /// error.
    void take(const std::string& message);
    /// Answers what is not a message.
    void refuse(const std::string& why);
    /// Checks the texts that have changed, and sends what is wrong with them. To be called when no message waits, so
    /// that quick changes are checked once.
    void publish();

    bool has_ended() const; ///< the editor has sent "exit"
    bool was_shut_down() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Serves an editor until it ends or the input does. Returns whether the editor has shut the server down before.
bool serve_editor(std::istream&, std::ostream&);

} // namespace placedpar::editor
