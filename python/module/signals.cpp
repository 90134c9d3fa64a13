#include "python/module/signals.hpp"

#include <atomic>
#include <csignal>

namespace placedpar::python {

namespace {

std::atomic<Interruption*> interrupted{nullptr};
struct sigaction before {};

extern "C" void interrupt_and_pass_on(int signal) {
    if (Interruption* interruption = interrupted.load())
        interruption->request();
    if (before.sa_handler != SIG_IGN && before.sa_handler != SIG_DFL)
        before.sa_handler(signal);
}

} // namespace

InterruptedByKeyboard::InterruptedByKeyboard(bool heeds) : heeds_(heeds) {
    if (!heeds_)
        return;
    interrupted = this;
    struct sigaction ours {};
    ours.sa_handler = interrupt_and_pass_on;
    sigaction(SIGINT, &ours, &before);
}

InterruptedByKeyboard::~InterruptedByKeyboard() {
    if (!heeds_)
        return;
    sigaction(SIGINT, &before, nullptr);
    interrupted = nullptr;
}

} // namespace placedpar::python
