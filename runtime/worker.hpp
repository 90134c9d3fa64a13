#pragma once

#include "runtime/switched_stack.hpp"

#include <boost/fiber/context.hpp>

namespace placedpar {

class Kernel;
class Process;

/// A fiber that runs the bodies of processes, one after the other.
class Worker {
public:
    /// `guarded`: running over the end of the stack is a fault at once, at the price of two entries in the
    /// operating system's table of this program's memory.
    Worker(Kernel&, bool guarded);
    void resume() { context_->resume(); }

    Process* process = nullptr; ///< the one whose body it runs, or is to run next
    bool dismissed = false;     ///< ends at its next turn
    SwitchedStack stack;

private:
    void work(Kernel&);
    boost::fibers::context* context_;
};

} // namespace placedpar
