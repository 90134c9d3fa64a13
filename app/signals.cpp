#include "app/signals.hpp"

#include <atomic>
#include <csignal>

namespace placedpar {

namespace {

std::atomic<Interruption*> to_be_requested{nullptr};

extern "C" void request_interruption(int) {
    if (Interruption* interruption = to_be_requested.load())
        interruption->request();
}

} // namespace

InterruptedBySignals::InterruptedBySignals() {
    to_be_requested = this;
    before_int_ = std::signal(SIGINT, request_interruption);
    before_term_ = std::signal(SIGTERM, request_interruption);
}

InterruptedBySignals::~InterruptedBySignals() {
    std::signal(SIGINT, before_int_);
    std::signal(SIGTERM, before_term_);
    to_be_requested = nullptr;
}

} // namespace placedpar
