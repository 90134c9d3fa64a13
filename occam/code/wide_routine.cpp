#include "occam/code/generator.hpp"
#include "runtime/transputer/assembler.hpp"

#include <string>

namespace placedpar::occam {

using transputer::Operation;

namespace {

/// Number of words below the caller's workspace that the routines use. The routines multiply and divide values of type
/// INT64.
constexpr int words_of_routine = 20;

/// Assembler text, to which the texts below are added. Copies the magnitudes of the operands, whose addresses are in
/// words 13 and 14, to words 0 to 3. Stores their signs in words 4 and 5.
constexpr const char* take_magnitudes = R"(
        ajw -12
        ldl 13; ldnl 0; stl 0; ldl 13; ldnl 1; stl 1
        ldl 14; ldnl 0; stl 2; ldl 14; ldnl 1; stl 3
        ldc 0; ldl 1; gt; stl 4
        ldc 0; ldl 3; gt; stl 5
        ldl 4; cj left
        ldc 0; ldc 0; ldl 0; ldiff; stl 0; ldc 0; ldl 1; ldiff; stl 1
left:   ldl 5; cj right
        ldc 0; ldc 0; ldl 2; ldiff; stl 2; ldc 0; ldl 3; ldiff; stl 3
right:
)";

/// Stores the number in words 6 and 7 at the address in word 15, with the sign in word 4. Sets the error flag if the
/// number does not fit in an INT64.
constexpr const char* give_result = R"(
        ldl 4; cj positive
        ldc 0; ldc 0; ldl 6; ldiff; stl 6; ldc 0; ldl 7; ldiff; stl 7
        ldl 6; ldl 7; or; cj fits               -- zero
        ldc 0; ldl 7; gt; eqc 0; cj fits
        seterr; j fits
positive:
        ldc 0; ldl 7; gt; cj fits
        seterr
fits:   ldl 6; ldl 15; stnl 0
        ldl 7; ldl 15; stnl 1
        ajw 12; ret
)";

constexpr const char* multiply = R"(
        ldl 1; cj small
        ldl 3; cj small
        seterr                                  -- both have upper halves
small:  ldc 0; ldl 0; ldl 2; lmul; stl 6; stl 7
        ldl 7; ldl 1; ldl 2; lmul; stl 7; stl 8
        ldl 7; ldl 0; ldl 3; lmul; stl 7; ldl 8; or; cj exact
        seterr
exact:  ldl 4; ldl 5; xor; stl 4
)";

/// Divides words 0 and 1 by words 2 and 3. Leaves the quotient in words 0 and 1, and the remainder in words 6 and 7.
constexpr const char* divide = R"(
        ldl 2; ldl 3; or; eqc 0; cj proper
        seterr; ajw 12; ret                     -- division by zero
proper: ldc 0; stl 6; ldc 0; stl 7
        ldl 3; cj short
        ldc 0; stl 8; ldc 64; stl 9
loop:   ldl 7; ldl 6; ldc 1; lshl; stl 6; stl 7
        ldl 1; ldc 31; shr; ldl 6; or; stl 6
        ldl 1; ldl 0; ldc 1; lshl; stl 0; stl 1
        ldc 0; ldl 6; ldl 2; ldiff; stl 10; ldl 7; ldl 3; ldiff; stl 11
        cj take
        j next
take:   ldl 10; stl 6; ldl 11; stl 7
        ldl 0; ldc 1; or; stl 0
next:   ldlp 8; ldc done - loop; lend
done:   j divided
short:  ldc 0; ldl 1; ldl 2; ldiv; stl 1; stl 7
        ldl 7; ldl 0; ldl 2; ldiv; stl 0; stl 6
        ldc 0; stl 7
divided:
)";
constexpr const char* quotient = R"(
        ldl 0; stl 6; ldl 1; stl 7
        ldl 4; ldl 5; xor; stl 4
)";

} // namespace

/// Generates a call of a routine with the addresses of both operands and of the result.
void Generator::wide_routine(WideRoutine which, const Wide& left, const Wide& right, const Cell& to) {
    std::string source = take_magnitudes;
    source += which == WideRoutine::multiply ? multiply : divide;
    source += which == WideRoutine::divide ? quotient : "";
    source += give_result;
    const Label entry = emitter_.constant(transputer::assemble(source).bytes, true);
    const Cell a = wide_variable(left).cell, b = wide_variable(right).cell;
    stack_ = 0;
    load_address(to);
    load_address(b);
    load_address(a);
    settle();
    const int moved = words_moved(0);
    const char* const operation = which == WideRoutine::multiply ? "*" : which == WideRoutine::divide ? "/" : "\\";
    call_moved(entry, moved, wide_error({.cell = a}, operation, {.cell = b}));
    stack_ = 0;
    frame_->need_below(words_of_routine + moved);
    checked_ = true;
    settle();
}

} // namespace placedpar::occam
