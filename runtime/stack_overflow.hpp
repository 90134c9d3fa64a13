#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace placedpar {

/// Whose stack it is. (What a process is, this file need not know.)
struct StackUser {
    std::string_view process; ///< at the outermost level
    bool is_component;        ///< of its PAR, and not the process itself
};

/// While one exists, a process of the simulation that runs on this thread cannot overflow its stack without being named
/// on standard error before the program ends by SIGSEGV. Other faults go where they went before. It does nothing under
/// AddressSanitizer, which has its own report.
class StackOverflowWatch {
public:
    /// Called in a signal handler, for an address where a fault was: who overflowed a stack by going there, if anybody.
    using WhoOverflowed = std::optional<StackUser> (*)(const void* address);

    explicit StackOverflowWatch(WhoOverflowed);
    ~StackOverflowWatch();
    StackOverflowWatch(const StackOverflowWatch&) = delete;
    StackOverflowWatch& operator=(const StackOverflowWatch&) = delete;

private:
    std::vector<char> handler_stack_; ///< empty where the thread had one already
};

/// Says on standard error that somebody has used up the stack. May be called from a signal handler.
void report_stack_overflow(const StackUser&) noexcept;

} // namespace placedpar
