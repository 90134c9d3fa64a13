#pragma once

#include <functional>
#include <iosfwd>
#include <memory>
#include <string>

namespace placedpar::editor {

/// Answers the messages of an editor by the Language Server Protocol: errors, completion, explanations, declarations.
/// The texts are netlists, programs and configurations in occam, and studies (experiments with a netlist, in TOML). The
/// class does not depend on how messages are transported.
class LanguageServer {
public:
    /// `send` sends a message to the editor.
    explicit LanguageServer(std::function<void(const std::string&)> send);
    ~LanguageServer();

    /// Handles a message from the editor. Answers a request with its result or an error, and an invalid message with an
    /// error.
    void take(const std::string& message);
    /// Sends an error with the text `why`, for input that is not a message.
    void refuse(const std::string& why);
    /// Checks the texts that have changed, and sends their errors and warnings. Call publish() when no message waits,
    /// so that several quick changes are checked only once.
    void publish();

    bool has_ended() const; ///< the editor has sent "exit"
    bool was_shut_down() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Serves an editor over two streams, until the editor sends "exit" or the input ends. Returns whether the editor has
/// sent "shutdown" before.
bool serve_editor(std::istream&, std::ostream&);

} // namespace placedpar::editor
