#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace placedpar {

/// The process that runs on a stack, as a report names it.
struct StackUser {
    std::string_view process; ///< name of the process at the outermost level
    bool is_component;        ///< the stack belongs to a component of the process's PARs
};

/// Watches this thread for stack overflows of processes, as long as the object exists. After an overflow, a report on
/// standard error names the process, and the program ends by SIGSEGV. Other faults go to the previous handler. Under
/// AddressSanitizer the object does nothing, because the sanitizer prints its own report.
class StackOverflowWatch {
public:
    /// Returns the process whose stack overflowed at the address of a fault, or nothing if the fault has another cause.
    /// The function is called in a signal handler.
    using WhoOverflowed = std::optional<StackUser> (*)(const void* address);

    explicit StackOverflowWatch(WhoOverflowed);
    ~StackOverflowWatch();
    StackOverflowWatch(const StackOverflowWatch&) = delete;
    StackOverflowWatch& operator=(const StackOverflowWatch&) = delete;

private:
    std::vector<char> handler_stack_; ///< empty if the thread already had a stack for handlers
};

/// Reports on standard error that the process has used up its stack. May be called from a signal handler.
void report_stack_overflow(const StackUser&) noexcept;

} // namespace placedpar
