#pragma once

#include "iserver/board.hpp"
#include "iserver/host_folder.hpp"
#include "iserver/packet.hpp"

#include <optional>
#include <string>

namespace placedpar::iserver {

/// Offers an emulated transputer to other programs as if it were a real board. Another program, such as a server of
/// INMOS's, boots the transputer and serves its requests. The connection is a socket or a pseudo terminal, over which
/// the bytes of the transputer's link travel.
class OfferedBoard {
public:
    /// `where` is "pty", "tcp:PORT" for programs on this computer only, or "tcp:ADDRESS:PORT". Port 0 means any free
    /// port. If this fails, throws UserError with the place and the reason.
    OfferedBoard(const std::string& where, Interrupted);

    /// Returns the name that connect_board() takes, such as "tcp:127.0.0.1:5000" or "/dev/pts/3".
    const std::string& name() const { return name_; }
    /// Waits for a program that connects. Returns false after an interruption.
    bool wait_for_program();
    /// Returns the bytes that have come from the program; if `waits` is true, waits until some have come. Returns
    /// nothing if the program has closed the connection, or after an interruption. REQUIRES: a program has connected.
    std::optional<Bytes> read(bool waits);
    /// Writes all bytes. Returns false if the program has closed the connection, or after an interruption. REQUIRES: a
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
