#include "serve/job.hpp"

#include "explore/netlist_run.hpp"
#include "serve/answer.hpp"
#include "serve/job_text.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>

#include <malloc.h>
#include <sys/prctl.h>
#include <sys/time.h>

#include <csignal>
#include <iostream>
#include <iterator>
#include <string>

namespace placedpar::serve {

namespace json = boost::json;

namespace {

Interruption* interrupted_by_alarm = nullptr; ///< interruption of the current job

/// Requests an interruption after a time. Destroying this object cancels the request. REQUIRES: no other object of this
/// class exists.
class Deadline {
public:
    Deadline(Interruption& interruption, std::uint64_t seconds) {
        interrupted_by_alarm = &interruption;
        std::signal(SIGALRM, [](int) { interrupted_by_alarm->request(); });
        set_alarm(seconds);
    }
    ~Deadline() { set_alarm(0); }
    Deadline(const Deadline&) = delete;
    Deadline& operator=(const Deadline&) = delete;

private:
    /// Replaces alarm(), with a system call that exists on all computers and that confine() allows.
    static void set_alarm(std::uint64_t seconds) {
        const itimerval once{.it_interval = {}, .it_value = {.tv_sec = static_cast<time_t>(seconds), .tv_usec = 0}};
        ::setitimer(ITIMER_REAL, &once, nullptr);
    }
};

} // namespace

std::string answer_of(const std::string& job, const RunLimits& limits) {
    Interruption interruption;
    const Deadline deadline(interruption, limits.seconds);
    return answer_of(job, limits.megabytes, interruption);
}

bool do_job(const RunLimits& limits) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL); // ends this process with the service, because the answer would be useless
    const std::string job(std::istreambuf_iterator<char>(std::cin), {});
    ::mallopt(M_ARENA_MAX, 1); // each thread would otherwise reserve address space, which is limited
    try {
        confine(limits);
    } catch (const UserError& error) {
        std::cout << json::serialize(json::object{{"ended", "refused"}, {"refused", error.what()}}) << std::endl;
        return true;
    }
    std::cout << answer_of(job, limits) << std::endl; // the newline shows that the answer is complete
    return is_job(job);
}

} // namespace placedpar::serve
