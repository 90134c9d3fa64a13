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

/// Describes the code of a computation, as far as it influences scheduling and time. An executive is the device that
/// executes a process, such as a transputer. Lengths are in cycles of the executive, at least 1.
struct CodeShape {
    /// Distance between the instructions `j` or `lend`, at which a low-priority process yields if its timeslice is
    /// over.
    Cycles between_points{1};
    /// Length of the computation's instructions, which are taken to be equal. A high-priority process that becomes
    /// ready waits for the end of the current instruction. A division of integers takes 39 cycles (databook).
    Cycles instruction{1};
    /// Number of accesses to words of memory outside the chip, for code and data. The computation's cycles already
    /// count each access at the speed of on-chip memory; the executive adds the difference.
    std::int64_t words_outside = 0;
};

/// The two priorities of occam's processes.
enum class Priority { high, low };

/// What a process does or, in a trace, a link or a bus. Process::activity() is `ready`, `ended`, or a wait, from
/// `delayed` to `stopped`. A `stopped` process waits for ever. In a trace, a process can also be `starting`,
/// `executing`, `computing`, or `moving` words over a bus. In a trace, a link with a message is `carrying`, and a
/// process that waits for a bus is `arbitrating`. Only reports use `halted`: the process's executive has stopped for
/// ever. The numbers up to `stopped` are in the files of traces and must not change.
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

/// Returns whether a process with this activity waits: for a partner, its timer, its components, the end of the work,
/// or for ever.
constexpr bool is_waiting(Activity activity) { return activity >= Activity::delayed && activity <= Activity::stopped; }

/// A running PAR: the number of components that have not ended, and the process that waits for them.
struct Join {
    std::size_t components_left;
    Process& parent;
    std::size_t components = components_left;
    std::uint32_t first_ordinal = 0; ///< number of the first component in the simulation; the others have the next
                                     ///< numbers
};

/// A communication that a process begins after a computation, such as the computation of its cost. To save a context
/// switch, the kernel begins the communication without resuming the process after the computation.
class Communication {
public:
    Communication() = default;
    Communication(const Communication&) = delete;
    Communication& operator=(const Communication&) = delete;

protected:
    ~Communication() = default;

private:
    friend class Process;
    /// Called at the process's turn. If the process must wait, calls Process::begin_wait and returns true; otherwise
    /// returns false, and the process continues. The kernel calls the function on the stack of any process, but
    /// Kernel::running() returns the process that communicates. The function itself must not wait.
    virtual bool begin(Process&) noexcept = 0;
};

/// A process of the simulation: a function, the body, which runs on a fiber. A process that is placed has an executive,
/// which it shares with other processes. A process made by the simulation is at the outermost level; a process made by
/// `par` is a component of a PAR. The maker owns the process, and destroys it only when the process has ended or the
/// simulation is over.
class Process {
public:
    using Body = std::function<void()>;

    /// Makes a process with a name, at the outermost level.
    Process(Kernel&, std::string name, Body, Executive*, Priority);
    /// Makes component number `index` of a PAR in `parent`, on the parent's executive.
    Process(Process& parent, std::size_t index, Body, Priority, Join&);
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    /// Returns a path such as "cluster[0].master", or "cluster[0].master/1" for a component of a PAR.
    std::string path() const;
    /// Returns the process's own name; empty for a component of a PAR.
    const std::string& name() const { return name_; }
    /// Returns the number of the process in its simulation, in the order of creation.
    std::uint32_t ordinal() const { return ordinal_; }
    /// Returns the process whose PAR has this process as a component; null at the outermost level.
    const Process* parent() const { return join_ ? &join_->parent : nullptr; }
    /// Returns the process's ancestor at the outermost level. At the outermost level, returns the process itself.
    const Process& outermost() const { return *outermost_; }
    /// Returns whether the process with this ordinal is another component of a PAR to which this process belongs,
    /// directly or through its ancestors.
    bool is_beside(std::uint32_t ordinal) const;
    /// Returns the process's executive; null if the process is not placed.
    Executive* executive() const { return executive_; }
    Priority priority() const { return priority_; }
    Kernel& kernel() const { return kernel_; }
    bool ended() const { return activity_ == Activity::ended; }
    /// Returns whether the process has had a turn. REQUIRES: the process has not ended.
    bool has_begun() const { return worker_ != nullptr; }
    /// Makes the process a part of the machine, such as a router's process. The run can end before such a process ends.
    void serve_machine();
    bool serves_machine() const { return machine_; }
    /// Makes the process record its actions in a log, its history, or repeat a recorded history without the machine
    /// (runtime/replay_log.hpp). REQUIRES: the process has not begun; the history outlives the run.
    void keep(ReplayLog&);
    /// Returns the process's history. Null if the process keeps none, and while the process is unwound after the run.
    ReplayLog* history() const { return history_; }

    // The next functions are for reports.
    Activity activity() const { return activity_; }
    /// Returns the channels on which the process waits. If the process does not wait, returns the channel of its last
    /// wait, or nothing if the last wait was for several channels.
    std::span<const AnyChannel* const> awaited_channels() const {
        return awaited_channel_ ? std::span(&awaited_channel_, 1) : alternatives_;
    }
    /// Returns whether the process's last wait has a time limit.
    bool awaits_timer() const { return awaits_timer_; }
    /// Sets whether the process's next waits may end without the partner, by a time limit or by another process.
    void may_give_up(bool may) { may_give_up_ = may; }
    /// Returns the place in its program at which the process last waited.
    const SourceLocation& place_in_program() const { return where_; }
    /// Returns the total time during which the process and all components of its PARs waited at the same time. A wait
    /// ends when the process runs again; a wait that has not ended counts up to now. REQUIRES: a process at the
    /// outermost level.
    Time time_waited() const;
    /// Returns since when the process and all its components have waited; nothing if one of them does not wait.
    /// REQUIRES: a process at the outermost level.
    std::optional<Time> waits_since() const;

    /// Wait until the process is made ready. The activity, the channels and the place appear in reports. REQUIRES: this
    /// process is running.
    void wait_for(Activity, const AnyChannel*, const SourceLocation&);
    void wait_for(Activity, std::span<const AnyChannel* const>, const SourceLocation&, bool awaits_timer = false);
    /// Computes on the executive. Throws the exceptions of Executive::begin_computing, and Unwinding when the
    /// simulation is over. REQUIRES: this process is running, and is placed.
    void compute(Cycles, const CodeShape&);
    /// Computes for the given cycles if the process is placed, then begins the communication, and waits until the
    /// communication is over. Throws the exceptions of compute(). REQUIRES: this process is running.
    void compute_and_communicate(Communication&, Cycles);
    /// Notes that the process waits from now on, until it is made ready. Only for Communication::begin. The activity,
    /// the channel and the place appear in reports.
    void begin_wait(Activity, const AnyChannel*, const SourceLocation&);
    /// Waits for the components of the process's PAR. If the process has an executive, the successor, one of the
    /// components, takes the process's place on the executive, and must not have been made ready.
    void wait_for_components(Process& successor, const SourceLocation&);
    /// Records a delay that needed no wait, because nothing else could happen in the meantime (Kernel::pass_time).
    /// REQUIRES: this process is running.
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

    // The first members are needed for each turn and each wait, so they share few cache lines.
    Kernel& kernel_;
    Worker* worker_ = nullptr;              ///< fiber that runs the body; null before the first turn
    const std::byte* stack_ends_ = nullptr; ///< end of the used part of the stack; null if not recorded
    Executive* executive_;                  ///< null if the process is not placed
    Process* next_ = nullptr;               ///< next process in the same queue
    Priority priority_;
    std::uint32_t ordinal_;
    Activity activity_ = Activity::ready;
    bool awaits_timer_ = false;
    bool may_give_up_ = false;
    bool machine_ = false;                        ///< the process serves the machine
    bool communicates_ = false;                   ///< the process waits in a Communication that has begun
    Communication* communication_ = nullptr;      ///< communication to begin at the next turn; null: the program
                                                  ///< continues
    const AnyChannel* awaited_channel_ = nullptr; ///< channel of the last wait, if it was a wait for a single channel
    SourceLocation where_;                        ///< place of the last wait in the program
    Process* outermost_ = this;                   ///< see outermost()
    // The next members of a process at the outermost level count for the process and its components together.
    std::size_t going_on_ = 1; ///< number of processes that neither wait nor have ended
    Time still_since_{};       ///< time at which the last of them began to wait or ended
    Time waited_{};
    Time work_left_{};  ///< see Executive::work_left
    CodeShape grain_{}; ///< see Executive::grain

    // The next members are needed rarely.
    ReplayLog* history_ = nullptr;
    std::span<const AnyChannel* const> alternatives_; ///< set while the process waits for several channels
    std::string name_;
    std::size_t index_ = 0;
    Body body_;
    std::size_t slot_ = 0; ///< index in the kernel's list
    Join* join_ = nullptr; ///< the PAR that has this process as a component
    unsigned times_unwound_ = 0;
};

/// A queue of processes, first in, first out. The processes themselves hold the links of the list, so a process is in
/// at most one queue.
class ProcessQueue {
public:
    bool empty() const { return !first_; }
    void push_back(Process& p) {
        p.next_ = nullptr;
        (first_ ? last_->next_ : first_) = &p;
        last_ = &p;
    }
    void push_front(Process& p) {
        if (!first_)
            last_ = &p;
        p.next_ = first_;
        first_ = &p;
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

/// Decides which process has the next turn on a thread of a native run, that is, a run in real time on several threads.
/// A process woken by an event or by a message of another thread runs before other ready processes, because another
/// thread may be waiting for it. After `most_in_a_row` such turns, another process has a turn, so that woken processes
/// do not block the others for ever.
class TurnsOfWoken {
public:
    static constexpr unsigned most_in_a_row = 8;

    /// Removes the next woken process from the queue and returns it. Returns null if the queue is empty, or if one of
    /// the other processes has the next turn. `others`: other processes are ready.
    Process* next(ProcessQueue& woken, bool others) {
        Process* const p = others && in_a_row_ >= most_in_a_row ? nullptr : woken.pop_front();
        in_a_row_ = p ? in_a_row_ + 1 : 0;
        return p;
    }

private:
    unsigned in_a_row_ = 0;
};

} // namespace placedpar
