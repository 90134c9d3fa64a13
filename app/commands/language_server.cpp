#include "app/command.hpp"
#include "app/options.hpp"
#include "editor/server.hpp"

#include <iostream>

namespace placedpar {

namespace {

ExitCode serve() {
    std::ios::sync_with_stdio(false); // so that the server knows whether more input has arrived
    return editor::serve_editor(std::cin, std::cout) ? ExitCode::success : ExitCode::bad_input;
}

Action declare_language_server(Options& command, const std::string&) {
    command.add_footer("Editors start this command: see docs/guides/editors.md.");
    return serve;
}

} // namespace

extern const Command language_server_command{
    .name = "language-server",
    .about = "Serves an editor over standard input and output, by the Language Server Protocol",
    .place = 55,
    .declare = declare_language_server,
};

} // namespace placedpar
