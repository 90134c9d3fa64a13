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

/// The rule by which one of the requesting masters gets a VMEbus. A master requests the bus on one of the levels BR0 to
/// BR3. `priority` (PRI): the highest level gets the bus. `round_robin` (RRS): the levels take turns in descending
/// order, beginning below the level that had the bus last. `single_level` (SGL): there is only BR3. Within a level, the
/// requesting master in the lowest slot gets the bus (VMEbus specification).
enum class Arbitration { priority, round_robin, single_level };

/// When a master gives up the bus: `when_done` (RWD) after each block of words, `on_request` (ROR) when another master
/// requests the bus.
enum class Release { when_done, on_request };

/// The times of a VMEbus.
struct VmeTiming {
    Time word = std::chrono::nanoseconds{310};        ///< a transfer of 32 bits (D32) with ordinary memory; published
                                                      ///< textbook figure
    Time byte = std::chrono::nanoseconds{310};        ///< our choice: a register is as fast as ordinary memory
    Time arbitration = std::chrono::nanoseconds{200}; ///< our choice: time from a request or a release of the bus to
                                                      ///< the grant
    Time time_out = std::chrono::microseconds{125};   ///< published: a common default of bus timers
};

/// A device that responds to accesses on a bus.
class BusSlave {
public:
    virtual ~BusSlave() = default;
    virtual const std::string& bus_name() const = 0;

    /// A period in which the slave does not respond, as if its board were removed from its slot.
    struct Absence {
        Time from, until;
        std::uint64_t unanswered = 0; ///< number of accesses without response
    };
    /// Adds a period without response. The returned reference is valid as long as the slave exists. REQUIRES: the run
    /// has not begun.
    const Absence& leave(Time from, Time until) { return absences_.emplace_back(Absence{from, until}); }
    /// Begins an access. Returns whether the slave responds.
    bool answer(Time now);

private:
    std::deque<Absence> absences_;
};

/// Thrown if no slave responds and the bus timer ends the cycle.
class BusError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A VMEbus. Its masters, such as a host computer or a transputer board, request the bus, and one of them gets it. The
/// bus then moves words for the processes of this master.
///
/// 1. The arbiter decides when the time `VmeTiming::arbitration` has passed since the bus was requested or given up.
/// The arbiter chooses among all masters that request the bus at that time.
/// 2. The move of a word is always completed. After each word, a master with Release::on_request gives up the bus if
/// any other master requests it. A master with Release::when_done usually finishes its block. Only with PRI arbitration
/// it gives up the bus earlier, to a master of a higher level (signal BCLR). The rest of the block waits for the
/// master's next turn.
/// 3. A master with Release::on_request keeps the bus after its last block until another master requests it. Meanwhile
/// its further blocks need no arbitration.
/// 4. The words of a block follow each other without a break, and need a single event. If the master must yield to a
/// new request, the event is moved to the end of the current word. A request at the very end of a word waits for the
/// next word.
class VmeBus {
public:
    /// Throws std::logic_error unless the times of a word, a byte and the time-out are positive, and the time of the
    /// arbitration is at least 0.
    VmeBus(Kernel&, std::string name, Arbitration = Arbitration::priority, const VmeTiming& = {});
    VmeBus(const VmeBus&) = delete;
    VmeBus& operator=(const VmeBus&) = delete;

    const std::string& name() const { return name_; }
    Arbitration arbitration() const { return arbitration_; }
    const VmeTiming& timing() const { return timing_; }
    const std::vector<VmeMaster*>& masters() const { return masters_; }

    /// Returns how long the bus has moved words so far, including accesses without a response.
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
    int last_level_ = 0; ///< level of the master that had the bus last
    Time block_began_{}; ///< start of the current block
    Time busy_{};        ///< total time of earlier blocks
    StepEvent<&VmeBus::arbitrate> arbitrate_{*this};
    StepEvent<&VmeBus::end_block> end_block_{*this};
};

/// A master's position on a bus.
struct VmePlace {
    int level = 3; ///< request level, BR0 to BR3
    int slot = 1;  ///< the daisy chain begins at slot 1
    Release release = Release::when_done;
};

/// What accesses over the bus cost a master's program, in cycles of its processor's clock. The time on the bus comes in
/// addition.
struct BusProgram {
    Cycles byte_access{};         ///< access to a register
    Cycles read_word{};           ///< reading a word of memory
    Cycles write_word{};          ///< writing a word of memory
    bool in_blocks = false;       ///< one instruction moves all words of a block
    Cycles interrupt{};           ///< time from an interrupt to the process that it wakes
    std::int64_t most_polls = 32; ///< largest number of unsuccessful reads of a status register; then the program waits
                                  ///< for an interrupt
};

/// A bus master. It requests the bus for the processes of one processor, one after another.
class VmeMaster {
public:
    /// REQUIRES: the bus outlives the master. Throws std::logic_error for a level outside 0 to 3 and for a slot outside
    /// 1 to 21. Also throws std::logic_error if the slot belongs to another master, or if the level is not 3 on a bus
    /// with a single level.
    VmeMaster(Kernel&, std::string name, VmeBus&, const VmePlace& = {}, const BusProgram& = {});
    VmeMaster(const VmeMaster&) = delete;
    VmeMaster& operator=(const VmeMaster&) = delete;

    const std::string& name() const { return name_; }
    VmeBus& bus() const { return bus_; }
    const VmePlace& place() const { return place_; }
    const BusProgram& program() const { return program_; }

    /// Move words for the running process, or access a register once. Meanwhile the process's processor stands still.
    /// Throw BusError if no slave responds. REQUIRES: words > 0.
    void move_words(BusSlave&, std::uint64_t words);
    void access_byte(BusSlave&);
    /// Holds the bus for a time without a break, like a device that does not release the bus.
    void hold(Time);
    /// Holds the bus until a time. If the bus is granted later than that, gives it up at once.
    void hold_until(Time);

    std::uint64_t words_moved() const { return words_moved_; }
    std::uint64_t bytes_accessed() const { return bytes_accessed_; }
    std::uint64_t bus_errors() const { return bus_errors_; }
    /// Return how often the bus was granted, the total time and the longest time of waiting for the bus.
    std::uint64_t grants() const { return grants_; }
    Time time_waited() const { return waited_; }
    Time longest_wait() const { return longest_wait_; }

private:
    friend class VmeBus;

    /// A block of words, for which a process waits.
    struct Block {
        Process& process;
        std::uint64_t words;
        Time each;
        Time until{}; ///< for hold_until(): the time until which the bus is held
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
    std::string waiting_track_; ///< name of the track that shows waits for the bus in a trace
    std::deque<Block*> blocks_;
    bool asks_ = false;
    Time asked_at_{};
    std::uint64_t words_moved_ = 0, bytes_accessed_ = 0, bus_errors_ = 0, grants_ = 0;
    Time waited_{}, longest_wait_{};
};

} // namespace placedpar::hardware
