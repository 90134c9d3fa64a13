#include "runtime/transputer/decoded_code.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace placedpar::transputer {
namespace {

constexpr unsigned longest_block = 48;                                                             // instructions
constexpr Word longest_reach = (longest_block * (most_prefixes + 1)) / NodeMemory::page_bytes + 1; // pages
constexpr std::uint32_t longest_wait_for_reals = 2 * 90; // half cycles at the beginning of a block
constexpr unsigned most_static_cost = 8000;              // half cycles in one block
constexpr std::size_t most_spare = 16;                   // blocks

std::uint64_t bytes_of(const Block& block) {
    return sizeof(Block) + (block.room + 1) * (sizeof(Entry) + sizeof(std::uint32_t));
}

/// Joins direct functions in pairs.
void join_pairs(std::span<Entry> entries) {
    for (std::size_t i = 0; i + 1 < entries.size(); ++i) {
        const Operation first = entries[i].operation;
        entries[i].operation = pair_of(first, entries[i + 1].operation);
        if (entries[i].operation != first)
            ++i;
    }
}

} // namespace

DecodedCode::DecodedCode(NodeMemory& memory, const CodeTiming& timing)
    : memory_(memory), timing_(timing), pages_(memory.size() / NodeMemory::page_bytes), decoded_(pages_.size()),
      scratch_(longest_block + 1), scratch_bounds_(longest_block) {
    front_.entries = std::make_unique<Entry[]>(longest_block + 1);
}

DecodedCode::Page& DecodedCode::page(Word offset) {
    std::unique_ptr<Page>& result = pages_[offset / NodeMemory::page_bytes];
    if (!result) {
        result = std::make_unique<Page>();
        bytes_used_ += sizeof(Page);
    }
    if (auto& decoded = decoded_[offset / NodeMemory::page_bytes]; !decoded)
        decoded = std::make_unique<std::bitset<NodeMemory::page_bytes>>();
    memory_.note_code(offset / NodeMemory::page_bytes, true);
    return *result;
}

std::span<const std::uint8_t> DecodedCode::bytes_from(Word offset, const Bytes& bytes) {
    return memory_.bytes(offset - bytes.before, bytes.end - (offset - bytes.before));
}

bool DecodedCode::fill(Block& block, Word address, const Bytes& bytes) {
    const Word begin = NodeMemory::offset_of(address);
    Word at = begin;
    const auto fetch = [this](Word word) { return word >= timing_.bytes_on_chip ? timing_.fetch : HalfCycles16{0}; };
    Word fetched = begin & ~Word{3};
    block.start = address;
    block.first_word = fetched;
    block.first_fetch = fetch(fetched);
    std::uint32_t after = 0, extra = block.first_fetch + longest_wait_for_reals;
    std::size_t count = 0;
    bool ended = false;
    while (!ended && count < bytes.most_instructions && after < most_static_cost) {
        const CodedInstruction read = read_instruction(bytes_from(at, bytes), timing_.model);
        if (read.length == 0)
            break;
        const Word next = at + read.length;
        for (; fetched + 4 < next; after += fetch(fetched))
            fetched += 4;
        const Instruction& description = description_of(read.operation);
        after += 2 * (read.length - 1);
        if (description.unit != Unit::scheduler)
            after += 2 * cycles_of(read.operation, timing_.model);
        else
            ++extra; // because the instruction must not begin in the half cycle in which links and events act
        extra += 2u * description.extra_cycles + std::uint32_t{description.accesses} * timing_.penalty;
        Word operand = read.operand;
        if (branches_by_operand(read.operation))
            operand += most_negative + next;
        else if (counts_words(read.operation))
            operand *= 4;
        else if (description.unit != Unit::direct)
            operand = most_negative + next;
        const bool may_break =
            read.operation == Operation::j && read.operand == 0 && (with_breakpoints & only(timing_.model));
        scratch_bounds_[count] = after + extra;
        scratch_[count++] = {may_break ? Operation::j_zero : read.operation, static_cast<std::uint8_t>(read.length),
                             static_cast<std::uint16_t>(after), operand};
        at = next;
        ended = ends_block(read.operation);
    }
    if (count == 0)
        return false;
    join_pairs(std::span(scratch_).first(count));
    scratch_[count] = {Operation::go_on, 0, static_cast<std::uint16_t>(after), most_negative + at};
    block.bytes = at - begin;
    block.last_word = fetched;
    block.most = after + extra;
    block.instructions = static_cast<std::uint32_t>(count);
    return true;
}

Block* DecodedCode::at_wrapped(Word address) {
    const Word offset = NodeMemory::offset_of(address);
    const Word place = memory_.wrapped(offset), end = memory_.end_around(place);
    if (!fill(front_, address, {end, offset - place, 1}))
        return nullptr;
    std::copy_n(scratch_.begin(), 2, front_.entries.get());
    return &front_;
}

Block* DecodedCode::front_of(const Block& block, std::uint64_t half_cycles) {
    if (&block == &front_)
        return &front_;
    const std::uint32_t* const bounds = block.bounds.get();
    const auto fit = std::upper_bound(bounds, bounds + block.instructions, half_cycles) - bounds;
    const std::size_t count = static_cast<std::size_t>(std::max<std::ptrdiff_t>(fit, 1));
    Word bytes = 0;
    for (std::size_t i = 0; i < count; ++i)
        bytes += block.entries[i].length;
    std::copy_n(block.entries.get(), count, front_.entries.get());
    front_.entries[count - 1].operation = first_of(front_.entries[count - 1].operation);
    front_.entries[count] = {Operation::go_on, 0, block.entries[count - 1].after, block.start + bytes};
    front_.start = block.start;
    front_.bytes = bytes;
    front_.first_word = block.first_word;
    front_.first_fetch = block.first_fetch;
    front_.last_word = NodeMemory::offset_of(block.start + bytes - 1) & ~Word{3};
    front_.instructions = static_cast<std::uint32_t>(count);
    return &front_;
}

Block* DecodedCode::decode(Word address) {
    std::unique_ptr<Block> block = spare_block();
    if (NodeMemory::offset_of(address) >= memory_.size() || !fill(*block, address, {memory_.size(), 0, longest_block}))
        return nullptr;
    if (block->room < block->instructions) {
        block->room = (block->instructions + 7) & ~7u;
        block->entries = std::make_unique<Entry[]>(block->room + 1);
        block->bounds = std::make_unique<std::uint32_t[]>(block->room);
    }
    const std::uint64_t bytes = bytes_of(*block);
    if (bytes_used_ + bytes > std::max<std::uint64_t>(memory_.size(), 65'536))
        forget_all();
    bytes_used_ += bytes;
    std::copy_n(scratch_.begin(), block->instructions + 1, block->entries.get());
    std::copy_n(scratch_bounds_.begin(), block->instructions, block->bounds.get());

    const Word begin = NodeMemory::offset_of(address);
    Page& first = page(begin);
    for (Word at = begin | (NodeMemory::page_bytes - 1); at - begin < block->bytes - 1; at += NodeMemory::page_bytes)
        page(at + 1).reached_from_before = true;
    mark_decoded(begin, block->bytes);
    first.blocks[begin % NodeMemory::page_bytes] = block.get();
    return first.starting.emplace_back(std::move(block)).get();
}

std::unique_ptr<Block> DecodedCode::spare_block() {
    if (spare_.empty())
        return std::make_unique<Block>();
    std::unique_ptr<Block> block = std::move(spare_.back());
    spare_.pop_back();
    return block;
}

/// Marks these bytes as decoded. REQUIRES: the pages of the bytes exist.
void DecodedCode::mark_decoded(Word offset, Word bytes) {
    for (Word at = offset; at < offset + bytes; ++at)
        decoded_[at / NodeMemory::page_bytes]->set(at % NodeMemory::page_bytes);
}

void DecodedCode::sweep() {
    while (!forgotten_.empty()) {
        if (spare_.size() < most_spare)
            spare_.push_back(std::move(forgotten_.back()));
        forgotten_.pop_back();
    }
}

/// Forgets all blocks, and frees the pages.
void DecodedCode::forget_all() {
    for (Word index = 0; index < pages_.size(); ++index) {
        std::unique_ptr<Page>& page = pages_[index];
        if (!page)
            continue;
        std::ranges::move(page->starting, std::back_inserter(forgotten_));
        page.reset();
        memory_.note_code(index, false);
    }
    bytes_used_ = 0;
}

/// Forgets the blocks that begin in a page and have bytes in an interval.
void DecodedCode::forget_blocks(Word page, Word offset, Word bytes) {
    if (!pages_[page])
        return;
    std::vector<std::unique_ptr<Block>>& starting = pages_[page]->starting;
    for (std::size_t i = 0; i < starting.size();) {
        const Word begin = NodeMemory::offset_of(starting[i]->start);
        if (begin >= offset + bytes || begin + starting[i]->bytes <= offset) {
            ++i;
            continue;
        }
        pages_[page]->blocks[begin % NodeMemory::page_bytes] = nullptr;
        bytes_used_ -= bytes_of(*starting[i]);
        forgotten_.push_back(std::exchange(starting[i], std::move(starting.back())));
        starting.pop_back();
    }
}

/// Forgets the blocks that have bytes in an interval of one page.
void DecodedCode::forget_in_page(Word index, Word offset, Word bytes) {
    Page* const page = pages_[index].get();
    if (!page)
        return;
    std::bitset<NodeMemory::page_bytes>& decoded = *decoded_[index];
    bool is_decoded = false;
    for (Word at = offset % NodeMemory::page_bytes, left = bytes; left > 0; ++at, --left) {
        is_decoded = is_decoded || decoded[at];
        decoded.reset(at);
    }
    if (!is_decoded)
        return;
    // A block with many prefixes may begin several pages before this page.
    for (Word before = index; page->reached_from_before && before-- > 0 && index - before <= longest_reach;)
        forget_blocks(before, offset, bytes);
    forget_blocks(index, offset, bytes);
    if (page->starting.empty() && (!page->reached_from_before || decoded.none())) {
        page->reached_from_before = false;
        memory_.note_code(index, false);
    }
}

void DecodedCode::forget_decoded(Word offset, Word bytes) {
    constexpr Word size = NodeMemory::page_bytes;
    for (const Word end = offset + bytes; offset < end;) {
        const Word part = std::min(end - offset, size - offset % size);
        forget_in_page(offset / size, offset, part);
        offset += part;
    }
}

} // namespace placedpar::transputer
