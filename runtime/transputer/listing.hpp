#pragma once

#include "runtime/transputer/code_lines.hpp"
#include "runtime/transputer/core.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace placedpar::transputer {

/// Counts how often an emulated transputer began each instruction, and the time of the instructions that have ended. If
/// an instruction is overwritten, the old and the new instruction are counted separately.
class Listing final : public Core::Watcher {
public:
    /// An instruction that was executed.
    struct Line {
        Word address = 0;
        CodedInstruction instruction;
        std::vector<std::uint8_t> bytes;
        std::uint64_t times = 0;
        HalfCycles spent = 0;
        bool is_replaced = false; ///< other code has replaced the instruction
    };

    /// Begins to count. REQUIRES: neither object is moved during the run.
    explicit Listing(Core&);
    Listing(const Listing&) = delete;
    Listing& operator=(const Listing&) = delete;

    /// Returns the instructions that were executed, by address. Instructions that were replaced by other code come
    /// last.
    std::vector<Line> lines() const;
    Model model() const { return core_.model(); }

private:
    struct Count {
        std::string bytes; // short strings need no further memory
        std::uint64_t times = 0;
        HalfCycles spent = 0;
    };
    /// The versions of code that were executed at an address, in order of time.
    struct Place {
        Count now;
        std::vector<Count> before;
    };
    using Page = std::array<Place, NodeMemory::page_bytes>;

    void begins(Word at) override;
    void executed(Word at, HalfCycles spent) override;
    Place& place(Word offset);
    bool is_in_memory(const std::string& bytes, Word offset) const;
    void code_has_changed(Place&, Word offset);

    Core& core_;
    std::vector<std::unique_ptr<Page>> pages_;
};

/// Returns two tables. The first shows the blocks of instructions with the most cycles. The second shows all code that
/// ran, by address: bytes, instruction, times, cycles and share of all cycles, with a sum for each block. Names of
/// procedures and places in files come from `lines`, as far as it has them.
std::string print_listing(const Listing&, const CodeLines& lines);

} // namespace placedpar::transputer
