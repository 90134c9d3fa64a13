// Compares the listing with the plain transputer and with published cycles.

#include "runtime/transputer/listing.hpp"

#include "plain_transputer.hpp"
#include "random_program.hpp"
#include "runtime/transputer/assembler.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

using namespace placedpar;
using namespace placedpar::test;
using transputer::assemble;
using transputer::Core;
using transputer::Listing;
using transputer::Model;

namespace {

struct LinksToNothing : transputer::LinkEngines {
    void begin_transfer(int, std::uint32_t, std::uint32_t) override {}
    bool byte_waits(int) override { return false; }
    void reset(int) override {}
};

/// A core that runs a program until no process is ready.
struct ProgramRun {
    ProgramRun(const std::vector<std::uint8_t>& program, std::uint32_t origin, std::uint32_t workspace, Model model,
               std::uint32_t memorycycles, bool listed)
        : core(model, 65536, {.memory_cycles = static_cast<int>(memorycycles)}, links) {
        core.copy_to_memory(origin - transputer::most_negative, program);
        core.set_registers({.instruction = origin, .workspace = workspace}, 1);
        if (!listed)
            core.watch(nullptr);
        while (core.run(core.local() + 100'000) != Core::Pause::stopped) {
            if (core.is_active())
                continue;
            if (core.next_timer() == Time::max())
                break;
            core.pass_idle_time(std::max(core.next_timer(), core.local_time()));
        }
    }

    std::uint64_t times() const {
        std::uint64_t sum = 0;
        for (const auto& line : listing.lines())
            sum += line.times;
        return sum;
    }
    std::uint64_t spent() const {
        std::uint64_t sum = 0;
        for (const auto& line : listing.lines())
            sum += line.spent;
        return sum;
    }

    LinksToNothing links;
    Core core;
    Listing listing{core};
};

constexpr std::uint32_t program_at = 0x80000100, program_workspace = 0x80000800;

ProgramRun listed_run(std::string_view source, std::uint32_t memorycycles = 3) {
    return {assemble(source, program_at).bytes, program_at, program_workspace, Model::t800, memorycycles, true};
}

/// Times and half cycles, by address.
using Counts = std::map<std::uint32_t, std::pair<std::uint64_t, std::uint64_t>>;

/// Returns the first address at which counts differ; "" if they agree.
std::string difference_of(const Counts& counts, const Counts& right) {
    const auto [a, b] = std::mismatch(counts.begin(), counts.end(), right.begin(), right.end());
    if (a == counts.end() && b == right.end())
        return "";
    const auto print = [](const Counts& all, auto at) {
        return at == all.end()
                   ? std::string("nothing")
                   : fmt::format("#{:08X} {} times, {} half cycles", at->first, at->second.first, at->second.second);
    };
    return fmt::format("{}, expected {}", print(counts, a), print(right, b));
}

Counts counts_of(const Listing& listing) {
    Counts result;
    for (const auto& line : listing.lines()) {
        result[line.address].first += line.times;
        result[line.address].second += line.spent;
    }
    return result;
}

} // namespace

TEST_CASE("the listing of a process has the times and cycles of the plain transputer, for each address") {
    for (const auto seed : seeds(60)) {
        INFO(replay(seed));
        const auto code = random_code(seed, {.processes = false, .data_first = seed % 2 == 0});
        const auto program = assemble(code.source, code.origin).bytes;
        const auto memorycycles = 1 + static_cast<std::uint32_t>(seed % 5);
        const ProgramRun run(program, code.origin, code.workspace, Model::t800, memorycycles, true);

        PlainTransputer plain({.memorycycles = memorycycles});
        plain.poke(code.origin, program);
        plain.iptr = code.origin;
        plain.wptr = code.workspace;
        Counts right;
        while (plain.stopped.empty() && !plain.idle) {
            auto& [times, half_cycles] = right[plain.iptr];
            ++times;
            half_cycles += plain.step();
        }
        CHECK(difference_of(counts_of(run.listing), right) == "");
    }
}

TEST_CASE("a listing counts every instruction and every cycle but those of interrupts, and changes nothing") {
    constexpr std::uint64_t interrupt = 2 * (19 + 17); // half cycles: to a process of high priority, and back
    std::uint64_t interrupts = 0;
    for (const auto seed : seeds(100)) {
        INFO(replay(seed));
        const auto code = random_code(seed, {.data_first = seed % 2 == 0});
        const auto program = assemble(code.source, code.origin).bytes;
        const ProgramRun run(program, code.origin, code.workspace, Model::t800, 4, true);
        ProgramRun usual(program, code.origin, code.workspace, Model::t800, 4, false);
        CHECK(run.times() == run.core.instructions());
        CHECK((run.core.busy() - run.spent()) % interrupt == 0);
        interrupts += (run.core.busy() - run.spent()) / interrupt;
        CHECK(run.core.local_time() == usual.core.local_time());
        CHECK(run.core.instructions() == usual.core.instructions());
        auto& watched = const_cast<Core&>(run.core).memory();
        CHECK(std::equal(watched.data(), watched.data() + watched.size(), usual.core.memory().data()));
    }
    if (all_seeds())
        CHECK(interrupts > 100);
}

TEST_CASE("a listing shows instructions of the scheduler with their cycles, without the waits between them") {
    // The first process outputs 8 bytes, the second inputs them 1000 turns of a loop later. By the table: startp 12,
    // the first at a channel 19, the second 19 and 2 for each of 2 words, cj 4 and 2, j 3, stopp 11; a prefix 1.
    const ProgramRun run = listed_run(R"(
                  mint
                  stlf
                  ldlp 20
                  mint
                  stnl 0
                  mint
                  ldnlp 512
                  stl 5
                  mint
                  ldl 5
                  stnl 0
                  ldc second - started
                  ldlp -20
                  startp
        started:  ldlp 0
                  mint
                  ldnlp 512
                  ldc 8
                  out
                  stopp
        second:   ldc 1000
                  stl 1
        loop:     ldl 1
                  cj done
                  ldl 1
                  adc -1
                  stl 1
                  j loop
        done:     ldlp 2
                  mint
                  ldnlp 512
                  ldc 8
                  in
                  stopp
    )");
    std::map<std::string, std::pair<std::uint64_t, std::uint64_t>> seen; // times and half cycles by instruction
    for (const auto& line : run.listing.lines()) {
        auto& [times, half_cycles] = seen[std::string(description_of(line.instruction.operation).name)];
        times += line.times;
        half_cycles += line.spent;
    }
    const auto cycles = [](std::uint64_t times, std::uint64_t all) { return std::pair{times, 2 * all}; };
    CHECK(seen["startp"] == cycles(1, 12));
    CHECK(seen["out"] == cycles(1, 19));
    CHECK(seen["in"] == cycles(1, 19 + 2 * 2));
    CHECK(seen["cj"] == cycles(1001, 1000 * 2 + 4));
    CHECK(seen["j"] == cycles(1000, 1000 * (3 + 1)));
    CHECK(seen["stopp"] == cycles(2, 2 * (11 + 1)));
    CHECK(run.spent() == run.core.busy());
}

TEST_CASE("a watcher is called once for each instruction, also where a timeslice ends") {
    struct CallCounter final : Core::Watcher {
        void begins(std::uint32_t) override { ++begun; }
        void executed(std::uint32_t, transputer::HalfCycles) override { ++ended; }
        std::uint64_t begun = 0, ended = 0;
    } counter;
    LinksToNothing links;
    Core core(Model::t800, 65536, {}, links);
    const auto program = assemble(R"(
                  mint
                  stlf
                  ldc other - started
                  ldlp 20
                  startp
        started:  ldc 10000
                  stl 1
        loop:     ldl 1
                  adc -1
                  stl 1
                  ldl 1
                  cj done
                  j loop
        done:     stopp
        other:    ldc 0
                  cj started
    )",
                                  program_at);
    core.copy_to_memory(program_at - transputer::most_negative, program.bytes);
    core.set_registers({.instruction = program_at, .workspace = program_workspace}, 1);
    core.watch(&counter);
    while (core.run(core.local() + 1'000) != Core::Pause::idle) {
    }
    CHECK(core.local_time() > std::chrono::milliseconds{10}); // at least two timeslices of both
    CHECK(counter.begun == core.instructions());
    CHECK(counter.ended == core.instructions());
}

TEST_CASE("code that other code replaced is listed apart") {
    // The loop's second turn executes ldc 2 where the first turn executed ldc 1.
    const ProgramRun run = listed_run(R"(
                 ldc 2
                 stl 1
        loop:    ldc 1
                 stl 2
                 ldc #42
                 ldc loop - after
                 ldpi
        after:   sb
                 ldl 1
                 adc -1
                 stl 1
                 ldl 1
                 cj done
                 j loop
        done:    stopp
    )");
    std::vector<std::pair<std::uint32_t, bool>> found; // operand, whether replaced
    for (const auto& line : run.listing.lines())
        if (line.address == program_at + 2) {
            CHECK(line.times == 1);
            found.emplace_back(line.instruction.operand, line.is_replaced);
        }
    CHECK(found == std::vector<std::pair<std::uint32_t, bool>>{{2, false}, {1, true}});
    CHECK(print_listing(run.listing, {}).find("  21 FB              ldpi    #80000102 ") != std::string::npos);
    CHECK(print_listing(run.listing, {}).find("\nreplaced by other code\n#80000102  41 ") != std::string::npos);
}

TEST_CASE("a program that writes new code without end is listed in a limited memory") {
    const ProgramRun run = listed_run(R"(
                 ldc 1000
                 stl 1
        loop:    ldc 0
                 stl 2
                 ldl 1
                 ldc 15
                 and
                 adc #40
                 ldc loop - after
                 ldpi
        after:   sb
                 ldl 1
                 adc -1
                 stl 1
                 ldl 1
                 cj done
                 j loop
        done:    stopp
    )");
    std::uint64_t times = 0, lines = 0;
    for (const auto& line : run.listing.lines())
        if (line.address == program_at + 4) {
            ++lines;
            times += line.times;
        }
    CHECK(times == 1000);
    CHECK(lines <= 9);
    CHECK(run.times() == run.core.instructions());
}

TEST_CASE("a listing is printed with its hot blocks first") {
    const ProgramRun run = listed_run(R"(
                 ldc 100
                 stl 1
        loop:    ldl 1
                 cj done
                 ldl 1
                 adc -1
                 stl 1
                 j loop
                 .word 0
        done:    stopp
    )");
    CHECK(print_listing(run.listing, {}) == R"(605 instructions of a T800, 1,321 cycles, without waits

  share             cycles            times  block
 68.1 %                900              100  #80000105 to #8000010A
 30.7 %                406              101  #80000103 to #80000104
  0.9 %                 12                1  #8000010F to #80000110
  0.2 %                  3                1  #80000100 to #80000102

address    bytes              instruction                    times             cycles    share    cycles of block    share
#80000100  26 44              ldc     100                        1                  2    0.2 %                  3    0.2 %
#80000102  D1                 stl     1                          1                  1    0.1 %
#80000103  71                 ldl     1                        101                202   15.3 %                406   30.7 %
#80000104  AA                 cj      #8000010F                101                204   15.4 %
#80000105  71                 ldl     1                        100                200   15.1 %                900   68.1 %
#80000106  60 8F              adc     -1                       100                200   15.1 %
#80000108  D1                 stl     1                        100                100    7.6 %
#80000109  60 08              j       #80000103                100                400   30.3 %

#8000010F  21 F5              stopp                              1                 12    0.9 %                 12    0.9 %
)");
}
