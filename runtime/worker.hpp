#pragma once

#include "runtime/switched_stack.hpp"

#include <boost/fiber/context.hpp>

namespace placedpar {

class Kernel;
class Process;

/// A fiber that runs the bodies of processes, one after the other.
class Worker {
public:
    /// `guarded`: an overflow of the stack faults at once. This costs two of the memory mappings that the operating
    /// system allows a program.
    Worker(Kernel&, bool guarded);
    void resume() { context_->resume(); }

    Process* process = nullptr; ///< whose body it runs, or will run next
    bool dismissed = false;     ///< it ends when it is resumed next
    SwitchedStack stack;

private:
    void work(Kernel&);

    boost::fibers::context* context_;
};

} // namespace placedpar
