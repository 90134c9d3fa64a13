// Processes, channels, alternations, timers.

#include "plain_transputer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace placedpar::test {

namespace plain_processes {

using P = PlainTransputer;
using Word = P::Word;

constexpr unsigned all = t414 | t425 | t400 | t800 | t805, debugged = t425 | t400 | t805;
constexpr auto at_end = When::at_end, at_end_or_later = When::at_end_unless_interrupted;

void count_loop(P& p) {
    const Word count = p.load(p.b + 4) - 1;
    p.store(p.b + 4, count);
    if (count != 0) {
        p.store(p.b, p.load(p.b) + 1);
        p.iptr -= p.a;
        p.cycles += 5;
    }
    p.may_slice = true;
    p.undefined = 7;
}

void start_process(P& p) {
    p.store(P::workspace(p.a) - P::iptr_word, p.iptr + p.b);
    p.enqueue(P::workspace(p.a) | p.priority);
    p.pop_all(2);
}

void end_process(P& p) {
    const Word place = p.a, count = p.load(place + 4);
    p.store(place + 4, count - 1);
    p.undefined = 7;
    if (count != 1) {
        p.leaving = true;
        return;
    }
    p.wptr = P::workspace(place);
    p.iptr = p.load(place);
}

void stop_on_error(P& p) {
    if (p.error[p.priority])
        p.leave();
}

/// Returns whether a process other than this one waits at a channel.
bool somebody_else_at(P& p, Word channel) {
    const Word other = p.load(channel);
    return other != P::not_process && other != p.descriptor();
}

void pay_for_message(P& p) {
    if (p.comes_second(p.b, true))
        p.pay_for_copy(p.c, p.told_by(p.load(p.b)), p.a);
}

void pay_for_value(P& p) { p.cycles += p.comes_second(p.b, true) ? 2 : 0; }

void enable_skip(P& p) {
    if (p.a)
        p.store_local(-3, P::ready);
}

void output_value(P& p, Word bytes) {
    p.store_local(0, p.a);
    p.transfer(true, p.b, p.wptr, bytes);
}

void reset_channel(P& p) {
    const Word channel = p.a;
    p.refuse_link(channel);
    p.a = p.load(channel);
    p.store(channel, P::not_process);
}

void enable_channel(P& p) {
    const Word channel = p.b;
    const bool guard = p.a;
    p.b = p.c;
    p.undefined = (p.undefined & 5) | (p.undefined >> 1 & 2);
    if (!guard)
        return;
    p.refuse_link(channel);
    if (somebody_else_at(p, channel))
        p.store_local(-3, P::ready);
    else
        p.store(channel, p.descriptor());
}

void enable_timer(P& p) {
    const Word time = p.b;
    const bool guard = p.a;
    p.b = p.c;
    p.undefined = (p.undefined & 5) | (p.undefined >> 1 & 2);
    if (!guard)
        return;
    if (p.local(-4) == P::time_not_set) {
        p.store_local(-4, P::time_set);
        p.store_local(-5, time);
    } else if (P::after(p.local(-5), time)) {
        p.store_local(-5, time);
    }
}

bool time_has_come(P& p) {
    return p.local(-3) == P::ready || (p.local(-4) == P::time_set && !P::after(p.local(-5), p.clock(p.priority)));
}

void wait_for_channel(P& p) {
    p.store_local(0, P::none_selected);
    if (p.local(-3) == P::ready)
        return;
    p.store_local(-3, P::waiting);
    p.leave();
}

void wait_for_channel_or_time(P& p) {
    p.store_local(0, P::none_selected);
    if (time_has_come(p)) {
        p.store_local(-3, P::ready);
        p.store_local(-5, p.clock(p.priority));
        return;
    }
    p.store_local(-3, P::waiting);
    if (p.local(-4) == P::time_set)
        p.insert_timer(p.local(-5));
    p.leave();
}

void disable_channel(P& p) {
    const Word channel = p.c;
    p.refuse_link(channel);
    const bool is_ready = somebody_else_at(p, channel);
    if (p.load(channel) == p.descriptor())
        p.store(channel, P::not_process);
    p.a = p.selects(is_ready);
    p.undefined = 6;
}

void disable_timer(P& p) {
    p.a = p.selects(!P::after(p.c, p.local(-5)));
    p.undefined = 6;
}

void wait_for_time(P& p) {
    p.undefined = 7;
    if (P::after(p.clock(p.priority), p.a))
        return;
    p.insert_timer(p.a);
    p.leave();
}

void start_clocks(P& p) {
    p.clocks_run = true;
    p.clock_value = p.pop();
    p.clocks_since = p.now;
}

void save_queue(P& p, unsigned priority) {
    const Word place = p.pop();
    p.store(place, p.front[priority]);
    p.store(place + 4, p.back[priority]);
}

constexpr PlainOperation table[] = {
    {0x21, "lend", 5, all, count_loop},
    {0x1E, "ldpri", 1, all, [](P& p) { p.push(p.priority); }},
    {0x43, "alt", 2, all, [](P& p) { p.store_local(-3, P::enabling); }},
    {0x4E, "talt", 4, all, [](P& p) { p.store_local(-3, P::enabling), p.store_local(-4, P::time_not_set); }},
    {0x49, "enbs", 3, all, enable_skip},
    {0x30, "diss", 4, all, [](P& p) { p.a = p.selects(true), p.undefined = 6; }},
    {0x45, "altend", 4, all, [](P& p) { p.iptr += p.local(0); }},
    {0x0D, "startp", 12, all, start_process, at_end},
    {0x03, "endp", 13, all, end_process, at_end},
    {0x39, "runp", 10, all, [](P& p) { p.enqueue(p.pop()); }, at_end},
    {0x15, "stopp", 11, all, [](P& p) { p.leave(); }, at_end},
    {0x55, "stoperr", 2, all, stop_on_error, at_end},
    {0x07, "in", 19, all, [](P& p) { p.transfer(false, p.b, p.c, p.a); }, at_end_or_later, pay_for_message},
    {0x0B, "out", 19, all, [](P& p) { p.transfer(true, p.b, p.c, p.a); }, at_end_or_later, pay_for_message},
    {0x0E, "outbyte", 21, all, [](P& p) { output_value(p, 1); }, at_end, pay_for_value},
    {0x0F, "outword", 21, all, [](P& p) { output_value(p, 4); }, at_end, pay_for_value},
    {0x12, "resetch", 3, all, reset_channel, at_end},
    {0x48, "enbc", 5, all, enable_channel, at_end, [](P& p) { p.cycles += p.a && somebody_else_at(p, p.b) ? 2 : 0; }},
    {0x47, "enbt", 8, all, enable_timer, at_end},
    {0x44, "altwt", 5, all, wait_for_channel, at_end, [](P& p) { p.cycles += p.local(-3) == P::ready ? 0 : 12; }},
    {0x51, "taltwt", 15, all, wait_for_channel_or_time, at_end, [](P& p) { p.cycles += time_has_come(p) ? 0 : 33; }},
    {0x2F, "disc", 8, all, disable_channel, at_end},
    {0x2E, "dist", 23, all, disable_timer, at_end},
    {0x22, "ldtimer", 2, all, [](P& p) { p.push(p.clock(p.priority)); }, at_end},
    {0x2B, "tin", 4, all, wait_for_time, at_end, [](P& p) { p.cycles += P::after(p.clock(p.priority), p.a) ? 0 : 26; }},
    {0x54, "sttimer", 1, all, start_clocks, at_end},
    {0x3E, "saveh", 4, all, [](P& p) { save_queue(p, 0); }, at_end},
    {0x3D, "savel", 4, all, [](P& p) { save_queue(p, 1); }, at_end},
    {0x18, "sthf", 1, all, [](P& p) { p.front[0] = p.pop(); }, at_end},
    {0x50, "sthb", 1, all, [](P& p) { p.back[0] = p.pop(); }, at_end},
    {0x1C, "stlf", 1, all, [](P& p) { p.front[1] = p.pop(); }, at_end},
    {0x17, "stlb", 1, all, [](P& p) { p.back[1] = p.pop(); }, at_end},
    {0x7A, "timerdisableh", 1, debugged, [](P& p) { p.timer_enabled[0] = false; }, at_end},
    {0x7B, "timerdisablel", 1, debugged, [](P& p) { p.timer_enabled[1] = false; }, at_end},
    {0x7C, "timerenableh", 1, debugged, [](P& p) { p.timer_enabled[0] = true; }, at_end},
    {0x7D, "timerenablel", 1, debugged, [](P& p) { p.timer_enabled[1] = true; }, at_end},
};

} // namespace plain_processes

const std::span<const PlainOperation> plain_scheduling_operations = plain_processes::table;

void PlainTransputer::enqueue(Word process) {
    const unsigned queue = process & 1;
    if (front[queue] == not_process)
        front[queue] = workspace(process);
    else
        store(back[queue] - link_word, workspace(process));
    back[queue] = workspace(process);
}

void PlainTransputer::leave() {
    store(wptr - iptr_word, iptr);
    leaving = true;
    undefined = 7;
}

PlainTransputer::Word PlainTransputer::clock(unsigned of_priority) const {
    return clocks_run && now > clocks_since ? clock_value + static_cast<Word>((now - clocks_since) / tick(of_priority))
                                            : clock_value;
}

/// Puts the running process into the timer queue of its priority, behind those that wake earlier or at the same time.
void PlainTransputer::insert_timer(Word time) {
    Word link = timer_heads + 4 * priority;
    for (Word next = load(link); next != not_process && !after(load(next - time_word), time); next = load(link))
        link = next - timer_word;
    store(wptr - time_word, time);
    store(wptr - timer_word, load(link));
    store(link, wptr);
}

void PlainTransputer::remove_timer(Word process) {
    if (!clocks_run)
        return;
    Word link = timer_heads + 4 * (process & 1);
    for (std::size_t most = memory.size() / 4; load(link) != not_process; link = load(link) - timer_word) {
        if (load(link) == workspace(process)) {
            store(link, load(load(link) - timer_word));
            store(workspace(process) - timer_word, time_set);
            store(workspace(process) - time_word, clock(process & 1));
            return;
        }
        if (most-- == 0)
            stop("the timer queue is a circle");
    }
}

/// Ends `disc`, `diss` and `dist`: selects the guard if it is ready, true, and no other one is selected.
bool PlainTransputer::selects(bool is_ready) {
    if (local(0) != none_selected || !is_ready || !b)
        return false;
    store_local(0, a);
    return true;
}

void PlainTransputer::refuse_link(Word channel) const {
    if (channel - most_neg < 0x24)
        stop(fmt::format("link #{:02X}: links are left out", channel - most_neg));
}

bool PlainTransputer::comes_second(Word channel, bool output) {
    const Word other = load(channel);
    if (other == not_process)
        return false;
    const Word told = told_by(other);
    return !output || (told != enabling && told != waiting && told != ready);
}

PlainTransputer::Word PlainTransputer::told_by(Word process) { return load(workspace(process) - state_word); }

/// Inputs or outputs a message on a soft channel.
void PlainTransputer::transfer(bool output, Word channel, Word pointer, Word count) {
    refuse_link(channel);
    const Word other = load(channel);
    if (!comes_second(channel, output)) {
        const Word told = other == not_process ? 0 : told_by(other);
        store(channel, descriptor());
        store_local(-3, pointer);
        leave();
        if (other == not_process)
            return;
        store(workspace(other) - state_word, ready);
        if (told != waiting)
            return;
        remove_timer(other);
        enqueue(other);
        return;
    }
    copy(output ? told_by(other) : pointer, output ? pointer : told_by(other), count);
    store(channel, not_process);
    enqueue(other);
    undefined = 7;
}

// What happens between instructions.

/// Lets the cycles of an operation pass, and then its effect happen, unless an interrupt comes before.
void PlainTransputer::go_on_with_pending() {
    const auto& operation = *pending_.operation;
    for (;;) {
        wake_due();
        if (operation.when == When::at_end_unless_interrupted && priority == 1 && front[0] != not_process)
            return interrupt();
        const std::uint64_t due = next_timer();
        if (pending_.left < due - now)
            break;
        pending_.left -= due - now;
        now = due;
    }
    now += pending_.left;
    pending_ = {};
    operation.effect(*this);
    finish();
}

/// Wakes what is due, and chooses the next process if the running one has left.
void PlainTransputer::finish() {
    wake_due();
    if (may_slice && slice_is_over) {
        leave();
        enqueue(descriptor());
    }
    if (leaving)
        run_next();
    leaving = may_slice = false;
    if (!idle && priority == 1 && front[0] != not_process)
        interrupt();
}

void PlainTransputer::wake_due() {
    for (unsigned queue = 0; queue < 2 && clocks_run; ++queue) {
        const Word head = timer_heads + 4 * queue;
        while (timer_enabled[queue] && load(head) != not_process && after(clock(queue), load(load(head) - time_word))) {
            const Word process = load(head);
            store(head, load(process - timer_word));
            store(process - timer_word, time_set);
            store(process - time_word, clock(queue));
            if (load(process - state_word) == waiting)
                store(process - state_word, ready);
            enqueue(process | queue);
        }
    }
}

/// Returns when a timer is due next; 2^64 - 1 if none is.
std::uint64_t PlainTransputer::next_timer() const {
    std::uint64_t moment = std::numeric_limits<std::uint64_t>::max();
    for (unsigned queue = 0; queue < 2 && clocks_run; ++queue) {
        const Word process = peek(timer_heads + 4 * queue);
        if (process == not_process || !timer_enabled[queue])
            continue;
        const Word ticks = peek(process - time_word) + 1 - clock_value;
        const std::uint64_t passed = (now - clocks_since) / tick(queue);
        moment = std::min(moment, clocks_since + (passed + (ticks - static_cast<Word>(passed))) * tick(queue));
    }
    return moment;
}

/// Lets time pass until a timer wakes a process.
void PlainTransputer::wait_for_timer() {
    if (next_timer() == std::numeric_limits<std::uint64_t>::max())
        stop("deadlock: no process is ready, none waits for a time");
    now = next_timer();
    leaving = true;
    may_slice = false;
    finish();
}

void PlainTransputer::run_next() {
    idle = false;
    if (front[0] == not_process && interrupted)
        return resume();
    const unsigned queue = front[0] == not_process;
    idle = front[queue] == not_process;
    if (idle)
        return;
    priority = queue;
    wptr = front[queue];
    front[queue] = wptr == back[queue] ? not_process : load(wptr - link_word);
    iptr = load(wptr - iptr_word);
    slice_began = slice();
}

void PlainTransputer::interrupt() {
    Word place = saved;
    for (const Word word : {descriptor(), iptr, a, b, c, error[1] ? most_neg : 0, Word{0}}) {
        store(place, word);
        place += 4;
    }
    interrupted_unit = unit;
    saved_undefined = undefined;
    interrupted_pending_ = std::exchange(pending_, {});
    slices_before = slice() - slice_began;
    interrupted = true;
    now += 2 * 19;
    run_next();
    wake_due();
}

void PlainTransputer::resume() {
    interrupted = false;
    priority = 1;
    wptr = workspace(load(saved));
    iptr = load(saved + 4);
    a = load(saved + 8);
    b = load(saved + 12);
    c = load(saved + 16);
    error[1] = load(saved + 20) >> 31;
    store(saved, not_process);
    unit = interrupted_unit;
    undefined = saved_undefined;
    pending_ = std::exchange(interrupted_pending_, {});
    slice_began = slice() - slices_before;
    now += 2 * 17;
    wake_due();
}

} // namespace placedpar::test
