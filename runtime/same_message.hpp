#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstring>
#include <optional>
#include <type_traits>
#include <variant>
#include <vector>

namespace placedpar {

/// Determines whether two messages of a type are equal. A device that broadcasts uses this to check that a program
/// outputs the same message on all channels. The answer is unknown if the type has no ==, and equal values may differ
/// in their bytes. An == of a base class counts as the type's own.
template <class T>
struct SameMessage {
    static constexpr bool by_equality = requires(const T& a, const T& b) {
        { a == b } -> std::convertible_to<bool>;
    };
    static constexpr bool by_bytes = !by_equality && std::has_unique_object_representations_v<T>;
    static constexpr bool is_known = by_equality || by_bytes;

    static std::optional<bool> of(const T& a, const T& b) {
        if constexpr (by_equality)
            return a == b;
        else if constexpr (by_bytes)
            return std::memcmp(&a, &b, sizeof(T)) == 0;
        else
            return std::nullopt;
    }
};

// Standard containers have their own cases. They declare an == for every element type, but this == does not compile if
// the elements have none.

template <class T>
struct SameMessage<std::vector<T>> {
    static constexpr bool is_known = SameMessage<T>::is_known;

    static std::optional<bool> of(const std::vector<T>& a, const std::vector<T>& b) {
        if (!is_known)
            return std::nullopt;
        bool same = a.size() == b.size();
        for (std::size_t i = 0; same && i < a.size(); ++i)
            same = *SameMessage<T>::of(a[i], b[i]);
        return same;
    }
};

template <class T, std::size_t n>
struct SameMessage<std::array<T, n>> {
    static constexpr bool is_known = SameMessage<T>::is_known;

    static std::optional<bool> of(const std::array<T, n>& a, const std::array<T, n>& b) {
        if (!is_known)
            return std::nullopt;
        bool same = true;
        for (std::size_t i = 0; same && i < n; ++i)
            same = *SameMessage<T>::of(a[i], b[i]);
        return same;
    }
};

/// Two variants that hold the same empty alternative are equal, even if this alternative has no ==.
template <class... Variants>
struct SameMessage<std::variant<Variants...>> {
    template <class T>
    static constexpr bool is_known_of = std::is_empty_v<T> || SameMessage<T>::is_known;
    static constexpr bool is_known = (is_known_of<Variants> && ...);

    static std::optional<bool> of(const std::variant<Variants...>& a, const std::variant<Variants...>& b) {
        if (!is_known)
            return std::nullopt;
        if (a.index() != b.index())
            return false;
        return std::visit(
            [&]<class T>(const T& variant) -> std::optional<bool> {
                if constexpr (std::is_empty_v<T>)
                    return true;
                else
                    return SameMessage<T>::of(variant, std::get<T>(b));
            },
            a);
    }
};

} // namespace placedpar
