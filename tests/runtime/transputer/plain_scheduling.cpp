// Processes, channels, alternations, timers.

#include "plain_transputer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace placedpar::test {

namespace {

using P = PlainTransputer;
using Word = P::Word;

constexpr unsigned all = t414 | t425 | t400 | t800 | t805, debugged = t425 | t400 | t805;
constexpr Word iptr_word = 4, link_word = 8, state_word = 12, timer_word = 16, time_word = 20; ///< below W

bool after(Word time, Word other) { return static_cast<std::int32_t>(time - other) > 0; }
/// Returns the workspace of a descriptor.
Word workspace(Word descriptor) { return descriptor & ~3U; }

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
    p.store(workspace(p.a) - iptr_word, p.iptr + p.b);
    p.enqueue(workspace(p.a) | p.priority);
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
    p.wptr = workspace(place);
    p.iptr = p.load(place);
}

void run_process(P& p) { p.enqueue(p.pop()); }

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
    const Word other = p.load(channel);
    if (other == P::not_process) {
        p.store(channel, p.descriptor());
    } else if (other != p.descriptor()) {
        p.store_local(-3, P::ready);
        p.cycles += 2;
    }
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
    } else if (after(p.local(-5), time)) {
        p.store_local(-5, time);
    }
}

void wait_for_alternative(P& p, bool timed) {
    p.store_local(0, P::none_selected);
    if (p.local(-3) == P::ready)
        return;
    const bool has_time = timed && p.local(-4) == P::time_set;
    const Word clock = p.clock(p.priority);
    if (has_time && !after(p.local(-5), clock)) {
        p.store_local(-3, P::ready);
        p.store_local(-5, clock);
        return;
    }
    p.store_local(-3, P::waiting);
    p.cycles += timed ? 33 : 12;
    if (has_time)
        p.insert_timer(p.local(-5));
    p.leave();
}

void disable_channel(P& p) {
    const Word channel = p.c;
    p.refuse_link(channel);
    const Word other = p.load(channel);
    if (other == p.descriptor())
        p.store(channel, P::not_process);
    p.a = p.selects(other != P::not_process && other != p.descriptor());
    p.undefined = 6;
}

void disable_timer(P& p) {
    p.remove_timer(p.descriptor());
    p.a = p.selects(!after(p.c, p.clock(p.priority)));
    p.undefined = 6;
}

void wait_for_time(P& p) {
    const Word time = p.a;
    p.undefined = 7;
    if (after(p.clock(p.priority), time))
        return;
    p.cycles += 26;
    p.insert_timer(time);
    p.leave();
}

void start_clocks(P& p) {
    p.clocks_run = true;
    p.clock_value = p.pop();
    p.clocks_since = p.now + 2 * p.cycles + p.extra;
}

void save_queue(P& p, unsigned priority) {
    const Word place = p.pop();
    p.store(place, p.front[priority]);
    p.store(place + 4, p.back[priority]);
}

constexpr PlainOperation table[] = {
    {0x21, "lend", 5, all, count_loop},
    {0x0D, "startp", 12, all, start_process},
    {0x03, "endp", 13, all, end_process},
    {0x39, "runp", 10, all, run_process},
    {0x15, "stopp", 11, all, [](P& p) { p.leave(); }},
    {0x1E, "ldpri", 1, all, [](P& p) { p.push(p.priority); }},
    {0x55, "stoperr", 2, all,
     [](P& p) {
         if (p.error[p.priority])
             p.leave();
     }},
    {0x07, "in", 19, all, [](P& p) { p.transfer(false, p.b, p.c, p.a); }},
    {0x0B, "out", 19, all, [](P& p) { p.transfer(true, p.b, p.c, p.a); }},
    {0x0E, "outbyte", 21, all, [](P& p) { output_value(p, 1); }},
    {0x0F, "outword", 21, all, [](P& p) { output_value(p, 4); }},
    {0x12, "resetch", 3, all, reset_channel},
    {0x43, "alt", 2, all, [](P& p) { p.store_local(-3, P::enabling); }},
    {0x4E, "talt", 4, all, [](P& p) { p.store_local(-3, P::enabling), p.store_local(-4, P::time_not_set); }},
    {0x48, "enbc", 5, all, enable_channel},
    {0x49, "enbs", 3, all,
     [](P& p) {
         if (p.a)
             p.store_local(-3, P::ready);
     }},
    {0x47, "enbt", 8, all, enable_timer},
    {0x44, "altwt", 5, all, [](P& p) { wait_for_alternative(p, false); }},
    {0x51, "taltwt", 15, all, [](P& p) { wait_for_alternative(p, true); }},
    {0x2F, "disc", 8, all, disable_channel},
    {0x30, "diss", 4, all, [](P& p) { p.a = p.selects(true), p.undefined = 6; }},
    {0x2E, "dist", 23, all, disable_timer},
    {0x45, "altend", 4, all, [](P& p) { p.iptr += p.local(0); }},
    {0x22, "ldtimer", 2, all, [](P& p) { p.push(p.clock(p.priority)); }},
    {0x2B, "tin", 4, all, wait_for_time},
    {0x54, "sttimer", 1, all, start_clocks},
    {0x3E, "saveh", 4, all, [](P& p) { save_queue(p, 0); }},
    {0x3D, "savel", 4, all, [](P& p) { save_queue(p, 1); }},
    {0x18, "sthf", 1, all, [](P& p) { p.front[0] = p.pop(); }},
    {0x50, "sthb", 1, all, [](P& p) { p.back[0] = p.pop(); }},
    {0x1C, "stlf", 1, all, [](P& p) { p.front[1] = p.pop(); }},
    {0x17, "stlb", 1, all, [](P& p) { p.back[1] = p.pop(); }},
    {0x7A, "timerdisableh", 1, debugged, [](P& p) { p.timer_enabled[0] = false; }},
    {0x7B, "timerdisablel", 1, debugged, [](P& p) { p.timer_enabled[1] = false; }},
    {0x7C, "timerenableh", 1, debugged, [](P& p) { p.timer_enabled[0] = true; }},
    {0x7D, "timerenablel", 1, debugged, [](P& p) { p.timer_enabled[1] = true; }},
};

} // namespace

const std::span<const PlainOperation> plain_scheduling_operations = table;

bool PlainTransputer::execute_scheduling(unsigned code) {
    for (const auto& row : table)
        if (row.code == code && row.models & settings.model) {
            cycles += row.cycles;
            row.effect(*this);
            return true;
        }
    return false;
}

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

Word PlainTransputer::clock(unsigned of_priority) const {
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
            return;
        }
        if (most-- == 0)
            stop("the timer queue is a circle");
    }
}

/// Ends `disc`, `diss` and `dist`: selects the guard if it is ready, true, and no other one is selected.
bool PlainTransputer::selects(bool is_ready) {
    if (!is_ready || !b || local(0) != none_selected)
        return false;
    store_local(0, a);
    return true;
}

void PlainTransputer::refuse_link(Word channel) const {
    if (channel - most_neg < 0x24)
        stop(fmt::format("link #{:02X}: links are left out", channel - most_neg));
}

/// Inputs or outputs a message on a soft channel.
void PlainTransputer::transfer(bool output, Word channel, Word pointer, Word count) {
    refuse_link(channel);
    const Word other = load(channel), its_pointer = other == not_process ? 0 : load(workspace(other) - state_word);
    const bool alternation = output && other != not_process && its_pointer - most_neg <= 3 && its_pointer != most_neg;
    if (other == not_process || alternation) {
        store(channel, descriptor());
        store_local(-3, pointer);
        leave();
        if (!alternation)
            return;
        store(workspace(other) - state_word, ready);
        if (its_pointer != waiting)
            return;
        remove_timer(other);
        enqueue(other);
        return;
    }
    cycles += 2 * (output ? copy(its_pointer, pointer, count) : copy(pointer, its_pointer, count));
    store(channel, not_process);
    enqueue(other);
    undefined = 7;
}

// What happens between instructions.

/// Wakes what is due, and chooses the next process if the running one has left.
void PlainTransputer::finish() {
    if (may_slice && priority == 1 && front[1] != not_process && slice() - slice_began >= 2) {
        leave();
        enqueue(descriptor());
    }
    wake_due();
    if (leaving)
        run_next();
    else if (priority == 1 && front[0] != not_process)
        interrupt();
}

void PlainTransputer::wake_due() {
    for (unsigned queue = 0; queue < 2 && clocks_run; ++queue) {
        const Word head = timer_heads + 4 * queue;
        while (timer_enabled[queue] && load(head) != not_process && after(clock(queue), load(load(head) - time_word))) {
            const Word process = load(head);
            store(head, load(process - timer_word));
            store(process - time_word, clock(queue));
            if (load(process - state_word) == waiting)
                store(process - state_word, ready);
            enqueue(process | queue);
        }
    }
}

/// Lets time pass until a timer wakes a process.
void PlainTransputer::wait_for_timer() {
    std::optional<std::uint64_t> moment;
    for (unsigned queue = 0; queue < 2 && clocks_run; ++queue) {
        const Word process = load(timer_heads + 4 * queue);
        if (process == not_process || !timer_enabled[queue])
            continue;
        const Word ticks = load(process - time_word) + 1 - clock_value;
        const std::uint64_t passed = (now - clocks_since) / tick(queue);
        const std::uint64_t until = clocks_since + (passed + (ticks - static_cast<Word>(passed))) * tick(queue);
        moment = std::min(moment.value_or(until), until);
    }
    if (!moment)
        stop("deadlock: no process is ready, none waits for a time");
    now = *moment;
    wake_due();
    run_next();
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
    const Word status = (error[1] ? most_neg : 0) | (halt_on_error ? 0x80U : 0U);
    Word place = saved;
    for (const Word word : {descriptor(), iptr, a, b, c, status}) {
        store(place, word);
        place += 4;
    }
    saved_f = f;
    saved_undefined = undefined;
    interrupted = true;
    now += 2 * 19;
    run_next();
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
    f = saved_f;
    undefined = saved_undefined;
    now += 2 * 17;
}

} // namespace placedpar::test
