#include "iserver/board.hpp"

#include "iserver/descriptors.hpp"
#include "text/counted.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

namespace placedpar::iserver {

namespace {

using Clock = std::chrono::steady_clock;

std::string reason(int error = errno) { return std::generic_category().message(error); }

OpenFile open_device(const std::string& name) {
    OpenFile device(::open(name.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    struct stat status;
    if (!device || ::fstat(device.descriptor(), &status) != 0)
        throw UserError(fmt::format("{}: {}", name, reason()));
    if (!S_ISCHR(status.st_mode))
        throw UserError(fmt::format("{}: a board is a character device or \"tcp:HOST:PORT\"", name));
    termios settings;
    if (::tcgetattr(device.descriptor(), &settings) == 0) {
        ::cfmakeraw(&settings);
        ::tcsetattr(device.descriptor(), TCSANOW, &settings);
    }
    return device;
}

/// Tries to connect to one address. Returns 0 for success, EINTR after an interruption, or another number of errno.
int try_to_connect(const OpenFile& socket, const addrinfo& address, const Interrupted& interrupted) {
    if (::connect(socket.descriptor(), address.ai_addr, address.ai_addrlen) == 0)
        return 0;
    if (errno != EINPROGRESS)
        return errno;
    if (wait_for(socket.descriptor(), POLLOUT, interrupted, std::nullopt) == Wait::interrupted)
        return EINTR;
    int error = 0;
    socklen_t size = sizeof error;
    ::getsockopt(socket.descriptor(), SOL_SOCKET, SO_ERROR, &error, &size);
    return error;
}

OpenFile connect_by_network(const std::string& name, const Interrupted& interrupted) {
    const auto addresses = addresses_of(name, network_address(name));
    int error = 0;
    for (const addrinfo* each = addresses.get(); each; each = each->ai_next) {
        OpenFile socket(::socket(each->ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
        error = socket ? try_to_connect(socket, *each, interrupted) : errno;
        const int at_once = 1; // sends each short reply at once, since the program waits for it
        ::setsockopt(socket.descriptor(), IPPROTO_TCP, TCP_NODELAY, &at_once, sizeof at_once);
        if (error == 0 || error == EINTR)
            return error == 0 ? std::move(socket) : OpenFile{};
    }
    throw UserError(fmt::format("{}: {}", name, reason(error)));
}

/// Boots a transputer board with a program, and serves the program's requests.
class BoardSession {
public:
    BoardSession(int board, const std::string& name, Server& server, const Interrupted& interrupted,
                 std::chrono::milliseconds patience)
        : board_(board), name_(name), server_(server), interrupted_(interrupted), patience_(patience) {}

    BoardRun run(std::string_view program);

private:
    bool send(std::string_view bytes, std::string_view what);
    ByteView receive();
    void serve(Clock::time_point start);
    void note(ByteView request, const Answer&);
    [[noreturn]] void fail(const std::string& why) const { throw UserError(fmt::format("{}: {}", name_, why)); }

    int board_;
    const std::string& name_;
    Server& server_;
    const Interrupted& interrupted_;
    std::chrono::milliseconds patience_;
    BoardRun run_;
    std::size_t noted_bytes_ = 0;
    PacketReader reader_;
    std::array<std::uint8_t, 512> received_;
};

/// Sends the bytes. Returns false if the run was interrupted.
bool BoardSession::send(std::string_view bytes, std::string_view what) {
    for (std::size_t sent = 0; sent < bytes.size();) {
        const Wait wait = wait_for(board_, POLLOUT, interrupted_, patience_);
        if (wait == Wait::interrupted)
            return false;
        if (wait == Wait::too_long)
            fail(fmt::format(
                "the board has taken {} of {} bytes of {}, and then none for {} s; the board may need a reset", sent,
                bytes.size(), what, std::chrono::duration<double>(patience_).count()));
        const ssize_t count = ::write(board_, bytes.data() + sent, bytes.size() - sent);
        if (count < 0 && errno != EAGAIN && errno != EINTR)
            fail(fmt::format("byte {} of {} cannot be sent: {}", sent + 1, what, reason()));
        sent += count > 0 ? static_cast<std::size_t>(count) : 0;
    }
    return true;
}

/// Receives some bytes; returns none after an interruption. Between two requests there is no time limit, because the
/// program may compute for as long as it likes.
ByteView BoardSession::receive() {
    for (;;) {
        const Wait wait =
            wait_for(board_, POLLIN, interrupted_, reader_.held() > 0 ? std::optional(patience_) : std::nullopt);
        if (wait == Wait::interrupted)
            return {};
        if (wait == Wait::too_long)
            fail(fmt::format("the board stopped within request {}: the number of missing bytes is {}",
                             run_.requests + 1, reader_.wanted()));
        const ssize_t count = ::read(board_, received_.data(), received_.size());
        if (count > 0)
            return ByteView(received_).first(static_cast<std::size_t>(count));
        if (count == 0 || (errno != EAGAIN && errno != EINTR))
            fail(fmt::format("the board closed the connection after {}: {}", counted(run_.requests, "request"),
                             count == 0 ? "the program had not ended yet" : reason()));
    }
}

void BoardSession::serve(Clock::time_point start) {
    while (run_.state == ServerState::running) {
        ByteView bytes = receive();
        if (bytes.empty())
            return;
        while (!bytes.empty() && run_.state == ServerState::running) {
            const ByteView request = reader_.take(bytes);
            if (!reader_.refusal().empty())
                fail(reader_.refusal());
            if (request.empty())
                break;
            const Answer answer =
                server_.answer(request, std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - start));
            run_.state = answer.state;
            run_.exit = answer.exit;
            ++run_.requests;
            note(request, answer);
            if (!send({reinterpret_cast<const char*>(answer.reply.data()), answer.reply.size()}, "a reply"))
                return;
        }
    }
}

void BoardSession::note(ByteView request, const Answer& answer) {
    noted_bytes_ += request.size() + answer.reply.size();
    if (noted_bytes_ <= BoardRun::most_noted_bytes)
        run_.exchanges.push_back({{request.begin(), request.end()}, answer});
}

BoardRun BoardSession::run(std::string_view program) {
    const Clock::time_point begin = Clock::now();
    const bool booted = send(program, "the program");
    const Clock::time_point start = Clock::now();
    if (booted)
        serve(start);
    server_.finish();
    run_.boot_time = std::chrono::duration_cast<std::chrono::microseconds>(start - begin);
    run_.run_time = std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - start);
    return run_;
}

} // namespace

OpenFile connect_board(const std::string& name, const Interrupted& interrupted) {
    return name.starts_with("tcp:") ? connect_by_network(name, interrupted) : open_device(name);
}

BoardRun serve_board(std::string_view program, const OpenFile& board, const std::string& name, Server& server,
                     const Interrupted& interrupted, std::chrono::milliseconds patience) {
    return BoardSession(board.descriptor(), name, server, interrupted, patience).run(program);
}

} // namespace placedpar::iserver
