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

/// Sends values over a channel to a parallel process. The interpreter runs the sender first.
ProgramStep RandomProgram::communication(int depth) {
    enum Form : std::uint32_t { simple, sequence, counted, variant, forms };
    const auto form = random_.below(forms);
    const Basic type = any_type(), second = any_type();
    const std::string channel = fresh("ch"), protocol = fresh("P");
    const std::size_t queue = names_count_;
    const Name x = declare(type, {}, "x"), y = declare(second, {}, "y"), text = declare(Basic::byte, {9}, "s"),
               length = declare(Basic::integer, {}, "n");
    const int messages = 1 + static_cast<int>(random_.below(3));
    const bool by_alternation = random_.chance(0.4);
    const auto sender = [&] {
        std::string lines = "SEQ\n";
        std::vector<std::function<void(ProgramMemory&)>> acts;
        for (int i = 0; i < messages; ++i) {
            if (random_.chance(0.5)) {
                const ProgramStep before = step(depth - 1);
                lines += indented(before.text, 2);
                acts.push_back(before.act);
            }
            const ProgramTerm a = term(type, 2), b = term(second, 2);
            const ProgramTerm count = masked(Basic::integer, variable_term(Basic::integer, 1), 3);
            const bool has_both = random_.chance(0.5);
            const std::string items[] = {a.text, a.text + "; " + b.text, count.text + "::\"abcdefghi\"",
                                         has_both ? "both; " + a.text + "; " + b.text : "one; " + b.text};
            lines += fmt::format("  {} ! {}\n", channel, items[form]);
            acts.emplace_back([form, has_both, queue, a = a.value, b = b.value, n = count.value](ProgramMemory& memory) {
                const ProgramValue none{}, is_both{has_both ? 1 : 0, 0};
                const bool sends_first = form == simple || form == sequence || (form == variant && has_both);
                const ProgramValue first = sends_first ? a(memory) : none;
                const ProgramValue other = form == sequence || form == variant ? b(memory) : none;
                memory.messages[queue].push_back({first, other, form == counted ? n(memory) : is_both});
            });
        }
        return ProgramStep{lines, [acts](ProgramMemory& memory) {
                               for (const auto& each : acts)
                                   each(memory);
                           }};
    };
    const auto receiver = [&] {
        std::string lines = declaration(x) + declaration(y) + declaration(text) + declaration(length) + "SEQ\n";
        std::vector<std::function<void(ProgramMemory&)>> acts;
        std::vector<ProgramStep> first_values;
        for (const Name& each : {x, y, text, length}) {
            first_values.push_back(initialised(each));
            lines += indented(first_values.back().text, 2);
            acts.push_back(first_values.back().act);
        }
        for (const Name& each : {x, y, text, length})
            names_.push_back(each);
        for (int i = 0; i < messages; ++i) {
            const ProgramStep then = block(depth - 1, 1);
            const std::string items[] = {x.text, x.text + "; " + y.text, length.text + "::" + text.text, "CASE"};
            const std::string behind = indented(then.text, 2);
            const std::string variants = fmt::format("  both; {0}; {1}\n{2}  one; {1}\n    SKIP\n", x.text, y.text, indented(behind, 2));
            const std::string input = fmt::format("{} ? {}\n", channel, items[form]);
            if (by_alternation)
                lines += "  ALT\n    FALSE & SKIP\n      STOP\n" +
                         indented(input + (form == variant ? variants : behind), 4);
            else
                lines += indented(input + (form == variant ? variants : then.text), 2);
            acts.emplace_back([form, queue, x = x.number, y = y.number, s = text.number, n = length.number,
                               act = then.act](ProgramMemory& memory) {
                const std::vector<ProgramValue> message = memory.messages[queue].front();
                memory.messages[queue].pop_front();
                const bool is_one = form == variant && message[2].integer == 0;
                if (form != counted && !is_one)
                    memory.named[x][0] = message[0];
                if (form == sequence || form == variant)
                    memory.named[y][0] = message[1];
                if (form == counted) {
                    memory.named[n][0] = message[2];
                    for (int at = 0; at < message[2].integer; ++at)
                        memory.named[s][static_cast<std::size_t>(at)].integer = "abcdefghi"[at];
                }
                if (!is_one)
                    act(memory);
            });
        }
        return ProgramStep{lines, [acts](ProgramMemory& memory) {
                               for (const auto& each : acts)
                                   each(memory);
                           }};
    };
    const auto [one, other] = apart(sender, receiver);
    const std::string protocols[] = {
        name_of(type), fmt::format("{}; {}", name_of(type), name_of(second)), "INT::[]BYTE",
        fmt::format("\n  CASE\n    both; {0}; {1}\n    one; {1}\n", name_of(type), name_of(second))};
    const std::string head = form == variant ? fmt::format("PROTOCOL {}{}:\n", protocol, protocols[form])
                                             : fmt::format("PROTOCOL {} IS {}:\n", protocol, protocols[form]);
    const bool sender_is_first = random_.chance(0.5);
    const auto acts = std::pair(one.act, other.act);
    return {head + fmt::format("CHAN OF {} {}:\nPAR\n", protocol, channel) +
                indented(sender_is_first ? one.text + other.text : other.text + one.text, 2),
            [acts](ProgramMemory& memory) {
                acts.first(memory);
                acts.second(memory);
            }};
}

} // namespace placedpar::test
