#include "occam/code/generator.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace placedpar::occam {

using transputer::Operation;

namespace {

/// Describes a predefined function for which the transputer has a single instruction on words.
struct WordFunction {
    std::string_view name;
    Operation operation;
    std::array<int, 3> operands; ///< indices of the arguments, in the order in which they are loaded; -1: none
    std::array<int, 3>
        results; ///< indices of the results, in the order in which they are taken from the register stack
    bool second_generation = false;
};

constexpr std::array<WordFunction, 14> word_functions = {{
    {"LONGADD", Operation::ladd, {2, 0, 1}, {0, -1, -1}},
    {"LONGSUM", Operation::lsum, {2, 0, 1}, {1, 0, -1}},
    {"LONGSUB", Operation::lsub, {2, 0, 1}, {0, -1, -1}},
    {"LONGDIFF", Operation::ldiff, {2, 0, 1}, {1, 0, -1}},
    {"LONGPROD", Operation::lmul, {2, 0, 1}, {1, 0, -1}},
    {"LONGDIV", Operation::ldiv, {0, 1, 2}, {0, 1, -1}},
    {"SHIFTLEFT", Operation::lshl, {0, 1, 2}, {1, 0, -1}},
    {"SHIFTRIGHT", Operation::lshr, {0, 1, 2}, {1, 0, -1}},
    {"NORMALISE", Operation::norm, {0, 1, -1}, {2, 1, 0}},
    {"FRACMUL", Operation::fmul, {0, 1, -1}, {0, -1, -1}},
    {"BITCOUNT", Operation::bitcnt, {1, 0, -1}, {0, -1, -1}, true},
    {"BITREVWORD", Operation::bitrevword, {0, -1, -1}, {0, -1, -1}, true},
    {"BITREVNBITS", Operation::bitrevnbits, {0, 1, -1}, {0, -1, -1}, true},
    {"CRCWORD", Operation::crcword, {2, 1, 0}, {0, -1, -1}, true},
}};

} // namespace

/// Generates a predefined function for which the transputer has instructions. Returns false for other functions.
bool Generator::predefined_call(const Expression& e, const Call& c, const std::vector<Storage>& results) {
    const bool left_in_register = results.empty();
    if (word_function(c, results))
        return true;
    if (predefined_shift(c)) {
        if (!left_in_register)
            store(results.front());
    } else if (!has_reals()) {
        return false;
    } else if (real_test(c)) {
        if (!left_in_register)
            store(results.front());
    } else if (real_function(e, c)) {
        if (!left_in_register)
            real_store(results.front());
    } else {
        return false;
    }
    return true;
}

bool Generator::word_function(const Call& c, const std::vector<Storage>& results) {
    const std::string_view name = c.name == "CRCBYTE" ? "CRCWORD" : std::string_view(c.name);
    const auto* function = std::ranges::find(word_functions, name, &WordFunction::name);
    if (function == word_functions.end() || (function->second_generation && options_.model == transputer::Model::t414))
        return false;
    std::vector<const Expression*> operands;
    for (const int each : function->operands)
        if (each >= 0)
            operands.push_back(&c.arguments[static_cast<std::size_t>(each)]);
    push(operands);
    op(c.name == "CRCBYTE" ? Operation::crcbyte : function->operation);
    const auto count_of = 3 - std::ranges::count(function->results, -1);
    stack_ = static_cast<int>(count_of);
    if (results.empty())
        return true;
    settle();
    const auto result = [&](std::ptrdiff_t i) {
        return results[static_cast<std::size_t>(function->results[static_cast<std::size_t>(i)])];
    };
    if (std::ranges::all_of(results, [](const Storage& each) { return each.base == Storage::Base::cell; })) {
        for (std::ptrdiff_t i = 0; i < count_of; ++i)
            store(result(i));
        return true;
    }
    std::array<Cell, 3> kept;
    for (std::ptrdiff_t i = 0; i < count_of; ++i)
        store(kept[static_cast<std::size_t>(i)] = temporary());
    for (std::ptrdiff_t i = 0; i < count_of; ++i) {
        load(kept[static_cast<std::size_t>(i)]);
        store(result(i));
    }
    return true;
}

/// Generates ASHIFTLEFT, ASHIFTRIGHT, ROTATELEFT and ROTATERIGHT.
bool Generator::predefined_shift(const Call& c) {
    const bool shifts = c.name == "ASHIFTLEFT" || c.name == "ASHIFTRIGHT", left = c.name.ends_with("LEFT");
    if (!shifts && c.name != "ROTATELEFT" && c.name != "ROTATERIGHT")
        return false;
    const Cell value = temporary(), places = temporary();
    expression(c.arguments[1]);
    store(places);
    expression(c.arguments[0]);
    if (shifts) {
        op(Operation::xdble);
    } else {
        store(value);
        if (left)
            constant(0);
        load(value);
        if (!left)
            constant(0);
    }
    load(places);
    op(left ? Operation::lshl : Operation::lshr);
    stack_ = 2;
    if (!shifts)
        op(Operation::or_);
    else if (left)
        op(Operation::csngl);
    stack_ = 1;
    return true;
}

bool Generator::real_test(const Call& c) {
    const std::string_view name = c.name.starts_with('D') ? std::string_view(c.name).substr(1) : c.name;
    const bool two = name == "ORDERED", one = name == "ISNAN" || name == "NOTFINITE";
    if (!two && !one)
        return false;
    stack_ = 0;
    real(c.arguments[0]);
    if (two)
        real_operands_behind(c.arguments[1]);
    op(two ? Operation::fpordered : name == "ISNAN" ? Operation::fpnan : Operation::fpnotfinite);
    reals_ = 0;
    return true;
}

/// Loads a second real on top of the real that is on the floating-point stack. If the second real needs all
/// floating-point registers, the first real is meanwhile in memory.
void Generator::real_operands_behind(const Expression& second) {
    if (depth_of_real(second) <= 3 - reals_)
        return real(second);
    const Storage first = in_workspace(*second.type);
    load_address(first.cell);
    op(bytes_of(*second.type) == 8 ? Operation::fpstnldb : Operation::fpstnlsn);
    --reals_;
    real(second);
    real_load(first);
    op(Operation::fprev);
}

bool Generator::real_function(const Expression& e, const Call& c) {
    const bool is_double = is_wide(*e.type);
    const std::string_view name =
        c.name.starts_with('D') && c.name != "DIVBY2" ? std::string_view(c.name).substr(1) : c.name;
    if (name == "MINUSX" || name == "COPYSIGN") {
        real_sign(c, name == "COPYSIGN");
        return true;
    }
    if (c.name == "REAL32REM" || c.name == "REAL64REM") {
        real_remainder(c.arguments[0], c.arguments[1]);
        return true;
    }
    constexpr std::array names = {"ABS", "SQRT", "MULBY2", "DIVBY2", "FPINT"};
    if (std::ranges::find(names, name) == names.end())
        return false;
    real(c.arguments[0]);
    if (name == "SQRT") {
        op(Operation::fpusqrtfirst);
        for (int i = 0; i < (is_double ? 5 : 2); ++i)
            op(Operation::fpusqrtstep);
        op(Operation::fpusqrtlast);
    } else {
        op(name == "ABS"      ? Operation::fpuabs
           : name == "MULBY2" ? Operation::fpumulby2
           : name == "DIVBY2" ? Operation::fpudivby2
                              : Operation::fpint);
    }
    return true;
}

/// Inverts the sign bit of a real in memory, or copies the sign bit of another real.
void Generator::real_sign(const Call& c, bool copies) {
    const bool is_double = is_wide(*c.arguments[0].type);
    const Operation store_real = is_double ? Operation::fpstnldb : Operation::fpstnlsn;
    const Storage value = in_workspace(*c.arguments[0].type), sign = in_workspace(*c.arguments[0].type);
    for (std::size_t i = 0; i < c.arguments.size(); ++i) {
        real(c.arguments[i]);
        load_address(i == 0 ? value.cell : sign.cell);
        op(store_real);
        --reals_;
    }
    const Cell upper = value.cell.after(is_double ? 1 : 0);
    load(upper);
    if (copies) {
        load(sign.cell.after(is_double ? 1 : 0));
        op(Operation::xor_);
    }
    op(Operation::mint);
    if (copies) {
        op(Operation::and_);
        load(upper);
    }
    op(Operation::xor_);
    store(upper);
    real_load(value);
}

void Generator::predefined_instance(const Process& p, const Instance& i) {
    if (i.name == "ASSERT") {
        const Label holds = emitter_.new_label();
        expression(i.arguments.front());
        settle();
        op(Operation::eqc, 0);
        jump_if_false(holds);
        stop_here("the condition of ASSERT is FALSE");
        return mark(holds);
    }
    if (i.name == "CAUSEERROR") {
        op(Operation::seterr);
        fails("CAUSEERROR");
        checked_ = true;
        return settle();
    }
    if (i.name == "RESCHEDULE") {
        load_base_of(*frame_);
        op(Operation::ldpri);
        op(Operation::or_);
        op(Operation::runp);
        op(Operation::stopp);
        frame_->need_below(3);
        return clear_error();
    }
    if (options_.model == transputer::Model::t414)
        return call(library_routine(p.at, i.name), pointers_to(i.arguments), {});
    move_in_two_dimensions(i);
}

/// Generates MOVE2D, DRAW2D and CLIP2D (source, sx, sy, target, tx, ty, width, length).
void Generator::move_in_two_dimensions(const Instance& i) {
    std::array<Cell, 2> starts;
    std::array<Extent, 2> strides;
    for (std::size_t side = 0; side < 2; ++side) {
        stack_ = 0;
        const Expression* const arguments = &i.arguments[3 * side];
        const Storage array = pointer_to(side == 0 ? value_in_memory(arguments[0]) : locate(arguments[0]));
        const Type& rows = *plain(*array.type).element;
        strides[side] = plain(rows).count ? Extent{*plain(rows).count} : array.extents.back();
        const Cell x = temporary();
        starts[side] = temporary();
        expression(arguments[1]);
        store(x);
        expression(arguments[2]);
        load_extent(strides[side]);
        op(Operation::prod);
        load(x);
        op(Operation::bsub);
        address(array);
        op(Operation::bsub);
        store(starts[side]);
    }
    const Cell width = temporary(), length = temporary();
    expression(i.arguments[6]);
    store(width);
    expression(i.arguments[7]);
    store(length);
    load_extent(strides[0]);
    load_extent(strides[1]);
    load(length);
    op(Operation::move2dinit);
    stack_ = 0;
    load(starts[0]);
    load(starts[1]);
    load(width);
    settle();
    op(i.name == "MOVE2D"   ? Operation::move2dall
       : i.name == "DRAW2D" ? Operation::move2dnonzero
                            : Operation::move2dzero);
    stack_ = 0;
}

} // namespace placedpar::occam
