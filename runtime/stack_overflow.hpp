#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace placedpar {

/// Names the process that owns a stack.
struct StackUser {
    std::string_view process; ///< name of the process at the outermost level
    bool is_component;        ///< the stack belongs to a component of the process's PARs
};

/// Reports a stack overflow of a process on this thread, as long as the object exists. The report on standard error
/// names the process; then the program ends by SIGSEGV. Other faults go to the previous handler. Under AddressSanitizer
/// the object does nothing, because the sanitizer prints its own report.
class StackOverflowWatch {
public:
    /// Returns the owner of the stack that overflowed at the address of a fault, if there is an owner. It is called in
    /// a signal handler.
    using WhoOverflowed = std::optional<StackUser> (*)(const void* address);

    explicit StackOverflowWatch(WhoOverflowed);
    ~StackOverflowWatch();
    StackOverflowWatch(const StackOverflowWatch&) = delete;
    StackOverflowWatch& operator=(const StackOverflowWatch&) = delete;

private:
    std::vector<char> handler_stack_; ///< empty if the thread already had a stack for handlers
};

/// Reports on standard error that the owner has used up its stack. May be called from a signal handler.
void report_stack_overflow(const StackUser&) noexcept;

} // namespace placedpar
