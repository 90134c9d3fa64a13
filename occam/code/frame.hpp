#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::occam {

/// The workspace of a procedure is laid out after all code of the procedure has been made. The words that are used most
/// come first. The components of a PAR are below the process that starts them. Until the layout is known, code refers
/// to a word by its Cell.

using Label = std::uint32_t;
struct Level;
struct Frame;

/// Identifies a word of a workspace before the layout is known.
struct Cell {
    enum class Area : std::uint8_t {
        local,     ///< a variable or temporary of the frame
        low,       ///< one of the lowest words, which instructions and calls use
        parameter, ///< a parameter of the frame's procedure
        link,   ///< the hidden parameter with the address of the enclosing procedure's frame, after the return address
        vector, ///< the hidden parameter with the address of free vector space
        base    ///< the word to which the frame's workspace pointer points
    };
    Frame* frame = nullptr;
    Area area = Area::base;
    int index = 0;

    Cell after(int words) const { return {frame, area, index + words}; }
};

/// Describes the workspace of a procedure, or of a component of a PAR.
struct Frame {
    explicit Frame(Level& l) : level(&l) {}

    /// Reserves consecutive local words, until `top` is set back.
    Cell allocate(int words);
    void use(const Cell& cell, double weight);
    /// States that the process needs this number of words below its frame.
    void need_below(std::int64_t words) { below = below < words ? words : below; }
    /// States that an instruction uses this number of the frame's lowest words. No variable that exists now is placed
    /// there.
    void need_low(int words);
    /// Returns the number of words of the frame. REQUIRES: the frame is laid out.
    std::int64_t words() const { return size; }
    void order_by_use();

    Level* level;
    int top = 0;
    int low = 0;            ///< number of lowest words that instructions use
    std::int64_t below = 0; ///< number of words needed below the lowest word of the frame
    std::int64_t coordinate =
        0; ///< position of the frame's workspace pointer, in words from the procedure's workspace pointer
    std::vector<double> uses;   ///< number of uses of each local word
    std::vector<bool> joined;   ///< states that a local word must follow the one before it
    std::vector<int> above_low; ///< for each local word, the number of lowest words in which it must not be placed
    std::vector<int> position;  ///< position of each local word
    std::int64_t size = 0;      ///< number of words of the frame
    std::vector<std::vector<Frame*>> parallels; ///< the components of each PAR
    /// Describes a replicated PAR. Its components have workspaces of equal size below the frame; the first component's
    /// workspace is at the top.
    struct Replication {
        const Level* level;
        std::int64_t components;
        std::optional<std::int64_t> base; ///< base of the replicator; nothing if it is not constant
    };
    std::vector<Replication> replications;
    std::vector<const Level*> calls; ///< called procedures that start processes, each listed once
    std::string name;         ///< name of a component of a PAR: the PROC of which it is an instance, or its place
    std::string place;        ///< line and column of a component, such as "12:3"
    std::string entry;        ///< name of the code of a component of a PAR
    bool is_instance = false; ///< the component is an instance of a PROC
    bool is_parallel = false; ///< the component is a PAR itself

    /// Returns how many constructs of the frame start processes.
    std::size_t starters() const { return parallels.size() + replications.size() + calls.size(); }
};

/// Number of words that the scheduler uses below the workspace pointer of a process.
inline constexpr int words_of_scheduler = 3;
/// Number of words that the instruction `call` takes.
inline constexpr int words_of_call = 4;
/// Number of words that an alternation uses below a workspace: for its state, its time and the queues of scheduler and
/// timer.
inline constexpr int words_of_alternation = 5;

/// Describes a procedure, or a component of a replicated PAR, whose frame has an address that is known only at run
/// time.
struct Level {
    explicit Level(Level* o) : outer(o), main(*this) {
        link = {&main, Cell::Area::link, 0};
        vector = {&main, Cell::Area::vector, 0};
    }
    /// Lays out all frames. REQUIRES: the code of the level is complete.
    void lay_out();
    /// Returns the number of words that a call needs below the caller's workspace pointer.
    std::int64_t need() const { return words_of_call + main.words() + main.below; }

    Level* outer;
    Frame main;
    std::deque<Frame> components;
    Cell link, vector, table; ///< cells with the addresses of the enclosing frame, of vector space, and of the table of
                              ///< large constants
    bool uses_link = false, uses_vector = false, uses_table = false;
    int parameters = 0;                           ///< number of words of the parameters
    std::int64_t vector_now = 0, vector_most = 0; ///< bytes of vector space
    Label entry = 0, table_label = 0;
    std::vector<std::uint32_t> constants;
};

/// Returns the offset of a word from the workspace pointer of its procedure, in words.
std::int64_t coordinate_of(const Cell&);

} // namespace placedpar::occam
