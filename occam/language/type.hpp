#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::occam {

struct Declaration; // occam/language/tree.hpp

/// The types that hold a single value. INT has 32 bits, but is another type than INT32.
enum class Basic : std::uint8_t { boolean, byte, integer, int16, int32, int64, real32, real64 };

/// Returns the name of the language, such as "REAL32".
std::string name_of(Basic);
/// Returns the number of bytes in memory and on a channel: 1 for BOOL and BYTE.
std::uint32_t bytes_of(Basic);
bool is_integer(Basic); ///< BYTE, INT, INT16, INT32, INT64
bool is_real(Basic);

struct Type;

/// A field of a record, in order of its place in memory.
struct Field {
    std::string name;
    const Type* type = nullptr;
    std::uint32_t offset = 0; ///< bytes from the start of the record
};

/// A type of the language. Types are made by a Types table, which makes each type once: two types are equal if their
/// pointers are.
struct Type {
    enum class Kind : std::uint8_t {
        basic,
        array,
        record,  ///< DATA TYPE ... RECORD
        derived, ///< DATA TYPE T IS element
        channel, ///< a single channel; its protocol is `protocol`
        timer,
        port, ///< of `element`
        node, ///< of a configuration, as are the next two
        arc,
        edge,
        mistaken ///< type of a wrong expression; it agrees with every type, so that one error does not cause others
    };
    Kind kind = Kind::mistaken;
    Basic basic = Basic::integer;
    const Type* element = nullptr;                 ///< of an array, a derived type or a port
    std::optional<std::uint32_t> count = {};       ///< number of elements of an array; nothing for an open array `[]T`
    const struct ProtocolType* protocol = nullptr; ///< of a channel
    const Declaration* declared = nullptr;         ///< of a record or a derived type
    std::vector<Field> fields = {};                ///< of a record

    bool is(Basic b) const { return kind == Kind::basic && basic == b; }
};

/// An item of a protocol: a value of `type`, or an array preceded by its length of type `count`: `count::[]element`.
struct ProtocolItem {
    const Type* type = nullptr;  ///< of a counted array: the open array
    const Type* count = nullptr; ///< null unless the array is counted
    bool operator==(const ProtocolItem&) const = default;
};

/// A tag of a variant protocol with the items that follow it.
struct ProtocolTag {
    std::string name;
    std::uint8_t value = 0; ///< the byte on the channel
    std::vector<ProtocolItem> items = {};
};

/// The messages that a channel carries. Protocols without a name are equal if their items are equal. Named protocols
/// are equal if they have the same declaration.
struct ProtocolType {
    enum class Kind : std::uint8_t { any, sequence, variant };
    Kind kind = Kind::any;
    const Declaration* declared = nullptr; ///< null unless it has a name
    std::vector<ProtocolItem> items = {};  ///< items of a sequence
    std::vector<ProtocolTag> tags = {};    ///< tags of a variant, including the tags of another variant that it names
};

/// Makes the types of a program, each once, and owns them.
class Types {
public:
    const Type* basic(Basic);
    const Type* array(const Type* element, std::optional<std::uint32_t> count);
    const Type* channel(const ProtocolType*);
    const Type* port(const Type* element);
    const Type* timer();
    const Type* hardware(Type::Kind); ///< node, arc or edge
    const Type* mistaken();
    /// Make a new type or protocol for a declaration.
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
