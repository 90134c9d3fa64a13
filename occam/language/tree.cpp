#include "occam/language/tree.hpp"

#include <algorithm>

namespace placedpar::occam {

namespace {

std::string name_of(const ProtocolItem& item) {
    return item.count ? name_of(*item.count) + "::" + name_of(*item.type) : name_of(*item.type);
}

std::string name_of(const ProtocolType& protocol) {
    if (protocol.declared)
        return protocol.declared->name;
    if (protocol.kind == ProtocolType::Kind::any)
        return "ANY";
    std::string text;
    for (const ProtocolItem& item : protocol.items)
        text += (text.empty() ? "" : "; ") + name_of(item);
    return text;
}

/// Returns the size of a record. Unless the record is packed, the size is a whole number of words, so that the elements
/// of arrays are aligned.
std::uint64_t bytes_of_record(const Type& record) {
    if (record.fields.empty())
        return 0;
    const std::uint64_t end = record.fields.back().offset + bytes_of(*record.fields.back().type);
    const auto* written = std::get_if<DataType>(&record.declared->form);
    return written && written->is_packed ? end : (end + 3) / 4 * 4;
}

} // namespace

std::string name_of(const Type& type) {
    switch (type.kind) {
    case Type::Kind::basic: return name_of(type.basic);
    case Type::Kind::array:
        return "[" + (type.count ? std::to_string(*type.count) : std::string()) + "]" + name_of(*type.element);
    case Type::Kind::record:
    case Type::Kind::derived: return type.declared->name;
    case Type::Kind::channel: return "CHAN OF " + name_of(*type.protocol);
    case Type::Kind::timer: return "TIMER";
    case Type::Kind::port: return "PORT OF " + name_of(*type.element);
    case Type::Kind::node: return "NODE";
    case Type::Kind::arc: return "ARC";
    case Type::Kind::edge: return "EDGE";
    case Type::Kind::mistaken: break;
    }
    return "a type in error";
}

std::uint64_t bytes_of(const Type& type) {
    switch (type.kind) {
    case Type::Kind::array: return std::uint64_t{type.count.value_or(0)} * bytes_of(*type.element);
    case Type::Kind::derived: return bytes_of(*type.element);
    case Type::Kind::record: return bytes_of_record(type);
    default: return bytes_of(type.basic);
    }
}

bool carries_host_protocol(const Type& type) {
    if (type.kind != Type::Kind::channel)
        return false;
    const ProtocolType& protocol = *type.protocol;
    return protocol.kind == ProtocolType::Kind::any ||
           (protocol.kind == ProtocolType::Kind::sequence && protocol.items.size() == 1 && protocol.items[0].count &&
            protocol.items[0].type->element->is(Basic::byte));
}

std::uint32_t word_alignment_of(const Type& type) {
    constexpr std::uint32_t word = 4;
    switch (type.kind) {
    case Type::Kind::array:
    case Type::Kind::derived: return word_alignment_of(*type.element);
    case Type::Kind::record:
        return std::ranges::any_of(type.fields,
                                   [](const Field& field) { return word_alignment_of(*field.type) == word; })
                   ? word
                   : 1;
    case Type::Kind::basic: return bytes_of(type.basic) >= word ? word : 1;
    default: return word;
    }
}

} // namespace placedpar::occam
