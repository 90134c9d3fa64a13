#include "occam/code/generator.hpp"

#include <algorithm>
#include <array>

namespace placedpar::occam {

using transputer::Operation;

const Type& Generator::plain(const Type& type) {
    return type.kind == Type::Kind::derived || type.kind == Type::Kind::port ? plain(*type.element) : type;
}

bool Generator::is_word(const Type& given) const {
    const Type& type = plain(given);
    return type.kind == Type::Kind::basic && bytes_of(type.basic) <= 4 && !is_real(type);
}

bool Generator::is_wide(const Type& given) {
    const Type& type = plain(given);
    return type.kind == Type::Kind::basic && bytes_of(type.basic) == 8;
}

bool Generator::is_real(const Type& type) const { return has_reals() && has_real_type(type); }

bool Generator::has_real_type(const Type& given) {
    const Type& type = plain(given);
    return type.kind == Type::Kind::basic && occam::is_real(type.basic);
}

bool Generator::is_channel(const Type& type) {
    return type.kind == Type::Kind::channel || (type.kind == Type::Kind::array && is_channel(*type.element));
}

std::int64_t Generator::size_of(const Type& given) {
    const Type& type = plain(given);
    if (type.kind == Type::Kind::channel || type.kind == Type::Kind::timer)
        return 4;
    if (type.kind == Type::Kind::array) {
        constexpr std::int64_t most = std::int64_t{1} << 40; // more bytes than any memory has
        const std::int64_t element = size_of(*type.element), count = type.count.value_or(1);
        return count == 0 ? 0 : element > most / count ? most : count * element;
    }
    return static_cast<std::int64_t>(bytes_of(type));
}

std::optional<std::int64_t> Generator::fixed_size(const Type& given) {
    const Type& type = plain(given);
    if (type.kind != Type::Kind::array)
        return size_of(type);
    const std::optional<std::int64_t> element = fixed_size(*type.element);
    return type.count && element ? std::optional(*type.count * *element) : std::nullopt;
}

Extent Generator::outer_extent(const Storage& location) const {
    const Type& type = plain(*location.type);
    return type.count ? Extent{*type.count} : location.extents.front();
}

std::optional<std::int64_t> Generator::fixed_bytes(const Storage& location) {
    std::int64_t size = size_of(*location.type);
    for (const Extent& extent : location.extents) {
        if (!extent.constant)
            return std::nullopt;
        size *= *extent.constant;
    }
    return size;
}

void Generator::load_size(const Storage& location) {
    if (const auto fixed = fixed_bytes(location))
        return constant(*fixed);
    const std::int64_t unit = size_of(*location.type);
    for (std::size_t i = 0; i < location.extents.size(); ++i) {
        load_extent(location.extents[i]);
        if (i > 0)
            op(Operation::prod);
    }
    if (unit == 4)
        op(Operation::bcnt);
    else if (unit != 1) {
        constant(unit);
        op(Operation::prod);
    }
}

std::optional<std::int64_t> Generator::constant_of(const Expression& e) {
    return e.constant && !e.constant->bytes ? std::optional(e.constant->bits) : std::nullopt;
}

const Type* Generator::basic(Basic basic) const {
    static const std::array<Type, 8> types = [] {
        std::array<Type, 8> all;
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i] = Type{.kind = Type::Kind::basic, .basic = static_cast<Basic>(i)};
        return all;
    }();
    return &types[static_cast<std::size_t>(basic)];
}

Storage Generator::locate(const Expression& e) {
    if (e.constant && !std::holds_alternative<Subscript>(e.form))
        return value_in_memory(e);
    if (const auto* name = std::get_if<NameUse>(&e.form))
        return bindings_.at(name->meaning);
    if (const auto* subscript = std::get_if<Subscript>(&e.form))
        return subscript->field ? locate_field(*subscript) : locate_element(*subscript);
    if (const auto* segment = std::get_if<Segment>(&e.form))
        return locate_segment(*segment);
    return value_in_memory(e);
}

Storage Generator::locate_field(const Subscript& subscript) {
    Storage location = locate(*subscript.array);
    if (location.has_index)
        finish_address(location);
    const Field& field = plain(*location.type).fields[*subscript.field];
    location.offset += field.offset;
    location.type = field.type;
    location.is_scalar = false;
    return location;
}

Storage Generator::locate_element(const Subscript& subscript) {
    Storage location = locate(*subscript.array);
    if (location.base == Storage::Base::computed && !location.has_index)
        location = pointer_to(location);
    const Extent extent = outer_extent(location);
    const Type& array = plain(*location.type);
    if (!array.count)
        location.extents.erase(location.extents.begin());
    location.type = array.element;
    location.is_scalar = false;
    const std::optional<std::int64_t> size = fixed_size(*array.element), index = constant_of(*subscript.index);
    if (index && size && !location.has_index && (extent.constant || !options_.range_checks))
        location.offset += *index * *size;
    else
        add_index(location, extent, *subscript.index);
    return location;
}

void Generator::add_index(Storage& location, const Extent& extent, const Expression& index) {
    if (!location.has_index) {
        expression(index);
        check_index(extent, index);
        location.has_index = true;
        return;
    }
    load_extent(extent);
    op(Operation::prod);
    if (std::max(depth_of(index), options_.range_checks ? 2 : 1) <= registers()) {
        expression(index);
        check_index(extent, index);
    } else {
        const Cell saved = temporary();
        store(saved);
        expression(index);
        check_index(extent, index);
        load(saved);
    }
    op(Operation::add);
}

void Generator::check_index(const Extent& extent, const Expression& index) {
    if (!options_.range_checks)
        return;
    const std::optional<Range> range = range_of(index);
    if (range && extent.constant && range->least >= 0 && range->most < *extent.constant)
        return;
    load_extent(extent);
    op(Operation::csub0);
    fails("subscript {b} is outside of an array of {a} elements");
}

std::optional<Range> Generator::range_of(const Expression& e) const {
    if (const auto value = constant_of(e))
        return Range{*value, *value};
    if (const auto* name = std::get_if<NameUse>(&e.form)) {
        const auto known = ranges_.find(name->meaning);
        return known == ranges_.end() ? std::nullopt : std::optional(known->second);
    }
    const auto* binary = std::get_if<BinaryOperation>(&e.form);
    if (!binary || (binary->operation != Operator::add && binary->operation != Operator::subtract))
        return std::nullopt;
    const std::optional<Range> left = range_of(*binary->left), right = range_of(*binary->right);
    if (!left || !right)
        return std::nullopt;
    return binary->operation == Operator::add ? Range{left->least + right->least, left->most + right->most}
                                              : Range{left->least - right->most, left->most - right->least};
}

const Type* Generator::array_of(const Type& element, std::optional<std::uint32_t> count) {
    for (const Type& each : arrays_)
        if (each.element == &element && each.count == count)
            return &each;
    return &arrays_.emplace_back(Type{.kind = Type::Kind::array, .element = &element, .count = count});
}

Storage Generator::pointer_to(Storage location) {
    if (location.is_static())
        return location;
    finish_address(location);
    location.cell = temporary();
    store(location.cell);
    location.base = Storage::Base::pointer;
    return location;
}

void Generator::load_base(Storage& location) {
    switch (location.base) {
    case Storage::Base::cell:
        load_address(location.cell.after(static_cast<int>(location.offset / 4)));
        location.offset %= 4;
        break;
    case Storage::Base::pointer: load(location.cell); break;
    case Storage::Base::absolute: op(Operation::mint); break;
    case Storage::Base::constant: {
        const Label here = emitter_.new_label();
        emitter_.difference(location.label, here, location.offset);
        count(1);
        op(Operation::ldpi);
        mark(here);
        location.offset = 0;
        break;
    }
    case Storage::Base::computed: break;
    }
}

/// Loads the address of a location without its offset. Afterwards the location is the offset from the address on the
/// register stack.
void Generator::finish_address(Storage& location) {
    if (!location.has_index) {
        load_base(location);
        location.base = Storage::Base::computed;
        return;
    }
    std::int64_t size = size_of(*location.type);
    if (!fixed_size(*location.type))
        for (const Extent& extent : location.extents) {
            load_extent(extent);
            op(Operation::prod);
        }
    const bool words = size % 4 == 0, doubles = size == 8 && has_reals();
    if (words && !doubles)
        size /= 4;
    if (size != 1 && !doubles) {
        constant(size);
        op(Operation::prod);
    }
    load_base(location);
    op(doubles ? Operation::wsubdb : words ? Operation::wsub : Operation::bsub);
    location.base = Storage::Base::computed;
    location.has_index = false;
}

void Generator::add_offset(std::int64_t bytes) {
    if (bytes % 4 == 0 && bytes != 0)
        op(Operation::ldnlp, bytes / 4);
    else if (bytes != 0)
        emitter_.put(Operation::adc, bytes);
}

void Generator::address(Storage location) {
    finish_address(location);
    add_offset(location.offset);
}

void Generator::load(Storage location) {
    const std::int64_t size = size_of(*location.type);
    const bool in_word = location.base == Storage::Base::cell && !location.has_index &&
                         (location.is_scalar || (size == 4 && location.offset % 4 == 0));
    if (size == 2)
        return load_int16(location);
    if (in_word)
        return load(location.cell.after(static_cast<int>(location.offset / 4)));
    finish_address(location);
    if (size == 4 && location.offset % 4 == 0)
        return op(Operation::ldnl, location.offset / 4);
    add_offset(location.offset);
    op(size == 4 ? Operation::ldnl : Operation::lb);
}

void Generator::load_int16(Storage location) {
    if (location.is_scalar) {
        load(location.cell);
    } else {
        address(location);
        const Cell at = temporary();
        store(at);
        load(at);
        op(Operation::adc, 1);
        op(Operation::lb);
        constant(8);
        op(Operation::shl);
        load(at);
        op(Operation::lb);
        op(Operation::or_);
    }
    constant(0x8000);
    op(Operation::xword);
}

void Generator::store(Storage location) {
    const std::int64_t size = size_of(*location.type);
    const bool in_word = location.base == Storage::Base::cell && !location.has_index &&
                         (location.is_scalar || (size == 4 && location.offset % 4 == 0));
    if (in_word) {
        settle();
        return store(location.cell.after(static_cast<int>(location.offset / 4)));
    }
    finish_address(location);
    settle();
    if (size == 4 && location.offset % 4 == 0)
        return op(Operation::stnl, location.offset / 4);
    add_offset(location.offset);
    if (size == 2)
        return store_int16();
    op(size == 4 ? Operation::stnl : Operation::sb);
}

/// Stores the two bytes of the value B at the address A.
void Generator::store_int16() {
    const Cell at = temporary(), value = temporary();
    store(at);
    store(value);
    load(value);
    load(at);
    op(Operation::sb);
    load(value);
    constant(8);
    op(Operation::shr);
    load(at);
    op(Operation::adc, 1);
    op(Operation::sb);
}

int Generator::depth_of_location(const Expression& e) const {
    if (const auto* subscript = std::get_if<Subscript>(&e.form)) {
        const int array = depth_of_location(*subscript->array);
        if (subscript->field)
            return array;
        const auto index = constant_of(*subscript->index);
        const bool is_static = array == 1 && index && fixed_size(*e.type) &&
                               (plain(*subscript->array->type).count || !options_.range_checks);
        if (is_static)
            return 1;
        const int own = std::max(depth_of(*subscript->index), 2);
        return array == 1 ? own : 3;
    }
    const bool is_name = std::holds_alternative<NameUse>(e.form) || e.constant;
    return is_name ? 1 : 3;
}

Storage Generator::in_workspace(const Type& type) {
    const std::int64_t size = size_of(type);
    return {.cell = temporary(static_cast<int>(std::max<std::int64_t>((size + 3) / 4, 1))),
            .type = &type,
            .is_scalar = size < 4 && !is_compound(plain(type))};
}

Storage Generator::in_vector_space(const Type& type) {
    const std::int64_t offset = level_->vector_now;
    level_->vector_now += (size_of(type) + 3) / 4 * 4;
    level_->vector_most = std::max(level_->vector_most, level_->vector_now);
    level_->uses_vector = true;
    Storage location{.base = Storage::Base::pointer, .cell = level_->vector, .type = &type};
    if (offset == 0)
        return location;
    load(level_->vector);
    add_offset(offset);
    location.cell = temporary();
    store(location.cell);
    return location;
}

Storage Generator::temporary_location(const Type& type) {
    return size_of(type) <= 8 || !options_.vector_space ? in_workspace(type) : in_vector_space(type);
}

Storage Generator::constant_in_memory(const Expression& e) {
    if (e.constant->bytes) {
        Storage location = bytes_constant(*e.type, *e.constant->bytes);
        if (plain(*e.type).kind == Type::Kind::array && !plain(*e.type).count)
            location.extents = {{static_cast<std::int64_t>(e.constant->bytes->size()) /
                                 std::max<std::int64_t>(size_of(*plain(*e.type).element), 1)}};
        return location;
    }
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(size_of(*e.type)));
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<std::uint8_t>(e.constant->bits >> 8 * i);
    return bytes_constant(*e.type, bytes);
}

Storage Generator::value_in_memory(const Expression& e) {
    if (e.constant)
        return constant_in_memory(e);
    if (std::holds_alternative<NameUse>(e.form) || std::holds_alternative<Subscript>(e.form) ||
        std::holds_alternative<Segment>(e.form))
        return locate(e);
    if (const auto* text = std::get_if<StringLiteral>(&e.form)) {
        const auto* first = reinterpret_cast<const std::uint8_t*>(text->bytes.data());
        return bytes_constant(*e.type, {first, text->bytes.size()});
    }
    if (const auto* conversion = std::get_if<Conversion>(&e.form); conversion && is_compound(plain(*e.type))) {
        Storage location = value_in_memory(*conversion->operand);
        location.type = e.type;
        return location;
    }
    Storage result = temporary_location(*e.type);
    if (const auto* table = std::get_if<TableLiteral>(&e.form))
        fill_table(*table, result);
    else if (std::holds_alternative<Call>(e.form) && !is_word(*e.type))
        call_function(e, {result});
    else if (const auto* values = std::get_if<ValueProcess>(&e.form))
        value_process(*values, [&] { assign_to(values->results.front(), result); });
    else
        assign_to(e, result);
    return result;
}

void Generator::fill_table(const TableLiteral& table, const Storage& to) {
    const Type& type = plain(*to.type);
    for (std::size_t i = 0; i < table.elements.size(); ++i) {
        Storage element = to;
        element.is_scalar = false;
        element.type = type.kind == Type::Kind::record ? type.fields[i].type : type.element;
        element.offset += type.kind == Type::Kind::record ? type.fields[i].offset
                                                          : static_cast<std::int64_t>(i) * size_of(*type.element);
        assign_to(table.elements[i], element);
    }
}

} // namespace placedpar::occam
