#pragma once

#include "runtime/source_location.hpp"
#include "runtime/time.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace placedpar {

class AnyChannel;
class Kernel;
class Process;
class Processor;
class Worker;

/// The two priorities of a transputer's processes.
enum class Priority { high, low };

/// What a process is doing, or what it waits for.
enum class Activity { ready, delayed, outputting, inputting, alternating, joining, ended };

/// How many components of a PAR still run, and who waits for them.
struct Join {
    std::size_t components_left;
    Process& parent;
};

/// One process of the simulation: a body that runs on a fiber, and, if it is placed, the processor that it
/// shares with others. It belongs to whoever created it: to a `par`, or to the simulation.
/// REQUIRES: it has ended, or the simulation is over, when it is destroyed.
class Process {
public:
    using Body = std::function<void()>;

    /// A process with a name of its own, started at the outermost level.
    Process(Kernel&, std::string name, Body, Processor*, Priority);
    /// Component number `index` of a PAR in `parent`, on the parent's processor.
    Process(Process& parent, std::size_t index, Body, Priority, Join&);
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    /// "cluster[0].master", or for a component of a PAR "cluster[0].master/1".
    std::string path() const;
    /// Counts the processes of a simulation in the order of their creation.
    std::uint32_t ordinal() const { return ordinal_; }
    /// The process whose PAR this one is a component of; null at the outermost level.
    const Process* parent() const { return join_ ? &join_->parent : nullptr; }
    /// Its ancestor at the outermost level, perhaps itself.
    const Process& outermost() const { return *outermost_; }
    Processor* processor() const { return processor_; }
    Priority priority() const { return priority_; }
    Kernel& kernel() const { return kernel_; }
    bool ended() const { return activity_ == Activity::ended; }
    /// A part of the machine and not of the program: a run can end while it still lives.
    void serve_machine();
    bool serves_machine() const { return machine_; }

    /// What it does or waits for, and where in its program, for reports.
    Activity activity() const { return activity_; }
    const std::vector<const AnyChannel*>& awaited_channels() const { return awaited_; }
    const SourceLocation& place_in_program() const { return where_; }
    /// Of a process at the outermost level: time in which neither it nor any component of its PARs could go on,
    /// for all of them waited for partners or delays; each wait up to the moment when the processor took the process
    /// up again, and those that were not over when the run was.
    Time time_waited() const { return waited_; }

    /// Waits, as part of the operation named, until made ready. REQUIRES: this process is running.
    void wait_for(Activity, const AnyChannel*, const SourceLocation&);
    void wait_for(Activity, std::span<const AnyChannel* const>, const SourceLocation&);
    /// Notes a delay for which the kernel passed the time on, without a wait. REQUIRES: this process is running.
    void was_delayed(Time since, const SourceLocation&);

private:
    friend class Kernel;
    friend class Processor;
    friend class Worker;
    friend class ProcessQueue;

    void wait(Activity);
    void goes_on();
    void stands_still();
    void trace_wait(Time since) const;

    Kernel& kernel_;
    std::string name_;
    std::size_t index_ = 0;
    Body body_;
    Processor* processor_;
    Priority priority_;
    std::uint32_t ordinal_;

    bool machine_ = false;
    Activity activity_ = Activity::ready;
    std::vector<const AnyChannel*> awaited_;
    SourceLocation where_;

    // Of a process at the outermost level, for itself and its components.
    std::size_t going_on_ = 1; ///< how many of them do not wait and have not ended
    Time still_since_{};       ///< when the last of them began to wait
    Time waited_{};

    Worker* worker_ = nullptr; ///< the fiber that runs its body; null before its first turn
    Process* next_ = nullptr;  ///< the next in the queue in which it stands
    std::size_t slot_ = 0;     ///< where the kernel lists it

    Time work_left_{};     ///< processor time that it still needs before its body goes on
    Join* join_ = nullptr; ///< the PAR of which it is a component
    Process* outermost_ = this;
};

/// First in, first out, linked through the processes themselves: a process stands in at most one queue.
class ProcessQueue {
public:
    bool empty() const { return !first_; }
    void push_back(Process& p) {
        p.next_ = nullptr;
        (first_ ? last_->next_ : first_) = &p;
        last_ = &p;
    }
    Process* pop_front() {
        Process* p = first_;
        if (p)
            first_ = p->next_;
        return p;
    }

private:
    Process* first_ = nullptr;
    Process* last_ = nullptr;
};

} // namespace placedpar
