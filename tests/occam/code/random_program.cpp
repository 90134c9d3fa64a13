// Random programs.

#include "random_program.hpp"

#include "executed.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace placedpar::test {

using occam::Basic;
using occam::name_of;

RandomProgram::Name RandomProgram::declare(Basic type, std::vector<std::uint32_t> sizes, std::string_view stem) {
    Name name{fresh(stem), type, std::move(sizes), cells_.size(), true};
    cells_.push_back(name.cells());
    return name;
}

RandomProgram::Name RandomProgram::index_name() {
    Name index = declare(Basic::integer, {}, "i");
    index.is_writable = false;
    return index;
}

std::vector<std::uint32_t> RandomProgram::any_sizes() {
    static const std::vector<std::vector<std::uint32_t>> all{{}, {}, {}, {4}, {8}, {5}, {4}, {2, 4}, {3, 5}};
    return one_of(all);
}

std::string RandomProgram::type_text(Basic type, const std::vector<std::uint32_t>& sizes) {
    std::string text;
    for (const std::uint32_t size : sizes)
        text += fmt::format("[{}]", size);
    return text + name_of(type);
}

std::string RandomProgram::declaration(const Name& name) {
    return fmt::format("{} {}:\n", type_text(name.type, name.sizes), name.text);
}

/// Returns the procedures that note values.
std::string RandomProgram::log_procedures() const {
    std::string text = fmt::format(R"(PROC log.INT (VAL INT v)
  IF
    logged < {}
      SEQ
        memory[logged] := v
        logged := logged + 1
        memory[1022] := logged
    TRUE
      SKIP
:
)",
                                   most_logged);
    for (const Basic type : {Basic::boolean, Basic::byte, Basic::int16, Basic::int32})
        text += fmt::format("PROC log.{0} (VAL {0} v)\n  log.INT (INT v)\n:\n", name_of(type));
    text += "PROC log.REAL32 (VAL REAL32 v)\n  VAL INT w RETYPES v:\n  log.INT (w)\n:\n";
    for (const Basic type : {Basic::int64, Basic::real64})
        text += fmt::format(
            "PROC log.{0} (VAL {0} v)\n  VAL [2]INT w RETYPES v:\n  SEQ i = 0 FOR 2\n    log.INT (w[i])\n:\n",
            name_of(type));
    return text;
}

void RandomProgram::add_function() {
    FunctionName function{fresh("f"), any_type(), {}, {}, {}};
    function.first = declare(function.type, {}, "a");
    function.second = declare(Basic::integer, {}, "b");
    function.first.is_writable = function.second.is_writable = false;
    names_ = unchanged_;
    names_.push_back(function.first);
    names_.push_back(function.second);
    const std::string type = name_of(function.type);
    std::string lines = fmt::format("{} FUNCTION {} (VAL {} {}, VAL INT {})", type, function.text, type,
                                    function.first.text, function.second.text);
    if (random_.chance(0.5)) {
        const ProgramTerm value = variable_term(function.type, 3);
        text += lines + fmt::format(" IS {}:\n", value.text);
        function.body = value.value;
    } else {
        is_in_function_ = true;
        const Name result = declare(function.type, {}, "r");
        const ProgramStep first = initialised(result);
        names_.push_back(result);
        const ProgramStep then = block(1, 2);
        is_in_function_ = false;
        text += lines + fmt::format("\n  {}  VALOF\n    SEQ\n{}{}    RESULT {}\n:\n", declaration(result),
                                    indented(first.text, 6), indented(then.text, 6), result.text);
        const auto acts = std::pair(first.act, then.act);
        function.body = [acts, number = result.number](ProgramMemory& memory) {
            acts.first(memory);
            acts.second(memory);
            return memory.named[number][0];
        };
    }
    functions_.push_back(std::move(function));
}

void RandomProgram::add_procedure() {
    ProcedureName procedure{
        fresh("p"), declare(any_type(), {}, "a"), declare(any_type(), {}, "b"), declare(any_type(), {4}, "d"), false,
        {}};
    procedure.value.is_writable = false;
    names_ = unchanged_;
    for (const Name& each : {procedure.value, procedure.reference, procedure.array})
        names_.push_back(each);
    has_logged_ = false;
    may_log_ = random_.chance(0.5);
    const ProgramStep body = block(2, 3);
    may_log_ = true;
    procedure.logs = has_logged_;
    procedure.body = body.act;
    text += fmt::format("PROC {} (VAL {} {}, {} {}, []{} {})\n{}:\n", procedure.text, name_of(procedure.value.type),
                        procedure.value.text, name_of(procedure.reference.type), procedure.reference.text,
                        name_of(procedure.array.type), procedure.array.text, indented(body.text, 2));
    procedures_.push_back(std::move(procedure));
}

RandomProgram::RandomProgram(std::uint64_t seed, bool has_reals) : random_(seed, "programs"), has_reals_(has_reals) {
    static constexpr std::array types{Basic::boolean, Basic::byte,  Basic::integer, Basic::int16,
                                      Basic::int32,   Basic::int64, Basic::real32,  Basic::real64};
    text = "INT logged:\n" + log_procedures();
    std::vector<ProgramStep> steps;
    for (const Basic type : types) {
        unchanged_.push_back(declare(type, {}, "z"));
        unchanged_.back().is_writable = false;
        text += declaration(unchanged_.back());
        const ProgramTerm value = literal(type);
        steps.push_back({fmt::format("{} := {}\n", unchanged_.back().text, value.text),
                         [value = value.value, number = unchanged_.back().number](ProgramMemory& memory) {
                             memory.named[number][0] = value(memory);
                         }});
    }
    for (int i = 0; i < 3; ++i)
        add_function(), add_procedure();
    names_ = unchanged_;
    for (int i = 0; i < 8; ++i) {
        const Name name = declare(any_type(), any_sizes(), "g");
        text += declaration(name);
        steps.push_back(initialised(name));
        names_.push_back(name);
    }
    for (int i = 0; i < 12; ++i)
        steps.push_back(step(3));
    text += "SEQ\n  logged := 0\n";
    for (const ProgramStep& each : steps)
        text += indented(each.text, 2);
    text += "  memory[1023] := 1\n";
    act_ = [steps](ProgramMemory& memory) {
        for (const ProgramStep& each : steps)
            each.act(memory);
    };
}

RandomProgram::Outcome RandomProgram::interpreted() const {
    ProgramMemory memory;
    for (const std::size_t cells : cells_)
        memory.own.emplace_back(cells);
    for (std::vector<ProgramValue>& each : memory.own)
        memory.named.emplace_back(each);
    try {
        act_(memory);
    } catch (const ProgramError&) {
        return {memory.log, true};
    }
    return {memory.log, false};
}

} // namespace placedpar::test
