#include "runtime/stack_overflow.hpp"

#include "runtime/stack_arena.hpp"

#include <unistd.h>

#include <csignal>
#include <mutex>
#include <string_view>

namespace placedpar {

namespace {

struct sigaction handled_before;
thread_local StackOverflowWatch::WhoOverflowed who_overflowed = nullptr;

/// Writes without allocating memory, because the fault may have happened during an allocation.
void write_error(std::string_view text) noexcept {
    while (!text.empty()) {
        ssize_t written = write(STDERR_FILENO, text.data(), text.size());
        if (written <= 0)
            return;
        text.remove_prefix(static_cast<std::size_t>(written));
    }
}

/// Reports the fault if a process has overflowed its stack, and restores the previous handler. After the return the
/// fault happens again, and goes to that handler.
void on_fault(int, siginfo_t* fault, void*) {
    if (auto user = who_overflowed ? who_overflowed(fault->si_addr) : std::nullopt)
        report_stack_overflow(*user);
    sigaction(SIGSEGV, &handled_before, nullptr);
}

/// Installs the fault handler for the whole program.
void handle_faults() {
    static std::mutex one_at_a_time;
    std::lock_guard lock(one_at_a_time);
    struct sigaction now {};
    sigaction(SIGSEGV, nullptr, &now);
    if ((now.sa_flags & SA_SIGINFO) && now.sa_sigaction == on_fault)
        return;
    handled_before = now;
    struct sigaction ours {};
    ours.sa_sigaction = on_fault;
    ours.sa_flags = SA_SIGINFO | SA_ONSTACK;
    sigaction(SIGSEGV, &ours, nullptr);
}

} // namespace

StackOverflowWatch::StackOverflowWatch(WhoOverflowed who) {
    if (SwitchedStack::is_watched())
        return;
    who_overflowed = who;
    stack_t now{};
    sigaltstack(nullptr, &now);
    if (now.ss_flags & SS_DISABLE) {
        handler_stack_.resize(64 * 1024);
        stack_t ours{.ss_sp = handler_stack_.data(), .ss_flags = 0, .ss_size = handler_stack_.size()};
        sigaltstack(&ours, nullptr);
    }
    handle_faults();
}

StackOverflowWatch::~StackOverflowWatch() {
    who_overflowed = nullptr;
    if (handler_stack_.empty())
        return;
    stack_t none{.ss_sp = nullptr, .ss_flags = SS_DISABLE, .ss_size = 0};
    sigaltstack(&none, nullptr);
}

void report_stack_overflow(const StackUser& user) noexcept {
    write_error(user.is_component ? "a component of process " : "process ");
    write_error(user.process);
    write_error(Stack::bytes() == Stack::usual_bytes ? " has used up its stack of 256 Kbyte"
                                                     : " has used up its stack of 1 Mbyte");
    write_error(": it calls itself without end, or has large arrays, which belong on the heap (std::vector)\n");
}

} // namespace placedpar
