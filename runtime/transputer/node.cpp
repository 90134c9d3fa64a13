#include "runtime/transputer/node.hpp"

#include "runtime/kernel.hpp"
#include "runtime/transputer/code_lines.hpp"
#include "runtime/transputer/code_text.hpp"
#include "runtime/transputer/process_trace.hpp"
#include "runtime/transputer/words.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

namespace placedpar::transputer {
namespace {

Word word_of(std::span<const std::uint8_t, 4> bytes) {
    Word result;
    std::memcpy(&result, bytes.data(), sizeof result);
    return result;
}

/// Returns the least time in which both directions of a link move a word. Each wire carries the four bytes of its
/// direction, and the acknowledges of the opposite direction.
Time time_of_word(const hardware::LinkTiming& timing) { return 4 * (timing.data() + timing.acknowledge()); }

/// Returns a time that no instruction of the integer unit exceeds, including waits for the floating-point unit and for
/// the memory. Instructions of the scheduler can take longer, but the core can pause before their effect.
Time longest_instruction(const CoreTiming& timing) {
    return duration_of(128 + 8 * std::int64_t{timing.memory_cycles}, timing.clock_hz);
}

} // namespace

Node::Node(Kernel& kernel, std::string name, Model model, std::uint64_t memory_bytes, const CoreTiming& timing)
    : kernel_(kernel), name_(std::move(name)), core_(model, memory_bytes, timing, *this),
      access_(duration_of(timing.memory_cycles, timing.clock_hz)),
      access_half_cycles_(2 * static_cast<HalfCycles>(timing.memory_cycles)),
      longest_instruction_(longest_instruction(timing)) {
    engines_.watcher = this;
    for (int i = 0; i < links; ++i)
        ports_[static_cast<std::size_t>(i)].belong_to(*this, i);
}

Node::~Node() = default;

void Node::has_link(hardware::Link& link) {
    link.from_a_to_b().move_messages_of(engines_);
    link.from_b_to_a().move_messages_of(engines_);
    wires_.push_back(&link);
    least_word_time_ = std::min(least_word_time_, time_of_word(link.timing()));
}

// Running

void Node::happen() noexcept {
    if (std::exchange(is_ahead_, false))
        ahead_by_ = std::min(ahead_by_ + ahead_by_ / 4, longest_ahead_);
    if (activity_ == Activity::listening)
        return listen();
    if (is_halted())
        return;
    if (!start_.empty())
        return begin(std::exchange(start_, {}), 0);
    if (std::exchange(is_idle_, false)) {
        busy_ += core_.local_time() - core_.time_at(0);
        core_.pass_idle_time(kernel_.now());
        words_settled_ = words_moved();
    }
    if (settle())
        run();
}

void Node::run() {
    Core::Pause pause{};
    do {
        tell_core();
        pause = may_run_ahead() ? run_ahead() : run_to_limit();
    } while (pause == Core::Pause::on_time && core_.local_time() == kernel_.now());
    if (pause == Core::Pause::idle)
        return be_idle();
    if (pause == Core::Pause::left && core_.local_time() <= kernel_.now())
        return kernel_.interrupt();
    if (pause == Core::Pause::stopped && core_.local_time() <= kernel_.now()) {
        if (core_.stopped() == Stopped::by_analyse)
            return end_analysis();
        activity_ = Activity::stopped;
        return when_stopped_();
    }
    kernel_.future().schedule(*this, core_.local_time(), EventQueue::turn);
}

Core::Pause Node::run_to_limit() {
    core_.let_go();
    return core_.run(limit(), wires_.empty()            ? Core::Links::rest
                              : core_.waits_for_links() ? Core::Links::may_wake
                                                        : Core::Links::take_accesses);
}

/// Returns the time up to which the core may run: at most `most_ahead` from now on. Between this time and the end of
/// the run, a halt or an analysis there must be room for one instruction. Otherwise the core could execute an
/// instruction beyond that moment, before which a link may still act on the core.
Time Node::horizon(Time most_ahead) const {
    return std::min(later(kernel_.now(), most_ahead),
                    std::min({halts_at_, analysed_at_, kernel_.limit()}) - longest_instruction_);
}

/// Returns whether the core can run ahead of virtual time. If a link then acts on the core, come_back() restores the
/// saved state. While a link moves bytes, the core cannot run ahead. The link's accesses to the memory would delay the
/// core by a time that is not known in advance.
bool Node::may_run_ahead() const {
    return most_ahead_ > Time{0} && !core_.is_watched() && !wires_.empty() &&
           std::ranges::all_of(wires_, &hardware::Link::is_still);
}

/// Saves the core's state, and runs ahead of virtual time as if no link acted on the core.
Core::Pause Node::run_ahead() {
    core_.keep();
    ahead_to_ = std::max(core_.half_cycle_at(horizon(ahead_by_)), core_.local() + 1);
    const Core::Pause pause = core_.run(ahead_to_, Core::Links::rest);
    is_ahead_ = core_.local_time() > kernel_.now();
    return pause;
}

/// If the core has run ahead of virtual time, restores the saved state and runs up to the present time.
void Node::come_back() {
    if (!std::exchange(is_ahead_, false))
        return;
    const HalfCycles now = core_.half_cycle_at(kernel_.now());
    if (now >= std::min(ahead_to_, core_.local()))
        return;
    core_.go_back();
    if (now > core_.local())
        core_.run(now, Core::Links::rest);
    kernel_.future().reschedule(*this, core_.local_time(), EventQueue::turn);
    ahead_by_ = std::max(ahead_by_ / 2, least_ahead_);
}

/// Returns the core's local time up to which nothing else can act on the core.
///
/// While link engines access the memory, the core waits, so its local time advances faster. Therefore it executes at
/// once only about a quarter of the time until the limit. If the memory is too slow even for this, the core executes a
/// single instruction.
HalfCycles Node::limit() const {
    const EventQueue& future = kernel_.future();
    const Time next_event = future.empty() ? Time::max() : future.next_time();
    Time until = horizon(most_ahead_);
    if (core_.may_be_interrupted())
        until = std::min(until, next_event);
    const HalfCycles next = core_.local() + 1, end = std::max(core_.half_cycle_at(until), next);
    if (wires_.empty())
        return end;
    const HalfCycles way = std::min(end, core_.next_attention()) - core_.local();
    if (engines_.parts_under_way == 0 && core_.time_at(core_.local() + way) <= next_event)
        return core_.local() + way;
    const HalfCycles at_once = 2 * wires_.size() * access_half_cycles_;
    const bool may_take_all = times(static_cast<std::int64_t>(8 * wires_.size()), access_) > 3 * least_word_time_;
    return way > at_once + 4 && !may_take_all ? core_.local() + (way - at_once) / 4 : next;
}

/// Advances the core's local time by the accesses of link engines since the last call. Returns false if the local time
/// is now in the future; the node then continues at that time.
bool Node::settle() {
    const std::uint64_t words = words_moved();
    core_.lose_accesses(words - std::exchange(words_settled_, words));
    if (core_.local_time() <= kernel_.now())
        return true;
    kernel_.future().schedule(*this, core_.local_time(), EventQueue::turn);
    return false;
}

std::uint64_t Node::words_moved() {
    std::uint64_t words = engines_.words_of_ended_parts;
    if (engines_.parts_under_way > 0)
        for (hardware::Link* const link : wires_)
            words += link->words_moved(engines_, kernel_.now());
    return words;
}

/// Notes what a link has done, for the next turn of the core. An idle core has its turn at the current time, after all
/// links have acted.
void Node::note(const Wake& wake) {
    if (activity_ != Activity::booted || is_halted())
        return;
    wakes_.push_back(wake);
    if (is_idle_)
        kernel_.future().reschedule(*this, kernel_.now(), EventQueue::turn);
}

/// Tells the core what links have done since its last turn, and lets it attend to its timers, in the order of time.
void Node::tell_core() {
    std::ranges::sort(wakes_, std::less<>{});
    for (const Wake& each : wakes_) {
        core_.attend_if_due(each.at);
        if (each.transfer_ended)
            core_.transfer_ended(each.channel);
        else
            core_.byte_has_come(each.channel, each.at);
    }
    wakes_.clear();
    core_.attend_if_due(Time::max());
}

void Node::be_idle() {
    if (core_.local_time() > kernel_.now()) { // a link may make a process ready before this time
        kernel_.future().schedule(*this, core_.local_time(), EventQueue::turn);
        return;
    }
    is_idle_ = true;
    if (core_.next_timer() != Time::max())
        kernel_.future().schedule(*this, core_.next_timer(), EventQueue::turn);
    else
        when_idle_();
}

Time Node::time_busy() const {
    const Time since = core_.time_at(0);
    return busy_ + std::max(std::min(core_.local_time(), kernel_.now()), since) - since;
}

Time Node::memory_taken_by_links() { return times(static_cast<std::int64_t>(words_moved()), access_); }

std::string Node::name_of_process(Word workspace) const {
    const std::string name = lines_ ? lines_->process(workspace) : "";
    return has_image_ && !name.empty() ? name : name_ + "." + (name.empty() ? print_address(workspace) : name);
}

std::string Node::name_of_channel(Word channel) const {
    if (std::string name = lines_ ? lines_->channel(channel) : ""; !name.empty())
        return name;
    const int number = hard_channel(channel);
    if (number < 0)
        return name_ + "." + print_address(channel);
    if (number == 2 * links)
        return name_ + ".event";
    const Port& port = ports_[static_cast<std::size_t>(number % links)];
    const ByteLane* const lane = number < links ? port.out : port.in;
    return lane ? lane->name() : name_ + ".link[" + std::to_string(number % links) + "]";
}

// Links

void Node::Port::read(std::span<std::uint8_t> to) {
    node_->core_.copy_from_memory(read_from, to);
    read_from += static_cast<Word>(to.size());
}

void Node::Port::write(std::span<const std::uint8_t> bytes) {
    if (node_->activity_ == Activity::listening)
        return node_->hear(bytes);
    node_->core_.copy_to_memory(write_to, bytes);
    write_to += static_cast<Word>(bytes.size());
}

void Node::begin_transfer(int channel, Word address, Word bytes) {
    if (channel >= 2 * links)
        return; // the event channel: nothing is connected to its pin
    Port& port = ports_[static_cast<std::size_t>(channel % links)];
    if (channel < links && port.out && !port.out->is_giving()) {
        port.read_from = NodeMemory::offset_of(address);
        port.out->give(bytes);
    } else if (channel >= links && port.in && !port.in->is_taking()) {
        port.write_to = NodeMemory::offset_of(address);
        port.in->take(bytes);
    }
}

bool Node::byte_waits(int channel) {
    const Port& port = ports_[static_cast<std::size_t>(channel % links)];
    return port.in && port.in->has_byte();
}

void Node::reset(int channel) {
    const Port& port = ports_[static_cast<std::size_t>(channel % links)];
    if (channel < links && port.out)
        port.out->reset_giving();
    else if (channel >= links && channel < 2 * links && port.in)
        port.in->reset_taking();
}

void Node::transfer_ended(int channel) {
    if (activity_ == Activity::listening)
        obey_next();
    else
        note({kernel_.now(), channel, true});
}

void Node::taken(int link) {
    if (activity_ == Activity::listening)
        obey(link);
    else
        transfer_ended(links + link);
}

void Node::byte_has_come(int link) {
    if (activity_ == Activity::listening)
        kernel_.future().reschedule(*this, kernel_.now(), EventQueue::turn);
    else
        note({kernel_.now(), links + link, false});
}

// Reset and boot

/// Reads a command from the first link at which a byte waits, unless another command is being obeyed.
void Node::listen() {
    for (int link = 0; link < links && !heard_link_ && !is_halted(); ++link)
        if (byte_waits(links + link)) {
            heard_link_ = link;
            heard_.clear();
            listening_ = Listening::for_command;
            ports_[static_cast<std::size_t>(link)].in->take(1);
        }
}

/// Ends a command. The node listens again after all other events of this time.
void Node::obey_next() {
    heard_link_.reset();
    kernel_.future().reschedule(*this, kernel_.now(), EventQueue::turn);
}

void Node::hear(std::span<const std::uint8_t> bytes) { heard_.insert(heard_.end(), bytes.begin(), bytes.end()); }

/// Returns the offset of a word. Addresses outside of the memory wrap, as on most boards.
Word Node::wrapped(Word address) const { return NodeMemory::offset_of(address) % core_.memory().size() & ~Word{3}; }

/// Acts on the bytes that the link has read: a command, or the bytes that follow a command.
void Node::obey(int link) {
    if (is_halted())
        return;
    Port& port = ports_[static_cast<std::size_t>(link)];
    const std::vector<std::uint8_t> heard = std::exchange(heard_, {});
    switch (listening_) {
    case Listening::for_command: {
        const std::uint8_t command = heard.front();
        listening_ = command == 0 ? Listening::for_poke : command == 1 ? Listening::for_peek : Listening::for_code;
        port.in->take(command == 0 ? 8u : command == 1 ? 4u : command);
        return;
    }
    case Listening::for_poke:
        core_.copy_to_memory(wrapped(word_of(std::span(heard).subspan<0, 4>())), std::span(heard).subspan<4, 4>());
        return obey_next();
    case Listening::for_peek:
        listening_ = Listening::answering;
        port.read_from = wrapped(word_of(std::span(heard).subspan<0, 4>()));
        port.out->give(4);
        return;
    case Listening::for_code: heard_link_.reset(); return begin(heard, link);
    case Listening::answering: return;
    }
}

/// Stores the code in the memory, and executes it as after a boot from this link.
void Node::begin(std::span<const std::uint8_t> code, int link) {
    activity_ = Activity::booted;
    core_.copy_to_memory(traits_of(core_.model()).memory_start, code);
    if (kernel_.trace() && !process_trace_) {
        process_trace_ = std::make_unique<ProcessTrace>(
            kernel_, core_, name_, [this](Word workspace) { return name_of_process(workspace); },
            [this](Word channel) { return name_of_channel(channel); });
        core_.watch_processes(process_trace_.get());
    }
    core_.boot(static_cast<Word>(code.size()), links + link);
    kernel_.future().reschedule(*this, kernel_.now(), EventQueue::turn);
}

void Node::start(const Image& image) {
    core_.copy_to_memory(image.offset, image.code);
    activity_ = Activity::booted;
    has_image_ = true;
    start_ = image.start;
    kernel_.future().reschedule(*this, kernel_.now(), EventQueue::turn);
}

/// Returns whether the image's program has stopped at its end. A process that stops leaves the address of its next
/// instruction below its workspace.
bool Node::has_ended(const Image& image) const {
    return core_.memory().word(image.workspace - 4) == most_negative + image.end;
}

// Halt and analyse

Node::Activity Node::activity() const { return is_halted() ? Activity::halted : activity_; }

bool Node::is_halted() const { return kernel_.now() >= halts_at_; }

void Node::analyse_at(Time moment) {
    analysed_at_ = moment;
    kernel_.future().reschedule(analysis_, moment, EventQueue::timer);
}

void Node::begin_analysis() {
    analysed_at_ = Time::max();
    if (is_halted() || activity_ == Activity::listening)
        return;
    core_.stop_for_analyse();
    if (activity_ == Activity::stopped)
        end_analysis();
    else if (activity_ == Activity::booted && is_idle_)
        kernel_.future().reschedule(*this, kernel_.now(), EventQueue::turn);
}

/// Resets the links, and listens to them.
void Node::end_analysis() {
    core_.reset_after_analyse();
    for (int channel = 0; channel < 2 * links; ++channel)
        reset(channel);
    wakes_.clear();
    activity_ = Activity::listening;
    is_idle_ = true;
}

} // namespace placedpar::transputer
