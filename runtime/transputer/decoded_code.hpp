#pragma once

#include "runtime/transputer/instruction.hpp"
#include "runtime/transputer/memory.hpp"

#include <bitset>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace placedpar::transputer {

/// An instruction of decoded code.
struct Entry {
    Operation operation;
    std::uint8_t length; ///< bytes, with prefixes
    std::uint16_t after; ///< half cycles from the start of the block to the end of this instruction, as far as they are
                         ///< known in advance
    /// The target of a branch, or the operand of another direct function. For an operation, the address of the next
    /// instruction. An operand that counts words is multiplied by 4.
    Word operand;
};

/// Decoded instructions that are executed one after the other. The last entry leads out of the block.
struct Block {
    std::unique_ptr<Entry[]> entries;
    std::uint32_t most = 0;             ///< upper bound for the time of the block, in half cycles
    Word first_word = 0, last_word = 0; ///< offsets of the first and last word of code
    std::uint32_t instructions = 0;
    std::uint16_t first_fetch = 0;           ///< additional half cycles if the first word must be fetched
    Word start = 0;                          ///< address of its first byte
    Word bytes = 0;                          ///< number of bytes of its instructions
    std::unique_ptr<std::uint32_t[]> bounds; ///< for each instruction: upper bound for the half cycles up to its end
    std::uint32_t room = 0;                  ///< number of instructions for which entries and bounds are allocated
};

/// The properties of a transputer that decoding needs.
struct CodeTiming {
    Model model;
    Word bytes_on_chip;
    HalfCycles16 fetch;   ///< half cycles of a word of code that is fetched from outside of the chip
    HalfCycles16 penalty; ///< additional half cycles of an access to data outside of the chip
};

/// The code that an emulated transputer executes, in decoded form, so that each instruction is decoded only once. Code
/// is decoded when it is first executed, and discarded when the program writes to it. Decoded code takes at most about
/// as many bytes of the host's memory as the transputer's memory has. At this limit, all decoded code is discarded.
class DecodedCode {
public:
    DecodedCode(NodeMemory&, const CodeTiming&);

    /// Returns the block that begins at an address; null if the code there is outside of the memory.
    Block* at(Word address) {
        const Word offset = NodeMemory::offset_of(address);
        if (offset < memory_.size())
            if (Page* const page = pages_[offset / NodeMemory::page_bytes].get())
                if (Block* const block = page->blocks[offset % NodeMemory::page_bytes])
                    return block;
        return decode(address);
    }
    /// Returns a block with the first instructions of the given block: all that certainly end within this number of
    /// half cycles, and at least one. The result is valid until the next call.
    Block* front_of(const Block&, std::uint64_t half_cycles);
    /// Discards the blocks with code in an interval of memory, which the program writes. REQUIRES: the memory holds the
    /// interval.
    void forget(Word offset, Word bytes) {
        if (is_decoded(offset, bytes)) // often false, because data often share a page with code
            forget_decoded(offset, bytes);
    }
    /// Returns a block with the instruction at an address beyond the end of the memory, where addresses wrap round.
    /// Returns null if the instruction crosses an end of the memory. The result is valid until the next call of a
    /// function.
    Block* at_wrapped(Word address);
    /// Frees the discarded blocks, or keeps their memory for later use. REQUIRES: none of these blocks is being
    /// executed.
    void sweep();
    bool must_sweep() const { return !forgotten_.empty(); }
    /// Returns whether a byte belongs to instructions that were decoded. If the byte was written to afterwards, the
    /// result is false, except if its page had no decoded block at that time.
    bool was_decoded(Word offset) const {
        const auto& decoded = decoded_[offset / NodeMemory::page_bytes];
        return decoded && (*decoded)[offset % NodeMemory::page_bytes];
    }

private:
    struct Page {
        Block* blocks[NodeMemory::page_bytes] = {};
        std::vector<std::unique_ptr<Block>> starting; ///< the blocks that start in this page
        bool reached_from_before = false;             ///< a block of the page before may end in this page
    };
    Block* decode(Word address);
    /// The interval from which instructions are read, and the distance between their addresses and their offsets.
    struct Bytes {
        Word end, before;
        unsigned most_instructions;
    };
    std::span<const std::uint8_t> bytes_from(Word offset, const Bytes&);
    bool fill(Block&, Word address, const Bytes&);
    Page& page(Word offset);
    bool is_decoded(Word offset, Word bytes) const {
        for (const Word end = offset + bytes; offset < end; ++offset)
            if (was_decoded(offset))
                return true;
        return false;
    }
    void forget_decoded(Word offset, Word bytes);
    std::unique_ptr<Block> spare_block();
    void mark_decoded(Word offset, Word bytes);
    void forget_blocks(Word page, Word offset, Word bytes);
    void forget_in_page(Word page, Word offset, Word bytes);
    void forget_all();

    NodeMemory& memory_;
    CodeTiming timing_;
    std::vector<std::unique_ptr<Page>> pages_;
    /// For each page, the bytes that belong to blocks, and some bytes of discarded blocks; null if the page never had a
    /// block.
    std::vector<std::unique_ptr<std::bitset<NodeMemory::page_bytes>>> decoded_;
    std::vector<std::unique_ptr<Block>> forgotten_;
    std::vector<std::unique_ptr<Block>> spare_; ///< discarded blocks that can be used again
    std::uint64_t bytes_used_ = 0;
    Block front_; ///< the result of front_of()
    std::vector<Entry> scratch_;
    std::vector<std::uint32_t> scratch_bounds_;
};

} // namespace placedpar::transputer
