#pragma once

#include "runtime/source_location.hpp"
#include "runtime/time.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>

namespace placedpar {

class AnyChannel;
class Executive;
class ReplayLog;
class Kernel;
class Process;
class Worker;

/// The shape of a computation's code: where the code can be left, in cycles of its executive, at least 1 each; and how
/// many of its words lie outside the chip.
struct CodeShape {
    /// Distance between descheduling points (`j`, `lend`), where a low-priority process yields at the end of its
    /// timeslice.
    Cycles between_points{1};
    /// Cycles of an instruction; an interrupt waits for its end. A division of integers takes 39 (databook).
    Cycles instruction{1};
    /// Words of code fetched, and of data read or written, outside the chip. The computation's cycles count each as an
    /// access on the chip; the executive adds the difference.
    std::int64_t words_outside = 0;
};

/// The two priorities of occam's processes.
enum class Priority { high, low };

/// What a process or a place does for a while. Process::activity() is `ready`, one of the waits (`stopped` waits for
/// nothing), or `ended`. A trace is also told that a process is `starting`, `executing`, `computing` or `moving` words
/// over a bus. A trace itself adds that a link is `carrying` a message and that a process waits while a bus is
/// `arbitrating`. Only reports use `halted`: the process's executive has stopped for ever.
/// The numbers of those up to `stopped` stand in the files of traces, and must not change.
enum class Activity {
    executing,
    carrying,
    ready,
    computing,
    delayed,
    outputting,
    inputting,
    alternating,
    joining,
    after_work,
    stopped,
    halted,
    ended,
    starting,
    moving,
    arbitrating
};
static_assert(static_cast<int>(Activity::stopped) == 10 && static_cast<int>(Activity::arbitrating) < 16);

/// Whether a process with this activity waits for a partner, its timer, its components, the end of the work, or
/// nothing.
constexpr bool is_waiting(Activity activity) { return activity >= Activity::delayed && activity <= Activity::stopped; }

/// A PAR: how many of its components still run, and the process that waits for them.
struct Join {
    std::size_t components_left;
    Process& parent;
    std::size_t components = components_left;
    std::uint32_t first_ordinal = 0; ///< of the first component; the others follow
};

/// A communication that begins after a computation. The kernel performs it instead of resuming the program, which saves
/// a context switch.
class Communication {
public:
    Communication() = default;
    Communication(const Communication&) = delete;
    Communication& operator=(const Communication&) = delete;

protected:
    ~Communication() = default;

private:
    friend class Process;
    /// Called at the process's turn. Returns whether the process waits; it has then called Process::begin_wait.
    /// Otherwise its program continues. The kernel calls it like an event, on the stack of any process, with
    /// Kernel::running set to this process: it must not wait in any other way.
    virtual bool begin(Process&) noexcept = 0;
};

/// One process of the simulation: a body that runs on a fiber, and, if it is placed, the executive that it
/// shares with others. It is owned by the `par` or the simulation that made it, and is destroyed only when it has ended
/// or the simulation is over.
class Process {
public:
    using Body = std::function<void()>;

    /// A process with a name of its own, started at the outermost level.
    Process(Kernel&, std::string name, Body, Executive*, Priority);
    /// Component number `index` of a PAR in `parent`, on the parent's executive.
    Process(Process& parent, std::size_t index, Body, Priority, Join&);
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    /// "cluster[0].master", or for a component of a PAR "cluster[0].master/1".
    std::string path() const;
    /// Returns the name that the process was given; empty for a component of a PAR.
    const std::string& name() const { return name_; }
    /// Counts the processes of a simulation in the order of their creation.
    std::uint32_t ordinal() const { return ordinal_; }
    /// The process whose PAR this one is a component of; null at the outermost level.
    const Process* parent() const { return join_ ? &join_->parent : nullptr; }
    /// Returns the process's ancestor at the outermost level, which may be the process itself.
    const Process& outermost() const { return *outermost_; }
    /// Returns whether the process with the given ordinal is another component of a PAR that contains this process.
    bool is_beside(std::uint32_t ordinal) const;
    /// Returns the process's executive; null if the process is not placed.
    Executive* executive() const { return executive_; }
    Priority priority() const { return priority_; }
    Kernel& kernel() const { return kernel_; }
    bool ended() const { return activity_ == Activity::ended; }
    /// Returns whether the process has had a turn. REQUIRES: it has not ended.
    bool has_begun() const { return worker_ != nullptr; }
    /// Makes the process part of the machine instead of the program: a run does not wait for its end.
    void serve_machine();
    bool serves_machine() const { return machine_; }
    /// Makes the process record its actions in the history, or repeat those in it. REQUIRES: the process has not begun;
    /// the history outlives the run.
    void keep(ReplayLog&);
    /// Returns the process's history; null if it keeps none, and while the process is unwound.
    ReplayLog* history() const { return history_; }

    // For reports.
    Activity activity() const { return activity_; }
    /// Returns the channels on which the process waits. If it does not wait, returns the channel of its last wait,
    /// unless that was a wait for several channels.
    std::span<const AnyChannel* const> awaited_channels() const {
        return awaited_channel_ ? std::span(&awaited_channel_, 1) : alternatives_;
    }
    /// Returns whether the process's last wait has a time limit.
    bool awaits_timer() const { return awaits_timer_; }
    /// States whether the process's waits may from now on be ended by a time limit or by another process, if their
    /// partner does not come.
    void may_give_up(bool may) { may_give_up_ = may; }
    /// Returns where in its program the process last waited.
    const SourceLocation& place_in_program() const { return where_; }
    /// For a process at the outermost level: how long it and all components of its PARs waited for partners or delays
    /// at once. A wait lasts until the process runs again; one that still lasts counts up to now.
    Time time_waited() const;
    /// For a process at the outermost level: since when it and all its components have waited; none if they do not.
    std::optional<Time> waits_since() const;

    /// Waits until made ready, and notes for reports why and where. REQUIRES: this process is running.
    void wait_for(Activity, const AnyChannel*, const SourceLocation&);
    void wait_for(Activity, std::span<const AnyChannel* const>, const SourceLocation&, bool awaits_timer = false);
    /// Computes on its executive. REQUIRES: this process is running, and is placed. Throws what
    /// Executive::begin_computing does, and Unwinding when the simulation is over.
    void compute(Cycles, const CodeShape&);
    /// Computes for the given cycles, if the process is placed, then begins the communication, and waits until it is
    /// over. Throws what compute() does. REQUIRES: this process is running.
    void compute_and_communicate(Communication&, Cycles);
    /// For a communication: the process waits from now on until it is made ready. Notes for reports why and where.
    void begin_wait(Activity, const AnyChannel*, const SourceLocation&);
    /// Waits for the components of its PAR. If it has an executive, it runs the last component itself, which must not
    /// be ready yet.
    void wait_for_components(Process& last, const SourceLocation&);
    /// Notes a delay that took no wait, since the kernel could pass the time (Kernel::pass_time). REQUIRES: this
    /// process is running.
    void was_delayed(Time since, const SourceLocation&);

private:
    friend class Executive;
    friend class Kernel;
    friend class Worker;
    friend class ProcessQueue;

    void note_wait(Activity);
    void finish_wait(Process* successor = nullptr);
    void note_end_of_wait();
    bool computes_at_once(Cycles, const CodeShape&);
    bool begin_communication();
    void goes_on();
    void stands_still();

    // The members are in the order of use, in few lines of the cache: first what each turn and wait needs, ...
    Kernel& kernel_;
    Worker* worker_ = nullptr;              ///< the fiber that runs its body; null before its first turn
    const std::byte* stack_ends_ = nullptr; ///< end of the used part of its stack; null if not noted
    Executive* executive_;                  ///< null if it is not placed
    Process* next_ = nullptr;               ///< the next in the queue in which it stands
    Priority priority_;
    std::uint32_t ordinal_;
    Activity activity_ = Activity::ready;
    bool awaits_timer_ = false;
    bool may_give_up_ = false;
    bool machine_ = false;                        ///< it serves the machine
    bool communicates_ = false;                   ///< it waits in a communication that has begun
    Communication* communication_ = nullptr;      ///< begins at its next turn; null: its program continues
    const AnyChannel* awaited_channel_ = nullptr; ///< of its last wait, if that was for a single channel
    SourceLocation where_;                        ///< where in its program it last waited
    Process* outermost_ = this;                   ///< see outermost()
    // For a process at the outermost level, which counts for itself and its components:
    std::size_t going_on_ = 1; ///< how many of them neither wait nor have ended
    Time still_since_{};       ///< when the last of them began to wait, or ended
    Time waited_{};
    Time work_left_{};  ///< see Executive::work_left
    CodeShape grain_{}; ///< see Executive::grain

    // ... and what few do.
    ReplayLog* history_ = nullptr;
    std::span<const AnyChannel* const> alternatives_; ///< set while it waits for several channels
    std::string name_;
    std::size_t index_ = 0;
    Body body_;
    std::size_t slot_ = 0; ///< its place in the kernel's list
    Join* join_ = nullptr; ///< the PAR of which it is a component
    unsigned times_unwound_ = 0;
};

/// A queue, first in, first out. It is linked through the processes themselves, so that a process stands in at most one
/// queue.
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
