#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string_view>

namespace placedpar::hydraulics {

/// The four links of the excavator. Each has a compliance on its pump side. The compliance is the additional volume of
/// oil that fits into the link's hose and cylinder when the pressure rises by 1 psi. Identification searches for these
/// compliances.
enum class Link : unsigned char { bucket, boom, stick, swing };

inline constexpr std::array<Link, 4> all_links{Link::bucket, Link::boom, Link::stick, Link::swing};

constexpr std::size_t index_of(Link link) { return static_cast<std::size_t>(link); }

/// One value for each link, at index_of(link).
template <typename T>
using PerLink = std::array<T, all_links.size()>;

/// Returns "bucket" and so on.
std::string_view name_of(Link);
/// Returns the thesis's symbol "BU", "BO", "ST" or "SW", as in C_BUi, the compliance of the bucket's inlet side.
std::string_view symbol_of(Link);
/// Returns the link with this name or symbol, or nullopt.
std::optional<Link> link_named(std::string_view);

/// The side of a cylinder: the pump feeds the inlet side, and the outlet side drains to the tank.
enum class Side : unsigned char { inlet, outlet };

class LinkSet {
public:
    constexpr LinkSet() = default;
    constexpr LinkSet(std::initializer_list<Link> links) {
        for (Link link : links)
            bits_ |= bit(link);
    }
    static constexpr LinkSet all() { return {Link::bucket, Link::boom, Link::stick, Link::swing}; }

    constexpr bool contains(Link link) const { return (bits_ & bit(link)) != 0; }
    constexpr bool empty() const { return bits_ == 0; }
    constexpr std::size_t size() const {
        std::size_t count = 0;
        for (Link link : all_links)
            count += contains(link);
        return count;
    }
    constexpr void insert(Link link) { bits_ |= bit(link); }
    friend constexpr LinkSet operator&(LinkSet a, LinkSet b) { return LinkSet(a.bits_ & b.bits_); }
    friend constexpr LinkSet operator|(LinkSet a, LinkSet b) { return LinkSet(a.bits_ | b.bits_); }
    friend constexpr auto operator<=>(LinkSet, LinkSet) = default;

private:
    constexpr explicit LinkSet(int bits) : bits_(static_cast<unsigned char>(bits)) {}
    static constexpr unsigned char bit(Link link) { return static_cast<unsigned char>(1u << index_of(link)); }

    unsigned char bits_ = 0;
};

} // namespace placedpar::hydraulics
