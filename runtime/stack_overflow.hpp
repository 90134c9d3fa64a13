#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace placedpar {

/// Names the process that a stack belongs to.
struct StackUser {
    std::string_view process; ///< at the outermost level
    bool is_component;        ///< the stack belongs to a component of its PAR, not to the process itself
};

/// While one exists, a process of the simulation that runs on this thread cannot overflow its stack without being named
/// on standard error before the program ends by SIGSEGV. Other faults go where they went before. It does nothing under
/// AddressSanitizer, which has its own report.
class StackOverflowWatch {
public:
    /// Called in a signal handler, for an address where a fault was: the owner of the stack that overflowed there, if
    /// any.
    using WhoOverflowed = std::optional<StackUser> (*)(const void* address);

    explicit StackOverflowWatch(WhoOverflowed);
    ~StackOverflowWatch();
    StackOverflowWatch(const StackOverflowWatch&) = delete;
    StackOverflowWatch& operator=(const StackOverflowWatch&) = delete;

private:
    std::vector<char> handler_stack_; ///< empty where the thread had one already
};

/// Reports on standard error that the owner has used up its stack. May be called from a signal handler.
void report_stack_overflow(const StackUser&) noexcept;

} // namespace placedpar
