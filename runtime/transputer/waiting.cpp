#include "runtime/transputer/waiting.hpp"

#include "runtime/transputer/words.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <span>
#include <utility>

namespace placedpar::transputer {
namespace {

std::optional<Word> word_of_node(const Core& core, Word address) {
    const Word offset = NodeMemory::offset_of(address) & ~Word{3};
    return core.memory().holds(offset, 4) ? std::optional(core.memory().word(offset)) : std::nullopt;
}

bool is_prefix(std::uint8_t byte) { return byte >> 4 == 0x2 || byte >> 4 == 0x6; }

/// Returns the bytes of the instruction that ends at `end`, with its prefixes.
std::vector<std::uint8_t> bytes_up_to(const NodeMemory& memory, Word end) {
    std::vector<std::uint8_t> bytes;
    while (end > 0 && bytes.size() < most_prefixes && (bytes.empty() || is_prefix(memory.byte(end - 1))))
        bytes.push_back(memory.byte(--end));
    std::ranges::reverse(bytes);
    return bytes;
}

/// The registers A, B and C of a waiting process, as far as its code before the wait shows their values.
class KnownStack {
public:
    void push(std::optional<Word> value) {
        c_ = b_;
        b_ = a_;
        a_ = value;
    }
    /// Replaces A and B by a value that is computed from both.
    template <class Function>
    void combine(const Function& f) {
        a_ = a_ && b_ ? std::optional(f(*b_, *a_)) : std::nullopt;
        b_ = c_;
    }
    template <class Function>
    void change(const Function& f) {
        a_ = a_ ? std::optional<Word>(f(*a_)) : std::nullopt;
    }
    void pop() {
        a_ = b_;
        b_ = c_;
    }
    void pop_second() { b_ = c_; }
    void reverse() { std::swap(a_, b_); }
    const std::optional<Word>& a() const { return a_; }
    const std::optional<Word>& b() const { return b_; }

private:
    std::optional<Word> a_, b_, c_;
};

/// Performs an instruction that only loads or computes an address. Returns false for any other instruction. REQUIRES:
/// an operand that counts words has been multiplied by 4.
bool evaluate(const Core& core, Word workspace, Operation operation, Word operand, KnownStack& stack) {
    const auto load = [&](Word address) { return word_of_node(core, address); };
    switch (operation) {
    case Operation::ldlp: return stack.push(workspace + operand), true;
    case Operation::ldl: return stack.push(load(workspace + operand)), true;
    case Operation::ldc: return stack.push(operand), true;
    case Operation::mint: return stack.push(most_negative), true;
    case Operation::dup: return stack.push(stack.a()), true;
    case Operation::ldnl:
        if (stack.a()) {
            const auto value = load(*stack.a() + operand);
            stack.pop();
            stack.push(value);
        }
        return true;
    case Operation::ldnlp:
    case Operation::adc: return stack.change([&](Word a) { return a + operand; }), true;
    case Operation::bcnt: return stack.change([](Word a) { return 4 * a; }), true;
    case Operation::rev: return stack.reverse(), true;
    case Operation::bsub:
    case Operation::add:
    case Operation::sum: return stack.combine([](Word b, Word a) { return a + b; }), true;
    case Operation::sub:
    case Operation::diff: return stack.combine([](Word b, Word a) { return b - a; }), true;
    case Operation::mul:
    case Operation::prod: return stack.combine([](Word b, Word a) { return b * a; }), true;
    case Operation::wsub: return stack.combine([](Word b, Word a) { return a + 4 * b; }), true;
    case Operation::wsubdb: return stack.combine([](Word b, Word a) { return a + 8 * b; }), true;
    case Operation::csub0:
    case Operation::ccnt1: return stack.pop(), true;
    default: return false;
    }
}

bool begins_alternative(Operation operation) { return operation == Operation::alt || operation == Operation::talt; }
bool enables(Operation operation) { return operation == Operation::enbc || operation == Operation::enbt; }

/// Returns the instructions before `address` that compute the channels of a wait, in the order in which they are
/// executed. Returns none if the wait is an ALT whose beginning is not found.
std::vector<CodedInstruction> code_before(const Core& core, Word address, bool alternates) {
    const std::size_t most_instructions = alternates ? 1000 : 24;
    std::vector<CodedInstruction> code;
    KnownStack ignored;
    while (code.size() < most_instructions) {
        const PlacedInstruction before = instruction_before(core, address);
        const Operation operation = before.instruction.operation;
        if (alternates && begins_alternative(operation))
            break;
        const bool is_known = (alternates && enables(operation)) || evaluate(core, 0, operation, 0, ignored);
        if (before.instruction.length == 0 || !is_known) {
            if (alternates)
                code.clear();
            break;
        }
        code.push_back(before.instruction);
        address = before.address;
    }
    std::ranges::reverse(code);
    return code;
}

/// Returns the channels of an input, an output or an ALT that ends before an address, if the code before the address
/// shows them.
std::optional<std::vector<Word>> channels_before(const Core& core, Word workspace, Word instruction, bool alternates) {
    std::vector<Word> channels;
    KnownStack stack;
    const Word waits = instruction_before(core, instruction).address;
    const std::vector<CodedInstruction> code = code_before(core, waits, alternates);
    for (const CodedInstruction& each : code) {
        if (each.operation == Operation::enbc && !stack.b())
            return std::nullopt;
        if (each.operation == Operation::enbc)
            channels.push_back(*stack.b());
        if (enables(each.operation))
            stack.pop_second();
        else
            evaluate(core, workspace, each.operation, each.operand * (counts_words(each.operation) ? 4 : 1), stack);
    }
    if (code.empty() || (!alternates && !stack.b()))
        return std::nullopt;
    if (!alternates)
        channels.push_back(*stack.b());
    return channels;
}

/// The operations at which a process waits.
constexpr std::array waits{Operation::in,    Operation::out,    Operation::outbyte, Operation::outword,
                           Operation::altwt, Operation::taltwt, Operation::tin};

/// Returns the instruction at which a process waits. Returns `unknown` if its saved Iptr follows no such instruction,
/// or follows data that only looks like one.
Operation waits_at(const Core& core, Word workspace) {
    const auto instruction = word_of_node(core, workspace - below::instruction);
    if (!instruction || !core.has_executed_before(*instruction))
        return Operation::unknown;
    const Operation operation = instruction_before(core, *instruction).instruction.operation;
    return std::ranges::count(waits, operation) > 0 ? operation : Operation::unknown;
}

/// Finds the waiting processes in the memory of an emulated transputer.
class WaitSearch {
public:
    explicit WaitSearch(const Core& core) : core_(core) {
        for (const int priority : {0, 1})
            for (const Word each : ready_processes(core, priority))
                active_.insert(each);
        if (core.is_running())
            active_.insert(core.registers().workspace);
        if (const Word saved = *word_of_node(core, reserved::saved); saved != not_a_process)
            active_.insert(saved & ~Word{3});
    }

    std::vector<WaitingProcess> find() {
        for (const int priority : {0, 1})
            add_timers(priority);
        for (Word channel = 0; channel < hard_channels; ++channel)
            add_at_link(most_negative + 4 * channel, static_cast<int>(channel));
        find_holders();
        for (auto first = holders_.begin(); first != holders_.end();) {
            const auto end = std::find_if(first, holders_.end(),
                                          [&](const Holder& each) { return each.workspace != first->workspace; });
            add_at_channels({&*first, static_cast<std::size_t>(end - first)});
            first = end;
        }
        add_without_guards();
        std::vector<WaitingProcess> result;
        for (auto& [workspace, process] : found_)
            result.push_back(std::move(process));
        return result;
    }

private:
    /// A word of memory that seems to hold a process's descriptor, that is, its workspace and priority.
    struct Holder {
        Word workspace, at;
        bool is_low; ///< the descriptor has low priority
    };

    bool can_wait(Word workspace) const {
        const Word offset = NodeMemory::offset_of(workspace);
        return offset >= below::time && core_.memory().holds(offset, 4) && !active_.contains(workspace);
    }

    WaitingProcess& process(Word workspace, bool is_low, Wait wait) {
        const Word instruction = *word_of_node(core_, workspace - below::instruction);
        return found_.try_emplace(workspace, WaitingProcess{workspace, is_low, instruction, wait, {}, {}})
            .first->second;
    }

    void add_timers(int priority) {
        Word next = *word_of_node(core_, reserved::timer_heads + 4 * static_cast<Word>(priority));
        std::set<Word> seen; // a program may write a circle into its memory
        while (next != not_a_process && can_wait(next) && seen.insert(next).second) {
            const Operation operation = waits_at(core_, next);
            if (operation != Operation::taltwt && operation != Operation::tin)
                return; // the program has overwritten the queue
            process(next, priority == 1, operation == Operation::taltwt ? Wait::alternative : Wait::timer).time =
                word_of_node(core_, next - below::time);
            next = *word_of_node(core_, next - below::timer_link);
        }
    }

    /// Adds the process that waits at a link's channel. The channel shows whether the process inputs or outputs. After
    /// analyse, the channel's word may be left over from an earlier wait.
    void add_at_link(Word channel, int number) {
        const Word descriptor = *word_of_node(core_, channel), workspace = descriptor & ~Word{3};
        if (descriptor == not_a_process || !can_wait(workspace))
            return;
        const Operation operation = waits_at(core_, workspace);
        const bool alternates = operation == Operation::altwt || operation == Operation::taltwt;
        if (operation == Operation::unknown || operation == Operation::tin ||
            waits_elsewhere(descriptor, channel, alternates))
            return;
        const Wait wait = alternates ? Wait::alternative : number < 4 ? Wait::output : Wait::input;
        process(workspace, (descriptor & 1) != 0, wait).channels.push_back(channel);
    }

    /// Returns whether the code of a descriptor's process shows that it waits on other channels, whose words hold the
    /// descriptor.
    bool waits_elsewhere(Word descriptor, Word channel, bool alternates) const {
        const Word workspace = descriptor & ~Word{3};
        const auto channels =
            channels_before(core_, workspace, *word_of_node(core_, workspace - below::instruction), alternates);
        return channels && std::ranges::find(*channels, channel) == channels->end() &&
               std::ranges::any_of(*channels, [&](Word each) { return word_of_node(core_, each) == descriptor; });
    }

    void find_holders() {
        const NodeMemory& memory = core_.memory();
        for (Word offset = traits_of(core_.model()).memory_start; offset < memory.size(); offset += 4) {
            const Word value = memory.word(offset), workspace = value & ~Word{3}, at = most_negative + offset;
            const bool is_own = workspace - at - 1 < below::time; // one of the process's own words, such as the link of
                                                                  // a queue
            if (NodeMemory::offset_of(value) < memory.size() && (value & 2) == 0 && !is_own && can_wait(workspace) &&
                leaves_pointer(workspace))
                holders_.push_back({workspace, at, (value & 1) != 0});
        }
        std::ranges::sort(holders_, {}, [](const Holder& each) { return std::pair(each.workspace, each.at); });
    }

    /// Returns whether the third word below the workspace (W-3) has a value that a process leaves in this word when it
    /// waits at channels in memory.
    bool leaves_pointer(Word workspace) const {
        const Word pointer = *word_of_node(core_, workspace - below::pointer);
        switch (waits_at(core_, workspace)) {
        case Operation::in:
        case Operation::out: return NodeMemory::offset_of(pointer) < core_.memory().size() || pointer == 0;
        case Operation::outbyte:
        case Operation::outword: return pointer == workspace;
        case Operation::altwt:
        case Operation::taltwt: return pointer == alternative::waiting;
        default: return false;
        }
    }

    /// Adds the process whose descriptor these words seem to hold. Some of them may be ordinary pointers.
    void add_at_channels(std::span<const Holder> holders) {
        const Word workspace = holders.front().workspace;
        const Operation operation = waits_at(core_, workspace);
        const bool alternates = operation == Operation::altwt || operation == Operation::taltwt;
        const auto known = found_.find(workspace);
        if (known != found_.end() && known->second.wait != Wait::alternative)
            return; // the process waits for a link or a timer
        const bool is_low =
            known != found_.end() ? known->second.priority == 1 : std::ranges::any_of(holders, &Holder::is_low);
        const auto channels =
            channels_before(core_, workspace, *word_of_node(core_, workspace - below::instruction), alternates);
        for (const Holder& each : holders)
            if (channels ? std::ranges::find(*channels, each.at) != channels->end() : each.is_low == is_low)
                process(workspace, each.is_low, wait_of(operation)).channels.push_back(each.at);
    }

    /// Adds the processes that wait in an ALT without a true guard. No word holds their workspace.
    void add_without_guards() {
        const NodeMemory& memory = core_.memory();
        for (Word offset = traits_of(core_.model()).memory_start; offset < memory.size(); offset += 4) {
            const Word workspace = most_negative + offset + below::state;
            if (memory.word(offset) != alternative::waiting || !can_wait(workspace) || found_.contains(workspace) ||
                word_of_node(core_, workspace) != alternative::none_selected)
                continue;
            const Operation operation = waits_at(core_, workspace);
            if (operation == Operation::altwt || operation == Operation::taltwt)
                process(workspace, true, Wait::alternative);
        }
    }

    static Wait wait_of(Operation operation) {
        switch (operation) {
        case Operation::in: return Wait::input;
        case Operation::altwt:
        case Operation::taltwt: return Wait::alternative;
        default: return Wait::output;
        }
    }

    const Core& core_;
    std::set<Word> active_;
    std::vector<Holder> holders_;
    std::map<Word, WaitingProcess> found_; ///< by workspace
};

} // namespace

std::vector<WaitingProcess> waiting_processes(const Core& core) { return WaitSearch(core).find(); }

std::vector<Word> ready_processes(const Core& core, int priority) {
    std::vector<Word> result;
    for (Word each = core.front(priority); each != not_a_process && result.size() < core.memory().size() / 4;) {
        const auto next = word_of_node(core, each - below::link);
        if (!next)
            break;
        result.push_back(each);
        each = each == core.back(priority) ? not_a_process : *next;
    }
    return result;
}

PlacedInstruction instruction_before(const Core& core, Word address) {
    const Word end = NodeMemory::offset_of(address);
    if (end > core.memory().size())
        return {};
    const std::vector<std::uint8_t> bytes = bytes_up_to(core.memory(), end);
    const CodedInstruction result = read_instruction(bytes, core.model());
    return {address - static_cast<Word>(bytes.size()), result};
}

} // namespace placedpar::transputer
