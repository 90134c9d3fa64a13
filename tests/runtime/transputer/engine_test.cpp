// Compares the emulated transputer with the plain one: each instruction at the edges of its operands, and random
// programs.

#include "edges.hpp"
#include "plain_transputer.hpp"
#include "random_program.hpp"
#include "runtime/random.hpp"
#include "runtime/transputer/assembler.hpp"
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

namespace {

using Word = std::uint32_t;

constexpr PlainModel plain_models[] = {t414, t425, t400, t800, t805};
constexpr transputer::Model core_models[] = {transputer::Model::t414, transputer::Model::t425, transputer::Model::t400,
                                             transputer::Model::t800, transputer::Model::t805};
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
    /// `in_pieces`: probability of going on in short pieces of time.
    Both(std::size_t model, Word memory, Word memorycycles, Word clock_mhz, double in_pieces = 0, bool wraps = false)
        : plain({plain_models[model], memory, memorycycles, clock_mhz, wraps}),
          core(core_models[model], memory,
               {.clock_hz = clock_mhz * 1'000'000, .memory_cycles = static_cast<int>(memorycycles), .wraps = wraps},
               no_links),
          clock_mhz_(clock_mhz), in_pieces_(in_pieces) {
        for (Word address = PlainTransputer::most_neg; address < plain.mem_start(); address += 4)
            plain.poke(address, PlainTransputer::not_process);
    }

    void poke(Word address, const std::vector<std::uint8_t>& bytes) {
        plain.poke(address, bytes);
        core.copy_to_memory(address - PlainTransputer::most_neg, bytes);
    }

    void set(transputer::Registers registers, bool halt_on_error = false) {
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
        core.run(before + 1);
        if (!plain.stopped.empty() && core.stopped() == transputer::Stopped::by_bad_address)
            return "";
        return differences(half_cycles, core.local() - before);
    }

    /// Executes until no process is ready in either. Returns what differs.
    std::string run_to_end() {
        for (int i = 0; i < 10'000'000 && plain.stopped.empty(); ++i)
            plain.step();
        RandomStream random(plain.now, "limits");
        while (random.chance(in_pieces_) && core_time() < plain.now)
            run_piece(random);
        run_core(~0ULL >> 2);
        std::string result = memory_difference();
        if (plain.now != core_time())
            result += fmt::format(" ends at half cycle {}, expected {};", core_time(), plain.now);
        return result;
    }

    /// Compares before each instruction. Returns the first difference.
    std::string first_difference() {
        FirstDifference first(*this);
        run_core(~0ULL >> 2);
        return first.found;
    }

    /// Runs for a short time. May have run ahead, and come back, before.
    void run_piece(RandomStream& random, std::uint64_t end = ~0ULL) {
        if (random.chance(0.3)) {
            core.keep();
            run_core(core_time() + random.below(2000));
            core.go_back();
        }
        run_core(std::min(core_time() + random.below(300), end), random.chance(0.5));
    }

    /// Runs the core alone. Time passes while it is idle.
    void run_core(std::uint64_t until, bool punctual = false) {
        for (;;) {
            const auto base = core_time() - core.local();
            if (until < base)
                return;
            switch (
                core.run(until - base, punctual ? transputer::Core::Links::may_wake : transputer::Core::Links::rest)) {
            case transputer::Core::Pause::limit:
            case transputer::Core::Pause::stopped:
            case transputer::Core::Pause::left: return;
            case transputer::Core::Pause::on_time: break;
            case transputer::Core::Pause::idle:
                if (core.next_timer() == Time::max() || core_time() >= until)
                    return;
                core.pass_idle_time(std::max(core.next_timer(), core.local_time()));
            }
        }
    }

    std::uint64_t core_time() const {
        return static_cast<std::uint64_t>(core.local_time().count()) * clock_mhz_ / 500'000;
    }

    PlainTransputer plain;
    NoLinks no_links;
    transputer::Core core;

private:
    /// Lets the plain transputer follow the core, and compares both before the core begins an instruction.
    struct FirstDifference final : transputer::Core::Watcher {
        explicit FirstDifference(Both& b) : both(b) { both.core.watch(this); }
        ~FirstDifference() { both.core.watch(nullptr); }
        FirstDifference(const FirstDifference&) = delete;
        void begins(Word at) override {
            while (both.plain.stopped.empty() && both.plain.now < both.core_time())
                both.plain.step();
            if (!found.empty() || both.plain.now != both.core_time() || both.plain.idle)
                return;
            const std::string difference = both.memory_difference() + both.differences(0, 0);
            if (!difference.empty())
                found = fmt::format("before the instruction at #{:08X}, half cycle {}, workspace #{:08X}:{}", at,
                                    both.plain.now, both.plain.wptr, difference);
        }
        void executed(Word, transputer::HalfCycles) override {}
        Both& both;
        std::string found;
    };

    std::string differences(std::uint64_t expected, std::uint64_t half_cycles) const {
        const transputer::Registers& r = core.registers();
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
                return fmt::format(" byte #{:08X} is #{:02X}, expected #{:02X};", PlainTransputer::most_neg + i,
                                   bytes[i], plain.memory[i]);
        return "";
    }

    Word clock_mhz_;
    double in_pieces_;
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
    test::EveryNth some(10);
    for (std::size_t model = 0; model < std::size(core_models); ++model) {
        Both both(model, 8192, 3, 20);
        for (const auto name : register_operations(both.plain)) {
            CAPTURE(name);
            CAPTURE(model);
            both.poke(0x80000200, transputer::assemble(name).bytes);
            int failures = 0;
            for (const Word a : values)
                for (const Word b : values)
                    for (const Word c : {0U, 1U, 0x80000000U, 0xFFFFFFFFU, 0x12345678U}) {
                        const bool chosen = model == 4 || (a + b + c) % 5 == model; // all triples on one model
                        if (!chosen || !is_defined(name, a, b) || some.passes_over())
                            continue;
                        both.set({0x80000200, workspace_at, a, b, c, ((a ^ b) & 1) != 0});
                        const auto difference = both.step();
                        if (!difference.empty() && ++failures < 3)
                            FAIL_CHECK(fmt::format("A #{:08X}, B #{:08X}, C #{:08X}:{}", a, b, c, difference));
                    }
        }
    }
}

TEST_CASE("the engine stops at the end of the instruction that sets Error, if HaltOnError is set") {
    for (const std::size_t model : {1U, 3U})
        for (const auto name : register_operations(Both(model, 4096, 3, 20).plain))
            for (const Word a : {0U, 1U, 0x7FFFFFFFU, 0x80000000U, 0xFFFFFFFFU})
                for (const Word b : {0U, 5U, 0x7FFFFFFFU, 0x80000000U, 0xFFFFFFFFU}) {
                    if (!is_defined(name, a, b))
                        continue;
                    Both both(model, 4096, 3, 20);
                    both.poke(0x80000200, transputer::assemble(name).bytes);
                    both.set({0x80000200, workspace_at, a, b, 7, false}, true);
                    const auto difference = both.step();
                    CHECK_MESSAGE(difference.empty(),
                                  fmt::format("{} A #{:08X}, B #{:08X}:{}", name, a, b, difference));
                }
}

TEST_CASE("the engine executes direct functions and accesses to memory as the plain transputer does") {
    std::vector<std::string> instructions{"lb", "sb", "ret", "altend"};
    for (const char* function :
         {"j", "ldlp", "ldnl", "ldc", "ldnlp", "ldl", "adc", "call", "cj", "ajw", "eqc", "stl", "stnl"})
        for (const Word operand : edges())
            instructions.push_back(fmt::format("{} #{:X}", function, operand));
    test::EveryNth some(5);
    for (const std::string& instruction : instructions)
        for (const Word a : {0U, 1U, 0x7FFFFFFFU, 0x80000000U, 0x80000C03U, 0x80001FFCU, 0x80002001U, 0xFFFFFFFFU}) {
            if (some.passes_over())
                continue;
            Both both(3, 8192, 4, 20);
            both.poke(0x80000200, transputer::assemble(instruction).bytes);
            both.poke(workspace_at, {0x10, 0x32, 0x54, 0x06});
            both.set({0x80000200, workspace_at, a, 0x89ABCDEF, 7, false}, a % 2 != 0); // some halt on an error
            const auto difference = both.step();
            CHECK_MESSAGE(difference.empty(), fmt::format("{} A #{:08X}:{}", instruction, a, difference));
        }
}

TEST_CASE(
    "where addresses wrap, all accesses and code outside of the memory do so, to the memory outside of the chip") {
    // Memory has 16 Kbyte. The program writes code at #80004100, goes there, and returns; stores, calls, moves and
    // communicates at addresses from 16 Kbyte on, also across ends of the memory. W is at #80005000.
    const auto code = transputer::assemble(R"(
           ldc #11223344; mint; ldc #4010; bsub; stnl 0; ldc #55667788; stl 2; ldl 2; stl 3
           mint; ldc #4010; bsub; mint; ldc #3FF9; bsub; ldc 20; move
           mint; ldc #3FF0; bsub; mint; ldc #4200; bsub; ldc 64; move
           ldpi routine; mint; ldc #4100; bsub; ldc 8; move
           ldpi here; stl 0; mint; ldc #4100; bsub; gcall
     here: stl 4; call local; stl 5; ldlp 20; ldc 9; bsub; lb; stl 6
           mint; stl 8; ldc other - next; ldlp -30; startp
     next: ldlp 10; ldlp 8; ldc 8; in
           mint; ldc #FFF00; bsub; ldnl 0; stl 7; ldc 3; ldlp 12; sb; fpldzerodb; ldlp 14; fpstnldb
           ldc 0; stl 15; ldc 3; stl 16
     loop: ldlp 15; ldc over - loop; lend
     over: stopp
    other: ldlp 4; ldlp 38; ldc 8; out; stopp
    local: ldl 1; ret
  routine: ldc 7; ldl 0; gcall; ldc 1; ldc 2; ldc 3
)",
                                           0x80001200);
    for (const std::size_t model : {3U, 4U})
        for (const bool wraps : {true, false}) {
            Both both(model, 16384, 3, 20, 0, wraps);
            both.poke(code.origin, code.bytes);
            both.set({code.origin, 0x80005000, 5, 6, 7, false});
            const std::string difference = both.run_to_end();
            CHECK_MESSAGE((difference.empty() || !wraps), difference);
            if (!wraps) {
                CHECK(both.core.stopped() == transputer::Stopped::by_bad_address);
                continue;
            }
            CHECK(both.core.stopped() == transputer::Stopped::nothing);
            CHECK(both.core.memory().word(0x1000 + 16) == 0x80004103); // W + 4: the address after the routine
            CHECK(both.core.memory().word(0x1000 + 8) == 0x55667788);  // W + 2
            CHECK(both.core.memory().word(16384 + 0x10) != 0);         // hidden behind the memory on the chip
            CHECK(both.core.memory().word(0x10) == PlainTransputer::not_process); // a link's channel is untouched
        }
}

TEST_CASE("j 0 is a breakpoint while its flag is set, and break always is one") {
    for (std::size_t model = 0; model < std::size(core_models); ++model)
        for (const std::string_view code :
             {"setj0break; testj0break; stl 1; clrj0break; testj0break; stl 2; j 0; setj0break; j 0; ldc 1",
              "setj0break; ldc 0; cj 0; j end; ldc 2; end: opr #9C0B1; ldc 1", "j 0; ldc 3; break; ldc 1",
              "setj0break; opr #80B2; j 0; ldc 4; setj0break; .byte #20, #20, 0; ldc 1"}) {
            CAPTURE(code);
            CAPTURE(model);
            const bool can_break = model != 0 && model != 3; // T414 and T800 cannot
            Both both(model, 8192, 3, 20);
            both.poke(0x80000200, transputer::assemble(code).bytes);
            both.set({0x80000200, workspace_at, 5, 6, 7, false});
            const std::string difference = both.run_to_end();
            CHECK((difference.empty() || !can_break));
            CHECK(both.plain.stopped.find("break") == (can_break ? 0 : std::string::npos));
            CHECK((!can_break || both.core.registers().instruction == both.plain.iptr));
            CHECK(both.core.stopped() ==
                  (can_break ? transputer::Stopped::by_break : transputer::Stopped::by_unknown_instruction));
        }
}

namespace {

void compare_random_programs(std::size_t count) {
    for (const auto seed : seeds(count)) {
        const auto model = seed % std::size(core_models);
        const RandomCodeKind kind{
            .model = plain_models[model], .processes = seed % 3 != 0, .data_first = seed % 2 == 0};
        const auto code = random_code(seed, kind);
        const auto program = transputer::assemble(code.source, code.origin);
        const Word memorycycles = 1 + static_cast<Word>(seed / 7 % 5), mhz = seed % 4 ? 1 : 20;
        const auto compare = [&](std::string (Both::*run)()) {
            Both both(model, 65536, memorycycles, mhz, seed % 2 ? 1 - 1e-3 : 0);
            both.poke(code.origin, program.bytes);
            both.set({code.origin, code.workspace, 0, 0, 0, false});
            return (both.*run)();
        };
        const auto difference = compare(&Both::run_to_end);
        CHECK_MESSAGE(difference.empty(),
                      fmt::format("{} {} First {}", replay(seed), difference, compare(&Both::first_difference)));
    }
}

} // namespace

TEST_CASE("damaged programs do the same however far the core runs ahead") {
    for (const auto seed : seeds(150)) {
        INFO(replay(seed));
        RandomStream random(seed, "damage");
        const auto code = random_code(seed, {.model = plain_models[seed % 5], .data_first = seed % 2 == 0});
        auto bytes = transputer::assemble(code.source, code.origin).bytes;
        for (std::uint32_t i = random.below(6); i > 0; --i)
            bytes[random.below(static_cast<std::uint32_t>(bytes.size()))] = static_cast<std::uint8_t>(random());
        Both at_once(seed % 5, 65536, 3, 1), in_pieces(seed % 5, 65536, 3, 1);
        for (Both* each : {&at_once, &in_pieces}) {
            each->poke(code.origin, bytes);
            each->set({code.origin, code.workspace, 0, 0, 0, false});
        }
        const std::uint64_t end = 60'000;
        while (in_pieces.core.stopped() == transputer::Stopped::nothing && in_pieces.core_time() < end &&
               random.below(500))
            in_pieces.run_piece(random, end);
        for (Both* each : {&at_once, &in_pieces})
            each->run_core(end);
        CHECK(at_once.core_time() == in_pieces.core_time());
        CHECK(at_once.core.why_stopped() == in_pieces.core.why_stopped());
        CHECK(std::equal(at_once.core.memory().data(), at_once.core.memory().data() + 65536,
                         in_pieces.core.memory().data()));
    }
}

// 120,000 instructions.
TEST_CASE("random programs run on the engine as on the plain transputer") { compare_random_programs(200); }

// 12 million instructions.
TEST_CASE("millions of random instructions run on the engine as on the plain transputer" * doctest::skip()) {
    compare_random_programs(20000);
}
