#pragma once

#include "runtime/byte_form.hpp"

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace placedpar {

/// Reads packed values one after another.
class PackedReader {
public:
    /// REQUIRES: the bytes outlive this object.
    explicit PackedReader(std::span<const std::uint8_t> bytes) : left_(bytes) {}
    std::size_t left() const { return left_.size(); }
    /// Throws NoMessage if fewer than `count` bytes are left.
    std::span<const std::uint8_t> take(std::size_t count) {
        if (count > left_.size())
            throw NoMessage("the message is cut off");
        return std::exchange(left_, left_.subspan(count)).first(count);
    }

private:
    std::span<const std::uint8_t> left_;
};

/// States how values travel to another copy of this program, such as another MPI rank of a native run. The bytes hold
/// the whole value, in the byte order of this computer. (ByteForm is for other programs, and may leave out what they do
/// not need.) Values without addresses are copied byte by byte. A std::string can be packed. A std::vector,
/// std::variant, std::optional or std::shared_ptr<const T> can be packed if its contents can. For a structure of such
/// values, list the members before a channel carries the structure:
///
///     struct Report {
///         std::vector<double> values;
///         std::string unit;
///     };
///     template <>
///     struct PackedForm<Report> : PackedMembers<Report, &Report::values, &Report::unit> {};
///
/// For other types a specialisation has the functions
///
///     static void write(const T&, MessageBytes&); // appends the bytes of the value
///     static T read(PackedReader&);               // throws NoMessage
template <class T>
struct PackedForm {};

template <class T>
concept Packable = requires(const T& value, MessageBytes& to, PackedReader& from) {
    PackedForm<T>::write(value, to);
    { PackedForm<T>::read(from) } -> std::same_as<T>;
};

namespace detail {

template <class T>
concept PlainValue = is_plain<T> && !std::is_const_v<T>;

} // namespace detail

template <detail::PlainValue T>
struct PackedForm<T> {
    static void write(const T& value, MessageBytes& to) {
        const auto* const bytes = reinterpret_cast<const std::uint8_t*>(&value);
        to.insert(to.end(), bytes, bytes + sizeof(T));
    }
    static T read(PackedReader& from) {
        const std::span<const std::uint8_t> bytes = from.take(sizeof(T));
        if constexpr (std::same_as<T, bool>) {
            return bytes[0] != 0;
        } else {
            std::array<std::uint8_t, sizeof(T)> copy;
            std::memcpy(copy.data(), bytes.data(), sizeof(T));
            return std::bit_cast<T>(copy);
        }
    }
};

/// Packs the listed members of a structure. Members that are not listed are not transferred.
template <class T, auto... members>
struct PackedMembers {
    static void write(const T& value, MessageBytes& to) { (write_member(value.*members, to), ...); }
    static T read(PackedReader& from) {
        T value;
        (read_member(value.*members, from), ...);
        return value;
    }

private:
    template <class Member>
    static void write_member(const Member& member, MessageBytes& to) {
        PackedForm<Member>::write(member, to);
    }
    template <class Member>
    static void read_member(Member& member, PackedReader& from) {
        member = PackedForm<Member>::read(from);
    }
};

template <Packable T>
struct PackedForm<std::vector<T>> {
    static void write(const std::vector<T>& values, MessageBytes& to) {
        PackedForm<std::uint64_t>::write(values.size(), to);
        for (const T& each : values)
            PackedForm<T>::write(each, to);
    }
    static std::vector<T> read(PackedReader& from) {
        const auto count = PackedForm<std::uint64_t>::read(from);
        if (count > from.left()) // each value has at least one byte
            throw NoMessage("an array of " + std::to_string(count) + " elements is longer than the message");
        std::vector<T> values;
        values.reserve(count);
        for (std::uint64_t i = 0; i < count; ++i)
            values.push_back(PackedForm<T>::read(from));
        return values;
    }
};

template <Packable... Alternatives>
requires(sizeof...(Alternatives) > 0 &&
         sizeof...(Alternatives) <= 256) struct PackedForm<std::variant<Alternatives...>> {
    using Variant = std::variant<Alternatives...>;

    static void write(const Variant& value, MessageBytes& to) {
        to.push_back(static_cast<std::uint8_t>(value.index()));
        std::visit([&]<class T>(const T& alternative) { PackedForm<T>::write(alternative, to); }, value);
    }
    static Variant read(PackedReader& from) { return read_alternative(from.take(1)[0], from); }

private:
    template <std::size_t index = 0>
    static Variant read_alternative(std::size_t tag, PackedReader& from) {
        if (tag == index)
            return Variant(std::in_place_index<index>,
                           PackedForm<std::variant_alternative_t<index, Variant>>::read(from));
        if constexpr (index + 1 < sizeof...(Alternatives))
            return read_alternative<index + 1>(tag, from);
        else
            throw NoMessage("no alternative has the tag " + std::to_string(tag));
    }
};

template <>
struct PackedForm<std::string> {
    static void write(const std::string& text, MessageBytes& to) {
        PackedForm<std::uint64_t>::write(text.size(), to);
        to.insert(to.end(), text.begin(), text.end());
    }
    static std::string read(PackedReader& from) {
        const std::span<const std::uint8_t> bytes = from.take(PackedForm<std::uint64_t>::read(from));
        return std::string(bytes.begin(), bytes.end());
    }
};

namespace detail {

/// Packs a value that may be absent: one byte that states whether the value is present, then the value.
template <class Holder, class T, Holder (*hold)(T)>
struct PackedIfThere {
    static void write(const Holder& holder, MessageBytes& to) {
        to.push_back(holder ? 1 : 0);
        if (holder)
            PackedForm<T>::write(*holder, to);
    }
    static Holder read(PackedReader& from) { return from.take(1)[0] ? hold(PackedForm<T>::read(from)) : Holder(); }
};

template <class T>
std::optional<T> held_in_optional(T value) {
    return value;
}
template <class T>
std::shared_ptr<const T> held_by_pointer(T value) {
    return std::make_shared<const T>(std::move(value));
}

} // namespace detail

template <Packable T>
struct PackedForm<std::optional<T>> : detail::PackedIfThere<std::optional<T>, T, detail::held_in_optional<T>> {};
template <Packable T>
struct PackedForm<std::shared_ptr<const T>>
    : detail::PackedIfThere<std::shared_ptr<const T>, T, detail::held_by_pointer<T>> {};

template <Packable T>
void pack(const T& value, MessageBytes& to) {
    PackedForm<T>::write(value, to);
}
/// Unpacks a value. Throws NoMessage unless the bytes are exactly one value.
template <Packable T>
T unpack(std::span<const std::uint8_t> bytes) {
    PackedReader from(bytes);
    T value = PackedForm<T>::read(from);
    if (from.left() > 0)
        throw NoMessage("further bytes follow the end of the message");
    return value;
}

/// The functions of a PackedForm for messages whose type is known only at run time. `slot` points to a
/// std::optional<T>, in which `read` stores the message.
struct AnyPackedForm {
    void (*write)(const void* message, MessageBytes&);
    void (*read)(std::span<const std::uint8_t>, void* slot);
};

/// Returns the packed form of messages of a type; null if they cannot be packed.
template <class T>
const AnyPackedForm* packed_form_of() {
    if constexpr (Packable<T>) {
        static constexpr AnyPackedForm form{
            [](const void* message, MessageBytes& to) { pack(*static_cast<const T*>(message), to); },
            [](std::span<const std::uint8_t> bytes, void* slot) {
                static_cast<std::optional<T>*>(slot)->emplace(unpack<T>(bytes));
            }};
        return &form;
    } else {
        return nullptr;
    }
}

} // namespace placedpar
