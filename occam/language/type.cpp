#include "occam/language/type.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace placedpar::occam {

namespace {

struct BasicTraits {
    const char* name;
    std::uint32_t bytes;
};
constexpr std::array<BasicTraits, 8> basic_traits = {
    {{"BOOL", 1}, {"BYTE", 1}, {"INT", 4}, {"INT16", 2}, {"INT32", 4}, {"INT64", 8}, {"REAL32", 4}, {"REAL64", 8}}};

} // namespace

std::string name_of(Basic basic) { return basic_traits[static_cast<std::size_t>(basic)].name; }

std::uint32_t bytes_of(Basic basic) { return basic_traits[static_cast<std::size_t>(basic)].bytes; }

bool is_integer(Basic basic) { return basic != Basic::boolean && !is_real(basic); }

bool is_real(Basic basic) { return basic == Basic::real32 || basic == Basic::real64; }

const Type* Types::unique(const Type& type) {
    const auto equal = [&](const Type& other) {
        return other.kind == type.kind && other.basic == type.basic && other.element == type.element &&
               other.count == type.count && other.protocol == type.protocol;
    };
    const auto known = std::ranges::find_if(types_, equal);
    return known != types_.end() ? &*known : &types_.emplace_back(type);
}

const Type* Types::basic(Basic basic) { return unique({.kind = Type::Kind::basic, .basic = basic}); }

const Type* Types::array(const Type* element, std::optional<std::uint32_t> count) {
    return unique({.kind = Type::Kind::array, .element = element, .count = count});
}

const Type* Types::channel(const ProtocolType* protocol) {
    return unique({.kind = Type::Kind::channel, .protocol = protocol});
}

const Type* Types::port(const Type* element) { return unique({.kind = Type::Kind::port, .element = element}); }

const Type* Types::hardware(Type::Kind kind) { return unique({.kind = kind}); }
const Type* Types::timer() { return unique({.kind = Type::Kind::timer}); }

const Type* Types::mistaken() { return unique({.kind = Type::Kind::mistaken}); }

const Type* Types::record(const Declaration* declared, std::vector<Field> fields) {
    return &types_.emplace_back(Type{.kind = Type::Kind::record, .declared = declared, .fields = std::move(fields)});
}

const Type* Types::derived(const Declaration* declared, const Type* element) {
    return &types_.emplace_back(Type{.kind = Type::Kind::derived, .element = element, .declared = declared});
}

const ProtocolType* Types::protocol(ProtocolType protocol) {
    const auto equal = [&](const ProtocolType& other) {
        return !other.declared && other.kind == protocol.kind && other.items == protocol.items;
    };
    const auto known = protocol.declared ? protocols_.end() : std::ranges::find_if(protocols_, equal);
    return known != protocols_.end() ? &*known : &protocols_.emplace_back(std::move(protocol));
}

} // namespace placedpar::occam
