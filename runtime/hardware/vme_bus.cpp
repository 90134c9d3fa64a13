#include "runtime/hardware/vme_bus.hpp"

#include "runtime/kernel.hpp"
#include "runtime/trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <utility>

namespace placedpar::hardware {

namespace {

constexpr int levels = 4, slots = 21;

void require_place(const VmeBus& bus, const std::string& name, const VmePlace& place) {
    if (place.level < 0 || place.level >= levels || place.slot < 1 || place.slot > slots)
        throw std::logic_error(fmt::format(
            "bus {}: a master has a level from 0 to {} and a slot from 1 to {}; {} has level {} and slot {}",
            bus.name(), levels - 1, slots, name, place.level, place.slot));
    if (bus.arbitration() == Arbitration::single_level && place.level != levels - 1)
        throw std::logic_error(
            fmt::format("bus {}: on a bus with a single level every master must have BR3; {} has BR{}", bus.name(),
                        name, place.level));
}

} // namespace

VmeBus::VmeBus(Kernel& kernel, std::string name, Arbitration arbitration, const VmeTiming& timing)
    : kernel_(kernel), name_(std::move(name)), arbitration_(arbitration), timing_(timing),
      first_rank_(kernel.new_ranks(2)) {
    if (timing.word <= Time{0} || timing.byte <= Time{0} || timing.time_out <= Time{0} || timing.arbitration < Time{0})
        throw std::logic_error("bus " + name_ +
                               ": the times of a word, a byte and the time-out must be positive, and the time of "
                               "arbitration must not be negative");
}

void VmeBus::attach(VmeMaster& master) {
    for (const VmeMaster* other : masters_)
        if (other->place().slot == master.place().slot)
            throw std::logic_error(fmt::format("bus {}: {} and {} are both masters in slot {}", name_, other->name(),
                                               master.name(), master.place().slot));
    masters_.push_back(&master);
}

Time VmeBus::time_busy() const { return end_block_.scheduled() ? busy_ + (kernel_.now() - block_began_) : busy_; }

void VmeBus::asked_by(VmeMaster& master) {
    if (!holder_)
        return arbitrate_later();
    if (holder_ == &master || !must_yield())
        return;
    if (!end_block_.scheduled())
        return give_up();
    kernel_.future().cancel(end_block_);
    end_block_after(std::min(words_moved() + 1, holder_->blocks_.front()->words));
}

/// Returns how many words of the current block have been moved.
std::uint64_t VmeBus::words_moved() const {
    return static_cast<std::uint64_t>((kernel_.now() - block_began_) / holder_->blocks_.front()->each);
}

void VmeBus::end_block_after(std::uint64_t words) {
    Time all = times(static_cast<std::int64_t>(words), holder_->blocks_.front()->each);
    kernel_.future().schedule(end_block_, later(block_began_, all), EventQueue::arrival, first_rank_);
}

/// Returns whether the holder gives up the bus after the current word.
bool VmeBus::must_yield() const {
    return std::ranges::any_of(masters_, [&](const VmeMaster* other) {
        if (other == holder_ || !other->asks_)
            return false;
        return holder_->place().release == Release::on_request ||
               (arbitration_ == Arbitration::priority && other->place().level > holder_->place().level);
    });
}

void VmeBus::arbitrate_later() {
    if (!arbitrate_.scheduled())
        kernel_.future().schedule(arbitrate_, later(kernel_.now(), timing_.arbitration), EventQueue::arrival,
                                  first_rank_ + 1);
}

void VmeBus::arbitrate() {
    if (VmeMaster* master = next())
        grant(*master);
}

VmeMaster* VmeBus::next() const {
    VmeMaster* best = nullptr;
    for (VmeMaster* master : masters_)
        if (master->asks_ && (!best || is_nearer(*master, *best)))
            best = master;
    return best;
}

bool VmeBus::is_nearer(const VmeMaster& master, const VmeMaster& than) const {
    return std::pair(turn_of(master), master.place().slot) < std::pair(turn_of(than), than.place().slot);
}

/// Returns the position of the master's request level in the arbitration; the level at position 0 gets the bus first.
int VmeBus::turn_of(const VmeMaster& master) const {
    int first = arbitration_ == Arbitration::round_robin ? last_level_ - 1 : levels - 1;
    return (first - master.place().level + levels) % levels;
}

void VmeBus::grant(VmeMaster& master) {
    holder_ = &master;
    last_level_ = master.place().level;
    master.granted();
    move_block();
}

/// Moves the first block of words of the master that has the bus, or only one word if this master must yield to
/// another.
void VmeBus::move_block() {
    VmeMaster::Block& block = *holder_->blocks_.front();
    block_began_ = kernel_.now();
    if (block.until > block_began_)
        block.each = block.until - block_began_;
    end_block_after(must_yield() ? 1 : block.words);
    if (TraceSink* trace = kernel_.trace())
        trace->takes({name_, holder_->name(), block_began_}, block_began_);
}

void VmeBus::end_block() {
    VmeMaster::Block& block = *holder_->blocks_.front();
    block.words -= words_moved();
    busy_ += kernel_.now() - block_began_;
    if (TraceSink* trace = kernel_.trace())
        trace->leaves({name_, kernel_.now(), 0, &block.process, block_began_}, kernel_.now());
    bool whole = block.words == 0;
    if (whole) {
        block.done = true;
        holder_->blocks_.pop_front();
        kernel_.enqueue(block.process);
    }
    if (must_yield() || (whole && holder_->place().release == Release::when_done))
        give_up();
    else if (!holder_->blocks_.empty())
        move_block();
}

void VmeBus::give_up() {
    VmeMaster& holder = *std::exchange(holder_, nullptr);
    if (!holder.blocks_.empty())
        holder.ask();
    if (next())
        arbitrate_later();
}

VmeMaster::VmeMaster(Kernel& kernel, std::string name, VmeBus& bus, const VmePlace& place, const BusProgram& program)
    : kernel_(kernel), name_(std::move(name)), bus_(bus), place_(place), program_(program),
      waiting_track_(bus.name() + " <- " + name_) {
    require_place(bus, name_, place);
    bus.attach(*this);
}

bool BusSlave::answer(Time now) {
    bool there = true;
    for (Absence& each : absences_)
        if (now >= each.from && now < each.until) {
            ++each.unanswered;
            there = false;
        }
    return there;
}

void VmeMaster::move_words(BusSlave& slave, std::uint64_t words) {
    require_answer(slave);
    move(words, bus_.timing().word);
    words_moved_ += words;
}

void VmeMaster::access_byte(BusSlave& slave) {
    require_answer(slave);
    move(1, bus_.timing().byte);
    ++bytes_accessed_;
}

void VmeMaster::hold(Time how_long) { move(1, how_long); }

void VmeMaster::hold_until(Time end) { move(1, Time{1}, end); }

void VmeMaster::require_answer(BusSlave& slave) {
    if (slave.answer(kernel_.now()))
        return;
    move(1, bus_.timing().time_out);
    ++bus_errors_;
    throw BusError(fmt::format("bus error: {} does not answer {} on bus {} within {}", slave.bus_name(), name_,
                               bus_.name(), to_string(bus_.timing().time_out)));
}

void VmeMaster::move(std::uint64_t words, Time each, Time until) {
    Process& self = kernel_.running();
    kernel_.begin_operation(self);
    Block block{self, words, each, until};
    blocks_.push_back(&block);
    if (bus_.holder_ != this && !asks_)
        ask();
    else if (bus_.holder_ == this && blocks_.size() == 1)
        bus_.move_block();
    TraceSink* trace = self.executive() ? kernel_.trace() : nullptr;
    if (trace)
        trace->turns(self, Activity::moving, kernel_.now());
    while (!block.done)
        kernel_.give_way();
    if (trace)
        trace->turns(self, Activity::ready, kernel_.now());
}

void VmeMaster::ask() {
    asks_ = true;
    asked_at_ = kernel_.now();
    if (TraceSink* trace = kernel_.trace())
        trace->takes({waiting_track_, fmt::format("waits at BR{}", place_.level), asked_at_}, asked_at_);
    bus_.asked_by(*this);
}

void VmeMaster::granted() {
    Time waited = kernel_.now() - asked_at_;
    asks_ = false;
    ++grants_;
    waited_ += waited;
    longest_wait_ = std::max(longest_wait_, waited);
    if (TraceSink* trace = kernel_.trace())
        trace->leaves({waiting_track_, kernel_.now()}, kernel_.now());
}

} // namespace placedpar::hardware
