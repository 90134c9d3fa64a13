#include "occam/code/generator.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar::occam {

using transputer::Operation;

void Generator::declare(const Declaration& d) {
    const Placed placed(emitter_, d.start);
    declare_here(d);
    settle(); // also if the name is never used
}

void Generator::declare_here(const Declaration& d) {
    if (const auto* variable = std::get_if<Variable>(&d.form))
        return declare_variable(d, *variable);
    if (const auto* abbreviation = std::get_if<Abbreviation>(&d.form))
        return abbreviate(d, abbreviation->value, abbreviation->is_value);
    if (const auto* retyping = std::get_if<Retyping>(&d.form))
        return retype(d, *retyping);
    if (std::holds_alternative<Procedure>(d.form) || std::holds_alternative<Function>(d.form))
        declare_routine(d);
}

void Generator::declare_variable(const Declaration& d, const Variable& variable) {
    stack_ = 0;
    constexpr std::int64_t most_bytes = 1 << 28;
    if (size_of(*d.type) > most_bytes)
        refuse(d.at, fmt::format("\"{}\" needs {} bytes; a variable can have at most {}", d.name, size_of(*d.type),
                                 most_bytes));
    if (is_channel(*d.type) || d.type->kind == Type::Kind::port)
        return declare_channels(d);
    const Type& type = plain(*d.type);
    if (type.kind == Type::Kind::timer ||
        (type.kind == Type::Kind::array && plain(*type.element).kind == Type::Kind::timer))
        return;
    if (d.placement && d.placement->where == Placement::Where::address)
        refuse(d.at, "only channels and ports can be placed at an address");
    const bool in_frame = d.placement ? d.placement->where == Placement::Where::workspace
                                      : !is_compound(type) || size_of(type) <= 8 || !options_.vector_space;
    const Storage location = in_frame ? in_workspace(*d.type) : in_vector_space(*d.type);
    bindings_[&d] = location;
    if (variable.initial) {
        assign_to(*variable.initial, location);
    } else if (location.is_scalar) {
        constant(0); // clears the whole word, since an input or a procedure may later write only its lowest byte
        store(location.cell);
    }
}

namespace {

/// Returns how many channels an array of channels has.
std::int64_t channels_of(const Type& type) {
    return type.kind == Type::Kind::array ? *type.count * channels_of(*type.element) : 1;
}

} // namespace

/// Makes a word for each declared channel. An array of channels is an array of pointers to such words.
void Generator::declare_channels(const Declaration& d) {
    const bool placed = d.placement && d.placement->where == Placement::Where::address;
    const std::int64_t at = placed ? *constant_of(*d.placement->address) : 0;
    if (d.type->kind == Type::Kind::port && !placed)
        refuse(d.at, fmt::format("PORT \"{0}\" is not placed; write PLACE {0} AT n:", d.name));
    if (d.type->kind == Type::Kind::port || (placed && d.type->kind == Type::Kind::channel)) {
        bindings_[&d] = {.base = Storage::Base::absolute, .offset = 4 * at, .type = d.type};
        return;
    }
    if (d.type->kind == Type::Kind::channel) {
        bindings_[&d] = in_workspace(*d.type);
        op(Operation::mint);
        return store(bindings_[&d].cell);
    }
    const std::int64_t count = channels_of(*d.type);
    const Type& words = *array_of(*basic(Basic::integer), static_cast<std::uint32_t>((placed ? 1 : 2) * count));
    Storage pointers = count <= 8 || !options_.vector_space ? in_workspace(words) : in_vector_space(words);
    pointers.type = d.type;
    bindings_[&d] = pointers;
    if (count <= 4 || placed) {
        for (std::int64_t i = 0; i < count; ++i) {
            Storage pointer = pointers;
            pointer.offset += 4 * i;
            Storage channel = placed ? Storage{.base = Storage::Base::absolute, .offset = 4 * (at + i)} : pointers;
            channel.offset += placed ? 0 : 4 * (count + i);
            pointer.type = channel.type = basic(Basic::integer);
            address(channel);
            store(pointer);
            if (!placed) {
                op(Operation::mint);
                store(channel);
            }
        }
        return;
    }
    make_channels(pointers, count);
}

/// Generates a loop that makes the channels of an array. The words of the channels follow the array of pointers.
void Generator::make_channels(Storage pointers, std::int64_t count) {
    const Cell control = temporary(2);
    pointers.type = basic(Basic::integer);
    Storage channels = pointers;
    channels.offset += 4 * count;
    constant(0);
    store(control);
    constant(count);
    store(control.after(1));
    loop(control, emitter_.new_label(), [&] {
        const auto element = [&](Storage location) {
            load(control);
            location.has_index = true;
            return location;
        };
        op(Operation::mint);
        store(element(channels));
        address(element(channels));
        store(element(pointers));
    });
}

/// Returns the location with `type` in place of its own type. Sizes of dimensions that `type` leaves open are those of
/// the location. REQUIRES: both types have the same number of dimensions.
Storage Generator::seen_as(Storage location, const Type& type) {
    std::vector<Extent> extents;
    Storage rest = location;
    for (const Type* each = &type; plain(*each).kind == Type::Kind::array; each = plain(*each).element) {
        const Extent extent = outer_extent(rest);
        if (!plain(*each).count)
            extents.push_back(extent);
        if (!plain(*rest.type).count)
            rest.extents.erase(rest.extents.begin());
        rest.type = plain(*rest.type).element;
    }
    location.extents = std::move(extents);
    location.type = &type;
    return location;
}

void Generator::abbreviate(const Declaration& d, const Expression& value, bool is_value) {
    stack_ = 0;
    if (is_channel(*d.type)) {
        if (d.type->kind == Type::Kind::array) {
            bindings_[&d] = seen_as(pointer_to(locate(value)), *d.type);
        } else if (const auto* name = std::get_if<NameUse>(&value.form)) {
            bindings_[&d] = bindings_.at(name->meaning);
        } else {
            channel(value);
            const Cell pointer = temporary();
            store(pointer);
            bindings_[&d] = {.base = Storage::Base::pointer, .cell = pointer, .type = d.type};
        }
        return;
    }
    if (d.type->kind == Type::Kind::timer)
        return;
    if (is_compound(plain(*d.type))) {
        if (!level_ && !value.constant)
            refuse(d.at, fmt::format("the value of \"{}\" is not known at compile time: declare it inside a procedure",
                                     d.name));
        const Storage location = is_value ? value_in_memory(value) : locate(value);
        bindings_[&d] = seen_as(level_ ? pointer_to(location) : location, *d.type);
    } else if (!is_value) {
        Storage location = pointer_to(locate(value));
        location.type = d.type;
        bindings_[&d] = location;
    } else if (!value.constant) {
        bindings_[&d] = in_workspace(*d.type);
        assign_to(value, bindings_[&d]);
    }
}

/// Returns whether the address of a location is certainly a multiple of 4.
bool Generator::is_aligned(const Storage& location) {
    if (word_alignment_of(*location.type) > 1)
        return true; // such values are always aligned
    const bool begins_at_word = location.base == Storage::Base::cell || location.base == Storage::Base::constant;
    return begins_at_word && !location.has_index && location.offset % 4 == 0;
}

/// Generates code that makes the bytes of a retyped value begin at a multiple of 4, as the instructions for words need.
/// Values of fixed size are copied. Otherwise the program stops if the address is wrong. Returns the new location.
Storage Generator::aligned(const Storage& location, const Declaration& d, bool is_value) {
    const auto bytes = fixed_bytes(location);
    stack_ = 0;
    if (is_value && bytes) {
        Storage copied = temporary_location(*array_of(*basic(Basic::byte), static_cast<std::uint32_t>(*bytes)));
        copy(location, copied);
        stack_ = 0;
        return copied;
    }
    if (options_.range_checks) {
        address(location);
        constant(3);
        op(Operation::and_);
        constant(1);
        op(Operation::csub0);
        fails(fmt::format("the address of \"{}\" is not a multiple of 4, so its bytes cannot be used as {}", d.name,
                          name_of(*d.type)));
        stack_ = 0;
    }
    return location;
}

void Generator::retype(const Declaration& d, const Retyping& r) {
    stack_ = 0;
    if (!level_ && !r.value.constant)
        refuse(d.at,
               fmt::format("the value of \"{}\" is not known at compile time: declare it inside a procedure", d.name));
    Storage location = r.is_value ? value_in_memory(r.value) : locate(r.value);
    if (level_)
        location = pointer_to(location);
    if (level_ && word_alignment_of(*d.type) > 1 && !is_aligned(location))
        location = aligned(location, d, r.is_value);
    const Type& type = plain(*d.type);
    const std::int64_t unit = size_of(*d.type);
    std::vector<Extent> extents;
    if (type.kind == Type::Kind::array && !fixed_size(type)) {
        if (const auto bytes = fixed_bytes(location)) {
            extents = {{*bytes / unit}};
        } else {
            load_size(location);
            constant(unit);
            op(Operation::div);
            extents = {{std::nullopt, temporary()}};
            store(extents.front().cell);
        }
    }
    location.is_scalar = location.is_scalar && size_of(*location.type) == unit && !is_compound(type);
    location.type = d.type;
    location.extents = std::move(extents);
    bindings_[&d] = location;
}

} // namespace placedpar::occam
