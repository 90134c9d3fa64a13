#pragma once

#include "runtime/protocol.hpp"

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace placedpar {

using MessageBytes = std::vector<std::uint8_t>;

/// Thrown for bytes that are not a message of a channel's protocol. The text states the reason.
class NoMessage : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// States how messages of a type are written as bytes. A C++ process can then communicate with a program that an
/// emulated transputer executes in its own code. The bytes are those of occam's protocols. Numbers are little-endian,
/// and BOOL is a byte of 0 or 1. An array `[n]T` is written as its elements. A counted array `INT::[]T` is written as
/// the number of elements, in four bytes, followed by the elements. A variant is written as one byte with the number of
/// its alternative, counted from 0, followed by the alternative. A specialisation has the functions
///
///     static void write(const T&, MessageBytes&);                           // appends the bytes of the message
///     static std::uint32_t next_part(std::span<const std::uint8_t> so_far); // the length of the part that follows
///                                                                           // `so_far`; 0: the message is complete
///     static T read(std::span<const std::uint8_t>);                         // returns the message of these bytes
///
/// `next_part` divides a message into the parts that a transputer outputs one by one. The last two functions may throw
/// NoMessage. If a simpler type has the same bytes, such as std::vector<double>, the specialisation names that type as
/// `SameAs`. Types without a specialisation have no byte form: addresses and padding mean nothing to the other program.
template <class T>
struct ByteForm {};

template <class T>
concept HasByteForm = requires(const T& message, MessageBytes& to, std::span<const std::uint8_t> bytes) {
    ByteForm<T>::write(message, to);
    { ByteForm<T>::next_part(bytes) } -> std::same_as<std::uint32_t>;
    { ByteForm<T>::read(bytes) } -> std::same_as<T>;
};

namespace detail {

static_assert(std::endian::native == std::endian::little, "numbers are written as the host stores them");

template <class T>
concept PlainNumber = std::is_arithmetic_v<T> && !std::same_as<T, long double> && std::same_as<T, std::remove_cv_t<T>>;

template <PlainNumber T>
void write_number(T number, MessageBytes& to) {
    std::array<std::uint8_t, sizeof(T)> bytes;
    std::memcpy(bytes.data(), &number, sizeof(T));
    to.insert(to.end(), bytes.begin(), bytes.end());
}

/// Reads the element with this index. REQUIRES: `bytes` contains the element.
template <PlainNumber T>
T read_number(std::span<const std::uint8_t> bytes, std::size_t element = 0) {
    if constexpr (std::same_as<T, bool>) {
        return bytes[element] != 0;
    } else {
        T number;
        std::memcpy(&number, bytes.data() + element * sizeof(T), sizeof(T));
        return number;
    }
}

} // namespace detail

template <detail::PlainNumber T>
struct ByteForm<T> {
    static void write(T number, MessageBytes& to) { detail::write_number(number, to); }
    static std::uint32_t next_part(std::span<const std::uint8_t> so_far) { return so_far.empty() ? sizeof(T) : 0; }
    static T read(std::span<const std::uint8_t> bytes) { return detail::read_number<T>(bytes); }
};

template <detail::PlainNumber T, std::size_t count>
requires(count > 0) struct ByteForm<std::array<T, count>> {
    static void write(const std::array<T, count>& array, MessageBytes& to) {
        for (const T each : array)
            detail::write_number(each, to);
    }
    static std::uint32_t next_part(std::span<const std::uint8_t> so_far) {
        return so_far.empty() ? static_cast<std::uint32_t>(sizeof(T) * count) : 0;
    }
    static std::array<T, count> read(std::span<const std::uint8_t> bytes) {
        std::array<T, count> array;
        for (std::size_t i = 0; i < count; ++i)
            array[i] = detail::read_number<T>(bytes, i);
        return array;
    }
};

template <detail::PlainNumber T>
struct ByteForm<std::vector<T>> {
    static void write(const std::vector<T>& array, MessageBytes& to) {
        detail::write_number(static_cast<std::uint32_t>(array.size()), to);
        for (const T each : array)
            detail::write_number(each, to);
    }
    static std::uint32_t next_part(std::span<const std::uint8_t> so_far) {
        if (so_far.size() != sizeof(std::int32_t))
            return so_far.empty() ? sizeof(std::int32_t) : 0;
        const auto count = detail::read_number<std::int32_t>(so_far);
        if (count < 0 || static_cast<std::uint32_t>(count) > std::numeric_limits<std::uint32_t>::max() / sizeof(T))
            throw NoMessage("an array cannot have " + std::to_string(count) + " elements");
        return static_cast<std::uint32_t>(count) * std::uint32_t{sizeof(T)};
    }
    static std::vector<T> read(std::span<const std::uint8_t> bytes) {
        bytes = bytes.subspan(sizeof(std::int32_t));
        std::vector<T> array(bytes.size() / sizeof(T));
        for (std::size_t i = 0; i < array.size(); ++i)
            array[i] = detail::read_number<T>(bytes, i);
        return array;
    }
};

namespace detail {

/// True for an alternative of a variant that consists only of its tag.
template <class T>
inline constexpr bool is_only_tag = std::is_empty_v<T> && !has_wire_form<T>;

template <class T>
concept Alternative = HasByteForm<T> || is_only_tag<T>;

} // namespace detail

template <detail::Alternative... Alternatives>
requires(sizeof...(Alternatives) > 0 && sizeof...(Alternatives) <= 256) struct ByteForm<std::variant<Alternatives...>> {
    using Variant = std::variant<Alternatives...>;

    static void write(const Variant& message, MessageBytes& to) {
        to.push_back(static_cast<std::uint8_t>(message.index()));
        std::visit(
            [&]<class T>(const T& alternative) {
                if constexpr (!detail::is_only_tag<T>)
                    ByteForm<T>::write(alternative, to);
            },
            message);
    }
    static std::uint32_t next_part(std::span<const std::uint8_t> so_far) {
        if (so_far.empty())
            return 1;
        return with_alternative(so_far, [&]<std::size_t, class T>() -> std::uint32_t {
            if constexpr (detail::is_only_tag<T>)
                return 0;
            else
                return ByteForm<T>::next_part(so_far.subspan(1));
        });
    }
    static Variant read(std::span<const std::uint8_t> bytes) {
        return with_alternative(bytes, [&]<std::size_t index, class T>() {
            if constexpr (detail::is_only_tag<T>)
                return Variant(std::in_place_index<index>);
            else
                return Variant(std::in_place_index<index>, ByteForm<T>::read(bytes.subspan(1)));
        });
    }

private:
    /// Calls `use` with the number and the type of the alternative that the tag names.
    template <std::size_t index = 0, class Use>
    static auto with_alternative(std::span<const std::uint8_t> bytes, const Use& use) {
        if (bytes[0] == index)
            return use.template operator()<index, std::variant_alternative_t<index, Variant>>();
        if constexpr (index + 1 < sizeof...(Alternatives))
            return with_alternative<index + 1>(bytes, use);
        else
            throw NoMessage("no alternative has the tag " + std::to_string(bytes[0]));
    }
};

/// The functions of a ByteForm for messages whose type is known only at run time. `slot` points to a std::optional<T>,
/// in which `read` stores the message.
struct AnyByteForm {
    void (*write)(const void* message, MessageBytes&);
    std::uint32_t (*next_part)(std::span<const std::uint8_t> so_far);
    void (*read)(std::span<const std::uint8_t>, void* slot);
};

/// Returns the byte form of messages of a type; null if they have none.
template <class T>
const AnyByteForm* byte_form_of() {
    if constexpr (HasByteForm<T>) {
        static constexpr AnyByteForm form{
            [](const void* message, MessageBytes& to) { ByteForm<T>::write(*static_cast<const T*>(message), to); },
            &ByteForm<T>::next_part,
            [](std::span<const std::uint8_t> bytes, void* slot) {
                static_cast<std::optional<T>*>(slot)->emplace(ByteForm<T>::read(bytes));
            }};
        return &form;
    } else {
        return nullptr;
    }
}

} // namespace placedpar
