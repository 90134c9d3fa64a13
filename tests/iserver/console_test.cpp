#include "iserver/console.hpp"

#include "iserver/host_folder.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <optional>
#include <string>
#include <thread>

using namespace placedpar;
using iserver::Console;
using iserver::OpenFile;

namespace {

/// A pseudo terminal: the test types and looks at one end, the console is at the other.
class Typist {
public:
    Typist() : keyboard_(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)) {
        REQUIRE(::grantpt(keyboard_.descriptor()) == 0);
        REQUIRE(::unlockpt(keyboard_.descriptor()) == 0);
        terminal_ = OpenFile(::open(::ptsname(keyboard_.descriptor()), O_RDWR | O_NOCTTY | O_CLOEXEC));
    }
    void type(std::string_view keys) {
        CHECK(::write(keyboard_.descriptor(), keys.data(), keys.size()) == static_cast<ssize_t>(keys.size()));
    }
    /// Returns what has appeared on the screen.
    std::string screen() {
        std::string seen;
        pollfd ready{.fd = keyboard_.descriptor(), .events = POLLIN, .revents = 0};
        while (::poll(&ready, 1, 20) > 0) {
            std::array<char, 512> bytes;
            seen.append(bytes.data(),
                        static_cast<std::size_t>(::read(keyboard_.descriptor(), bytes.data(), bytes.size())));
        }
        return seen;
    }
    bool is_as_usual() const {
        termios settings{};
        REQUIRE(::tcgetattr(terminal_.descriptor(), &settings) == 0);
        return (settings.c_lflag & ICANON) != 0 && (settings.c_lflag & ECHO) != 0 && (settings.c_iflag & ICRNL) != 0;
    }
    int terminal() const { return terminal_.descriptor(); }

private:
    OpenFile keyboard_, terminal_;
};

/// Waits for a key that was typed a moment before.
std::optional<std::uint8_t> soon(Console& console) {
    for (int attempt = 0; attempt < 1000; ++attempt)
        if (std::optional<std::uint8_t> key = console.pressed_key())
            return key;
        else
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return std::nullopt;
}

bool not_interrupted() { return false; }

} // namespace

TEST_CASE("keys of a terminal come at once and without echo, lines are echoed, and the terminal is restored") {
    Typist typist;
    {
        Console console(not_interrupted, typist.terminal());
        CHECK(console.is_interactive());
        CHECK(typist.is_as_usual());
        CHECK_FALSE(console.pressed_key());
        CHECK_FALSE(typist.is_as_usual());
        typist.type("a\r");
        CHECK(console.wait_for_key() == 'a');
        CHECK(soon(console) == 13);
        CHECK(typist.screen() == "");
        std::thread later([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(250));
            typist.type("a linx\x7f"
                        "e\r");
        });
        CHECK(console.line() == "a line\n");
        later.join();
        CHECK(typist.screen().starts_with("a linx"));
        CHECK(typist.is_as_usual());
        CHECK_FALSE(console.pressed_key());
    }
    CHECK(typist.is_as_usual());
}

TEST_CASE("the screen is standard output, and gets every byte unchanged") {
    Typist typist;
    const OpenFile usual(::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3));
    ::dup2(typist.terminal(), STDOUT_FILENO);
    Console(not_interrupted, typist.terminal()).write("\x1b[2Jshown\a\n");
    ::dup2(usual.descriptor(), STDOUT_FILENO);
    CHECK(typist.screen() == "\x1b[2Jshown\a\r\n");
}

TEST_CASE("an output that cannot be written is reported") {
    const OpenFile usual(::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3));
    const OpenFile full(::open("/dev/full", O_WRONLY | O_CLOEXEC));
    ::dup2(full.descriptor(), STDOUT_FILENO);
    std::string message;
    try {
        iserver::write_to_screen("lost");
    } catch (const UserError& error) {
        message = error.what();
    }
    ::dup2(usual.descriptor(), STDOUT_FILENO);
    CHECK(message == "the program's output cannot be written: No space left on device");
}

TEST_CASE("a line that was typed ahead of a program which reads keys is a line") {
    Typist typist;
    Console console(not_interrupted, typist.terminal());
    CHECK_FALSE(console.pressed_key());
    typist.type("kline\rmore\r");
    CHECK(console.wait_for_key() == 'k');
    CHECK(console.line() == "line\n");
    CHECK(console.line() == "more\n");
}

TEST_CASE("the end of a terminal's input is met where lines are read") {
    Typist typist;
    Console console(not_interrupted, typist.terminal());
    typist.type("last\x04\x04");
    CHECK(console.line() == "last");
    CHECK(console.at_end());
    CHECK(console.line() == "");
    CHECK_FALSE(console.wait_for_key());
}

TEST_CASE("the end of a line of a pipe is the return key, or the end of a line, as the program asks") {
    std::array<int, 2> ends{};
    REQUIRE(::pipe(ends.data()) == 0);
    const OpenFile reader(ends[0]), writer(ends[1]);
    Console console(not_interrupted, reader.descriptor());
    CHECK(::write(writer.descriptor(), "a\n\nc\r\n\rb\n", 10) == 10);
    for (const char key : {'a', '\r', '\r', 'c', '\r', '\r'}) // CR LF is one return key
        CHECK(console.wait_for_key() == key);
    CHECK(console.line() == "b\n");
}

TEST_CASE("keys and lines also come from a pipe, until its end") {
    std::array<int, 2> ends{};
    REQUIRE(::pipe(ends.data()) == 0);
    const OpenFile reader(ends[0]);
    OpenFile writer(ends[1]);
    Console console(not_interrupted, reader.descriptor());
    CHECK_FALSE(console.is_interactive());
    CHECK_FALSE(console.pressed_key());
    CHECK(::write(writer.descriptor(), "kfirst\nsecond", 13) == 13);
    CHECK(console.wait_for_key() == 'k');
    CHECK(console.line() == "first\n");
    CHECK_FALSE(console.at_end());
    writer = OpenFile();
    CHECK(console.line() == "second");
    CHECK(console.at_end());
    CHECK_FALSE(console.wait_for_key());
}

TEST_CASE("an interruption ends the input, so that a run can end") {
    Typist typist;
    std::atomic<int> questions = 0;
    Console console([&] { return ++questions > 2; }, typist.terminal());
    CHECK_FALSE(console.wait_for_key());
    CHECK(console.line() == "");
    CHECK(console.at_end());
}
