#include "occam/code/emit.hpp"

#include "runtime/transputer/assembler.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>

namespace placedpar::occam {

using transputer::Operation;

namespace {

constexpr std::uint8_t operate = 15;

std::uint8_t function_code(Operation operation) {
    return static_cast<std::uint8_t>(transputer::description_of(operation).code);
}

/// Lays out code: computes the lengths and offsets of all elements.
class CodeLayout {
public:
    CodeLayout(std::vector<CodeElement> elements, Label labels)
        : elements_(std::move(elements)), offsets_(elements_.size() + 1), lengths_(elements_.size()), labels_(labels) {
        while (grow())
            ;
    }
    std::uint32_t offset(Label label) const { return labels_[label]; }
    std::uint32_t offset_at(std::size_t element) const { return offsets_[element]; }
    const std::vector<CodeElement>& elements() const { return elements_; }

    std::int64_t operand(std::size_t i) const {
        const CodeElement& element = elements_[i];
        switch (element.kind) {
        case CodeElement::Kind::cell: return element.value + coordinate_of(element.cell) - element.frame->coordinate;
        case CodeElement::Kind::remote: return element.value + coordinate_of(element.cell);
        case CodeElement::Kind::words: return element.value * element.frame->words();
        case CodeElement::Kind::branch:
            return std::int64_t{labels_[element.to]} - std::int64_t{offsets_[i]} -
                   static_cast<std::int64_t>(lengths_[i]);
        case CodeElement::Kind::difference:
            return element.value + std::int64_t{labels_[element.to]} - std::int64_t{labels_[element.from]};
        default: return element.value;
        }
    }

    std::vector<std::uint8_t> bytes_of(std::size_t i) const {
        if (lengths_[i] == 0)
            return {};
        if (!is_instruction(elements_[i]))
            return std::vector<std::uint8_t>(lengths_[i]);
        return transputer::encoded(elements_[i].function, static_cast<std::int32_t>(operand(i)), lengths_[i]);
    }

private:
    static bool is_instruction(const CodeElement& element) { return element.kind <= CodeElement::Kind::difference; }

    /// Computes offsets from lengths, and lengths from offsets. Returns whether an instruction became longer.
    bool grow() {
        std::uint32_t at = 0;
        for (std::size_t i = 0; i < elements_.size(); ++i) {
            offsets_[i] = at;
            if (elements_[i].kind == CodeElement::Kind::mark)
                labels_[elements_[i].to] = at;
            else if (elements_[i].kind == CodeElement::Kind::align)
                lengths_[i] = (4 - at % 4) % 4;
            else if (elements_[i].kind == CodeElement::Kind::data)
                lengths_[i] = static_cast<std::size_t>(elements_[i].value);
            at += static_cast<std::uint32_t>(lengths_[i]);
        }
        offsets_.back() = at;
        bool grown = false;
        for (std::size_t i = 0; i < elements_.size(); ++i)
            if (is_instruction(elements_[i]))
                grown |= grow(i);
        return grown;
    }

    bool grow(std::size_t i) {
        const std::int64_t value = operand(i);
        if (value == 0 && elements_[i].function == function_code(Operation::ajw))
            return false; // nothing to do
        const std::size_t needed =
            transputer::encoded(elements_[i].function, static_cast<std::int32_t>(value), elements_[i].least).size();
        if (needed <= lengths_[i])
            return false;
        lengths_[i] = needed;
        return true;
    }

    std::vector<CodeElement> elements_;
    std::vector<std::uint32_t> offsets_;
    std::vector<std::size_t> lengths_;
    std::vector<std::uint32_t> labels_;
};

} // namespace

void Emitter::put(Operation operation, std::int64_t operand) {
    const transputer::Instruction& instruction = transputer::description_of(operation);
    if (instruction.unit == transputer::Unit::direct) {
        buffer_->push_back({.function = function_code(operation), .value = operand});
    } else if (instruction.unit == transputer::Unit::selected) {
        put(Operation::ldc, instruction.code);
        put(Operation::fpentry);
    } else {
        buffer_->push_back({.function = operate, .value = instruction.code});
    }
}

void Emitter::put(Operation operation, const Cell& cell, const Frame& current, int words) {
    buffer_->push_back({.kind = CodeElement::Kind::cell,
                        .function = function_code(operation),
                        .value = words,
                        .cell = cell,
                        .frame = &current});
}

void Emitter::put_remote(Operation operation, const Cell& cell, int words) {
    buffer_->push_back(
        {.kind = CodeElement::Kind::remote, .function = function_code(operation), .value = words, .cell = cell});
}

void Emitter::put_words(Operation operation, const Frame& frame, int factor) {
    buffer_->push_back(
        {.kind = CodeElement::Kind::words, .function = function_code(operation), .value = factor, .frame = &frame});
}

void Emitter::branch(Operation operation, Label to, std::uint8_t least_bytes) {
    buffer_->push_back(
        {.kind = CodeElement::Kind::branch, .least = least_bytes, .function = function_code(operation), .to = to});
}

void Emitter::difference(Label to, Label from, std::int64_t more) {
    buffer_->push_back({.kind = CodeElement::Kind::difference,
                        .function = function_code(Operation::ldc),
                        .value = more,
                        .to = to,
                        .from = from});
}

void Emitter::address(Label label) {
    const Label here = new_label();
    difference(label, here);
    put(Operation::ldpi);
    mark(here);
}

void Emitter::mark(Label label) { buffer_->push_back({.kind = CodeElement::Kind::mark, .to = label}); }

void Emitter::line(const Place& place) {
    place_ = place;
    if (buffer_ != nullptr) // a declaration outside of all procedures has no code
        buffer_->push_back({.kind = CodeElement::Kind::line, .place = place});
}

void Emitter::name(std::string text) {
    buffer_->push_back({.kind = CodeElement::Kind::name, .value = static_cast<std::int64_t>(names_.size())});
    names_.push_back(std::move(text));
}

void Emitter::error(std::string text, std::vector<Cell> cells, const Frame& current, int moved) {
    buffer_->push_back({.kind = CodeElement::Kind::error, .value = static_cast<std::int64_t>(errors_.size())});
    errors_.push_back({std::move(text), std::move(cells), &current, moved});
}

/// Returns the text in which each {w} or {l} also has the offset of its cell from the workspace pointer, in words:
/// "{w+3}".
std::string Emitter::ErrorMeaning::with_offsets() const {
    std::string result = text;
    std::size_t at = 0;
    for (const Cell& each : cells) {
        at = std::min(result.find("w}", at), result.find("l}", at)) + 1;
        result.insert(at, fmt::format("{:+}", coordinate_of(each) - frame->coordinate + moved));
    }
    return result;
}

Label Emitter::constant(std::span<const std::uint8_t> bytes, bool aligned) {
    std::string key(bytes.begin(), bytes.end());
    key += aligned ? 'w' : 'b';
    const auto [known, is_new] = constant_of_.try_emplace(std::move(key), constants_.size());
    if (is_new)
        constants_.push_back({{bytes.begin(), bytes.end()}, aligned, new_label()});
    return constants_[known->second].label;
}

Code Emitter::finish(const std::vector<const CodeBuffer*>& buffers, Label entry) {
    std::vector<CodeElement> all;
    for (const CodeBuffer* each : buffers)
        all.insert(all.end(), each->begin(), each->end());
    const std::size_t first_constant = all.size();
    for (const ConstantBytes& each : constants_) {
        if (each.aligned)
            all.push_back({.kind = CodeElement::Kind::align});
        all.push_back({.kind = CodeElement::Kind::mark, .to = each.label});
        all.push_back({.kind = CodeElement::Kind::data, .value = static_cast<std::int64_t>(each.bytes.size())});
    }
    all.push_back({.kind = CodeElement::Kind::align});
    all.push_back({.kind = CodeElement::Kind::mark, .to = end_of_code});
    const CodeLayout layout(std::move(all), labels_);
    Code code;
    for (std::size_t i = 0; i < layout.elements().size(); ++i) {
        const CodeElement& element = layout.elements()[i];
        if (element.kind == CodeElement::Kind::line) {
            if (!code.lines.empty() && code.lines.back().offset == layout.offset_at(i))
                code.lines.pop_back();
            if (code.lines.empty() || code.lines.back().place != element.place)
                code.lines.push_back({layout.offset_at(i), element.place});
        } else if (element.kind == CodeElement::Kind::name) {
            code.names.push_back({layout.offset_at(i), names_[static_cast<std::size_t>(element.value)]});
        } else if (element.kind == CodeElement::Kind::error) {
            code.errors.push_back(
                {layout.offset_at(i), errors_[static_cast<std::size_t>(element.value)].with_offsets()});
        }
        const std::vector<std::uint8_t> bytes = layout.bytes_of(i);
        code.bytes.insert(code.bytes.end(), bytes.begin(), bytes.end());
    }
    for (const ConstantBytes& each : constants_)
        std::ranges::copy(each.bytes, code.bytes.begin() + static_cast<std::ptrdiff_t>(layout.offset(each.label)));
    code.entry = layout.offset(entry);
    code.constants = layout.offset_at(first_constant);
    return code;
}

bool may_set_error(Operation operation) {
    switch (operation) {
    case Operation::add:
    case Operation::sub:
    case Operation::adc:
    case Operation::mul:
    case Operation::div:
    case Operation::rem:
    case Operation::fmul:
    case Operation::ladd:
    case Operation::lsub:
    case Operation::ldiv:
    case Operation::csub0:
    case Operation::ccnt1:
    case Operation::cword:
    case Operation::csngl:
    case Operation::cflerr:
    case Operation::fpchkerror: return true;
    default: return false;
    }
}

namespace {

using Operations = std::initializer_list<Operation>;

constexpr Operations that_push = {Operation::ldc,       Operation::ldl,        Operation::ldlp,    Operation::mint,
                                  Operation::dup,       Operation::xdble,      Operation::ldtimer, Operation::ldpri,
                                  Operation::testerr,   Operation::fpgt,       Operation::fpeq,    Operation::fpnan,
                                  Operation::fpordered, Operation::fpnotfinite};
constexpr Operations that_pop = {
    Operation::stl,        Operation::cj,          Operation::add,         Operation::sub,
    Operation::sum,        Operation::diff,        Operation::mul,         Operation::prod,
    Operation::fmul,       Operation::div,         Operation::rem,         Operation::gt,
    Operation::and_,       Operation::or_,         Operation::xor_,        Operation::shl,
    Operation::shr,        Operation::bsub,        Operation::wsub,        Operation::wsubdb,
    Operation::csub0,      Operation::ccnt1,       Operation::xword,       Operation::cword,
    Operation::csngl,      Operation::fpldnlsn,    Operation::fpldnldb,    Operation::fpstnlsn,
    Operation::fpstnldb,   Operation::fpstnli32,   Operation::fpi32tor32,  Operation::fpi32tor64,
    Operation::fpb32tor64, Operation::fpldnladdsn, Operation::fpldnladddb, Operation::fpldnlmulsn,
    Operation::fpldnlmuldb};
constexpr Operations that_pop_two = {Operation::stnl, Operation::sb, Operation::fpldnlsni, Operation::fpldnldbi};

bool is_among(Operation operation, const Operations& all) {
    return std::find(all.begin(), all.end(), operation) != all.end();
}

} // namespace

int stack_effect(Operation operation) {
    return is_among(operation, that_push)      ? 1
           : is_among(operation, that_pop)     ? -1
           : is_among(operation, that_pop_two) ? -2
                                               : 0;
}

} // namespace placedpar::occam
