#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::occam {

struct Declaration; // occam/language/tree.hpp

/// Lists the types of single values. INT has 32 bits, but is another type than INT32.
enum class Basic : std::uint8_t { boolean, byte, integer, int16, int32, int64, real32, real64 };

/// Returns the type's name in occam, such as "REAL32".
std::string name_of(Basic);
/// Returns the number of bytes of a value in memory and on a channel, such as 1 for BOOL and BYTE.
std::uint32_t bytes_of(Basic);
bool is_integer(Basic); ///< BYTE, INT, INT16, INT32, INT64
bool is_real(Basic);

struct Type;

/// Describes a field of a record.
struct Field {
    std::string name;
    const Type* type = nullptr;
    std::uint32_t offset = 0; ///< bytes from the start of the record
};

/// Describes a type of an occam program. Only the class Types makes types, and makes each type once. Two types are
/// therefore equal if their addresses are equal.
struct Type {
    enum class Kind : std::uint8_t {
        basic,
        array,
        record,  ///< DATA TYPE ... RECORD
        derived, ///< DATA TYPE T IS element
        channel, ///< a single channel; its protocol is `protocol`
        timer,
        port, ///< a port for values of type `element`
        node, ///< node, arc and edge exist only in configurations
        arc,
        edge,
        mistaken ///< type of an expression with an error; it agrees with every type, so that one error does not cause
                 ///< others
    };
    Kind kind = Kind::mistaken;
    Basic basic = Basic::integer;
    const Type* element =
        nullptr; ///< type of the elements of an array, the base of a derived type, or the values of a port
    std::optional<std::uint32_t> count = {};       ///< number of elements of an array; nothing for an open array `[]T`
    const struct ProtocolType* protocol = nullptr; ///< protocol of a channel
    const Declaration* declared = nullptr;         ///< declaration of a record or a derived type
    std::vector<Field> fields = {};                ///< fields of a record, in the order of memory

    bool is(Basic b) const { return kind == Kind::basic && basic == b; }
};

/// Describes an item of a protocol: a value of `type`, or a counted array `count::[]element`, which is sent as a length
/// of type `count` and the elements.
struct ProtocolItem {
    const Type* type = nullptr;  ///< for a counted array: the open array
    const Type* count = nullptr; ///< for a counted array: type of the length; null for another item
    bool operator==(const ProtocolItem&) const = default;
};

/// Describes a tag of a variant protocol, and the items that follow it.
struct ProtocolTag {
    std::string name;
    std::uint8_t value = 0; ///< the byte that is sent for the tag
    std::vector<ProtocolItem> items = {};
};

/// Describes the messages that a channel carries. Two protocols without names are equal if their items are equal. Two
/// named protocols are equal if they have the same declaration.
struct ProtocolType {
    enum class Kind : std::uint8_t { any, sequence, variant };
    Kind kind = Kind::any;
    const Declaration* declared = nullptr; ///< declaration of a named protocol; null if the protocol has no name
    std::vector<ProtocolItem> items = {};  ///< items of a sequence
    std::vector<ProtocolTag> tags =
        {}; ///< tags of a variant protocol, including the tags of other protocols that it extends
};

/// Makes each type of a program once, and owns the types.
class Types {
public:
    const Type* basic(Basic);
    const Type* array(const Type* element, std::optional<std::uint32_t> count);
    const Type* channel(const ProtocolType*);
    const Type* port(const Type* element);
    const Type* timer();
    const Type* hardware(Type::Kind); ///< node, arc or edge
    const Type* mistaken();
    /// These functions make a new type or protocol for a declaration.
    const Type* record(const Declaration*, std::vector<Field>);
    const Type* derived(const Declaration*, const Type* element);
    const ProtocolType* protocol(ProtocolType);
    /// Returns all types that were made.
    const std::deque<Type>& all() const { return types_; }

private:
    const Type* unique(const Type&);
    std::deque<Type> types_;
    std::deque<ProtocolType> protocols_;
};

} // namespace placedpar::occam
