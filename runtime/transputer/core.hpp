#pragma once

#include "runtime/random.hpp"
#include "runtime/time.hpp"
#include "runtime/transputer/core_state.hpp"
#include "runtime/transputer/decoded_code.hpp"
#include "runtime/transputer/memory.hpp"
#include "runtime/transputer/model.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace placedpar::transputer {

class CodeLines; // runtime/transputer/code_lines.hpp

/// The timing constants of an emulated transputer.
struct CoreTiming {
    std::int64_t clock_hz = 20'000'000;
    int memory_cycles = 3; ///< cycles of an access to a word of memory outside of the chip; published: at least 3
    int switch_cycles = 0; ///< cycles of a switch to the next process, beyond the instruction that gives up the
                           ///< processor
    /// True: addresses beyond the end of the memory wrap round to its beginning, as on boards. False: only addresses of
    /// lb, sb, ldnl and stnl wrap, because programs find the size of the memory by these instructions. Other accesses
    /// beyond the end stop the core.
    bool wraps = false;
};

/// The operations of links that a core calls. Channels 0 to 3 are the outputs of the links, 4 to 7 the inputs, and 8 is
/// the event channel. The functions must not wait or throw.
class LinkEngines {
public:
    /// Begins to move bytes from or to memory, and calls Core::transfer_ended() at the end. If the link is not
    /// connected, the transfer never ends.
    virtual void begin_transfer(int channel, Word address, Word bytes) = 0;
    /// Returns whether a byte has arrived at an input for which no transfer has begun.
    virtual bool byte_waits(int channel) = 0;
    /// Cancels the current transfer.
    virtual void reset(int channel) = 0;

protected:
    ~LinkEngines() = default;
};

/// The processor of an emulated transputer: registers, memory, the queues of processes and of timers. It executes a
/// transputer's own code, with the cycles of the published table. It knows nothing of the simulation's events and
/// wires; Node makes it a device of a simulation.
///
/// Processes are workspaces in the memory. The queues, the states of an ALT and the saved registers of an interrupted
/// process are in the same words as in the real machine. An instruction has its effect at its end.
///
/// Source: IMS T800 data sheet; "Transputer instruction set: a compiler writer's guide" (INMOS 1988).
class Core : private CoreState {
public:
    Core(Model, std::uint64_t memory_bytes, const CoreTiming&, LinkEngines&);

    /// The reason why a run() has ended.
    enum class Pause {
        limit,   ///< local time has reached the limit
        on_time, ///< the next effect concerns links, queues or clocks, so call run() again at its time; also returned
                 ///< after an effect on a link, because other devices may then act on the core
        idle,    ///< no process can run before a timer is due or a link makes a process ready
        stopped, ///< see stopped()
        left     ///< the watcher ends the run
    };
    /// What links may do to the core before it reaches the limit of run().
    enum class Links {
        rest,          ///< nothing
        take_accesses, ///< use the memory, so that the core waits; effects that depend on clocks happen at their own
                       ///< times, after lose_accesses()
        may_wake       ///< also make processes ready; every effect on queues and clocks happens at its own time
    };
    /// Executes until an instruction would begin at `limit` or later. Effects at the limit or later do not happen.
    /// REQUIRES: the present time is local_time(). If the core was idle, call pass_idle_time() first.
    Pause run(HalfCycles limit, Links = Links::rest);

    /// Saves the state and the memory, so that go_back() can restore them.
    void keep();
    /// Discards the saved state.
    void let_go() { memory_.let_go(); }
    /// Restores the saved state. REQUIRES: keep() was called, and neither let_go() nor go_back() was called after it.
    /// Since keep(), no link has acted on the core, and the core has not acted on a link.
    void go_back();
    /// Handles timers and the end of a timeslice period that were due before `then`.
    void attend_if_due(Time then) {
        if (local_ >= due_ && time_at(due_) < then && stopped_ == Stopped::nothing)
            attend();
    }

    /// Returns the local time: the number of half cycles since the core was last woken from idleness.
    HalfCycles local() const { return local_; }
    Time time_at(HalfCycles local) const {
        return later(origin_, half_cycles_.duration(static_cast<std::int64_t>(local)));
    }
    Time local_time() const { return time_at(local_); }
    /// Returns the first half cycle at or after a time. REQUIRES: time >= time_at(0).
    HalfCycles half_cycle_at(Time) const;
    /// Sets the local time after the core was idle. REQUIRES: the last run() returned Pause::idle, or run() was never
    /// called.
    void pass_idle_time(Time now);
    /// Advances the local time by the accesses in which link engines moved this number of words from or to memory.
    void lose_accesses(std::uint64_t words);
    /// Returns when the first timer is due; Time::max() if none is.
    Time next_timer() const { return next_timer_; }
    /// Returns the local time at which the core handles its timers and timeslices next.
    HalfCycles next_attention() const { return due_ > local_ ? due_ : local_; }

    /// From now on, runs ready processes in a random order. A transputer runs them in the order in which they became
    /// ready, but occam does not promise this order. So a shuffled run can reveal a fault of a program.
    void shuffle(const RandomStream& lots) { shuffle_ = lots; }
    /// Begins to execute code at MemStart, as at the end of a boot. Register A gets the old Iptr, B the old Wptr, and C
    /// the address of the input channel.
    void boot(Word code_bytes, int input_channel);
    /// Makes the process that waits at a link's channel ready, because its transfer has ended.
    void transfer_ended(int channel);
    /// Handles a byte that arrived without a transfer. If a process waits for the byte in an ALT, makes the process
    /// ready.
    void byte_has_come(int channel, Time);
    /// Returns whether a process waits for a link.
    bool waits_for_links() const;
    /// Returns whether a link may change at any moment which process the core executes. In one case, a process of high
    /// priority waits for a link. In the other, the running process has used up its timeslice, and continues only
    /// because no other process is ready.
    bool may_be_interrupted() const;
    /// Copy bytes for a link or a boot. Offsets outside of the memory stop the core if addresses do not wrap.
    void copy_from_memory(Word offset, std::span<std::uint8_t>);
    void copy_to_memory(Word offset, std::span<const std::uint8_t>);
    bool is_running() const { return running_; }
    /// Returns whether a process runs or is ready.
    bool is_active() const { return running_ || front_[0] != not_a_process || front_[1] != not_a_process; }

    /// Makes the core stop at the next j, lend or wait, as the analyse pin does.
    void stop_for_analyse() { is_analysed_ = true; }
    /// Makes a core that has stopped ready for another boot, after which `testpranal` pushes TRUE. Saves the registers
    /// of a low-priority process below MemStart. Keeps memory and queues, and stops the clocks.
    void reset_after_analyse();

    Stopped stopped() const { return stopped_; }
    /// Returns the instruction that set the Error flag, which stopped the core. REQUIRES: stopped() is by_error.
    const ErrorNote& error() const { return noted_[static_cast<std::size_t>(priority_)]; }

    /// A process that stopped because of an error, while the core continued.
    struct StoppedProcess {
        ErrorNote error;
        int priority;
        Time at;
    };
    /// Returns the processes that `stoperr` has stopped, and those that stopped at an instruction with an error text
    /// (know_errors()), in order of time. The list has only the first 1,000 of these processes.
    std::span<const StoppedProcess> stopped_processes() const {
        return {stops_.data(), std::min(errors_, stops_.size())};
    }
    /// Returns the number of all such processes.
    std::size_t count_stopped() const { return errors_; }
    /// Sets a compiler's table, which has texts for the errors of some instructions. REQUIRES: the table outlives the
    /// run.
    void know_errors(const CodeLines& lines) { lines_ = &lines; }

    /// Returns why the core stopped, such as "the bytes at #80000104 are not an instruction of a T800".
    std::string why_stopped() const;

    Model model() const { return model_; }
    NodeMemory& memory() { return memory_; }
    const NodeMemory& memory() const { return memory_; }
    const Registers& registers() const { return registers_; }
    bool high_priority() const { return priority_ == 0; }
    bool halts_on_error() const { return halts_on_error_; }
    /// Returns the Error flag of a priority.
    bool has_error(int priority) const { return priority == priority_ ? registers_.error : other_error_; }
    Fpu& fpu() { return fpu_; }
    const Fpu& fpu() const { return fpu_; }
    /// Returns whether the byte before an address belongs to code that was executed, or was decoded with such code.
    bool has_executed_before(Word address) const {
        const Word offset = NodeMemory::offset_of(address) - 1;
        return offset < memory_.size() && code_.was_decoded(offset);
    }
    /// Returns the front of a queue of ready processes: an address of a workspace, or not_a_process.
    Word front(int priority) const { return front_[static_cast<std::size_t>(priority)]; }
    Word back(int priority) const { return back_[static_cast<std::size_t>(priority)]; }
    Word clock(int priority) const { return clock_at(local_time(), priority); }
    Word clock_at(Time, int priority) const;
    /// Returns for how many half cycles instructions were executed.
    HalfCycles busy() const { return busy_before_ + local_; }
    std::uint64_t instructions() const { return instructions_; }

    /// Sets the registers of the running process, for tests and debuggers.
    void set_registers(const Registers&, int priority);
    void set_halts_on_error(bool halts) { halts_on_error_ = halts; }
    /// A watcher is called for each instruction, for listings and debuggers. REQUIRES: the watcher only reads the core.
    class Watcher {
    public:
        /// Called before an instruction is executed. `at`: address of the instruction's first byte, including its
        /// prefixes.
        virtual void begins(Word at) = 0;
        /// Called after begins(). Returns whether the run ends before this instruction.
        virtual bool ends_run() const { return false; }
        /// Called after an instruction was executed, if it did not stop the core. Usually this is the instruction that
        /// began last. However, other processes may interrupt an instruction of the scheduler, which has its effect
        /// after its cycles. `spent`: half cycles, without waits for a channel or a time, and without interrupts.
        virtual void executed(Word at, HalfCycles spent) = 0;

    protected:
        ~Watcher() = default;
    };
    /// Executes one instruction at a time from now on, with the same results. REQUIRES: `watcher` outlives the run.
    void watch(Watcher* watcher) { watcher_ = watcher; }

    /// A change of a process's activity.
    enum class ProcessChange : std::uint8_t {
        gets_processor,
        becomes_ready,   ///< the process is in a queue of ready processes, or interrupted
        communicated,    ///< the process becomes ready by a communication with the running process
        enables_channel, ///< the running process enables the channel in an ALT
        needs_no_wait,   ///< a guard of the running process's ALT is ready
        waits_in_alt,    ///< the process waits for the channels that it has enabled
        waits_for_time,  ///< the process waits for a time, and for the channels that it has enabled, if any
        waits_for_input,
        waits_for_output,
        stops, ///< the process has left the processor and waits for nothing, or the core has stopped
        ends
    };
    /// A watcher of processes is called when they change their activity, for traces. REQUIRES: the watcher only reads
    /// the core.
    class ProcessWatcher {
    public:
        /// Called when a process changes its activity, at the local time. `workspace` is the process's present
        /// workspace, which differs from its first workspace within a procedure.
        virtual void changes(Word workspace, ProcessChange, Word channel) = 0;

    protected:
        ~ProcessWatcher() = default;
    };
    /// From now on, performs every action of the scheduler at its own time, with the same results. REQUIRES: `watcher`
    /// outlives the run.
    void watch_processes(ProcessWatcher* watcher) { process_watcher_ = watcher; }
    /// Returns whether a watcher is set. The core must then not go back, because the watcher has already seen its
    /// actions.
    bool is_watched() const { return watcher_ != nullptr || process_watcher_ != nullptr; }

private:
    /// Why execute(), the loop over instructions, has returned to the scheduler.
    enum class Left : std::uint8_t {
        budget,
        scheduling, ///< the scheduler must perform the next instruction later
        performed,  ///< an instruction of the scheduler had its effect, after which another process may run
        timeslice,
        halt,
        unknown,
        unknown_selector,
        bad_address
    };
    // engine.cpp
    Left execute(HalfCycles until, bool at_once);
    Word place_of(const Block&, const Entry&) const;
    void note_error(const Block&, const Entry&, ErrorNote);
    static std::uint64_t instructions_after(const Block&, const Entry&);
    void page_is_written(Block&, const Entry&, Word offset, Word bytes);

    // scheduler.cpp: processes and time; channels.cpp; core_memory.cpp: memory, moves, errors
    bool watcher_ends_run();
    void execute_until(HalfCycles, bool at_once);
    void act_on(Left);
    bool finish_pending(HalfCycles limit, Links, Pause&);
    bool must_begin_on_time(Operation, Links) const;
    bool must_be_on_time(Operation, Links) const;
    bool concerns_link(Operation) const;
    Left perform_at_once(Operation, Registers&, HalfCycles until);
    Left communicate_at_once(Operation, Registers&, HalfCycles until);
    Left switch_at_once(bool goes_on, Registers&);
    /// Returns whether the running process gives way at its next j or lend.
    bool is_slice_over() const {
        return is_analysed_ || (priority_ == 1 && slices_seen_ >= 2 && front_[1] != not_a_process);
    }
    void attend();
    void begin_slice();
    void find_due();
    bool dispatch();
    void run_front(int priority);
    void take_front(std::size_t priority, Registers&);
    void put_off_some(std::size_t priority);
    void set_priority(int priority);
    void save_process();
    void interrupt();
    void resume_interrupted();
    void leave_processor();
    void store_instruction(const Registers&);
    void stop_process();
    void stop_by_error(const ErrorNote&);
    void give_way();
    void enqueue(Word process);
    void end_process();
    /// A communication of the running process at a channel. If the channel is a word of memory, `partner` is the
    /// process that waits there.
    struct Communication {
        Word channel, address, bytes;
        Word partner = not_a_process; ///< workspace and priority of the process that waits
        Word partner_pointer = 0;     ///< address of its bytes, or its state if it is in an ALT
        bool meets_process() const { return partner != not_a_process && !meets_alternative(); }
        bool meets_alternative() const;
    };
    Communication communication_by(Operation, const Registers&);
    HalfCycles cost_of(Operation, const Communication&) const;
    void begin_communication(Operation);
    bool communicate(bool is_output, const Communication&, const Registers&);
    void copy_message(Word from, Word to, Word bytes);
    void communicate_by_link(int link, const Communication&);
    void wake_alternative(Word partner, Time, ProcessChange woken);
    void reset_channel();
    HalfCycles cost_of(Operation);
    void perform(Operation);
    void perform_on_processes(Operation);
    void perform_on_queues(Operation);
    void move_block(Word from, Word to, Word bytes);
    void move_in_two_dimensions(Operation);
    bool reaches(Word& offset, Word bytes) const;
    bool can_wrap(Word bytes) const;
    Word load_outside(Word address);
    void store_outside(Word address, Word value);
    // A bad address stops the core.
    [[gnu::always_inline]] Word load(Word address) {
        const Word offset = NodeMemory::offset_of(address) & ~Word{3};
        if (offset < memory_.size()) [[likely]]
            return memory_.word(offset);
        return load_outside(address);
    }
    [[gnu::always_inline]] void store(Word address, Word value) {
        const Word offset = NodeMemory::offset_of(address) & ~Word{3};
        if (offset >= memory_.size()) [[unlikely]]
            return store_outside(address, value);
        if (memory_.must_prepare(offset)) [[unlikely]]
            prepare_write(offset, 4);
        memory_.set_word(offset, value);
    }
    void write(Word offset, std::span<const std::uint8_t>);
    void prepare_write(Word offset, Word bytes);
    /// Returns the number of words that an interval touches, including words that it covers only in part.
    static HalfCycles words_touched(Word address, Word bytes) {
        return bytes == 0 ? 0 : ((HalfCycles{address} & 3) + bytes + 3) / 4;
    }
    /// Returns the additional half cycles of a copy whose source or target is outside of the chip.
    HalfCycles outside_words(Word address, Word bytes) const {
        return NodeMemory::offset_of(address) < traits_.bytes_on_chip ? 0 : words_touched(address, bytes) * penalty_;
    }
    void fault(Stopped, Word address);
    void tell(Word workspace, ProcessChange change, Word channel = not_a_process) {
        if (process_watcher_ && stopped_ == Stopped::nothing) [[unlikely]]
            process_watcher_->changes(workspace & ~Word{3}, change, channel);
    }

    // alternation.cpp: ALT, clocks and timers
    bool is_ready(Word channel);
    /// Returns the largest possible length of a queue. A queue that seems longer is a circle, which a wrong program
    /// wrote into the memory.
    Word longest_queue() const { return memory_.size() / 4; }
    void enable_channel();
    void disable_channel();
    void select(bool ready);
    void enable_timer();
    void disable_timer();
    bool time_has_come();
    void wait_for_alternative(bool timer);
    void start_clocks(Word value);
    Time when_after(Word time, int priority) const;
    void wait_for_time();
    void join_timers(Word time);
    void leave_timers(Word workspace, int priority, Time);
    void wake_timers(int priority);
    void find_next_timer();

    Word descriptor() const { return descriptor(registers_); }
    Word descriptor(const Registers& r) const { return r.workspace | static_cast<Word>(priority_); }
    void push(Word value) {
        registers_.c = registers_.b;
        registers_.b = registers_.a;
        registers_.a = value;
    }
    void pop() {
        registers_.a = registers_.b;
        registers_.b = registers_.c;
    }

    Model model_;
    const Traits& traits_;
    CoreTiming timing_;
    NodeMemory memory_;
    DecodedCode code_;
    LinkEngines& links_;
    Clock half_cycles_;
    HalfCycles penalty_; ///< additional half cycles of an access to data outside of the chip
    HalfCycles switch_;  ///< half cycles of a switch to the next process

    CoreState kept_;
    const CodeLines* lines_ = nullptr;
    /// Only the first `errors_` entries count: go_back() does not remove entries.
    std::vector<StoppedProcess> stops_;
    Watcher* watcher_ = nullptr;
    ProcessWatcher* process_watcher_ = nullptr;
};

} // namespace placedpar::transputer
