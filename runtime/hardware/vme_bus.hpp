#pragma once

#include "runtime/event.hpp"
#include "runtime/executive.hpp"
#include "runtime/time.hpp"

#include <cstdint>
#include <deque>
#include <stdexcept>
#include <string>
#include <vector>

namespace placedpar {
class Kernel;
class Process;
} // namespace placedpar

namespace placedpar::hardware {

class VmeMaster;

/// Determines which of the requesting masters gets a VMEbus. `priority` (PRI): the highest request level. `round_robin`
/// (RRS): the levels take turns, downwards from the one below that which had the bus last. `single_level` (SGL): there
/// is only BR3. Within a level the grant is passed from slot to slot: the lowest one that asks keeps it (VMEbus
/// specification).
enum class Arbitration { priority, round_robin, single_level };

/// When a master gives up the bus: `when_done` (RWD) after each block of words, `on_request` (ROR) when another asks.
enum class Release { when_done, on_request };

/// How long things take on a VMEbus.
struct VmeTiming {
    Time word = std::chrono::nanoseconds{310};        ///< D32 with ordinary memory, published (textbook figure)
    Time byte = std::chrono::nanoseconds{310};        ///< ours: a register is as fast as ordinary memory
    Time arbitration = std::chrono::nanoseconds{200}; ///< ours: from a request to its grant, or from a release
    Time time_out = std::chrono::microseconds{125};   ///< published: a common default of bus timers
};

/// A device that responds to accesses on a bus.
class BusSlave {
public:
    virtual ~BusSlave() = default;
    virtual const std::string& bus_name() const = 0;

    /// A period in which the slave does not respond, like a board that was removed from its slot.
    struct Absence {
        Time from, until;
        std::uint64_t unanswered = 0; ///< accesses
    };
    /// Adds a period without response. The returned reference is valid as long as the slave exists. REQUIRES: before
    /// the run.
    const Absence& leave(Time from, Time until) { return absences_.emplace_back(Absence{from, until}); }
    /// Begins an access; returns whether the slave responds.
    bool answer(Time now);

private:
    std::deque<Absence> absences_;
};

/// Thrown when no slave responds: the bus timer has ended the cycle.
class BusError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A VMEbus: its masters request it, one of them has it, and it moves words for the processes that the master executes.
///
/// 1. The arbiter decides `arbitration` after the bus was asked for or given up, among all who ask then.
/// 2. A word that is being moved is moved to its end. After it a master that releases on request gives the bus up if
///    another asks for it; one that releases when done does so if a higher level asks for it and the arbitration is PRI
///    (BCLR). The rest of its block waits for its next turn.
/// 3. A master that releases on request keeps the bus until another master asks for it, and needs no arbitration
///    meanwhile.
/// 4. The words of a block follow each other without a break; one event covers the block until a request arrives that
///    the holder must yield to. A request at the end of a word waits for the next word.
class VmeBus {
public:
    /// Throws std::logic_error unless the times of a word, a byte and the time-out are positive and that of the
    /// arbitration is not negative.
    VmeBus(Kernel&, std::string name, Arbitration = Arbitration::priority, const VmeTiming& = {});
    VmeBus(const VmeBus&) = delete;
    VmeBus& operator=(const VmeBus&) = delete;

    const std::string& name() const { return name_; }
    Arbitration arbitration() const { return arbitration_; }
    const VmeTiming& timing() const { return timing_; }
    const std::vector<VmeMaster*>& masters() const { return masters_; }

    /// Returns how long the bus has moved words so far, accesses without a response included.
    Time time_busy() const;

private:
    friend class VmeMaster;

    template <void (VmeBus::*Step)()>
    struct StepEvent final : Event {
        explicit StepEvent(VmeBus& b) : bus(b) {}
        void happen() noexcept override { (bus.*Step)(); }
        VmeBus& bus;
    };

    void attach(VmeMaster&);
    void asked_by(VmeMaster&);
    void arbitrate_later();
    void arbitrate();
    VmeMaster* next() const;
    bool is_nearer(const VmeMaster&, const VmeMaster& than) const;
    int turn_of(const VmeMaster&) const;
    void grant(VmeMaster&);
    void move_block();
    void end_block();
    void give_up();
    bool must_yield() const;
    std::uint64_t words_moved() const;
    void end_block_after(std::uint64_t words);

    Kernel& kernel_;
    std::string name_;
    Arbitration arbitration_;
    VmeTiming timing_;
    std::uint64_t first_rank_;
    std::vector<VmeMaster*> masters_;
    VmeMaster* holder_ = nullptr;
    int last_level_ = 0; ///< level of the last master on the bus
    Time block_began_{}; ///< when the current words began
    Time busy_{};        ///< total time of earlier words
    StepEvent<&VmeBus::arbitrate> arbitrate_{*this};
    StepEvent<&VmeBus::end_block> end_block_{*this};
};

/// A master's place on a bus.
struct VmePlace {
    int level = 3; ///< of BR0 to BR3
    int slot = 1;  ///< the daisy chain begins at slot 1
    Release release = Release::when_done;
};

/// Costs of programmed input and output to a master's program, in addition to the bus's time, in cycles of the
/// executive's clock.
struct BusProgram {
    Cycles byte_access{};         ///< to a register
    Cycles read_word{};           ///< of memory
    Cycles write_word{};          ///<
    bool in_blocks = false;       ///< words of memory are moved by one instruction, without the program between them
    Cycles interrupt{};           ///< from an interrupt to the process that it wakes
    std::int64_t most_polls = 32; ///< unsuccessful reads of a status register before the program waits for an interrupt
};

/// A requester: it requests the bus for the processes of one executive, one after another.
class VmeMaster {
public:
    /// REQUIRES: the bus outlives it. Throws std::logic_error for a level or slot that does not exist (0 to 3, 1 to
    /// 21), a slot that another master has, and a level other than 3 on a bus of a single level.
    VmeMaster(Kernel&, std::string name, VmeBus&, const VmePlace& = {}, const BusProgram& = {});
    VmeMaster(const VmeMaster&) = delete;
    VmeMaster& operator=(const VmeMaster&) = delete;

    const std::string& name() const { return name_; }
    VmeBus& bus() const { return bus_; }
    const VmePlace& place() const { return place_; }
    const BusProgram& program() const { return program_; }

    /// Moves the given number of words for the running process, or accesses a register once. The process keeps its
    /// executive, which stands still meanwhile. Throws BusError if no slave responds. REQUIRES: words > 0.
    void move_words(BusSlave&, std::uint64_t words);
    void access_byte(BusSlave&);
    /// Holds the bus for this time in one cycle that cannot be interrupted, like a device that does not release it.
    void hold(Time);
    /// Holds the bus until a time. If the bus is granted later than that, it is given up at once.
    void hold_until(Time);

    std::uint64_t words_moved() const { return words_moved_; }
    std::uint64_t bytes_accessed() const { return bytes_accessed_; }
    std::uint64_t bus_errors() const { return bus_errors_; }
    /// Return how often the bus was granted, and the total and the longest wait for it.
    std::uint64_t grants() const { return grants_; }
    Time time_waited() const { return waited_; }
    Time longest_wait() const { return longest_wait_; }

private:
    friend class VmeBus;

    /// A block of words for which a process waits.
    struct Block {
        Process& process;
        std::uint64_t words;
        Time each;
        Time until{}; ///< end of the current single word, if its end is still to come
        bool done = false;
    };
    void move(std::uint64_t words, Time each, Time until = {});
    void require_answer(BusSlave&);
    void ask();
    void granted();

    Kernel& kernel_;
    std::string name_;
    VmeBus& bus_;
    VmePlace place_;
    BusProgram program_;
    std::string waiting_track_; ///< of a trace
    std::deque<Block*> blocks_;
    bool asks_ = false;
    Time asked_at_{};
    std::uint64_t words_moved_ = 0, bytes_accessed_ = 0, bus_errors_ = 0, grants_ = 0;
    Time waited_{}, longest_wait_{};
};

} // namespace placedpar::hardware
