#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::test {

/// The types of transputer, as bits for the table of operations.
enum PlainModel : unsigned { t414 = 1, t425 = 2, t400 = 4, t800 = 8, t805 = 16 };

struct PlainSettings {
    PlainModel model = t800;
    std::uint32_t memory = 65536;   ///< bytes, a multiple of 4
    std::uint32_t memorycycles = 3; ///< cycles of a whole access outside the chip
    std::uint32_t clock_mhz = 20;
    bool wraps = false; ///< all accesses outside of the memory wrap, not only those of lb, sb, ldnl and stnl
};

struct PlainOperation;

/// A second implementation of the transputer, against which the first one is tested. It executes one instruction at a
/// time from tables (`plain_operations.cpp`, `plain_scheduling.cpp`, `plain_floating_point.cpp`), with the effects and
/// cycles of `docs/reference/transputer.md`. The two implementations share no code.
///
/// Where the reference leaves a choice, this implementation decides:
/// 1. Word accesses ignore the two lowest bits of an address.
/// 2. An operation on processes, channels or clocks takes effect when its cycles have passed. Its cycles depend on what
///    it finds when they begin. Other instructions take effect at once. A timer wakes its process between instructions,
///    or while an operation of the first kind is under way.
/// 3. A word of code is fetched if it differs from the word of the previous byte of code.
/// 4. Operations on processes, channels and clocks do not pay for words outside the chip, except those of messages.
/// 5. Clocks start with their value when sttimer ends. Timeslice periods count from time 0.
/// 6. The cost of a message depends on the words that it touches in the memory of the process that comes second. The
///    cost of a move depends on the words of its source, and the cost of a two-dimensional move on the words of its
///    first row.
/// 7. Processes in the timer queue with equal times wake in the order in which they came.
/// 8. A process that becomes ready passes through its queue, even if it runs at once.
/// 9. dist compares with word W-5: the time at which the process was woken, or the time that taltwt found.
/// 10. A process gives way if its timeslice periods had passed when its instruction began. Processes that were woken
///     meanwhile come before it in the queue. While a process is interrupted, no periods are counted.
/// 11. Timers that are due when an operation of the first kind ends wake before its effect.
/// 12. An address outside of the memory wraps to the memory outside of the chip. The bytes at its beginning, which the
///     memory on the chip hides, are stored behind `settings.memory`.
/// 13. FPError belongs to the registers of the unit, which an interrupt saves. A load from outside the chip delays the
///     integer unit alone.
///
/// Links are left out: an instruction that uses the channel of a link stops the processor.
struct PlainTransputer {
    using Word = std::uint32_t;
    static constexpr Word most_neg = 0x80000000, not_process = most_neg;
    static constexpr Word enabling = most_neg + 1, waiting = most_neg + 2, ready = most_neg + 3;
    static constexpr Word time_set = most_neg + 1, time_not_set = most_neg + 2, none_selected = 0xFFFFFFFF;
    static constexpr Word timer_heads = most_neg + 0x24, saved = most_neg + 0x2C;

    /// Words below the workspace of a process that waits, as offsets in bytes.
    static constexpr Word iptr_word = 4, link_word = 8, state_word = 12, timer_word = 16, time_word = 20;
    static Word workspace(Word descriptor) { return descriptor & ~3U; }
    /// Returns whether a time is after another, on a clock that wraps.
    static bool after(Word time, Word other) { return static_cast<std::int32_t>(time - other) > 0; }

    explicit PlainTransputer(const PlainSettings&);

    /// Executes one instruction with its prefixes, and then the wake-ups, interrupts and switches of processes that
    /// follow it. An idle processor waits for its next timer. Returns the half cycles that passed.
    std::uint64_t step();
    /// Steps until the processor stops, or the next instruction is at the address. Returns the half cycles that passed.
    std::uint64_t run(Word until, int steps = 1000000);

    Word on_chip() const { return settings.model == t414 || settings.model == t400 ? 2048 : 4096; }
    Word mem_start() const { return most_neg + (settings.model == t414 ? 0x48 : 0x70); }
    /// Writes bytes into memory without cost.
    void poke(Word address, std::span<const std::uint8_t>);
    void poke(Word address, Word value);
    /// Returns a word of memory without cost.
    Word peek(Word address) const;
    /// Returns the clock of a priority.
    Word clock(unsigned of_priority) const;

    PlainSettings settings;
    std::vector<std::uint8_t> memory;
    std::uint64_t now = 0; ///< half cycles since the start
    std::string stopped;   ///< why and where the processor stopped; empty while it runs

    Word iptr, wptr;
    Word a = 0, b = 0, c = 0;
    unsigned undefined = 0, saved_undefined = 0; ///< 1, 2, 4: the reference leaves the value of A, B, C open
    unsigned priority = 1;                       ///< 0 high, 1 low
    bool idle = false, interrupted = false;
    std::array<bool, 2> error{};
    bool halt_on_error = false, analysed = false, j0_break = false;
    std::array<Word, 2> front{not_process, not_process}, back{not_process, not_process};
    bool clocks_run = false;
    Word clock_value = 0;           ///< value of both clocks when they were started
    std::uint64_t clocks_since = 0; ///< time at which the clocks were started
    std::array<bool, 2> timer_enabled{true, true};
    std::uint64_t slice_began = 0;   ///< the timeslice period in which the process was dispatched
    std::uint64_t slices_before = 0; ///< periods that an interrupted process has seen
    Word rows = 0, target_stride = 0, source_stride = 0;

    /// The floating-point unit.
    struct Real {
        std::uint64_t bits = 0;
        bool is_double = false;
    };
    struct Unit {
        std::array<Real, 3> f{};
        bool error = false;
        int rounding = 0; ///< 0 nearest, 1 up, 2 down, 3 to zero
    };
    Unit unit, interrupted_unit;
    std::uint64_t fpu_free = 0; ///< time at which the present operation of the unit ends

    // The rest is for the tables. Instructions add to `cycles`, and memory to `extra`, in half cycles.
    Word operand = 0, begun_at = 0, fetched = 0;
    std::uint64_t cycles = 0, extra = 0;
    bool leaving = false, may_slice = false, slice_is_over = false, has_erred = false;

    void push(Word);
    Word pop();
    /// Replaces two operands by a result.
    void binary(Word);
    void pop_all(unsigned count);
    void set_error() { error[priority] = has_erred = true; }
    [[noreturn]] void stop(std::string_view reason) const;

    Word load(Word address, bool wraps = false);
    void store(Word address, Word value, bool wraps = false);
    std::uint8_t load_byte(Word address, bool wraps = false);
    void store_byte(Word address, std::uint8_t value, bool wraps = false);
    Word local(int number) { return load(wptr + 4 * static_cast<Word>(number)); }
    void store_local(int number, Word value) { store(wptr + 4 * static_cast<Word>(number), value); }
    void copy(Word target, Word source, Word count);
    /// Returns the index in `memory` for an offset from MostNeg.
    Word wrapped(Word place) const;
    /// Adds the cost of a copy, which depends on the words at the first address.
    void pay_for_copy(Word first, Word second, Word count);

    Word descriptor() const { return wptr | priority; }
    void enqueue(Word descriptor);
    /// Stores the instruction pointer and gives up the processor.
    void leave();
    void insert_timer(Word time);
    void remove_timer(Word descriptor);
    bool selects(bool is_ready);
    void refuse_link(Word channel) const;
    /// Returns whether a process that inputs or outputs comes second, so that the message is copied and the process
    /// pays for its words. A process that outputs to an alternation always comes first.
    bool comes_second(Word channel, bool output);
    /// Returns the word that a process waiting at a channel has stored: its pointer, or the state of its ALT.
    Word told_by(Word process);
    void transfer(bool output, Word channel, Word pointer, Word count);

    bool execute_floating_point(unsigned code);

private:
    struct Pending {
        const PlainOperation* operation = nullptr;
        std::uint64_t left = 0; ///< half cycles to its effect
    };
    bool execute_from(std::span<const PlainOperation>, unsigned code);
    void go_on_with_pending();
    std::uint64_t next_timer() const;
    struct Stop {
        std::string reason;
    };
    std::size_t offset(Word address, bool wraps);
    void execute();
    void direct(unsigned function);
    void finish();
    void wake_due();
    void wait_for_timer();
    void run_next();
    void interrupt();
    void resume();
    Pending pending_, interrupted_pending_;
    std::uint64_t slice() const { return now / (2048ULL * settings.clock_mhz); }
    std::uint64_t tick(unsigned of_priority) const { return (of_priority ? 128ULL : 2ULL) * settings.clock_mhz; }
};

/// When an operation takes effect: at its start, or when its cycles have passed. An interrupt may come before.
enum class When { at_once, at_end, at_end_unless_interrupted };

/// A row of the tables.
struct PlainOperation {
    unsigned code;
    std::string_view name;
    unsigned cycles;
    unsigned models;
    void (*effect)(PlainTransputer&);
    When when = When::at_once;
    void (*cost)(PlainTransputer&) = [](PlainTransputer&) {}; ///< adds cycles to an operation with effect at its end
};
extern const std::span<const PlainOperation> plain_integer_operations, plain_scheduling_operations;

/// A row of the table of the floating-point unit.
struct PlainRealOperation {
    unsigned code; ///< or 0x1000 + selector of fpentry
    std::string_view name;
    unsigned single_cycles, double_cycles;
    bool waits; ///< the integer unit waits for the result
    void (*effect)(PlainTransputer&);
};
extern const std::span<const PlainRealOperation> plain_real_operations;

} // namespace placedpar::test
