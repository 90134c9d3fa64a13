#include "serve/confinement.hpp"

#include <doctest/doctest.h>

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>
#include <system_error>
#include <thread>

using namespace placedpar;

namespace {

/// The test program itself may have been built with sanitizers, which reserve much address space.
constexpr serve::RunLimits wide{.seconds = 10, .megabytes = 1u << 28};

/// Returns what a child process finds in `succeeds`, without or after being confined.
bool in_child(bool confined, const std::function<bool()>& succeeds) {
    const pid_t child = ::fork();
    if (child == 0) {
        if (confined)
            serve::confine(wide);
        ::_exit(succeeds() ? 1 : 0);
    }
    int status = 0;
    REQUIRE(::waitpid(child, &status, 0) == child);
    REQUIRE(WIFEXITED(status));
    return WEXITSTATUS(status) == 1;
}

/// What must be possible only without confinement.
void check_forbidden(const std::function<bool()>& succeeds) {
    CHECK(in_child(false, succeeds));
    CHECK_FALSE(in_child(true, succeeds));
}

bool forks() {
    const pid_t child = ::fork();
    if (child == 0)
        ::_exit(0);
    return child > 0 && ::waitpid(child, nullptr, 0) == child;
}

} // namespace

TEST_CASE("a confined process opens no file and no connection") {
    check_forbidden([] { return ::open("/dev/null", O_RDONLY) >= 0; });
    check_forbidden([] { return ::access("/", F_OK) == 0; });
    check_forbidden([] { return ::socket(AF_INET, SOCK_STREAM, 0) >= 0; });
}

TEST_CASE("a confined process starts no other process and no program") {
    check_forbidden(forks);
    check_forbidden([] { return ::execl("/bin/sh", "sh", "-c", "exit 1", nullptr) == 0; });
}

TEST_CASE("a confined process sends signals only to itself") {
    const pid_t parent = ::getpid(); // its first thread has the same number; signal 0 has no effect
    check_forbidden([parent] { return ::syscall(SYS_tgkill, parent, parent, 0) == 0; });
    CHECK(in_child(true, [] { return ::syscall(SYS_tgkill, ::getpid(), ::gettid(), 0) == 0; }));
    CHECK(in_child(true, [] {
        std::signal(SIGUSR1, [](int) { ::_exit(1); });
        return std::raise(SIGUSR1) != 0;
    }));
}

TEST_CASE("a confined process can start a thread") {
    CHECK(in_child(true, [] {
        bool ran = false;
        try {
            std::thread([&ran] { ran = true; }).join();
        } catch (const std::system_error&) {
            return false;
        }
        return ran;
    }));
}
