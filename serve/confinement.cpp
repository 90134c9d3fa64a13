#include "serve/confinement.hpp"

#include "text/user_error.hpp"

#include <sched.h>
#include <seccomp.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <memory>

namespace placedpar::serve {

namespace {

/// The system calls that a computation needs: for memory, threads, clocks, signals, and files that are already open.
constexpr std::array allowed_calls{SYS_read,
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
                                   SYS_rseq,
                                   SYS_getcwd,
                                   SYS_set_robust_list,
                                   SYS_uname,
                                   SYS_getrusage,
                                   SYS_setitimer,
                                   SYS_sched_getaffinity};

struct ReleaseRules {
    void operator()(void* rules) const { seccomp_release(rules); }
};

/// Allows only some system calls. Threads can be started, but not processes. clone3 is refused, because its flags are
/// in memory, which the kernel's rules cannot read. The C library then starts threads by clone. Signals can be sent
/// only to this process, as abort() does. Returns whether the kernel has accepted the rules.
bool allow_calls() {
    const std::unique_ptr<void, ReleaseRules> rules(seccomp_init(SCMP_ACT_ERRNO(ENOENT)));
    bool taken = rules && seccomp_attr_set(rules.get(), SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_ERRNO(ENOSYS)) == 0;
    auto add = [&](std::uint32_t answer, long call, unsigned conditions = 0, const scmp_arg_cmp& condition = {}) {
        taken =
            taken && seccomp_rule_add_array(rules.get(), answer, static_cast<int>(call), conditions, &condition) == 0;
    };
    add(SCMP_ACT_ERRNO(ENOSYS), SYS_clone3);
    for (const long call : allowed_calls)
        add(SCMP_ACT_ALLOW, call);
    add(SCMP_ACT_ALLOW, SYS_tgkill, 1, {0, SCMP_CMP_EQ, static_cast<scmp_datum_t>(::getpid()), 0});
    add(SCMP_ACT_ALLOW, SYS_clone, 1, {0, SCMP_CMP_MASKED_EQ, CLONE_THREAD, CLONE_THREAD});
    return taken && seccomp_load(rules.get()) == 0;
}

void limit(__rlimit_resource resource, std::uint64_t most) {
    const rlimit both{most, most};
    if (::setrlimit(resource, &both) != 0)
        throw UserError("this computer refuses to limit the memory and time of a run: setrlimit failed");
}

} // namespace

void confine(const RunLimits& limits) {
    limit(RLIMIT_AS, limits.megabytes << 20);
    limit(RLIMIT_CPU, limits.seconds + 5);
    limit(RLIMIT_FSIZE, largest_answer_bytes);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_NOFILE, 3);
    if (!allow_calls())
        throw UserError("runs cannot be confined on this computer: the kernel needs CONFIG_SECCOMP_FILTER");
}

} // namespace placedpar::serve
