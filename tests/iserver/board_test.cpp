#include "iserver/board.hpp"

#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include "tests/iserver/served_program.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <functional>
#include <numeric>
#include <string>
#include <thread>

using namespace placedpar;
using iserver::BoardRun;
using iserver::Bytes;
using iserver::OpenFile;
using iserver::ServerState;
using test::Request;
using namespace std::chrono_literals;

namespace {

const std::string board_name = "board";
const iserver::Interrupted never = [] { return false; };

/// A board that takes a program of a known length and then does what the test says.
class FakeBoard {
public:
    FakeBoard(OpenFile end, std::size_t program_bytes, std::function<void(FakeBoard&)> behaviour)
        : end_(std::move(end)), thread_([this, program_bytes, behaviour = std::move(behaviour)] {
              program_ = receive(program_bytes);
              behaviour(*this);
              end_ = OpenFile();
          }) {}
    ~FakeBoard() { join(); }
    void join() {
        if (thread_.joinable())
            thread_.join();
    }

    void send(const Bytes& bytes) {
        for (std::size_t sent = 0; sent < bytes.size();)
            if (ssize_t count = ::write(end_.descriptor(), bytes.data() + sent, bytes.size() - sent); count > 0)
                sent += static_cast<std::size_t>(count);
            else
                return;
    }
    Bytes receive(std::size_t size) {
        Bytes bytes(size);
        std::size_t got = 0;
        while (got < size)
            if (ssize_t count = ::read(end_.descriptor(), bytes.data() + got, size - got); count > 0)
                got += static_cast<std::size_t>(count);
            else
                break;
        bytes.resize(got);
        return bytes;
    }
    /// Sends a request in two parts, and returns the reply with its length.
    Bytes ask(const Request& request) {
        Bytes packet = request.bytes();
        packet.resize(std::max<std::size_t>(6, packet.size() + packet.size() % 2));
        const auto length = static_cast<std::uint16_t>(packet.size());
        packet.insert(packet.begin(), {static_cast<std::uint8_t>(length), static_cast<std::uint8_t>(length >> 8)});
        send({packet.begin(), packet.begin() + 3});
        std::this_thread::sleep_for(1ms);
        send({packet.begin() + 3, packet.end()});
        Bytes reply = receive(2);
        const Bytes rest = reply.size() == 2 ? receive(reply[0] + 256U * reply[1]) : Bytes();
        reply.insert(reply.end(), rest.begin(), rest.end());
        return reply;
    }
    const Bytes& program() const { return program_; }

private:
    OpenFile end_;
    Bytes program_;
    std::thread thread_;
};

struct Ends {
    OpenFile host, board;
};

Ends connected_sockets() {
    std::array<int, 2> ends{};
    REQUIRE(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) == 0);
    ::fcntl(ends[0], F_SETFL, O_NONBLOCK);
    return {.host = OpenFile(ends[0]), .board = OpenFile(ends[1])};
}

Ends pseudo_terminal() {
    OpenFile board(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC));
    REQUIRE(::grantpt(board.descriptor()) == 0);
    REQUIRE(::unlockpt(board.descriptor()) == 0);
    OpenFile host = iserver::connect_board(::ptsname(board.descriptor()), never);
    return {.host = std::move(host), .board = std::move(board)};
}

Ends connection_by_network() {
    OpenFile listener(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    REQUIRE(::bind(listener.descriptor(), reinterpret_cast<sockaddr*>(&address), size) == 0);
    REQUIRE(::listen(listener.descriptor(), 1) == 0);
    REQUIRE(::getsockname(listener.descriptor(), reinterpret_cast<sockaddr*>(&address), &size) == 0);
    OpenFile host = iserver::connect_board("tcp:127.0.0.1:" + std::to_string(ntohs(address.sin_port)), never);
    return {.host = std::move(host), .board = OpenFile(::accept(listener.descriptor(), nullptr, nullptr))};
}

/// Every byte, many times: more than the buffers of a connection hold.
std::string every_byte() {
    std::string program(300'000, '\0');
    std::iota(program.begin(), program.end(), '\0');
    return program;
}

/// A program on a fake board, and its host.
struct Case {
    test::ScratchFolder folder;
    std::string screen;
    iserver::ScriptedTerminal terminal{"keys", [this](std::string_view text) { screen += text; }};
    iserver::Server server{{.host_folder = folder.path(), .command_line = "10 20"}, terminal};

    BoardRun run(Ends ends, const std::string& program, std::function<void(FakeBoard&)> behaviour,
                 const iserver::Interrupted& interrupted = never, std::chrono::milliseconds patience = 30s) {
        std::signal(SIGPIPE, SIG_IGN);
        FakeBoard board(std::move(ends.board), program.size(), std::move(behaviour));
        const OpenFile host = std::move(ends.host); // closed before the board is joined
        return iserver::serve_board(program, host, board_name, server, interrupted, patience);
    }
    /// Returns the message with which the run fails.
    std::string failure(const std::string& program, std::function<void(FakeBoard&)> behaviour) {
        try {
            run(connected_sockets(), program, std::move(behaviour), never, 300ms);
        } catch (const UserError& error) {
            return error.what();
        }
        return "";
    }
};

void serve_whole_program(Ends ends) {
    const std::string program = every_byte();
    Bytes taken;
    std::string command_line;
    std::string all_bytes(256, '\0');
    std::iota(all_bytes.begin(), all_bytes.end(), '\0');
    Bytes read;
    Case host;
    const BoardRun run = host.run(std::move(ends), program, [&](FakeBoard& board) {
        taken = board.program();
        command_line = test::text_of(board.ask(Request(40).byte(0)));
        board.ask(Request(13).word(1).text("hello\n"));
        const std::int64_t stream = test::word_of(board.ask(Request(10).text("file").byte(1).byte(5)));
        board.ask(Request(13).word(stream).text(all_bytes));
        board.ask(Request(17).word(stream).word(0).word(1));
        read = board.ask(Request(12).word(stream).count(300));
        board.ask(Request(35).word(7));
    });
    CHECK(std::string(taken.begin(), taken.end()) == program);
    CHECK(command_line == "10 20");
    CHECK(host.screen == "hello\n");
    CHECK(test::text_of(read) == all_bytes);
    CHECK(host.folder.content("file") == all_bytes);
    CHECK(run.state == ServerState::exited);
    CHECK(run.exit == 7);
    CHECK(run.requests == 7);
    CHECK(run.boot_time > 0us);
    CHECK(run.run_time >= 7ms); // each request took at least a millisecond
    CHECK(run.run_time < 10s);
}

} // namespace

TEST_CASE("a board on a pair of sockets is booted and served") { serve_whole_program(connected_sockets()); }

TEST_CASE("a board behind a pseudo terminal is booted and served") { serve_whole_program(pseudo_terminal()); }

TEST_CASE("a board behind a network is booted and served") { serve_whole_program(connection_by_network()); }

TEST_CASE("a program that runs longer than the host's patience is waited for") {
    Case host;
    std::int64_t first = 0, second = 0;
    auto behaviour = [&](FakeBoard& board) {
        first = test::word_of(board.ask(Request(33)));
        std::this_thread::sleep_for(1100ms);
        second = test::word_of(board.ask(Request(33)));
        board.ask(Request(35).word(999'999'999));
    };
    const BoardRun run = host.run(connected_sockets(), "boot", behaviour, never, 1000ms);
    CHECK(run.exit == 0);
    CHECK(second - first >= 1); // measured time
    CHECK(second - first <= 10);
    CHECK(run.run_time >= 1100ms);
}

TEST_CASE("a board that does not follow the protocol is reported") {
    Case host;
    CHECK(host.failure("boot", [](FakeBoard& board) { board.ask(Request(33)); }) ==
          "board: the board closed the connection after 1 request: the program has not ended");
    CHECK(host.failure("boot", [](FakeBoard& board) {
        board.send({7, 0, 1, 2}), board.receive(1);
    }) == "board: request 1 to the host has the length 7; a length must be even, and from 6 to 510");
    CHECK(host.failure("boot",
                       [](FakeBoard& board) {
                           board.send({4, 0, 0, 0, 34, 0, 0, 0}), board.receive(1);
                       }) ==
          "board: the program's first request is of the older AFserver (alien file server) protocol; only programs for "
          "iserver can be served");
    CHECK(host.failure("boot", [](FakeBoard& board) {
        board.send({40, 0, 13}), board.receive(1);
    }) == "board: the board stopped within request 1: the number of missing bytes is 39");
}

TEST_CASE("a board that takes no bytes is reported") {
    Case host;
    Ends ends = connected_sockets();
    std::string failure;
    try {
        iserver::serve_board(every_byte() + every_byte() + every_byte(), ends.host, board_name, host.server, never,
                             100ms);
    } catch (const UserError& error) {
        failure = error.what();
    }
    CHECK(failure.starts_with("board: the board has taken "));
    CHECK(failure.ends_with(" of 900000 bytes of the program, and then none for 0.1 s; the board may need a reset"));
    ends.board = OpenFile();
    CHECK_THROWS_WITH_AS(iserver::serve_board("boot", ends.host, board_name, host.server, never),
                         "board: byte 1 of the program cannot be sent: Broken pipe", UserError);
}

TEST_CASE("a run on a board is interrupted at once, in every wait") {
    Case host;
    std::atomic<bool> interrupted = false;
    std::thread user([&] {
        std::this_thread::sleep_for(50ms);
        interrupted = true;
    });
    const auto start = std::chrono::steady_clock::now();
    auto is_interrupted = [&] { return interrupted.load(); };
    auto behaviour = [](FakeBoard& board) {
        board.ask(Request(13).word(1).text("\x1b[31mred"));
        board.receive(1);
    };
    CHECK(host.run(connected_sockets(), "boot", behaviour, is_interrupted).state == ServerState::running);
    CHECK(std::chrono::steady_clock::now() - start < 5s);
    CHECK(host.screen == "\x1b[31mred\x1b[0m");
    user.join();
    Ends ends = connected_sockets();
    CHECK(iserver::serve_board(every_byte(), ends.host, board_name, host.server, is_interrupted).requests == 0);
}

TEST_CASE("a program on a board that waits for a key that will not come ends the run") {
    Case host;
    const BoardRun run = host.run(connected_sockets(), "boot", [](FakeBoard& board) {
        for (int key = 0; key < 5; ++key)
            board.ask(Request(30));
    });
    CHECK(run.state == ServerState::waits_for_input);
    CHECK(run.requests == 5);
}

TEST_CASE("a board that cannot be reached is refused with the reason") {
    CHECK_THROWS_WITH_AS(iserver::connect_board("/nowhere/link0", never), "/nowhere/link0: No such file or directory",
                         UserError);
    const test::ScratchFolder folder;
    folder.write("file", "");
    const std::string file = (folder.path() / "file").string();
    CHECK_THROWS_WITH_AS(iserver::connect_board(file, never),
                         (file + ": a board is a character device or \"tcp:HOST:PORT\"").c_str(), UserError);
    for (const std::string wrong : {"tcp:", "tcp:host", "tcp::5000", "tcp:host:"})
        CHECK_THROWS_WITH_AS(iserver::connect_board(wrong, never),
                             (wrong + ": a board on a network is written \"tcp:HOST:PORT\"").c_str(), UserError);
    for (const std::string port : {"-1", "65536", "70000000000"})
        CHECK_THROWS_WITH_AS(iserver::connect_board("tcp:127.0.0.1:" + port, never),
                             ("tcp:127.0.0.1:" + port + ": the port is " + port + ", expected 0 to 65535").c_str(),
                             UserError);
    CHECK_THROWS_WITH_AS(iserver::connect_board("tcp:127.0.0.1:1", never), "tcp:127.0.0.1:1: Connection refused",
                         UserError);
    try {
        iserver::connect_board("tcp:[::1]:1", never);
        FAIL("no board is there");
    } catch (const UserError& error) {
        CHECK(std::string(error.what()).find("not known") == std::string::npos); // an address, not a name
    }
    CHECK_THROWS_WITH_AS(iserver::connect_board("tcp:127.0.0.1:no-such-service", never),
                         doctest::Contains("tcp:127.0.0.1:no-such-service: Servname not supported"), UserError);
}
