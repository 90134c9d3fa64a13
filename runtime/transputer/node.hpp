#pragma once

#include "runtime/event.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/transputer/byte_lane.hpp"
#include "runtime/transputer/core.hpp"
#include "runtime/transputer/image.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {
class Kernel;
} // namespace placedpar

namespace placedpar::transputer {

class CodeLines;    // runtime/transputer/code_lines.hpp
class ProcessTrace; // runtime/transputer/process_trace.hpp

/// An emulated transputer, which executes its own code, as a device of a simulation. After reset it listens to its
/// links. The first byte that comes over a link is a command: boot the transputer, read its memory (peek) or write its
/// memory (poke). After a boot, the transputer's core executes code.
///
/// To save events, the core executes ahead of virtual time. This does not change the results, with the exceptions
/// below. While nothing is under way on any link, the core saves its state and executes up to its next link
/// instruction. If a link is about to act on the core, the core first returns to the saved state, and executes again up
/// to the present. While a link is under way, the core executes only as long as nothing can act on it. It stops at the
/// end of a timer or a timeslice, and when a clock is read. It stops before a change of its queues if a link may make a
/// process ready. It stops at the next event of any other device if a high-priority process waits for a link.
/// Exceptions are programs that read bytes that a link is about to store, or that change bytes or a channel word that a
/// link is about to read.
///
/// Processes that links make ready at the same time become ready in the order of their channels.
///
/// Source: IMS T800 data sheet, "reset, bootstrap and analyse".
class Node final : private Event, private LinkEngines, private hardware::LinkEngineWatcher {
public:
    static constexpr int links = 4;

    /// The activity of a node. Before it is booted, a node is `listening`.
    enum class Activity : std::uint8_t { listening, booted, stopped, halted };

    /// Throws the exceptions of NodeMemory's constructor.
    Node(Kernel&, std::string name, Model, std::uint64_t memory_bytes, const CoreTiming&);
    ~Node();

    /// Returns the node's end of a link, for the constructor of a ByteLink. `number`: 0 to 3.
    ByteEnd& end(int number) { return ports_[static_cast<std::size_t>(number)]; }
    /// States that this link ends here. Its engines then use the node's memory, and the core waits for their accesses.
    /// REQUIRES: the link outlives the run.
    void has_link(hardware::Link&);
    /// Sets a function to call when the core stops by an error.
    void when_stopped(std::function<void()> f) { when_stopped_ = std::move(f); }
    /// Sets a compiler's table with the names of processes and channels, for reports. REQUIRES: the table outlives the
    /// node; the run has not begun.
    void name_by(const CodeLines& lines) {
        lines_ = &lines;
        core_.know_errors(lines);
    }
    /// Makes each instruction an event of its own, without running ahead. Tests compare such runs with usual runs.
    /// REQUIRES: the run has not begun.
    void run_instruction_by_instruction() { run_ahead_by(Time{0}); }
    /// Sets how far the core executes ahead of virtual time while nothing is under way on the links. REQUIRES: the run
    /// has not begun.
    void run_ahead_by(Time time) {
        most_ahead_ = std::min(most_ahead_, time);
        ahead_by_ = least_ahead_ = longest_ahead_ = time;
    }

    /// Puts a program into the memory, and begins it at the present time. REQUIRES: the program fits into the memory;
    /// the node listens, and the run has not begun.
    void start(const Image&);

    /// Returns whether the first process of the program that start() began has ended.
    bool has_ended(const Image&) const;
    /// Sets a function to call when only a link can wake the node: no process can run, and no timer is set.
    void when_idle(std::function<void()> f) { when_idle_ = std::move(f); }

    /// Stops the node at a time, as a fault. From then on, the node executes nothing, and obeys no commands to boot.
    /// Its link engines finish the transfers that are under way. REQUIRES: the run has not begun.
    void halt_at(Time moment) { halts_at_ = std::min(halts_at_, moment); }
    /// Sets the pin analyse at a time, and then the pin reset: the core stops at its next j, lend or wait. Then the
    /// links are reset, and the node listens to them as after reset. The memory stays as it is, except that the
    /// registers of the running process are saved below MemStart (Core::reset_after_analyse). Source: IMS T800 data
    /// sheet, "analyse". REQUIRES: the run has not begun.
    void analyse_at(Time);

    const std::string& name() const { return name_; }
    /// Returns the node's name followed by the name of a process, such as "root.phil[2]". If the process has no name,
    /// the address of its workspace takes the place of the name, as in "root.#80000144".
    std::string name_of_process(Word workspace) const;
    /// Returns the name of a channel in the compiler's table. Without such a name, a link's channel has the name of the
    /// link direction, or of the channel that C++ processes use there. Other channels have the name "root.event" or a
    /// name such as "root.#80000100".
    std::string name_of_channel(Word) const;
    Activity activity() const;
    /// Returns the core, in its state at the present time.
    Core& core() {
        come_back();
        return core_;
    }
    /// Returns how long instructions were executed so far, with waits for the memory.
    Time time_busy() const;
    /// Returns how long the memory has served link engines so far.
    Time memory_taken_by_links();
    /// Returns whether no process can run, no timer is due, and no transfer is complete. The node then waits for a link
    /// or a timer.
    bool is_idle() const { return is_idle_; }

private:
    class Port final : public ByteEnd {
    public:
        void belong_to(Node& node, int number) {
            node_ = &node;
            number_ = number;
        }
        void read(std::span<std::uint8_t>) override;
        void given() override { node_->transfer_ended(number_); }
        void write(std::span<const std::uint8_t>) override;
        void taken() override { node_->taken(number_); }
        void byte_waits() override { node_->byte_has_come(number_); }

        Word read_from = 0, write_to = 0; ///< offsets of the next bytes in memory

    private:
        Node* node_ = nullptr;
        int number_ = 0;
    };
    /// What a listening node expects next over a link.
    enum class Listening : std::uint8_t { for_command, for_poke, for_peek, for_code, answering };

    /// An action of a link on a channel of the node: a transfer has ended, or a byte has come.
    struct Wake {
        Time at;
        int channel;
        bool transfer_ended; ///< false: a byte has come
        bool operator<(const Wake& other) const { return at != other.at ? at < other.at : channel < other.channel; }
    };

    /// The moment at which the pin analyse is set.
    struct Analysis final : Event {
        explicit Analysis(Node& n) : node(n) {}
        void happen() noexcept override { node.begin_analysis(); }
        Node& node;
    };

    void happen() noexcept override;
    void begin_analysis();
    void end_analysis();
    bool is_halted() const;
    void run();
    Core::Pause run_to_limit();
    HalfCycles limit() const;
    bool may_run_ahead() const;
    Core::Pause run_ahead();
    void come_back();
    void link_will_change() override { come_back(); }
    /// Returns the virtual time up to which the core may execute if no link acts on it.
    Time horizon(Time most_ahead) const;
    bool settle();
    std::uint64_t words_moved();
    void note(const Wake&);
    void tell_core();
    void be_idle();

    // LinkEngines
    void begin_transfer(int channel, Word address, Word bytes) override;
    bool byte_waits(int channel) override;
    void reset(int channel) override;

    void transfer_ended(int channel);
    void taken(int link);
    void byte_has_come(int link);

    // Reset and boot
    void listen();
    void obey_next();
    Word wrapped(Word address) const;
    void hear(std::span<const std::uint8_t>);
    void obey(int link);
    void begin(std::span<const std::uint8_t> code, int link);

    Kernel& kernel_;
    std::string name_;
    Core core_;
    Time access_; ///< time of an access to a word of the memory
    HalfCycles access_half_cycles_;
    Time longest_instruction_;
    std::array<Port, links> ports_;
    std::vector<hardware::Link*> wires_;
    Time least_word_time_ = Time::max(); ///< least time in which both directions of the fastest link move a word
    hardware::LinkEngineMemory engines_;
    std::uint64_t words_settled_ = 0;
    Time busy_{};
    Time most_ahead_ = std::chrono::microseconds{100}; ///< how far the core may run ahead while links may act on it
    Time ahead_by_ = most_ahead_; ///< how far the core runs ahead the next time if nothing is under way on the links
    Time least_ahead_ = std::chrono::microseconds{10}, longest_ahead_ = std::chrono::milliseconds{1};
    bool is_ahead_ = false; ///< the core has saved its state, and has then executed up to `ahead_to_`
    HalfCycles ahead_to_ = 0;
    Time halts_at_ = Time::max(), analysed_at_ = Time::max();
    Analysis analysis_{*this};
    std::vector<Wake> wakes_; ///< actions of links since the last turn of the core
    bool is_idle_ = true;
    Activity activity_ = Activity::listening;
    std::optional<int> heard_link_; ///< the link whose command is being obeyed
    Listening listening_ = Listening::for_command;
    std::vector<std::uint8_t> heard_;
    std::vector<std::uint8_t> start_; ///< the starting instructions of an image, until the run begins
    std::function<void()> when_stopped_ = [] {}, when_idle_ = [] {};
    const CodeLines* lines_ = nullptr;
    bool has_image_ = false;                      ///< start() was called; the image's table has whole names of
                                                  ///< processes
    std::unique_ptr<ProcessTrace> process_trace_; ///< null until a boot, and if the run is not traced
};

} // namespace placedpar::transputer
