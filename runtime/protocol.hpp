#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <ranges>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace placedpar {

/// The lengths in bytes of the parts in which a message travels over a link. A transputer sends each part by its own
/// output instruction. A value of fixed size is one part. occam's counted array `INT::[]BYTE` has two parts, the count
/// and the bytes.
class WireForm {
public:
    static constexpr std::size_t most_parts = 4;

    /// Throws std::length_error for a part of fewer than 0 or more than 2^32 - 1 bytes.
    template <std::integral... Bytes>
    requires(sizeof...(Bytes) >= 1 && sizeof...(Bytes) <= most_parts) constexpr WireForm(Bytes... bytes)
        : bytes_{length(bytes)...}, parts_(sizeof...(Bytes)) {}

    /// Returns the form with a tag, a part of one byte, before the other parts. Throws std::length_error if the result
    /// exceeds most_parts.
    constexpr WireForm behind_tag() const {
        if (parts_ == most_parts)
            throw std::length_error("a variant of a message can have at most 3 parts after its tag");
        WireForm tagged(1);
        for (std::size_t part = 0; part < parts_; ++part)
            tagged.bytes_[tagged.parts_++] = bytes_[part];
        return tagged;
    }

    constexpr std::size_t parts() const { return parts_; }
    constexpr std::uint32_t operator[](std::size_t part) const { return bytes_[part]; }
    constexpr std::int64_t total() const {
        std::int64_t sum = 0;
        for (std::size_t part = 0; part < parts_; ++part)
            sum += bytes_[part];
        return sum;
    }

private:
    static constexpr std::uint32_t length(std::integral auto bytes) {
        if (!std::in_range<std::uint32_t>(bytes))
            throw std::length_error("a part of a message has 0 to 4294967295 bytes");
        return static_cast<std::uint32_t>(bytes);
    }

    std::array<std::uint32_t, most_parts> bytes_{};
    std::size_t parts_;
};

namespace detail {

template <class T>
inline constexpr bool has_wire_form = requires(const T& message) {
    { message.wire_form() } -> std::same_as<WireForm>;
};
/// True if a copy of the bytes is a copy of the value. Types with addresses are excluded, because an address means
/// nothing to another process.
template <class T>
inline constexpr bool is_plain =
    std::is_trivially_copyable_v<T> && !std::is_pointer_v<T> && !std::is_member_pointer_v<T> &&
    !std::is_null_pointer_v<T> && !std::ranges::borrowed_range<T>;
template <class T>
inline constexpr bool is_message = has_wire_form<T> || is_plain<T>;
template <class T>
inline constexpr bool is_message<std::vector<T>> = is_plain<T>;
template <class... Variants>
inline constexpr bool is_message<std::variant<Variants...>> = (is_message<Variants> && ...);

} // namespace detail

/// The types that a channel can carry: values of a fixed size, counted arrays of them, variants, and types with a
/// wire_form(). Processes share no memory, so pointers, references, spans and views are excluded. Types of variable
/// size without a wire_form(), such as std::string, are excluded, too. Moving a message must not throw, because events
/// move messages, and an exception in an event would belong to no process.
template <class T>
concept Protocol = std::is_object_v<T> && std::same_as<T, std::remove_cv_t<T>> && !std::is_array_v<T> &&
                   std::is_nothrow_move_constructible_v<T> && detail::is_message<T>;

/// Returns the form of a message on a wire. A type of fixed size is one part. Other types have a member `WireForm
/// wire_form() const`.
template <class T>
WireForm wire_form(const T& message) {
    if constexpr (detail::has_wire_form<T>)
        return message.wire_form();
    else {
        static_assert(detail::is_plain<T>, "a message of varying size needs wire_form() const");
        return WireForm(sizeof(T));
    }
}

/// Returns the form of occam's counted array `INT::[]T`.
template <class T>
requires detail::is_plain<T> WireForm wire_form(const std::vector<T>& message) {
    return WireForm(4u, message.size() * sizeof(T));
}

/// Returns the form of occam's variant protocol, `PROTOCOL P CASE ...`. A tag states which alternative follows, and
/// each alternative has its own size. An alternative that is an empty struct consists only of its tag.
template <class... Variants>
WireForm wire_form(const std::variant<Variants...>& message) {
    auto form = []<class T>(const T& variant) {
        if constexpr (std::is_empty_v<T> && !requires { variant.wire_form(); })
            return WireForm(1);
        else
            return wire_form(variant).behind_tag();
    };
    return std::visit(form, message);
}

} // namespace placedpar
