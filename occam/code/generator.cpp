#include "occam/code/generator.hpp"

#include "text/refused_text.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

namespace placedpar::occam {

using transputer::Operation;

Generator::Generator(const Program& program, const CodeOptions& options) : program_(program), options_(options) {}

void Generator::refuse(const Place& place, const std::string& what) const {
    Diagnostic diagnostic = error_at(place.line, place.column, what);
    diagnostic.location.file = program_.files[place.file];
    throw RefusedText({std::move(diagnostic)});
}

void Generator::count(int effect) {
    stack_ = std::max(stack_ + effect, 0);
    if (stack_ > 3)
        throw std::logic_error("an expression needs more than three registers, at line " +
                               std::to_string(emitter_.place().line));
}

void Generator::op(Operation operation, std::int64_t operand) {
    emitter_.put(operation, operand);
    count(stack_effect(operation));
    checked_ = checked_ || may_set_error(operation);
}

namespace {

/// Returns the number of bytes that an ldc has with its prefixes: one byte for each hexadecimal digit of the constant.
int digits_of(std::int64_t value) {
    const auto word = static_cast<std::int32_t>(value);
    return static_cast<int>(
        8 - static_cast<unsigned>(__builtin_clz(static_cast<unsigned>(word < 0 ? ~word : word) | 1)) / 4);
}

} // namespace

void Generator::constant(std::int64_t value) {
    const auto word = static_cast<std::uint32_t>(value);
    if (word == transputer::most_negative)
        return op(Operation::mint);
    if (digits_of(value) <= 6)
        return op(Operation::ldc, static_cast<std::int32_t>(word));
    auto& constants = level_->constants;
    const auto known = std::ranges::find(constants, word) - constants.begin();
    if (static_cast<std::size_t>(known) == constants.size())
        constants.push_back(word);
    load(level_->table);
    op(Operation::ldnl, known);
    level_->uses_table = true;
}

void Generator::load_frame_of(const Level& level) {
    if (&level == level_) {
        emitter_.put(Operation::ldlp, Cell{&level_->main, Cell::Area::base, 0}, *frame_);
        return count(1);
    }
    emitter_.put(Operation::ldl, level_->link, *frame_);
    level_->main.use(level_->link, weight_);
    level_->uses_link = true;
    count(1);
    for (Level* each = level_->outer; each != &level; each = each->outer) {
        emitter_.put_remote(Operation::ldnl, each->link);
        each->uses_link = true;
    }
}

void Generator::load(const Cell& cell) {
    cell.frame->use(cell, weight_);
    cell.frame->level->uses_vector |= cell.area == Cell::Area::vector;
    if (cell.frame->level != level_) {
        load_frame_of(*cell.frame->level);
        return emitter_.put_remote(Operation::ldnl, cell);
    }
    emitter_.put(Operation::ldl, cell, *frame_);
    count(1);
}

void Generator::store(const Cell& cell) {
    cell.frame->use(cell, weight_);
    if (cell.frame->level != level_) {
        load_frame_of(*cell.frame->level);
        emitter_.put_remote(Operation::stnl, cell);
        return count(-2);
    }
    emitter_.put(Operation::stl, cell, *frame_);
    count(-1);
}

void Generator::load_address(const Cell& cell) {
    cell.frame->use(cell, weight_);
    if (cell.frame->level != level_) {
        load_frame_of(*cell.frame->level);
        return emitter_.put_remote(Operation::ldnlp, cell);
    }
    emitter_.put(Operation::ldlp, cell, *frame_);
    count(1);
}

void Generator::load_extent(const Extent& extent, std::int64_t more) {
    if (extent.constant)
        return constant(*extent.constant + more);
    load(extent.cell);
    if (more != 0)
        op(Operation::adc, more);
}

void Generator::jump(Label label) { emitter_.branch(Operation::j, label); }

void Generator::jump_if_false(Label label) {
    emitter_.branch(Operation::cj, label);
    count(-1);
}

void Generator::mark(Label label) { emitter_.mark(label); }

void Generator::settle() {
    if (!halts() && checked_)
        op(Operation::stoperr);
    checked_ = false;
}

void Generator::clear_error() {
    if (!halts()) {
        emitter_.put(Operation::testerr);
        checked_ = false;
    }
}

void Generator::fails(ErrorText error, int moved) {
    if (is_library_)
        return emitter_.error("called from {w}", {level_->link.after(-1)}, *frame_);
    emitter_.error(std::move(error.text), std::move(error.cells), *frame_, moved);
}

void Generator::stop_here(const ErrorText& why) {
    if (options_.mode != ErrorMode::stop) {
        op(Operation::seterr);
        fails(why);
    }
    op(Operation::stopp);
    fails(why);
    frame_->need_below(3);
}

void Generator::loop(const Cell& control, Label start, const std::function<void()>& body) {
    {
        const Kept weight(weight_, weight_ * 8);
        mark(start);
        clear_error();
        body();
        load_address(control);
        const Label end = emitter_.new_label();
        emitter_.difference(end, start);
        count(1);
        control.frame->use(control, weight_);
        op(Operation::lend);
        mark(end);
    }
    stack_ = 0;
    frame_->need_below(3);
}

Storage Generator::bytes_constant(const Type& type, std::span<const std::uint8_t> bytes) {
    Storage location{.base = Storage::Base::constant, .label = emitter_.constant(bytes, true), .type = &type};
    return location;
}

} // namespace placedpar::occam
