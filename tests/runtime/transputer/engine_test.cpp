// Compares the emulated transputer with the plain one: each instruction at the edges of its operands, and random programs.

#include "assembler.hpp"
#include "edges.hpp"
#include "plain_transputer.hpp"
#include "random_program.hpp"
#include "runtime/transputer/core.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

using namespace placedpar;
using namespace placedpar::test;
using placedpar::transputer::Core;
using placedpar::transputer::Model;
using placedpar::transputer::Registers;

namespace {

using Word = std::uint32_t;

constexpr PlainModel plain_models[] = {t414, t425, t400, t800, t805};
constexpr Model models[] = {Model::t414, Model::t425, Model::t400, Model::t800, Model::t805};
constexpr Word workspace_at = 0x80000C00;

/// Links that nothing is connected to.
struct NoLinks : transputer::LinkEngines {
    void begin_transfer(int, Word, Word) override {}
    bool byte_waits(int) override { return false; }
    void reset(int) override {}
};

/// Both implementations with the same memory.
class Both {
public:
    Both(std::size_t model, Word memory, Word memorycycles, Word clock_mhz)
        : plain({plain_models[model], memory, memorycycles, clock_mhz}),
          core(models[model], memory,
               {.clock_hz = clock_mhz * 1'000'000, .memory_cycles = static_cast<int>(memorycycles)}, no_links),
          clock_mhz_(clock_mhz) {
        for (Word address = PlainTransputer::most_neg; address < plain.mem_start(); address += 4)
            plain.poke(address, PlainTransputer::not_process);
    }

    void poke(Word address, const std::vector<std::uint8_t>& bytes) {
        plain.poke(address, bytes);
        core.copy_to_memory(address - PlainTransputer::most_neg, bytes);
    }

    void set(Registers registers, bool halt_on_error = false) {
        plain.iptr = registers.instruction;
        plain.wptr = registers.workspace;
        plain.a = registers.a;
        plain.b = registers.b;
        plain.c = registers.c;
        plain.error[1] = registers.error;
        plain.halt_on_error = halt_on_error;
        plain.undefined = 0;
        core.set_registers(registers, 1);
        core.set_halts_on_error(halt_on_error);
    }

    /// Executes one instruction. Returns what differs.
    std::string step() {
        const auto half_cycles = plain.step();
        const auto before = core.local();
        core.run(before + 1, false);
        return differences(half_cycles, core.local() - before);
    }

    /// Executes until no process is ready in either. Returns what differs.
    std::string run_to_end() {
        for (int i = 0; i < 10'000'000 && plain.stopped.empty(); ++i)
            plain.step();
        run_core(~0ULL >> 2);
        std::string result = memory_difference();
        if (plain.now != core_time())
            result += fmt::format(" ends at half cycle {}, expected {};", core_time(), plain.now);
        return result;
    }

    /// Executes in small steps. Returns the first difference.
    std::string first_difference() {
        while (plain.stopped.empty()) {
            const Word at = plain.iptr;
            plain.step();
            run_core(plain.now);
            std::string difference = memory_difference();
            if (core_time() == plain.now && !plain.idle && difference.empty())
                difference = differences(0, 0);
            if (!difference.empty())
                return fmt::format("after the instruction at #{:08X}, half cycle {} (engine {}), workspace #{:08X}:{}", at,
                                   plain.now, core_time(), plain.wptr, difference);
        }
        return plain.stopped;
    }

    std::uint64_t core_time() const {
        return static_cast<std::uint64_t>(core.local_time().count()) * clock_mhz_ / 500'000;
    }

    PlainTransputer plain;
    NoLinks no_links;
    Core core;

private:
    void run_core(std::uint64_t until) {
        for (;;) {
            const auto base = core_time() - core.local();
            if (core.local() + base >= until)
                return;
            switch (core.run(until - base, false)) {
            case Core::Pause::limit:
            case Core::Pause::stopped: return;
            case Core::Pause::on_time: break;
            case Core::Pause::idle:
                if (core.next_timer() == Time::max())
                    return;
                if(getenv("DBG")) printf("idle now %lld next %lld\n",(long long)core.local_time().count(),(long long)core.next_timer().count());
                core.pass_idle_time(std::max(core.next_timer(), core.local_time()));
            }
        }
    }

    std::string differences(std::uint64_t expected, std::uint64_t half_cycles) const {
        const Registers& r = core.registers();
        std::string result;
        const auto compare = [&](std::string_view what, std::uint64_t value, std::uint64_t right) {
            if (value != right)
                result += fmt::format(" {} #{:X}, expected #{:X};", what, value, right);
        };
        const auto known = [&](unsigned bit, Word value, Word right) { return plain.undefined & bit ? right : value; };
        compare("A", known(1, r.a, plain.a), plain.a);
        compare("B", known(2, r.b, plain.b), plain.b);
        compare("C", known(4, r.c, plain.c), plain.c);
        compare("Iptr", r.instruction, plain.iptr);
        compare("Wptr", r.workspace, plain.wptr);
        compare("Error", r.error, plain.error[plain.priority]);
        compare("half cycles", half_cycles, expected);
        compare("stopped", core.stopped() != transputer::Stopped::nothing, !plain.stopped.empty());
        return result;
    }

    /// Words below MemStart in which an interrupt saves registers that may be undefined are left out.
    std::string memory_difference() {
        const std::uint8_t* const bytes = core.memory().data();
        for (std::size_t i = 0; i < plain.memory.size(); ++i)
            if (bytes[i] != plain.memory[i] && (i < 0x34 || i >= 0x48))
                return fmt::format(" byte #{:08X} is #{:02X}, expected #{:02X};", PlainTransputer::most_neg + i, bytes[i],
                                   plain.memory[i]);
        return "";
    }

    Word clock_mhz_;
};

/// Operations whose whole effect is on registers.
std::vector<std::string_view> register_operations(const PlainTransputer& plain) {
    std::vector<std::string_view> names;
    for (const auto& row : plain_integer_operations)
        if (row.models & plain.settings.model && row.when == When::at_once)
            names.push_back(row.name);
    std::erase_if(names, [](std::string_view name) {
        return name == "lb" || name == "sb" || name == "ret" || name == "break" || name.ends_with("j0break");
    });
    return names;
}

/// Returns whether the reference says what an operation does with these operands.
bool is_defined(std::string_view name, Word a, Word b) {
    const auto value = static_cast<std::int32_t>(b), sign = static_cast<std::int32_t>(a);
    if (name == "xword")
        return sign > 0 && (a & (a - 1)) == 0 && value >= 0 && value < 2 * std::int64_t{sign};
    return true;
}

} // namespace

TEST_CASE("the engine executes each operation as the plain transputer does, at the edges of operands") {
    const auto values = edges();
    for (std::size_t model = 0; model < std::size(models); ++model) {
        Both both(model, 8192, 3, 20);
        std::vector<std::uint8_t> code;
        for (const auto name : register_operations(both.plain)) {
            CAPTURE(name);
            CAPTURE(model);
            both.poke(0x80000200, assemble(name).bytes);
            int failures = 0;
            for (const Word a : values)
                for (const Word b : values)
                    for (const Word c : {0U, 1U, 0x80000000U, 0xFFFFFFFFU, 0x12345678U}) {
                        if (!is_defined(name, a, b))
                            continue;
                        both.set({0x80000200, workspace_at, a, b, c, ((a ^ b) & 1) != 0});
                        const auto difference = both.step();
                        if (!difference.empty() && ++failures < 3)
                            FAIL_CHECK(fmt::format("A #{:08X}, B #{:08X}, C #{:08X}:{}", a, b, c, difference));
                    }
        }
    }
}

TEST_CASE("random programs run on the engine as on the plain transputer") {
    for (const auto seed : seeds(400)) {
        INFO(replay(seed));
        const auto model = seed % std::size(models);
        const RandomCodeKind kind{.model = plain_models[model], .processes = seed % 3 != 0, .data_first = seed % 2 == 0};
        const auto code = random_code(seed, kind);
        const auto program = assemble(code.source, code.origin);
        const Word memorycycles = 1 + static_cast<Word>(seed / 7 % 5), mhz = seed % 4 ? 1 : 20;
        const auto compare = [&](std::string (Both::*run)()) {
            Both both(model, 65536, memorycycles, mhz);
            both.poke(code.origin, program.bytes);
            both.set({code.origin, code.workspace, 0, 0, 0, false});
            return (both.*run)();
        };
        if (const auto difference = compare(&Both::run_to_end); !difference.empty())
            FAIL_CHECK(difference << " first " << compare(&Both::first_difference));
    }
}
