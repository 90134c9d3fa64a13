#include "serve/confinement.hpp"

#include "text/user_error.hpp"

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <vector>

namespace placedpar::serve {

namespace {

/// What computing needs: memory, threads, clocks, signals, and open files.
constexpr std::array allowed_calls = {SYS_read,
                                      SYS_write,
                                      SYS_readv,
                                      SYS_writev,
                                      SYS_lseek,
                                      SYS_close,
                                      SYS_fstat,
                                      SYS_brk,
                                      SYS_mmap,
                                      SYS_munmap,
                                      SYS_mprotect,
                                      SYS_mremap,
                                      SYS_madvise,
                                      SYS_futex,
                                      SYS_sched_yield,
                                      SYS_nanosleep,
                                      SYS_getpid,
                                      SYS_gettid,
                                      SYS_clock_gettime,
                                      SYS_clock_getres,
                                      SYS_gettimeofday,
                                      SYS_clock_nanosleep,
                                      SYS_rt_sigaction,
                                      SYS_rt_sigprocmask,
                                      SYS_rt_sigreturn,
                                      SYS_sigaltstack,
                                      SYS_getrandom,
                                      SYS_exit,
                                      SYS_exit_group,
                                      SYS_restart_syscall,
                                      SYS_set_robust_list,
                                      SYS_rseq,
                                      SYS_sched_getaffinity,
                                      SYS_getcwd,
                                      SYS_uname,
                                      SYS_getrusage,
                                      SYS_setitimer};

#if defined(__x86_64__)
constexpr std::uint32_t native_calls = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t native_calls = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t native_calls = 0; // no call is allowed where this is wrong
#endif

using Rules = std::vector<sock_filter>;

constexpr sock_filter load(std::size_t offset) {
    return BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset));
}

constexpr sock_filter answer(std::uint32_t value) { return BPF_STMT(BPF_RET | BPF_K, value); }

/// Appends rules that answer in this way if the loaded word is this number.
void answer_if(Rules& rules, long number, std::uint32_t value) {
    rules.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(number), 0, 1));
    rules.push_back(answer(value));
}

/// Appends rules that allow the call with this number if the condition holds for its first argument, and refuse the
/// call otherwise. The condition is a jump over one rule if it does not hold.
void allow_if(Rules& rules, long number, const sock_filter& condition) {
    rules.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(number), 0, 4));
    rules.push_back(load(offsetof(seccomp_data, args)));
    rules.push_back(condition);
    rules.push_back(answer(SECCOMP_RET_ALLOW));
    rules.push_back(answer(SECCOMP_RET_ERRNO | EPERM));
}

/// Returns the rules for system calls. A thread may be started, but no process. The C library starts threads by clone3,
/// whose flags are in memory that rules cannot read, and by clone if there is no such call. Signals may be sent to this
/// process only: abort() sends one. Calls of another architecture have other numbers.
Rules rules_of_calls() {
    Rules rules{load(offsetof(seccomp_data, arch))};
    rules.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, native_calls, 1, 0));
    rules.push_back(answer(SECCOMP_RET_ERRNO | ENOSYS));
    rules.push_back(load(offsetof(seccomp_data, nr)));
    answer_if(rules, SYS_clone3, SECCOMP_RET_ERRNO | ENOSYS);
    for (const long number : allowed_calls)
        answer_if(rules, number, SECCOMP_RET_ALLOW);
    const auto own = static_cast<std::uint32_t>(::getpid());
    allow_if(rules, SYS_tgkill, BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, own, 0, 1));
    allow_if(rules, SYS_clone, BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, CLONE_THREAD, 0, 1));
    rules.push_back(answer(SECCOMP_RET_ERRNO | ENOENT));
    return rules;
}

void limit(__rlimit_resource resource, std::uint64_t most) {
    const rlimit both{most, most};
    if (::setrlimit(resource, &both) != 0)
        throw UserError("this computer cannot limit what a run uses: setrlimit fails");
}

} // namespace

void confine(const RunLimits& limits) {
    limit(RLIMIT_AS, limits.megabytes << 20);
    limit(RLIMIT_CPU, limits.seconds + 5);
    limit(RLIMIT_FSIZE, largest_answer_bytes);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_NOFILE, 3);
    Rules rules = rules_of_calls();
    const sock_fprog program{static_cast<unsigned short>(rules.size()), rules.data()};
    if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 || ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0)
        throw UserError("this computer cannot confine runs: its kernel has no seccomp filters");
}

} // namespace placedpar::serve
