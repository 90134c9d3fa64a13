#include "python/module/signals.hpp"

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <mutex>
#include <set>

namespace placedpar::python {

namespace {

std::atomic<InterruptedByKeyboard*> innermost{nullptr};
struct sigaction before {};

extern "C" void interrupt_and_pass_on(int signal) {
    if (InterruptedByKeyboard* interruption = innermost.load())
        interruption->request_all();
    if (before.sa_handler != SIG_IGN && before.sa_handler != SIG_DFL)
        before.sa_handler(signal);
}

void install_handler() {
    sigaction(SIGINT, nullptr, &before);
    if (before.sa_handler == SIG_IGN)
        return;
    struct sigaction ours {};
    ours.sa_handler = interrupt_and_pass_on;
    sigaction(SIGINT, &ours, nullptr);
}

/// All interruptions that exist.
struct LiveRuns {
    std::mutex mutex;
    std::condition_variable ended;
    std::set<Interruption*> all;
};

LiveRuns& live_runs() {
    static auto* const runs = new LiveRuns; // never destroyed, because threads may still run at the end of the program
    return *runs;
}

} // namespace

bool InterruptedByKeyboard::is_main_thread() {
    const auto threading = pybind11::module_::import("threading");
    return threading.attr("current_thread")().is(threading.attr("main_thread")());
}

InterruptedByKeyboard::InterruptedByKeyboard(bool heeds) : heeds_(heeds) {
    {
        const std::lock_guard lock(live_runs().mutex);
        live_runs().all.insert(this);
    }
    if (!heeds_)
        return;
    outer_ = innermost.exchange(this);
    if (!outer_)
        install_handler();
}

InterruptedByKeyboard::~InterruptedByKeyboard() {
    if (heeds_) {
        if (!outer_)
            sigaction(SIGINT, &before, nullptr);
        innermost = outer_;
    }
    const std::lock_guard lock(live_runs().mutex);
    live_runs().all.erase(this);
    live_runs().ended.notify_all();
}

void InterruptedByKeyboard::request_all() noexcept {
    for (InterruptedByKeyboard* each = this; each; each = each->outer_)
        each->request();
}

void end_all_runs() {
    const pybind11::gil_scoped_release turn_of_other_threads;
    LiveRuns& runs = live_runs();
    std::unique_lock lock(runs.mutex);
    for (Interruption* each : runs.all)
        each->request();
    runs.ended.wait_for(lock, std::chrono::seconds(10), [&] { return runs.all.empty(); });
}

} // namespace placedpar::python
