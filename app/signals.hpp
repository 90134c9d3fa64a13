#pragma once

#include "explore/netlist_run.hpp"

namespace placedpar {

/// While an object exists, SIGINT and SIGTERM request the interruption instead of ending the program. Only one object
/// may exist at a time.
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
