#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::occam {

/// These structures lay out the workspaces of processes. The workspace of a procedure is laid out after all its code
/// has been made, so that the words with the most uses get the lowest offsets, which need the shortest instructions.
/// The workspaces of the components of a PAR are below that of the process that starts them. Until the layout is known,
/// code refers to a word by a Cell.

using Label = std::uint32_t;
struct Level;
struct Frame;

/// Identifies a word of a workspace.
struct Cell {
    enum class Area : std::uint8_t {
        local, ///< a variable or temporary of the frame
        low,   ///< one of the lowest words of the frame, which hold operands of some instructions and further arguments
               ///< of calls
        parameter, ///< a parameter of the frame's procedure
        link,      ///< a hidden parameter, directly after the return address: the address of the frame of the enclosing
                   ///< procedure
        vector,    ///< a hidden parameter: the address of free vector space, the memory for arrays
        base       ///< the word to which the frame's workspace pointer points
    };
    Frame* frame = nullptr;
    Area area = Area::base;
    int index = 0;

    Cell after(int words) const { return {frame, area, index + words}; }
};

/// Describes the workspace of a procedure, or of a component of a PAR: its frame.
struct Frame {
    explicit Frame(Level& l) : level(&l) {}

    /// Reserves consecutive local words. The caller frees them by setting `top` to its earlier value.
    Cell allocate(int words);
    void use(const Cell& cell, double weight);
    /// Returns whether some code uses this local word. Other words have no place in the workspace.
    bool is_used(const Cell& cell) const { return uses[static_cast<std::size_t>(cell.index)] > 0; }
    /// Tells that the process needs this number of words below its frame.
    void need_below(std::int64_t words) { below = below < words ? words : below; }
    /// Tells that an instruction uses this number of the frame's lowest words. Local words that are reserved at present
    /// are then placed above them.
    void need_low(int words);
    /// Returns the number of words of the frame. REQUIRES: the frame is laid out.
    std::int64_t words() const { return size; }
    void order_by_use();

    Level* level;
    int top = 0;
    int low = 0;                 ///< number of lowest words that instructions use
    std::int64_t below = 0;      ///< number of words needed below the lowest word of the frame
    std::int64_t coordinate = 0; ///< position of the frame's workspace pointer, in words from the workspace pointer of
                                 ///< the procedure that contains it
    std::vector<double> uses;    ///< estimated number of uses of each local word
    std::vector<bool> joined;    ///< for each local word: whether it must directly follow the previous local word
    std::vector<int> above_low;  ///< for each local word: number of lowest words that it must not occupy
    std::vector<int> position;   ///< position of each local word
    std::int64_t size = 0;       ///< number of words of the frame
    std::vector<std::vector<Frame*>> parallels; ///< the components of each PAR
    /// Describes a replicated PAR. The workspaces of its components have equal size and are below the frame, that of
    /// the first component at the top.
    struct Replication {
        const Level* level;
        std::int64_t components;
        std::optional<std::int64_t> base; ///< base of the replicator; nothing if the base is not constant
    };
    std::vector<Replication> replications;
    std::vector<const Level*> calls; ///< procedures that are called and start processes, each listed once
    std::string name;  ///< for a component of a PAR: the PROC of which it is an instance, or its place in the source
    std::string place; ///< for a component of a PAR: line and column, such as "12:3"
    std::string entry; ///< for a component of a PAR: name of its code
    bool is_instance = false; ///< the component is an instance of a PROC
    bool is_parallel = false; ///< the component is a PAR itself

    /// Returns how many PARs and calls of the frame start processes.
    std::size_t starters() const { return parallels.size() + replications.size() + calls.size(); }
};

/// Number of words below the workspace pointer of a process that the scheduler uses.
inline constexpr int words_of_scheduler = 3;
/// Number of words below the workspace pointer that the instruction `call` takes.
inline constexpr int words_of_call = 4;
/// Number of words below the workspace pointer that an ALT uses: for its state, its time, and links in the queues of
/// the scheduler and the timer.
inline constexpr int words_of_alternation = 5;

/// Describes the code of a procedure, or of a component of a replicated PAR. The address of its frame is known only at
/// run time. The frames of the components of its other PARs are at fixed distances from this frame.
struct Level {
    explicit Level(Level* o) : outer(o), main(*this) {
        link = {&main, Cell::Area::link, 0};
        vector = {&main, Cell::Area::vector, 0};
    }
    /// Lays out all frames of the level. REQUIRES: its code is complete.
    void lay_out();
    /// Returns the number of words that a call needs below the caller's workspace pointer.
    std::int64_t need() const { return words_of_call + main.words() + main.below; }

    Level* outer;
    Frame main;
    std::deque<Frame> components;
    Cell link, vector, table; ///< words with the addresses of the frame of the enclosing level, of free vector space,
                              ///< and of the table of large constants
    bool uses_link = false, uses_vector = false, uses_table = false;
    int parameters = 0;                           ///< number of words of the parameters
    std::int64_t vector_now = 0, vector_most = 0; ///< vector space in use at present, and its maximum, in bytes
    Label entry = 0, table_label = 0;
    std::vector<std::uint32_t> constants;
};

/// Returns the offset of a cell from the workspace pointer of its level, in words. REQUIRES: the level is laid out.
std::int64_t coordinate_of(const Cell&);

} // namespace placedpar::occam
