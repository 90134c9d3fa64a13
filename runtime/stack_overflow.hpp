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

/// While it exists, a stack overflow of a process on this thread is reported on standard error, with the process's
/// name, before the program ends by SIGSEGV. Other faults are passed on to the previous handler. It does nothing under
/// AddressSanitizer, which prints its own report.
class StackOverflowWatch {
public:
    /// Returns the owner of the stack that overflowed at the address of a fault, if there is one. It is called in a
    /// signal handler.
    using WhoOverflowed = std::optional<StackUser> (*)(const void* address);

    explicit StackOverflowWatch(WhoOverflowed);
    ~StackOverflowWatch();
    StackOverflowWatch(const StackOverflowWatch&) = delete;
    StackOverflowWatch& operator=(const StackOverflowWatch&) = delete;

private:
    std::vector<char> handler_stack_; ///< empty if the thread had one already
};

/// Reports on standard error that the owner has used up its stack. May be called from a signal handler.
void report_stack_overflow(const StackUser&) noexcept;

} // namespace placedpar
