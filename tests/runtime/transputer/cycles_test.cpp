// Measures the cycles of every instruction as a program of the time did: it reads the clock, executes the instruction
// many times, and reads the clock again. The cycles are compared with the table of INMOS's databook.

#include "runtime/transputer/assembler.hpp"
#include "runtime/transputer/core.hpp"
#include "runtime/transputer/instruction.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::transputer::cycles_by_the_clock {

constexpr Models t4_and_t8 = all_models, newer = second_generation, debugged = with_breakpoints, t4 = without_reals,
                 t8 = with_reals;

/// A row of the databook's table.
struct PublishedCycles {
    std::string_view instruction; ///< as it is assembled, with its operand
    double cycles;                ///< without prefixes
    Models models = t4_and_t8;
    std::string_view before = "";  ///< instructions that give it its operands
    std::string_view after = "";   ///< instructions that restore what it changed
    std::string_view instead = ""; ///< takes the place of the instruction when everything else is measured
    double cycles_instead = 0;     ///< the cycles of `instead`
};

// Words of the workspace: 1, 2 count the loop, 3, 4 hold times, 20 has the real 1.0 and 22, 23 the REAL64 1.0.
constexpr PublishedCycles published_cycles[] = {
    // Direct functions
    {"j next; next:", 3},
    {"ldlp 9", 1},
    {"ldnl 1", 2, t4_and_t8, "ldlp 9"},
    {"ldc 9", 1},
    {"ldnlp 1", 1, t4_and_t8, "ldlp 9"},
    {"ldl 9", 2},
    {"adc 1", 1, t4_and_t8, "ldc 9"},
    {"call next; next:", 7, t4_and_t8, "", "ajw 4", "ajw -4", 1},
    {"cj next; next:", 4, t4_and_t8, "ldc 0"},
    {"cj next; next:", 2, t4_and_t8, "ldc 1"},
    {"ajw 0", 1},
    {"eqc 9", 2, t4_and_t8, "ldc 9"},
    {"stl 9", 1, t4_and_t8, "ldc 9"},
    {"stnl 1", 2, t4_and_t8, "ldc 9; ldlp 9"},
    {"ldc #123", 1}, // with two pfix
    {"ldc -300", 1}, // with nfix and pfix
    // Arithmetic and logic
    {"and", 1, t4_and_t8, "ldc 6; ldc 3"},
    {"or", 1, t4_and_t8, "ldc 6; ldc 3"},
    {"xor", 1, t4_and_t8, "ldc 6; ldc 3"},
    {"not", 1, t4_and_t8, "ldc 6"},
    {"shl", 2, t4_and_t8, "ldc 6; ldc 0"},
    {"shl", 5 + 2, t4_and_t8, "ldc 6; ldc 5"},
    {"shl", 31 + 2, t4_and_t8, "ldc 6; ldc 31"},
    {"shr", 2, t4_and_t8, "ldc 6; ldc 0"},
    {"shr", 17 + 2, t4_and_t8, "ldc 6; ldc 17"},
    {"add", 1, t4_and_t8, "ldc 6; ldc 3"},
    {"sub", 1, t4_and_t8, "ldc 6; ldc 3"},
    {"mul", 40, t4_and_t8 & ~only(Model::t414), "ldc 6; ldc 3"},
    {"mul", 38, only(Model::t414), "ldc 6; ldc 3"},
    {"fmul", 35, t4_and_t8, "ldc 6; ldc 3"},
    {"fmul", 38, t4_and_t8, "ldc #40000000; ldc #40000000"}, // the product needs no rounding
    {"div", 39, t4_and_t8, "ldc 60; ldc 7"},
    {"rem", 37, t4_and_t8, "ldc 60; ldc 7"},
    {"gt", 2, t4_and_t8, "ldc 6; ldc 3"},
    {"diff", 1, t4_and_t8, "ldc 6; ldc 3"},
    {"sum", 1, t4_and_t8, "ldc 6; ldc 3"},
    {"prod", 0 + 4, t4_and_t8, "ldc 6; ldc 1"},
    {"prod", 8 + 4, t4_and_t8, "ldc 6; ldc #1FF"},
    {"prod", 30 + 4, t4_and_t8, "ldc 6; ldc #40000000"},
    {"prod", 31 + 4, t4, "ldc 6; ldc -1"},
    {"prod", 0 + 5, t8, "ldc 6; ldc -1"},
    {"prod", 8 + 5, t8, "ldc 6; ldc -257"},
    // Long arithmetic
    {"ladd", 2, t4_and_t8, "ldc 0; ldc 6; ldc 3"},
    {"lsub", 2, t4_and_t8, "ldc 0; ldc 6; ldc 3"},
    {"lsum", 2, t4_and_t8, "ldc 0; ldc 6; ldc 3"},
    {"ldiff", 2, t4_and_t8, "ldc 0; ldc 6; ldc 3"},
    {"lmul", 33, t4_and_t8, "ldc 0; ldc 6; ldc 3"},
    {"ldiv", 35, t4_and_t8, "ldc 0; ldc 60; ldc 7"},
    {"lshl", 0 + 3, t4_and_t8, "ldc 1; ldc 6; ldc 0"},
    {"lshl", 31 + 3, t4_and_t8, "ldc 1; ldc 6; ldc 31"},
    {"lshl", 32 - 28, t4_and_t8, "ldc 1; ldc 6; ldc 32"},
    {"lshl", 63 - 28, t4_and_t8, "ldc 1; ldc 6; ldc 63"},
    {"lshr", 5 + 3, t4_and_t8, "ldc 1; ldc 6; ldc 5"},
    {"lshr", 40 - 28, t4_and_t8, "ldc 1; ldc 6; ldc 40"},
    {"norm", 0 + 5, t4_and_t8, "mint; ldc 0"},
    {"norm", 31 + 5, t4_and_t8, "ldc 1; ldc 0"},
    {"norm", 32 - 26, t4_and_t8, "ldc 0; mint"},
    {"norm", 63 - 26, t4_and_t8, "ldc 0; ldc 1"},
    {"norm", 3, t4_and_t8, "ldc 0; ldc 0"},
    // Support of reals
    {"cflerr", 3, t4, "ldc 0"},
    {"unpacksn", 15, t4, "ldc #3F800000"},
    {"roundsn", 12, t4, "ldc 100; mint; ldc 0"},
    {"postnormsn", 5, t4, "ldc 100; stl 0; ldc 1; mint; ldc 0"},
    {"ldinf", 1, t4},
    {"fptesterror", 2, debugged& t4},
    // General
    {"rev", 1},
    {"xword", 4, t4_and_t8, "ldc 6; ldc #80"},
    {"cword", 5, t4_and_t8, "ldc 6; ldc #80"},
    {"xdble", 2, t4_and_t8, "ldc 6"},
    {"csngl", 3, t4_and_t8, "ldc 0; ldc 6"},
    {"mint", 1},
    {"dup", 1, newer},
    {"pop", 1, debugged},
    // Blocks of two dimensions: 3 rows
    {"move2dinit", 8, newer, "ldc 8; ldc 8; ldc 3"},
    {"move2dall", (2 * 1 + 23) * 3, newer, "ldc 8; ldc 8; ldc 3; move2dinit; ldlp 40; ldlp 60; ldc 4"},
    {"move2dall", (2 * 2 + 23) * 3, newer, "ldc 8; ldc 8; ldc 3; move2dinit; ldlp 40; ldlp 60; ldc 8"},
    {"move2dnonzero", (2 * 1 + 23) * 3, newer, "ldc 8; ldc 8; ldc 3; move2dinit; ldlp 40; ldlp 60; ldc 4"},
    {"move2dzero", (2 * 1 + 23) * 3, newer, "ldc 8; ldc 8; ldc 3; move2dinit; ldlp 40; ldlp 60; ldc 4"},
    // Checks and bits
    {"crcword", 35, newer, "ldc 1; ldc 2; ldc 3"},
    {"crcbyte", 11, newer, "ldc 1; ldc 2; ldc 3"},
    {"bitcnt", 0 + 2, newer, "ldc 0; ldc 1"},
    {"bitcnt", 31 + 2, newer, "ldc 0; ldc -1"},
    {"bitrevword", 36, newer, "ldc 1"},
    {"bitrevnbits", 9 + 4, newer, "ldc 1; ldc 9"},
    // Addresses
    {"bsub", 1, t4_and_t8, "ldc 1; ldlp 9"},
    {"wsub", 2, t4_and_t8, "ldc 1; ldlp 9"},
    {"wsubdb", 3, newer, "ldc 1; ldlp 9"},
    {"bcnt", 2, t4_and_t8, "ldc 6"},
    {"wcnt", 5, t4_and_t8, "ldc 6"},
    {"lb", 5, t4_and_t8, "ldlp 9"},
    {"sb", 4, t4_and_t8, "ldc 6; ldlp 9"},
    {"move", 2 * 0 + 8, t4_and_t8, "ldlp 40; ldlp 60; ldc 0"},
    {"move", 2 * 1 + 8, t4_and_t8, "ldlp 40; ldlp 60; ldc 4"},
    {"move", 2 * 16 + 8, t4_and_t8, "ldlp 40; ldlp 60; ldc 64"},
    {"move", 2 * 3 + 8, t4_and_t8, "ldlp 40; adc 3; ldlp 60; ldc 6"}, // part words at both ends
    // Control
    {"ret", 5, t4_and_t8, "ajw -4; ldc next - here; ldpi; here: stl 0", "next:", "ajw 4", 1},
    {"ldpi", 2, t4_and_t8, "ldc 0"},
    {"gajw", 2, t4_and_t8, "ldlp 0"},
    {"gcall", 4, t4_and_t8, "ldc next - here; ldpi; here:", "next:"},
    {"lend", 10, t4_and_t8, "ldc 9; stl 11; ldlp 10; ldc 0"}, // jumps to the next instruction
    {"lend", 5, t4_and_t8, "ldc 1; stl 11; ldlp 10; ldc 0"},
    // Timers and alternations
    {"ldtimer", 2},
    {"tin", 4, t4_and_t8, "ldtimer; adc -9"},
    {"talt", 4},
    {"taltwt", 15, t4_and_t8, "talt; ldc 1; enbs"},
    {"taltwt", 15, t4_and_t8, "talt; ldtimer; adc -9; ldc 1; enbt"},
    {"enbt", 8, t4_and_t8, "talt; ldc 9; ldc 1"},
    {"dist", 23, t4_and_t8, "ldc -1; stl 0; ldc 9; ldc 1; ldc 0"},
    {"resetch", 3, t4_and_t8, "ldlp 9"},
    {"alt", 2},
    {"altwt", 5, t4_and_t8, "alt; ldc 1; enbs"},
    {"altend", 4, t4_and_t8, "ldc 0; stl 0"},
    {"enbs", 3, t4_and_t8, "ldc 1"},
    {"diss", 4, t4_and_t8, "ldc -1; stl 0; ldc 1; ldc 0"},
    {"enbc", 7, t4_and_t8, "ldlp 60; stl 9; alt; ldlp 9; ldc 1"}, // another process waits at the channel
    {"enbc", 5, t4_and_t8, "mint; stl 9; alt; ldlp 9; ldc 1"},
    {"disc", 8, t4_and_t8, "mint; stl 9; ldc -1; stl 0; ldlp 9; ldc 1; ldc 0"},
    // Processes: each time another one is started, which does not run before the end
    {"startp", 12, t4_and_t8, "ldl 8; ldnlp -6; stl 8; ldc child - here; ldl 8", "here:"},
    {"runp", 10, t4_and_t8, "ldl 8; ldnlp -6; stl 8; ldl 8"},
    {"ldpri", 1},
    // Errors
    {"csub0", 2, t4_and_t8, "ldc 3; ldc 6"},
    {"ccnt1", 3, t4_and_t8, "ldc 3; ldc 6"},
    {"testerr", 2},
    {"testerr", 3, t4_and_t8, "seterr"},
    {"seterr", 1},
    {"stoperr", 2, t4_and_t8, "testerr"},
    {"clrhalterr", 1},
    {"sethalterr", 1},
    {"testhalterr", 2},
    // Queues
    {"testpranal", 2},
    {"saveh", 4, t4_and_t8, "ldlp 9"},
    {"savel", 4, t4_and_t8, "ldlp 9"},
    {"sthf", 1, t4_and_t8, "mint"},
    {"sthb", 1, t4_and_t8, "mint"},
    {"stlf", 1, t4_and_t8, "mint"},
    {"stlb", 1, t4_and_t8, "mint"},
    {"lddevid", 1, newer},
    {"ldmemstartval", 1, debugged},
    {"timerdisableh", 1, debugged},
    {"timerdisablel", 1, debugged},
    {"timerenableh", 1, debugged},
    {"timerenablel", 1, debugged},
    {"clrj0break", 1, debugged},
    {"setj0break", 1, debugged},
    {"testj0break", 2, debugged},
};

/// A row of the table of the floating-point unit: typical cycles.
struct PublishedRealCycles {
    std::string_view instruction;
    double cycles;
    std::string_view before;
    bool waits = false; ///< the integer unit waits for the result
};

constexpr std::string_view singles = "ldlp 20; fpldnlsn; ldlp 20; fpldnlsn", doubles = "ldlp 22; fpldnldb; fpdup";

constexpr PublishedRealCycles published_real_cycles[] = {
    {"fpldnlsn", 2, "ldlp 20"},
    {"fpldnldb", 3, "ldlp 22"},
    {"fpldnlsni", 4, "ldc 0; ldlp 20"},
    {"fpldnldbi", 6, "ldc 0; ldlp 22"},
    {"fpldzerosn", 2, ""},
    {"fpldzerodb", 2, ""},
    {"fpldnladdsn", 8, "ldlp 20; fpldnlsn; ldlp 20"},
    {"fpldnladddb", 9, "ldlp 22; fpldnldb; ldlp 22"},
    {"fpldnlmulsn", 13, "ldlp 20; fpldnlsn; ldlp 20"},
    {"fpldnlmuldb", 21, "ldlp 22; fpldnldb; ldlp 22"},
    {"fpstnlsn", 2, "ldlp 20; fpldnlsn; ldlp 9", true},
    {"fpstnldb", 3, "ldlp 22; fpldnldb; ldlp 9", true},
    {"fpstnli32", 4, "ldlp 20; fpldnlsn; ldlp 9", true},
    {"fprev", 1, singles},
    {"fpdup", 1, singles},
    {"fpchkerror", 1, "", true},
    {"fptesterror", 2, "", true},
    {"fpgt", 4, singles, true},
    {"fpeq", 3, singles, true},
    {"fpordered", 3, singles, true},
    {"fpnan", 2, singles, true},
    {"fpnotfinite", 2, singles, true},
    {"fprtoi32", 7, singles},
    {"fpi32tor32", 8, "ldlp 9"},
    {"fpi32tor64", 8, "ldlp 9"},
    {"fpb32tor64", 8, "ldlp 9"},
    {"fpint", 5, doubles},
    {"fpadd", 6, singles},
    {"fpadd", 6, doubles},
    {"fpsub", 6, singles},
    {"fpsub", 6, doubles},
    {"fpmul", 11, singles},
    {"fpmul", 18, doubles},
    {"fpdiv", 16, singles},
    {"fpdiv", 31, doubles},
    {"fpremfirst", 36, singles, true},
    {"fpremstep", 32, doubles, true},
    {"fpurn", 1, ""},
    {"fpurz", 1, ""},
    {"fpurp", 1, ""},
    {"fpurm", 1, ""},
    {"fpuseterror", 1, ""},
    {"fpuclearerror", 1, ""},
    {"fpuchki32", 3, singles},
    {"fpuchki64", 3, doubles},
    {"fpur32tor64", 3, singles},
    {"fpur64tor32", 6, doubles},
    {"fpunoround", 2, doubles},
    {"fpuabs", 2, singles},
    {"fpusqrtfirst", 27, doubles},
    {"fpusqrtstep", 42, doubles},
    {"fpusqrtlast", 8, singles},
    {"fpuexpinc32", 6, singles},
    {"fpuexpdec32", 6, doubles},
    {"fpumulby2", 6, singles},
    {"fpudivby2", 6, doubles},
};

/// A row for an instruction at which a process gives up the processor.
struct PublishedWait {
    std::string_view instruction;
    double cycles;
    std::string_view before;
};

// The channel is the word 9 of the process.
constexpr PublishedWait published_waits[] = {
    {"stopp", 11, ""},
    {"in", 2 * 0 + 19, "mint; stl 9; ldlp 10; ldlp 9; ldc 16"},
    {"out", 2 * 0 + 19, "mint; stl 9; ldlp 10; ldlp 9; ldc 16"},
    {"outword", 21, "mint; stl 9; ldlp 9; ldc 7"}, // 21: ours
    {"outbyte", 21, "mint; stl 9; ldlp 9; ldc 7"},
    {"endp", 13, "ldc 2; stl 10; ldlp 9"},
    {"tin", 30, "ldc #F00000"},
    {"altwt", 17, "alt"},
    {"taltwt", 48, "talt; ldc #F00000; ldc 1; enbt"},
};

/// A row for instructions of two processes that wake each other again and again: the sum of both.
struct PublishedMeeting {
    std::string_view what;
    double cycles;
    std::string_view main;    ///< instructions of the first process
    std::string_view partner; ///< and of the second; both have the address of a channel in word 9
    std::string_view without; ///< the instructions of both that are not measured
};

constexpr PublishedMeeting published_meetings[] = {
    {"runp and stopp", 2 * (10 + 11 + 2), "ldl 8; runp; stopp", "ldl 8; runp; stopp", "ldl 8; ldl 8"},
    {"in and out of 4 bytes", 19 + 19 + 2 * 1, "ldlp 30; ldl 9; ldc 4; out", "ldlp 30; ldl 9; ldc 4; in",
     "ldlp 30; ldl 9; ldc 4; ldlp 30; ldl 9; ldc 4"},
    {"in and out of 64 bytes", 19 + 19 + 2 * 16, "ldlp 30; ldl 9; ldc 64; in", "ldlp 30; ldl 9; ldc 64; out",
     "ldlp 30; ldl 9; ldc 64; ldlp 30; ldl 9; ldc 64"},
    {"in and out of 6 bytes in 3 words", 19 + 19 + 2 * 3, "ldlp 30; adc 3; ldl 9; ldc 6; out",
     "ldlp 30; adc 3; ldl 9; ldc 6; in", "ldlp 30; adc 3; ldl 9; ldc 6; ldlp 30; adc 3; ldl 9; ldc 6"},
    // Each side is second every other time. An outword that is first takes 21 cycles (ours).
    {"outword and in", (23 + 19) / 2.0 + (21 + 19 + 2 * 1) / 2.0, "ldl 9; ldc 7; outword", "ldlp 30; ldl 9; ldc 4; in",
     "ldl 9; ldc 7; ldlp 30; ldl 9; ldc 4"},
    {"outbyte and in", (23 + 19) / 2.0 + (21 + 19 + 2 * 1) / 2.0, "ldl 9; ldc 7; outbyte", "ldlp 30; ldl 9; ldc 1; in",
     "ldl 9; ldc 7; ldlp 30; ldl 9; ldc 1"},
};

/// Links that nothing is connected to.
struct LinksWithoutWires : LinkEngines {
    void begin_transfer(int, Word, Word) override {}
    bool byte_waits(int) override { return false; }
    void reset(int) override {}
};

constexpr Word program_at = most_negative + 0x80;

/// Loads a program, to be executed at high priority.
void load_program(Core& core, const Assembly& program, Word workspace) {
    core.copy_to_memory(NodeMemory::offset_of(program.origin), program.bytes);
    Registers registers;
    registers.instruction = program.origin;
    registers.workspace = workspace;
    core.set_registers(registers, 0);
}

/// Runs a program at high priority until it halts by an error. Returns the ticks of 1 us that it stored in word 4.
Word ticks_of(Model model, const std::string& source, Word workspace, int memory_cycles) {
    LinksWithoutWires links;
    Core core(model, 0x40000, {.memory_cycles = memory_cycles}, links);
    load_program(core, assemble(source, program_at, model), workspace);
    core.run(400'000'000);
    REQUIRE_MESSAGE(core.stopped() == Stopped::by_error, core.why_stopped());
    return core.memory().word(NodeMemory::offset_of(workspace) + 16);
}

constexpr double cycles_of_tick = 20;
constexpr int turns = 1000;
constexpr const char* halt = "clrhalterr; testerr; sethalterr; seterr\n";

/// Returns the cycles of instructions, with those of a loop. Everything is on the chip, unless many processes need
/// more memory; then all memory is as fast as that on the chip.
double cycles_of_turn(Model model, std::string_view body, const std::string& before = "", const std::string& other = "",
                      bool far = false) {
    std::string padding; // so that the loop's own instruction always has one prefix
    for (int i = 0; i < 16; ++i)
        padding += "ldc 0; ";
    const std::string source = fmt::format(R"(
            ldc 0; sttimer; ldc #3F800000; stl 20; ldc 0; stl 22; ldc #3FF00000; stl 23; ldlp -40; stl 8
            {}
            ldc 0; stl 1; ldc {}; stl 2; ldtimer; stl 3
      turn: {}{}
            ldlp 1; ldc end_of_turns - turn; lend
 end_of_turns: ldtimer; ldl 3; diff; stl 4; {}
            {}
     child: stopp
)",
                                           before, turns, padding, body, halt, other);
    const Word workspace = far ? most_negative + 0x3F000 : most_negative + 0x500;
    return ticks_of(model, source, workspace, far ? 1 : 3) * cycles_of_tick / turns;
}

std::string joined(std::initializer_list<std::string_view> parts) {
    std::string result;
    for (const std::string_view part : parts)
        result += fmt::format("{}\n", part);
    return result;
}

/// Returns the instruction's first word: its name.
std::string_view name_of(std::string_view instruction) {
    return instruction.substr(0, instruction.find_first_of(" ;"));
}

/// Returns the cycles of the instruction's prefixes, and of the constant that selects it.
double cycles_before(std::string_view instruction, Model model) {
    return static_cast<double>(assemble(instruction, 0, model).bytes.size()) - 1;
}

bool agree(double measured, double published) { return std::abs(measured - published) < 0.1; }

std::vector<Model> every_model() { return {Model::t414, Model::t425, Model::t400, Model::t800, Model::t805}; }

/// Returns the cycles of N processes that execute these instructions, one after the other, each in a workspace of 40
/// words, for each process.
double cycles_of_leaving(Model model, std::string_view body) {
    constexpr int processes = 500;
    const std::string source = fmt::format(R"(
            ldc 0; sttimer; ldc 0; stl 1; ldc {}; stl 2; ldlp -80; stl 8
     again: ldl 8; ldnlp -40; stl 8; ldc child - here; ldl 8; startp
      here: ldlp 1; ldc done - again; lend
      done: ldc last - started; ldlp -40; startp
   started: ldtimer; stl 3; stopp
     child: {}
            stopp
      last: ldtimer; ldl 43; diff; stl 44; {}
)",
                                           processes, body, halt);
    return ticks_of(model, source, most_negative + 0x3F000, 1) * cycles_of_tick / processes;
}

TEST_CASE("a program measures the published cycles of each instruction between two readings of the clock") {
    for (const Model model : every_model())
        for (const PublishedCycles& row : published_cycles) {
            if ((row.models & only(model)) == 0)
                continue;
            const bool far = row.instruction == "startp" || row.instruction == "runp";
            const double all = cycles_of_turn(model, joined({row.before, row.instruction, row.after}), "", "", far);
            const double rest = cycles_of_turn(model, joined({row.before, row.instead, row.after}), "", "", far);
            const double instead = row.instead.empty() ? 0 : row.cycles_instead + cycles_before(row.instead, model);
            const double measured = all - rest + instead - cycles_before(row.instruction, model);
            CHECK_MESSAGE(agree(measured, row.cycles),
                          fmt::format("{} after \"{}\" on a {}: {:.2f} cycles, published {}", row.instruction,
                                      row.before, traits_of(model).name, measured, row.cycles));
        }
}

TEST_CASE("a program measures the published cycles of the floating-point unit") {
    // Before and after the instruction the program waits for the unit.
    for (const Model model : {Model::t800, Model::t805})
        for (const PublishedRealCycles& row : published_real_cycles) {
            const double all = cycles_of_turn(model, joined({row.before, "fpchkerror", row.instruction, "fpchkerror"}));
            const double rest = cycles_of_turn(model, joined({row.before, "fpchkerror", "fpchkerror"}));
            const double before = cycles_before(row.instruction, model);
            // The integer unit goes on after 1 cycle. The next instruction has a prefix, which takes another cycle.
            const double measured = all - rest - before + (row.waits ? 0 : 1);
            CHECK_MESSAGE(agree(measured, row.waits ? row.cycles : std::max(row.cycles, 2.0)),
                          fmt::format("{} after \"{}\" on a {}: {:.2f} cycles, published {}", row.instruction,
                                      row.before, traits_of(model).name, measured, row.cycles));
        }
}

TEST_CASE("a program measures the published cycles of instructions at which processes wait") {
    for (const Model model : every_model())
        for (const PublishedWait& row : published_waits) {
            const double all = cycles_of_leaving(model, joined({row.before, row.instruction}));
            const double rest = cycles_of_leaving(model, joined({row.before, "stopp"}));
            const double measured = all - rest + 11 + 1 - cycles_before(row.instruction, model);
            CHECK_MESSAGE(agree(measured, row.cycles),
                          fmt::format("{} on a {}: {:.2f} cycles, published {}", row.instruction, traits_of(model).name,
                                      measured, row.cycles));
        }
}

TEST_CASE("a program measures the published cycles of processes that meet") {
    for (const Model model : every_model())
        for (const PublishedMeeting& row : published_meetings) {
            const std::string before = "ldlp 11; stl 9; mint; stl 11\n"
                                       "ldc partner - i1; ldlp -40; startp; i1: stopp";
            const std::string partner = fmt::format("partner: ldlp 40; stl 8; ldlp 51; stl 9; ldl 8; runp; stopp\n"
                                                    "meeting: {}\nj meeting",
                                                    row.partner);
            const std::string begin = row.what == "runp and stopp" ? "" : "ldl 8; runp;";
            const double all = cycles_of_turn(model, row.main, before + "\n" + begin, partner);
            const double rest =
                cycles_of_turn(model, joined({row.without, "ldc 0; j next; next:"})); // j back has a prefix
            CHECK_MESSAGE(agree(all - rest, row.cycles),
                          fmt::format("{} on a {}: {:.2f} cycles, published {}", row.what, traits_of(model).name,
                                      all - rest, row.cycles));
        }
}

TEST_CASE("sttimer takes 1 cycle and break 9, as the processor's own time says") {
    // A program cannot measure an instruction that sets the clock, or one that stops the processor.
    for (const Model model : every_model()) {
        const auto cycles_to_stop = [model](std::string_view source) {
            LinksWithoutWires links;
            Core core(model, 0x10000, {}, links);
            load_program(core, assemble(source, program_at, model), most_negative + 0x500);
            core.run(1000);
            CHECK(core.stopped() != Stopped::nothing);
            return static_cast<double>(core.local()) / 2;
        };
        CHECK(cycles_to_stop("sttimer; sethalterr; seterr") - cycles_to_stop("sethalterr; seterr") == 1 + 1);
        if (debugged & only(model))
            CHECK(cycles_to_stop("break") == 1 + 9);
    }
}

TEST_CASE("each instruction of each type has a row in the published tables") {
    for (const Model model : every_model()) {
        std::set<std::string_view> measured{"sttimer", "break", "fpentry"}; // fpentry is measured with what it enters
        for (const PublishedCycles& row : published_cycles)
            if (row.models & only(model))
                measured.insert(name_of(row.instruction));
        for (const PublishedWait& row : published_waits)
            measured.insert(row.instruction);
        if (with_reals & only(model))
            for (const PublishedRealCycles& row : published_real_cycles)
                measured.insert(row.instruction);
        for (int i = 0; i < static_cast<int>(Operation::go_on); ++i) {
            const Instruction& each = description_of(static_cast<Operation>(i));
            const bool here = each.unit == Unit::direct || (each.models & only(model));
            CHECK_MESSAGE((!here || measured.contains(each.name)), each.name, " of a ", traits_of(model).name);
        }
    }
}

} // namespace placedpar::transputer::cycles_by_the_clock
