#pragma once

#include <boost/fiber/context.hpp>

namespace placedpar {

class Kernel;
class Process;

/// A fiber that runs the bodies of processes, one after the other.
class Worker {
public:
    explicit Worker(Kernel&);
    void resume() { context_->resume(); }

    Process* process = nullptr; ///< the one whose body it runs, or is to run next
    bool dismissed = false;     ///< ends at its next turn

private:
    void work(Kernel&);
    boost::fibers::context* context_;
};

} // namespace placedpar
