#include "runtime/transputer/waiting.hpp"
#include "runtime/transputer/words.hpp"

#include <algorithm>
#include <utility>

namespace placedpar::transputer {
namespace {

constexpr int most_steps_ahead = 5000;
constexpr std::size_t most_ends_ahead = 64;

struct NoLinks final : LinkEngines {
    void begin_transfer(int, Word, Word) override {}
    bool byte_waits(int) override { return false; }
    void reset(int) override {}
};

/// Executes the code of one process on a copy of its transputer, to find out on which channels it communicates next.
/// Waits end at once, and no other process runs.
class LookAhead {
public:
    LookAhead(const Core& core, const WaitingProcess& process)
        : core_(core.model(), core.memory().size(), CoreTiming{}, links_) {
        const NodeMemory& memory = core.memory();
        std::copy_n(memory.data(), memory.size(), core_.memory().data());
        core_.set_registers({.instruction = process.instruction, .workspace = process.workspace}, process.priority);
    }

    std::vector<ChannelEnd> ends() {
        for (int step = 0; step < most_steps_ahead && ends_.size() < most_ends_ahead && goes_on(); ++step) {
        }
        return std::move(ends_);
    }

private:
    /// Executes an instruction. Returns whether the process continues.
    bool goes_on() {
        const Registers& r = core_.registers();
        const Word offset = NodeMemory::offset_of(r.instruction), size = core_.memory().size();
        if (offset >= size)
            return false;
        const CodedInstruction next = read_instruction(core_.memory().bytes(offset, size - offset), core_.model());
        if (next.operation == Operation::unknown || description_of(next.operation).unit != Unit::scheduler) {
            core_.run(core_.local() + 1);
            return core_.stopped() == Stopped::nothing && core_.is_running();
        }
        Registers after = r;
        after.instruction += next.length;
        const bool result = pass(next.operation, after);
        core_.set_registers(after, core_.high_priority() ? 0 : 1);
        return result;
    }

    /// Performs an instruction of the scheduler without its wait, as far as it affects the process that executes it.
    bool pass(Operation operation, Registers& r) {
        switch (operation) {
        case Operation::in: return note(r.b, false);
        case Operation::out:
        case Operation::outbyte:
        case Operation::outword: return note(r.b, true);
        case Operation::enbc:
            if (r.a != 0)
                note(r.b, false);
            return r.b = r.c, true;
        case Operation::enbt: return r.b = r.c, true;
        case Operation::altwt:
        case Operation::taltwt: return store_word(r.workspace, alternative::none_selected);
        case Operation::disc: return select_guard(r);
        case Operation::dist: return r.a = 0, r.b = r.c, true;
        case Operation::ldtimer: return r.c = r.b, r.b = r.a, r.a = 0, true;
        case Operation::startp: return r.a = r.b = r.c, true;
        case Operation::runp:
        case Operation::tin:
        case Operation::sttimer: return r.a = r.b, r.b = r.c, true;
        case Operation::resetch:
        case Operation::stoperr:
        case Operation::move:
        case Operation::move2dall:
        case Operation::move2dnonzero:
        case Operation::move2dzero: return true;
        default: return false; // the process ends, or the instruction is for operating systems
        }
    }

    bool note(Word channel, bool is_output) {
        const ChannelEnd end{channel, is_output};
        if (std::ranges::find(ends_, end) == ends_.end())
            ends_.push_back(end);
        return true;
    }

    bool store_word(Word address, Word value) {
        const Word offset = NodeMemory::offset_of(address) & ~Word{3};
        if (!core_.memory().holds(offset, 4))
            return false;
        core_.memory().set_word(offset, value);
        return true;
    }

    /// Selects the guard of a `disc` if it is the first guard with a true condition.
    bool select_guard(Registers& r) {
        const Word offset = NodeMemory::offset_of(r.workspace) & ~Word{3};
        if (!core_.memory().holds(offset, 4))
            return false;
        const bool selected = r.b != 0 && core_.memory().word(offset) == alternative::none_selected;
        if (selected)
            core_.memory().set_word(offset, r.a);
        r.a = selected;
        return true;
    }

    NoLinks links_;
    Core core_;
    std::vector<ChannelEnd> ends_;
};

} // namespace

std::vector<ChannelEnd> ends_ahead(const Core& core, const WaitingProcess& process) {
    return LookAhead(core, process).ends();
}

} // namespace placedpar::transputer
