#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::occam {

/// The workspace of a procedure is laid out when all of its code has been made: words that are used most come first,
/// and the components of a PAR lie below the process that started them. Until then code names a word by its Cell.

using Label = std::uint32_t;
struct Level;
struct Frame;

/// A word of a workspace.
struct Cell {
    enum class Area : std::uint8_t {
        local,     ///< a variable or temporary of the frame
        low,       ///< one of the lowest words, which instructions and calls use
        parameter, ///< of the procedure of the frame
        link,      ///< the hidden parameter, after the return address: the frame of the enclosing procedure
        vector,    ///< the hidden parameter: free vector space
        base       ///< where the workspace pointer of the frame points
    };
    Frame* frame = nullptr;
    Area area = Area::base;
    int index = 0;

    Cell after(int words) const { return {frame, area, index + words}; }
};

/// The workspace of a procedure, or of a component of a PAR.
struct Frame {
    explicit Frame(Level& l) : level(&l) {}

    /// Reserve local words that lie together, until `top` is set back.
    Cell allocate(int words);
    void use(const Cell& cell, double weight);
    /// States that the process needs this number of words below its frame.
    void need_below(std::int64_t words) { below = below < words ? words : below; }
    /// States that an instruction uses this number of the frame's lowest words. No variable that exists now is placed
    /// there.
    void need_low(int words);
    /// Returns the words of the frame. REQUIRES: it is laid out.
    std::int64_t words() const { return size; }
    void order_by_use();

    Level* level;
    int top = 0;
    int low = 0;                 ///< lowest words that instructions use
    std::int64_t below = 0;      ///< words below the lowest word of the frame
    std::int64_t coordinate = 0; ///< workspace pointer, in words from the procedure's workspace pointer
    std::vector<double> uses;    ///< number of uses of each local word
    std::vector<bool> joined;    ///< states that a local word must follow the one before it
    std::vector<int> above_low;  ///< for each local word, the number of lowest words in which it must not be placed
    std::vector<int> position;   ///< position of each local word
    std::int64_t size = 0;       ///< words of the frame
    std::vector<std::vector<Frame*>> parallels; ///< the components of each PAR
    /// A replicated PAR, whose components have workspaces of equal size below the frame, the first component's at the
    /// top.
    struct Replication {
        const Level* level;
        std::int64_t components;
        std::optional<std::int64_t> base; ///< nothing if it is not constant
    };
    std::vector<Replication> replications;
    std::vector<const Level*> calls; ///< the procedures that it calls and that start processes, each once
    std::string name;         ///< name of a component of a PAR: the PROC of which it is an instance, or its place
    std::string place;        ///< line and column of a component, such as "12:3"
    std::string entry;        ///< name of the code of a component of a PAR
    bool is_instance = false; ///< the component is an instance of a PROC
    bool is_parallel = false; ///< the component is a PAR itself

    /// Returns how many constructs of the frame start processes.
    std::size_t starters() const { return parallels.size() + replications.size() + calls.size(); }
};

/// The words below the workspace pointer of a process that is started.
inline constexpr int words_of_scheduler = 3;
/// The words that `call` takes.
inline constexpr int words_of_call = 4;
/// Words below a workspace in which an alternation has its state, its time and its place in the queue.
inline constexpr int words_of_alternation = 5;

/// A procedure, or the component of a replicated PAR. The address of its frame is known only at run time.
struct Level {
    explicit Level(Level* o) : outer(o), main(*this) {
        link = {&main, Cell::Area::link, 0};
        vector = {&main, Cell::Area::vector, 0};
    }
    /// Lays out all frames. REQUIRES: the code of the level is complete.
    void lay_out();
    /// Returns the words below the workspace pointer of the caller that a call needs.
    std::int64_t need() const { return words_of_call + main.words() + main.below; }

    Level* outer;
    Frame main;
    std::deque<Frame> components;
    Cell link, vector, table; ///< where the addresses of these are; `table` has the large constants
    bool uses_link = false, uses_vector = false, uses_table = false;
    int parameters = 0;                           ///< words
    std::int64_t vector_now = 0, vector_most = 0; ///< bytes of vector space
    Label entry = 0, table_label = 0;
    std::vector<std::uint32_t> constants;
};

/// Returns the offset of a word from the workspace pointer of its procedure, in words.
std::int64_t coordinate_of(const Cell&);

} // namespace placedpar::occam
