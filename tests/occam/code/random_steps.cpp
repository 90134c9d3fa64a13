// Random processes.

#include "executed.hpp"
#include "random_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <utility>

namespace placedpar::test {

using occam::Basic;
using occam::name_of;

namespace {

using Act = std::function<void(ProgramMemory&)>;

/// Returns the bytes of a value in memory, as integers.
std::vector<ProgramValue> bytes_of_value(const ProgramValue& value, Basic type) {
    std::vector<ProgramValue> bytes;
    for (const std::int32_t word : words_of_value(value, type))
        for (int i = 0; i < 4; ++i)
            bytes.push_back({(static_cast<std::uint32_t>(word) >> (8 * i)) & 255, 0});
    return bytes;
}

} // namespace

ProgramStep in_sequence(const std::vector<ProgramStep>& steps) {
    std::string text = "SEQ\n";
    std::vector<std::function<void(ProgramMemory&)>> acts;
    for (const ProgramStep& each : steps) {
        text += indented(each.text, 2);
        acts.push_back(each.act);
    }
    return {text, [acts](ProgramMemory& memory) {
                for (const auto& each : acts)
                    each(memory);
            }};
}

std::size_t RandomProgram::Name::cells() const {
    std::size_t all = 1;
    for (const std::uint32_t size : sizes)
        all *= size;
    return all;
}

/// Forbids assignments to names.
void RandomProgram::freeze(const std::set<std::size_t>& numbers) {
    for (Name& each : names_)
        each.is_writable = each.is_writable && !numbers.contains(each.number);
}

ProgramStep RandomProgram::with_names(std::vector<Name> added, const std::function<ProgramStep()>& inner) {
    const std::vector<Name> before = names_;
    std::ranges::move(added, std::back_inserter(names_));
    ProgramStep step = inner();
    names_ = before;
    return step;
}

/// Returns declarations and processes that may use them.
ProgramStep RandomProgram::block(int depth, int steps) {
    std::vector<Name> own;
    std::string text;
    for (auto count = random_.below(3); count-- > 0;) {
        own.push_back(declare(any_type(), any_sizes(), "v"));
        text += declaration(own.back());
    }
    ProgramStep inner = with_names({}, [&] {
        std::vector<ProgramStep> all;
        for (const Name& each : own) {
            all.push_back(initialised(each));
            names_.push_back(each);
        }
        for (int i = 0; i < steps; ++i)
            all.push_back(step(depth));
        return in_sequence(all);
    });
    return {text + inner.text, inner.act};
}

ProgramStep RandomProgram::step(int depth) {
    const auto which = random_.below(depth > 0 ? 20 : 8);
    if (is_in_function_ && ((which > 3 && which < 8) || which > 15))
        return assignment();
    switch (which) {
    case 2: return double_assignment();
    case 3: return array_assignment();
    case 4:
    case 5:
    case 6: return may_log_ ? log() : assignment();
    case 7: return instance();
    case 8: return choice(depth);
    case 9: return selection(depth);
    case 10: return loop(depth);
    case 11: return replicated(depth);
    case 12:
    case 13: return abbreviation(depth);
    case 14: return value_abbreviation(depth);
    case 15: return retyping(depth);
    case 16: return parallel(depth);
    case 17: return replicated_parallel();
    case 18:
    case 19: return communication(depth);
    default: return assignment();
    }
}

ProgramStep RandomProgram::assignment() {
    Basic type = any_type();
    for (int tries = 0; tries < 20 && !has_spot(type, true); ++tries)
        type = any_type();
    if (!has_spot(type, true))
        return {"SKIP\n", [](ProgramMemory&) {}};
    const ProgramSpot to = spot(type, true);
    const ProgramTerm value = term(type, 3);
    return {fmt::format("{} := {}\n", to.text, value.text),
            [to = to.cells, value = value.value](ProgramMemory& memory) {
                const ProgramValue result = value(memory);
                to(memory)[0] = result;
            }};
}

ProgramStep RandomProgram::double_assignment() {
    std::vector<Name> scalars;
    for (const Name& each : names_)
        if (each.sizes.empty() && each.is_writable)
            scalars.push_back(each);
    if (scalars.size() < 2)
        return assignment();
    const auto first = random_.below(static_cast<std::uint32_t>(scalars.size()));
    const Name one = scalars[first];
    scalars.erase(scalars.begin() + first);
    const Name other = one_of(scalars);
    const ProgramTerm a = term(one.type, 2), b = term(other.type, 2);
    return {fmt::format("{}, {} := {}, {}\n", one.text, other.text, a.text, b.text),
            [a = a.value, b = b.value, one = one.number, other = other.number](ProgramMemory& memory) {
                const ProgramValue x = a(memory), y = b(memory);
                memory.named[one][0] = x, memory.named[other][0] = y;
            }};
}

/// Assigns a whole array or a segment: from another one, or from a table.
ProgramStep RandomProgram::array_assignment() {
    std::vector<Name> targets;
    for (const Name& each : names_)
        if (each.sizes.size() == 1 && each.is_writable)
            targets.push_back(each);
    if (targets.empty())
        return assignment();
    const Name to = one_of(targets);
    std::vector<Name> sources;
    for (const Name& each : names_)
        if (each.sizes.size() == 1 && each.type == to.type && each.number != to.number)
            sources.push_back(each);
    const std::uint32_t size = to.sizes[0];
    if (sources.empty() || random_.chance(0.4)) {
        std::string text;
        std::vector<std::function<ProgramValue(ProgramMemory&)>> values;
        for (std::uint32_t i = 0; i < size; ++i) {
            const ProgramTerm value = term(to.type, 1);
            text += (i > 0 ? ", " : "") + value.text;
            values.push_back(value.value);
        }
        return {fmt::format("{} := [{}]\n", to.text, text), [values, to = to.number](ProgramMemory& memory) {
                    std::vector<ProgramValue> results;
                    for (const auto& each : values)
                        results.push_back(each(memory));
                    std::ranges::copy(results, memory.named[to].begin());
                }};
    }
    const Name from = one_of(sources);
    const std::uint32_t count = std::min(size, from.sizes[0]);
    const auto at = random_.below(size - count + 1), start = random_.below(from.sizes[0] - count + 1);
    const bool whole = size == from.sizes[0] && random_.chance(0.5);
    return {whole ? fmt::format("{} := {}\n", to.text, from.text)
                  : fmt::format("[{} FROM {} FOR {}] := [{} FROM {} FOR {}]\n", to.text, at, count, from.text, start,
                                count),
            [at, start, count, to = to.number, from = from.number](ProgramMemory& memory) {
                const auto source = memory.named[from].subspan(start, count);
                std::ranges::copy(std::vector(source.begin(), source.end()), memory.named[to].subspan(at).begin());
            }};
}

ProgramStep RandomProgram::log() {
    const Basic type = any_type();
    const ProgramTerm value = term(type, 3);
    has_logged_ = true;
    return {fmt::format("log.{} ({})\n", name_of(type), value.text),
            [type, value = value.value](ProgramMemory& memory) {
                for (const std::int32_t word : words_of_value(value(memory), type))
                    if (memory.log.size() < most_logged)
                        memory.log.push_back(word);
            }};
}

ProgramStep RandomProgram::choice(int depth) {
    std::string text = "IF\n";
    std::vector<std::pair<std::function<ProgramValue(ProgramMemory&)>, Act>> choices;
    for (auto count = 1 + random_.below(3); count-- > 0;) {
        const ProgramTerm when = condition(3);
        const ProgramStep then = block(depth - 1, 1);
        text += "  " + when.text + "\n" + indented(then.text, 4);
        choices.emplace_back(when.value, then.act);
    }
    if (random_.chance(0.995)) {
        const ProgramStep then = block(depth - 1, 1);
        text += "  TRUE\n" + indented(then.text, 4);
        choices.emplace_back([](ProgramMemory&) { return ProgramValue{1, 0}; }, then.act);
    }
    return {text, [choices](ProgramMemory& memory) {
                for (const auto& [when, then] : choices)
                    if (when(memory).integer != 0)
                        return then(memory);
                throw ProgramError{};
            }};
}

ProgramStep RandomProgram::selection(int depth) {
    static constexpr std::array types{Basic::byte, Basic::integer, Basic::int16, Basic::int32, Basic::int64};
    const Basic type = one_of(types);
    const bool is_dense = random_.chance(0.3);
    const ProgramTerm selector = masked(type, variable_term(type, 2), is_dense ? 4 : 3);
    std::string text = fmt::format("CASE {}\n", selector.text);
    std::map<int, Act> options;
    for (int i = 0; i < (is_dense ? 15 : 7); ++i) {
        if (!is_dense && random_.chance(0.5))
            continue;
        const ProgramStep then = is_dense ? assignment() : block(depth - 1, 1);
        const std::string own = type == Basic::integer ? "" : "(" + name_of(type) + ")";
        text += fmt::format("  {}{}{}\n", i, own, i % 3 == 1 ? fmt::format(", {}{}", 100 + i, own) : "") +
                indented(then.text, 4);
        options[i] = then.act;
    }
    Act otherwise = [](ProgramMemory&) { throw ProgramError{}; };
    if (options.empty() || random_.chance(0.995)) {
        const ProgramStep then = block(depth - 1, 1);
        text += "  ELSE\n" + indented(then.text, 4);
        otherwise = then.act;
    }
    return {text, [value = selector.value, options, otherwise](ProgramMemory& memory) {
                const auto found = options.find(static_cast<int>(value(memory).integer));
                (found == options.end() ? otherwise : found->second)(memory);
            }};
}

ProgramStep RandomProgram::loop(int depth) {
    const std::string counter = fresh("w");
    const ProgramTerm also = condition(2);
    const ProgramStep body = block(depth - 1, 2);
    const auto times = random_.below(4);
    const bool has_condition = random_.chance(0.5);
    const std::string text =
        fmt::format("INT {0}:\nSEQ\n  {0} := {1}\n  WHILE ({0} > 0){2}\n    SEQ\n      {0} := {0} - 1\n", counter,
                    times, has_condition ? " AND " + also.text : "");
    return {text + indented(body.text, 6),
            [times, has_condition, also = also.value, act = body.act](ProgramMemory& memory) {
                for (auto left = times; left > 0 && (!has_condition || also(memory).integer != 0); --left)
                    act(memory);
            }};
}

ProgramStep RandomProgram::replicated(int depth) {
    const Name index = index_name();
    const int base = static_cast<int>(random_.below(7)) - 3, step_by = static_cast<int>(random_.below(5)) - 2;
    const bool has_step = random_.chance(0.3);
    const ProgramTerm count = masked(Basic::integer, term(Basic::integer, 1), 2);
    const ProgramStep body = with_names({index}, [&] { return block(depth - 1, 2); });
    return {fmt::format("SEQ {} = {} FOR {}{}\n", index.text, base, count.text,
                        has_step ? fmt::format(" STEP {}", step_by) : "") +
                indented(body.text, 2),
            [base, step_by = has_step ? step_by : 1, count = count.value, number = index.number,
             act = body.act](ProgramMemory& memory) {
                const WideInteger times = count(memory).integer;
                std::vector<ProgramValue> value{{base, 0}};
                for (int i = 0; i < times; ++i, value[0].integer += step_by) {
                    memory.named[number] = value;
                    act(memory);
                }
            }};
}

/// Gives an element, a row or a segment another name.
ProgramStep RandomProgram::abbreviation(int depth) {
    std::vector<Name> fitting;
    for (const Name& each : names_)
        if (each.is_writable)
            fitting.push_back(each);
    if (fitting.empty())
        return assignment();
    const Name whole = one_of(fitting);
    ProgramSpot place = element(whole);
    std::vector<std::uint32_t> sizes;
    if (whole.sizes.size() == 1 && whole.sizes[0] > 3 && random_.chance(0.4)) {
        const auto start = random_.below(whole.sizes[0] - 2);
        sizes = {3};
        place = {
            fmt::format("[{} FROM {} FOR 3]", whole.text, start),
            [start, number = whole.number](ProgramMemory& memory) { return memory.named[number].subspan(start, 3); },
            whole.number,
            {}};
    }
    Name own = declare(whole.type, sizes, "e");
    const ProgramStep body = with_names({own}, [&] {
        std::erase_if(names_, [&](const Name& each) { return each.number == whole.number; });
        freeze(place.reads);
        return block(depth - 1, 2);
    });
    return {fmt::format("{} IS {}:\n", own.text, place.text) + body.text,
            [cells = place.cells, number = own.number, act = body.act](ProgramMemory& memory) {
                memory.named[number] = cells(memory);
                act(memory);
            }};
}

ProgramStep RandomProgram::value_abbreviation(int depth) {
    const Basic type = any_type();
    const ProgramTerm value = variable_term(type, 3);
    Name own = declare(type, {}, "c");
    own.is_writable = false;
    const ProgramStep body = with_names({own}, [&] {
        freeze(value.reads);
        return block(depth - 1, 2);
    });
    const bool has_type = random_.chance(0.5);
    return {fmt::format("VAL {}{} IS {}:\n", has_type ? name_of(type) + " " : "", own.text, value.text) + body.text,
            [value = value.value, number = own.number, act = body.act](ProgramMemory& memory) {
                std::vector<ProgramValue> cell{value(memory)};
                memory.named[number] = cell;
                act(memory);
            }};
}

/// Reads, or changes, the bytes of a scalar.
ProgramStep RandomProgram::retyping(int depth) {
    std::vector<Name> fitting;
    for (const Name& each : names_)
        if (each.sizes.empty() && each.is_writable && bits_of_type(each.type) >= 32)
            fitting.push_back(each);
    if (fitting.empty())
        return assignment();
    const Name whole = one_of(fitting);
    const bool is_value = is_real_type(whole.type) || random_.chance(0.5);
    const auto size = static_cast<std::uint32_t>(bits_of_type(whole.type) / 8);
    Name own = declare(Basic::byte, {size}, "b");
    own.is_writable = !is_value;
    const ProgramStep body = with_names({own}, [&] {
        if (is_value)
            freeze({whole.number});
        else
            std::erase_if(names_, [&](const Name& each) { return each.number == whole.number; });
        return block(depth - 1, 2);
    });
    return {
        fmt::format("{}[{}]BYTE {} RETYPES {}:\n", is_value ? "VAL " : "", size, own.text, whole.text) + body.text,
        [is_value, type = whole.type, from = whole.number, number = own.number, act = body.act](ProgramMemory& memory) {
            std::vector<ProgramValue> bytes = bytes_of_value(memory.named[from][0], type);
            memory.named[number] = bytes;
            act(memory);
            WideInteger value = 0;
            for (std::size_t i = bytes.size(); i-- > 0;)
                value = value << 8 | bytes[i].integer;
            if (!is_value)
                memory.named[from][0].integer = wrapped_to(value, type);
        }};
}

ProgramStep RandomProgram::instance() {
    const std::vector<Name> before = names_;
    std::vector<ProcedureName> fitting;
    for (const ProcedureName& each : procedures_)
        if (has_spot(each.reference.type, true) && (may_log_ || !each.logs))
            fitting.push_back(each);
    if (fitting.empty())
        return assignment();
    const ProcedureName called = one_of(fitting);
    const ProgramSpot reference = spot(called.reference.type, true);
    std::vector<Name> arrays;
    for (const Name& each : names_)
        if (each.type == called.array.type && each.is_writable && each.sizes.size() == 1 && each.sizes[0] >= 4 &&
            each.number != reference.name && !reference.reads.contains(each.number))
            arrays.push_back(each);
    if (arrays.empty())
        return assignment();
    const Name array = one_of(arrays);
    const auto start = random_.below(array.sizes[0] - 3);
    std::erase_if(names_,
                  [&](const Name& each) { return each.number == reference.name || each.number == array.number; });
    const ProgramTerm value = term(called.value.type, 2);
    names_ = before;
    has_logged_ = has_logged_ || called.logs;
    const std::string passed =
        array.sizes[0] == 4 && random_.chance(0.5) ? array.text : fmt::format("[{} FROM {} FOR 4]", array.text, start);
    return {fmt::format("{} ({}, {}, {})\n", called.text, value.text, reference.text, passed),
            [value = value.value, cells = reference.cells, from = array.number, start, called](ProgramMemory& memory) {
                std::vector<ProgramValue> cell{value(memory)};
                const auto referred = cells(memory);
                const auto part = memory.named[from].subspan(start, 4);
                memory.named[called.value.number] = cell;
                memory.named[called.reference.number] = referred;
                memory.named[called.array.number] = part;
                called.body(memory);
            }};
}

/// Gives a variable its first value.
ProgramStep RandomProgram::initialised(const Name& name) {
    if (name.sizes.empty()) {
        const ProgramTerm value = term(name.type, 2);
        return {fmt::format("{} := {}\n", name.text, value.text),
                [value = value.value, number = name.number](ProgramMemory& memory) {
                    const ProgramValue result = value(memory);
                    memory.named[number][0] = result;
                }};
    }
    std::vector<Name> indices;
    std::string head, subscripts;
    for (std::size_t i = 0; i < name.sizes.size(); ++i) {
        indices.push_back(index_name());
        head += std::string(2 * i, ' ') + fmt::format("SEQ {} = 0 FOR {}\n", indices.back().text, name.sizes[i]);
        subscripts += "[" + indices.back().text + "]";
    }
    ProgramTerm value;
    with_names(indices, [&] {
        value = term(name.type, 1);
        return ProgramStep{};
    });
    return {head + std::string(2 * indices.size(), ' ') +
                fmt::format("{}{} := {}\n", name.text, subscripts, value.text),
            [value = value.value, name, indices](ProgramMemory& memory) {
                std::vector<std::vector<ProgramValue>> at(indices.size(), std::vector<ProgramValue>(1));
                for (std::size_t cell = 0; cell < name.cells(); ++cell) {
                    for (std::size_t i = indices.size(), rest = cell; i-- > 0; rest /= name.sizes[i]) {
                        at[i][0].integer = static_cast<WideInteger>(rest % name.sizes[i]);
                        memory.named[indices[i].number] = at[i];
                    }
                    memory.named[name.number][cell] = value(memory);
                }
            }};
}

} // namespace placedpar::test
