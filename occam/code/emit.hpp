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

/// Describes one element of code, such as an instruction or a label, before addresses and operands are known. Cell and
/// Frame (occam/code/frame.hpp) describe words of a workspace before its layout is known.
struct CodeElement {
    enum class Kind : std::uint8_t {
        number, ///< instruction with the operand `value`
        cell, ///< instruction; its operand is `value` plus the number of words from the workspace pointer of `frame` to
              ///< `cell`
        remote,     ///< instruction; its operand is `value` plus the number of words from the workspace pointer of the
                    ///< cell's procedure to `cell`
        words,      ///< instruction; its operand is `value` times the number of words of the frame
        branch,     ///< instruction; its operand is the distance in bytes to the label `to`
        difference, ///< instruction; its operand is the number of bytes from label `from` to label `to`, plus `value`
        mark,       ///< position of the label `to`; no instruction
        align,      ///< padding to the next whole word
        data,       ///< `value` bytes
        line,       ///< note: the code for `place` in the source begins here
        error, ///< note: the preceding instruction can set the error flag; number `value` in the list of errors says
               ///< what this means
        name   ///< note: the code with number `value` in the list of names begins here
    };
    Kind kind = Kind::number;
    std::uint8_t least = 1; ///< least number of bytes of the instruction, which may need prefixes
    std::uint8_t function =
        0; ///< function code of a direct instruction; 15 (opr) for an operation, whose code is the operand
    std::int64_t value = 0;
    Cell cell = {};
    const Frame* frame = nullptr;
    Label to = 0, from = 0;
    Place place = {};
};

using CodeBuffer = std::vector<CodeElement>;

/// The label of the first word after code and constants.
inline constexpr Label end_of_code = 0;

/// Collects the code that Generator makes in buffers, and converts it to bytes when all of it is known.
class Emitter {
public:
    using Operation = transputer::Operation;

    Label new_label() { return labels_++; }
    CodeBuffer& buffer() { return *buffer_; }
    /// Makes later calls append to another buffer. Returns the previous buffer.
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
    /// States what it means if the preceding instruction sets the error flag. The text has the form that
    /// transputer::print_error() reads. In it, {w} stands for the value of the next of these cells, {l} for the INT64
    /// there, and {/l} for the kind of an error of a division by this INT64. `moved`: number of words by which the
    /// workspace pointer of `current` is moved down. REQUIRES: the cells belong to the same procedure as `current`.
    void error(std::string text, std::vector<Cell> cells, const Frame& current, int moved = 0);
    /// Stores constant bytes after the code, and returns their label.
    Label constant(std::span<const std::uint8_t> bytes, bool aligned);

    /// Returns the code of all buffers, in this order, followed by the constants.
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

/// Returns whether an instruction can set the error flag, depending on its operands.
bool may_set_error(transputer::Operation);
/// Returns how many words an instruction adds to the register stack; negative if the instruction removes words.
int stack_effect(transputer::Operation);

} // namespace placedpar::occam
