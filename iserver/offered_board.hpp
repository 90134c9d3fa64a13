#pragma once

#include "iserver/board.hpp"
#include "iserver/host_folder.hpp"
#include "iserver/packet.hpp"

#include <optional>
#include <string>

namespace placedpar::iserver {

/// The outer end of a link of an emulated machine, which another program boots and serves as it would a real board. The
/// link is a socket or a pseudo terminal; connect_board() reaches both.
class OfferedBoard {
public:
    /// `where`: "pty", "tcp:PORT" for programs on this computer, or "tcp:ADDRESS:PORT". Port 0 is any free port. Throws
    /// UserError, with the place and the reason.
    OfferedBoard(const std::string& where, Interrupted);

    /// Returns the name that connect_board() takes, such as "tcp:127.0.0.1:5000" or "/dev/pts/3".
    const std::string& name() const { return name_; }
    /// Waits for a program that connects. Returns false after an interruption.
    bool wait_for_program();
    /// Returns the bytes that have come from the program. If `waits` and there are none, waits for some. Returns
    /// nothing if the program has closed the link, or after an interruption. REQUIRES: a program has connected.
    std::optional<Bytes> read(bool waits);
    /// Writes all bytes. Returns false if the program has closed the link, or after an interruption. REQUIRES: a
    /// program has connected; SIGPIPE is ignored.
    bool write(ByteView);

private:
    void listen(const std::string& where);
    void open_terminal();

    Interrupted interrupted_;
    OpenFile listener_; ///< the listening socket
    OpenFile link_;
    std::string name_;
};

} // namespace placedpar::iserver
