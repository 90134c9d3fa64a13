#pragma once

#include "runtime/channel.hpp"
#include "runtime/source_location.hpp"
#include "runtime/timer.hpp"

#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace placedpar {

/// One guard of an alternation, without the process that it guards.
struct Guard {
    enum Kind { never, input, timeout, skip } kind;
    AnyChannel* channel = nullptr; ///< of an input guard
    Time due{};                    ///< of a timeout guard
    SourceLocation where{};        ///< in its program
};

/// Waits until a guard is ready and returns its index; of several ready ones the first in the order given, which is
/// occam's PRI ALT, and what the transputer's own instructions choose for ALT. Guards of kind `never` (a condition
/// that is false) are passed over. The message of an input guard has not been input yet.
/// Throws std::logic_error when no guard could ever be ready (occam: such an ALT acts as STOP).
std::size_t select(std::span<const Guard> guards, const SourceLocation& = SourceLocation::current());

/// An input guard and the process that it guards: `on(c, [&](int x) { ... })`.
template <class T, class Body>
auto on(Input<T> from, Body body, const SourceLocation& where = SourceLocation::current()) {
    return std::pair(Guard{Guard::input, &from.channel(), Time{}, where},
                     [from, body = std::move(body), where]() mutable { body(from.input(where)); });
}

/// A timeout guard, occam's `timer ? AFTER t`: ready when the virtual time `due` has come.
template <class Body>
auto after(Time due, Body body, const SourceLocation& where = SourceLocation::current()) {
    return std::pair(Guard{Guard::timeout, nullptr, due, where}, std::move(body));
}

/// occam's SKIP guard: always ready, so that a guard before it is chosen only if it is ready, and one behind it never.
/// Polling costs a placed process its cycles. One that is not placed polls in no time: others get their turn at this
/// moment, but time passes only when it waits.
template <class Body>
auto skip(Body body, const SourceLocation& where = SourceLocation::current()) {
    return std::pair(Guard{Guard::skip, nullptr, Time{}, where}, std::move(body));
}

/// A condition before a guard: `when(free > 0, on(c, ...))`.
template <class Body>
auto when(bool condition, std::pair<Guard, Body> guarded) {
    if (!condition)
        guarded.first.kind = Guard::never;
    return guarded;
}

/// occam's PRI ALT: waits for the first ready guard, inputs if it is an input, and runs the body that it guards.
/// Returns its index.
template <class... Bodies>
std::size_t alt(std::pair<Guard, Bodies>... alternatives) {
    const Guard guards[] = {alternatives.first...};
    std::size_t chosen = select(guards, guards[0].where);
    std::size_t index = 0;
    ((index++ == chosen ? static_cast<void>(alternatives.second()) : void()), ...);
    return chosen;
}

/// The replicated form, `ALT i = 0 FOR n`: `alt(inputs, [&](std::size_t i, T message) { ... })`.
template <class T, class Body>
std::size_t alt(std::span<const Input<T>> inputs, Body body, const SourceLocation& where = SourceLocation::current()) {
    std::vector<Guard> guards;
    for (const Input<T>& from : inputs)
        guards.push_back({Guard::input, &from.channel()});
    std::size_t chosen = select(guards, where);
    body(chosen, inputs[chosen].input(where));
    return chosen;
}

} // namespace placedpar
