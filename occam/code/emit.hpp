#pragma once

#include "occam/code/code.hpp"
#include "occam/code/frame.hpp"
#include "runtime/transputer/instruction.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace placedpar::occam {

/// Describes one element of code whose address is not known yet.
struct CodeElement {
    enum class Kind : std::uint8_t {
        number,     ///< an instruction with the operand `value`
        cell,       ///< operand: `value` plus the words from the workspace pointer of `frame` to `cell`
        remote,     ///< operand: `value` plus the words from the start of the procedure's frame to `cell`
        words,      ///< operand: `value` times the words of the frame
        branch,     ///< operand: the distance to `to`
        difference, ///< operand: bytes from `from` to `to`, plus `value`
        mark,       ///< the place of the label `to`
        align,      ///< padding up to the next whole word
        data,       ///< `value` bytes
        line,       ///< the code for a place in the source begins
        error,      ///< the preceding instruction can fail, with the error number `value`
        name        ///< the code with the name number `value` begins
    };
    Kind kind = Kind::number;
    std::uint8_t least = 1;    ///< smallest number of bytes of the instruction
    std::uint8_t function = 0; ///< a direct function; 15 (opr) for an operation, whose code is the operand
    std::int64_t value = 0;
    Cell cell = {};
    const Frame* frame = nullptr;
    Label to = 0, from = 0;
    Place place = {};
};

using CodeBuffer = std::vector<CodeElement>;

/// This label is at the first word after code and constants.
inline constexpr Label end_of_code = 0;

/// Collects code in buffers, and converts it to bytes.
class Emitter {
public:
    using Operation = transputer::Operation;

    Label new_label() { return labels_++; }
    CodeBuffer& buffer() { return *buffer_; }
    /// Directs code to another buffer. Returns the previous buffer.
    CodeBuffer* redirect(CodeBuffer* buffer) { return std::exchange(buffer_, buffer); }

    void put(Operation, std::int64_t operand = 0);
    void put(Operation, const Cell&, const Frame& current, int words = 0);
    void put_remote(Operation, const Cell&, int words = 0);
    void put_words(Operation, const Frame&, int factor);
    void branch(Operation, Label, std::uint8_t least_bytes = 1);
    /// Loads the distance from label `from` to label `to`, plus `more`, in bytes.
    void difference(Label to, Label from, std::int64_t more = 0);
    /// Loads the address of a label.
    void address(Label);
    void mark(Label);
    /// Begins the code for a place in the source.
    void line(const Place&);
    const Place& place() const { return place_; }
    void name(std::string);
    /// States the meaning of an error of the preceding instruction, in the form that transputer::print_error() reads.
    /// In the text, {w} stands for the word in the next of these cells, {l} for the INT64, and {/l} for the kind of an
    /// error of a division by the INT64. `moved`: the words by which the workspace of `current` is moved down.
    /// REQUIRES: the cells belong to the level of `current`.
    void error(std::string text, std::vector<Cell> cells, const Frame& current, int moved = 0);
    /// Returns the label of constant bytes, which are stored after the code.
    Label constant(std::span<const std::uint8_t> bytes, bool aligned);

    /// Returns the code of all buffers, in this order, and the constants.
    Code finish(const std::vector<const CodeBuffer*>&, Label entry);

private:
    struct ConstantBytes {
        std::vector<std::uint8_t> bytes;
        bool aligned;
        Label label;
    };
    CodeBuffer* buffer_ = nullptr;
    Label labels_ = 1;
    Place place_ = {};
    struct ErrorMeaning {
        std::string text;
        std::vector<Cell> cells;
        const Frame* frame;
        int moved;
        std::string with_offsets() const;
    };
    std::vector<std::string> names_;
    std::vector<ErrorMeaning> errors_;
    std::vector<ConstantBytes> constants_;
    std::unordered_map<std::string, std::size_t> constant_of_; ///< for look-up only; never iterated
};

/// Returns whether an instruction may set the flag Error, depending on computed values.
bool may_set_error(transputer::Operation);
/// Returns how many words an instruction adds to the register stack; the number is negative if it removes words.
int stack_effect(transputer::Operation);

} // namespace placedpar::occam
