#pragma once

#include "explore/netlist_run.hpp"

namespace placedpar {

/// While an object of this class exists, SIGINT and SIGTERM do not end the program. They request an interruption, so
/// that the run ends early and its results so far are printed. Only one object may exist at a time.
class InterruptedBySignals : public Interruption {
public:
    InterruptedBySignals();
    ~InterruptedBySignals();
    InterruptedBySignals(const InterruptedBySignals&) = delete;
    InterruptedBySignals& operator=(const InterruptedBySignals&) = delete;

private:
    void (*before_int_)(int);
    void (*before_term_)(int);
};

} // namespace placedpar
