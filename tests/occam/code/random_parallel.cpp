// Random parallel processes, whose result does not depend on their order.

#include "executed.hpp"
#include "random_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace placedpar::test {

using occam::Basic;
using occam::name_of;

std::pair<ProgramStep, ProgramStep> RandomProgram::apart(const std::function<ProgramStep()>& first,
                                                         const std::function<ProgramStep()>& second) {
    const std::vector<Name> before = names_;
    const bool may_log_before = std::exchange(may_log_, false);
    std::vector<Name> own, others;
    for (const Name& each : before) {
        const bool is_own = random_.chance(0.5);
        if (is_own || !each.is_writable)
            own.push_back(each);
        if (!is_own || !each.is_writable)
            others.push_back(each);
    }
    names_ = own;
    ProgramStep one = first();
    names_ = others;
    ProgramStep other = second();
    names_ = before;
    may_log_ = may_log_before;
    return {std::move(one), std::move(other)};
}

ProgramStep RandomProgram::parallel(int depth) {
    const auto inner = [&] { return block(depth - 1, 2); };
    const auto [one, other] = apart(inner, inner);
    const auto acts = std::pair(one.act, other.act);
    return {"PAR\n" + indented(one.text + other.text, 2), [acts](ProgramMemory& memory) {
                acts.first(memory);
                acts.second(memory);
            }};
}

ProgramStep RandomProgram::replicated_parallel() {
    std::vector<Name> fitting;
    for (const Name& each : names_)
        if (each.sizes.size() == 1 && each.is_writable)
            fitting.push_back(each);
    if (fitting.empty())
        return assignment();
    const Name array = one_of(fitting), index = index_name();
    ProgramTerm value;
    with_names({index}, [&] {
        std::erase_if(names_, [&](const Name& each) { return each.number == array.number; });
        value = term(array.type, 3);
        return ProgramStep{};
    });
    return {fmt::format("PAR {0} = 0 FOR {1}\n  {2}[{0}] := {3}\n", index.text, array.sizes[0], array.text, value.text),
            [value = value.value, array, number = index.number](ProgramMemory& memory) {
                std::vector<ProgramValue> at(1);
                for (std::uint32_t i = 0; i < array.sizes[0]; ++i) {
                    at[0].integer = i;
                    memory.named[number] = at;
                    memory.named[array.number][i] = value(memory);
                }
            }};
}

/// A channel with what passes over it.
struct RandomProgram::Message {
    enum Form : std::uint32_t { simple, sequence, counted, variant, forms } form{};
    Basic type{}, second{};
    std::string channel;
    std::size_t queue = 0;
    int count = 0;
    bool by_alternation = false;
    Name x{}, y{}, text{}, length{}; ///< into which it is received
};

ProgramStep RandomProgram::sender(const Message& m, int depth) {
    std::vector<ProgramStep> steps;
    for (int i = 0; i < m.count; ++i) {
        if (random_.chance(0.5))
            steps.push_back(step(depth - 1));
        const ProgramTerm a = term(m.type, 2), b = term(m.second, 2);
        const ProgramTerm count = masked(Basic::integer, variable_term(Basic::integer, 1), 3);
        const bool has_both = random_.chance(0.5);
        const std::string items[] = {a.text, a.text + "; " + b.text, count.text + "::\"abcdefghi\"",
                                     has_both ? "both; " + a.text + "; " + b.text : "one; " + b.text};
        steps.push_back(
            {fmt::format("{} ! {}\n", m.channel, items[m.form]), [form = m.form, has_both, queue = m.queue, a = a.value,
                                                                  b = b.value, n = count.value](ProgramMemory& memory) {
                 const bool sends_first =
                     form == Message::simple || form == Message::sequence || (form == Message::variant && has_both);
                 const bool sends_second = form == Message::sequence || form == Message::variant;
                 const ProgramValue first = sends_first ? a(memory) : ProgramValue{};
                 const ProgramValue other = sends_second ? b(memory) : ProgramValue{};
                 const ProgramValue third = form == Message::counted ? n(memory) : ProgramValue{has_both ? 1 : 0, 0};
                 memory.messages[queue].push_back({first, other, third});
             }});
    }
    return in_sequence(steps);
}

/// Makes the input of one message, and a process behind it.
ProgramStep RandomProgram::reception(const Message& m, int depth) {
    const ProgramStep then = block(depth - 1, 1);
    const std::string items[] = {m.x.text, m.x.text + "; " + m.y.text, m.length.text + "::" + m.text.text, "CASE"};
    const std::string variants =
        fmt::format("  both; {0}; {1}\n{2}  one; {1}\n    SKIP\n", m.x.text, m.y.text, indented(then.text, 4));
    std::string input = fmt::format("{} ? {}\n", m.channel, items[m.form]);
    if (m.form == Message::variant)
        input += variants;
    else
        input += m.by_alternation ? indented(then.text, 2) : then.text;
    if (m.by_alternation)
        input = "ALT\n  FALSE & SKIP\n    STOP\n" + indented(input, 2);
    return {input, [form = m.form, queue = m.queue, x = m.x.number, y = m.y.number, s = m.text.number,
                    n = m.length.number, act = then.act](ProgramMemory& memory) {
                const std::vector<ProgramValue> message = memory.messages[queue].front();
                memory.messages[queue].pop_front();
                const bool is_one = form == Message::variant && message[2].integer == 0;
                if (form != Message::counted && !is_one)
                    memory.named[x][0] = message[0];
                if (form == Message::sequence || form == Message::variant)
                    memory.named[y][0] = message[1];
                if (form == Message::counted) {
                    memory.named[n][0] = message[2];
                    for (int at = 0; at < message[2].integer; ++at)
                        memory.named[s][static_cast<std::size_t>(at)].integer = "abcdefghi"[at];
                }
                if (!is_one)
                    act(memory);
            }};
}

ProgramStep RandomProgram::receiver(const Message& m, int depth) {
    std::vector<ProgramStep> steps;
    std::string declarations;
    for (const Name& each : {m.x, m.y, m.text, m.length}) {
        declarations += declaration(each);
        steps.push_back(initialised(each));
    }
    for (const Name& each : {m.x, m.y, m.text, m.length})
        names_.push_back(each);
    for (int i = 0; i < m.count; ++i)
        steps.push_back(reception(m, depth));
    ProgramStep all = in_sequence(steps);
    return {declarations + all.text, all.act};
}

/// Sends values over a channel to a parallel process. The interpreter runs the sender first.
ProgramStep RandomProgram::communication(int depth) {
    Message m{.form = static_cast<Message::Form>(random_.below(Message::forms)),
              .type = any_type(),
              .second = any_type(),
              .channel = fresh("ch"),
              .queue = names_count_,
              .count = 1 + static_cast<int>(random_.below(3)),
              .by_alternation = random_.chance(0.4)};
    m.x = declare(m.type, {}, "x"), m.y = declare(m.second, {}, "y");
    m.text = declare(Basic::byte, {9}, "s"), m.length = declare(Basic::integer, {}, "n");
    const std::string protocol = fresh("P");
    const auto [one, other] = apart([&] { return sender(m, depth); }, [&] { return receiver(m, depth); });
    const std::string protocols[] = {
        " IS " + name_of(m.type), fmt::format(" IS {}; {}", name_of(m.type), name_of(m.second)), " IS INT::[]BYTE",
        fmt::format("\n  CASE\n    both; {0}; {1}\n    one; {1}\n", name_of(m.type), name_of(m.second))};
    const std::string head =
        fmt::format("PROTOCOL {}{}:\nCHAN OF {} {}:\nPAR\n", protocol, protocols[m.form], protocol, m.channel);
    const bool sender_is_first = random_.chance(0.5);
    const auto acts = std::pair(one.act, other.act);
    return {head + indented(sender_is_first ? one.text + other.text : other.text + one.text, 2),
            [acts](ProgramMemory& memory) {
                acts.first(memory);
                acts.second(memory);
            }};
}

} // namespace placedpar::test
