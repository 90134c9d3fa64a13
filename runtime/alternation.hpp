#pragma once

#include "runtime/channel.hpp"
#include "runtime/source_location.hpp"
#include "runtime/timer.hpp"

#include <concepts>
#include <cstddef>
#include <numeric>
#include <span>
#include <tuple>
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
template <class T, std::invocable<T> Body>
auto on(Input<T> from, Body body, const SourceLocation& where = SourceLocation::current()) {
    return std::pair(Guard{Guard::input, &from.channel(), Time{}, where},
                     [from, body = std::move(body), where]() mutable { body(from.input(where)); });
}

/// A timeout guard, occam's `timer ? AFTER t`: ready when the virtual time `due` has come.
template <std::invocable Body>
auto after(Time due, Body body, const SourceLocation& where = SourceLocation::current()) {
    return std::pair(Guard{Guard::timeout, nullptr, due, where}, std::move(body));
}

/// occam's SKIP guard: always ready, so that a guard before it is chosen only if it is ready, and one behind it never.
/// Polling costs a placed process its cycles. One that is not placed polls in no time: others get their turn at this
/// moment, but time passes only when it waits.
template <std::invocable Body>
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

/// Several guards in the place of one: a replicated guard, or an ALT within an ALT.
template <class Body>
struct Guards {
    std::vector<Guard> guards;
    std::vector<std::size_t> numbers; ///< of each, the replicator's value
    Body body;                        ///< is given the number of the one that was chosen
};
template <class Body>
Guards(std::vector<Guard>, std::vector<std::size_t>, Body) -> Guards<Body>;

/// Whose turn it is in a fair ALT, which remembers it from one time to the next.
struct Turn {
    std::size_t next = 0;
};

namespace detail {

/// One guard of each input, beginning with inputs[first]. `body` is given the number of the input.
template <class T, class Body>
auto replicated(std::span<const Input<T>> inputs, std::size_t first, Body body, const SourceLocation& where) {
    std::vector<Guard> guards;
    std::vector<std::size_t> numbers;
    for (std::size_t k = 0; k < inputs.size(); ++k) {
        numbers.push_back((first + k) % inputs.size());
        guards.push_back({Guard::input, &inputs[numbers.back()].channel(), Time{}, where});
    }
    return Guards{std::move(guards), std::move(numbers), std::move(body)};
}

} // namespace detail

/// A replicated guard, `ALT i = 0 FOR n`: `each(inputs, [&](std::size_t i, T message) { ... })`. Of several ready ones
/// the first is chosen. REQUIRES: the inputs outlive it.
template <class T, std::invocable<std::size_t, T> Body>
auto each(std::span<const Input<T>> inputs, Body body, const SourceLocation& where = SourceLocation::current()) {
    auto take = [inputs, body = std::move(body), where](std::size_t i) mutable { body(i, inputs[i].input(where)); };
    return detail::replicated(inputs, 0, std::move(take), where);
}

/// A replicated guard that is fair: the first to be looked at is the one behind that which was chosen last, so that
/// each that is ready is chosen before another is a second time (G. Jones, Carefully scheduled selection with ALT,
/// occam user group newsletter 10, 1989). `each(inputs, turn, [&](std::size_t i, T message) { ... })`. REQUIRES: the
/// inputs and the turn outlive it.
template <class T, std::invocable<std::size_t, T> Body>
auto each(std::span<const Input<T>> inputs, Turn& turn, Body body,
          const SourceLocation& where = SourceLocation::current()) {
    auto take = [inputs, &turn, body = std::move(body), where](std::size_t i) mutable {
        turn.next = i + 1;
        body(i, inputs[i].input(where));
    };
    return detail::replicated(inputs, turn.next, std::move(take), where);
}

// Takes a vector, such as environment.inputs<T>("in"), which may be made within the call of alt().
template <class T, std::invocable<std::size_t, T> Body>
auto each(const std::vector<Input<T>>& inputs, Body body, const SourceLocation& where = SourceLocation::current()) {
    return each(std::span<const Input<T>>(inputs), std::move(body), where);
}
template <class T, std::invocable<std::size_t, T> Body>
auto each(const std::vector<Input<T>>& inputs, Turn& turn, Body body,
          const SourceLocation& where = SourceLocation::current()) {
    return each(std::span<const Input<T>>(inputs), turn, std::move(body), where);
}

/// An ALT within an ALT: its guards stand in its place, in their order.
template <class... Bodies>
auto either(std::pair<Guard, Bodies>... alternatives) {
    std::vector<std::size_t> numbers(sizeof...(alternatives));
    std::iota(numbers.begin(), numbers.end(), 0u);
    return Guards{std::vector<Guard>{alternatives.first...}, std::move(numbers),
                  [bodies = std::tuple(std::move(alternatives.second)...)](std::size_t chosen) mutable {
                      auto run = [chosen](auto&... body) {
                          std::size_t number = 0;
                          ((number++ == chosen ? static_cast<void>(body()) : void()), ...);
                      };
                      std::apply(run, bodies);
                  }};
}

/// A condition before each, `ALT i = 0 FOR n  wanted[i] & c[i] ? x`: `when([&](std::size_t i) { return wanted[i]; },
/// each(...))`.
template <std::predicate<std::size_t> Condition, class Body>
auto when(Condition condition, Guards<Body> several) {
    for (std::size_t k = 0; k < several.guards.size(); ++k)
        if (!condition(several.numbers[k]))
            several.guards[k].kind = Guard::never;
    return several;
}

/// A condition before all of them.
template <class Body>
auto when(bool condition, Guards<Body> several) {
    return when([=](std::size_t) { return condition; }, std::move(several));
}

/// occam's PRI ALT: waits for the first ready guard, inputs if it is an input, and runs the body that it guards.
/// Returns its index.
template <class... Bodies>
requires(sizeof...(Bodies) > 0) std::size_t alt(std::pair<Guard, Bodies>... alternatives) {
    const Guard guards[] = {alternatives.first...};
    std::size_t chosen = select(guards, guards[0].where);
    std::size_t index = 0;
    ((index++ == chosen ? static_cast<void>(alternatives.second()) : void()), ...);
    return chosen;
}

namespace detail {

template <class Body>
std::span<const Guard> guards_of(const std::pair<Guard, Body>& one) {
    return {&one.first, 1};
}
template <class Body>
std::span<const Guard> guards_of(const Guards<Body>& several) {
    return several.guards;
}
template <class Body>
void run_chosen(std::pair<Guard, Body>& one, std::size_t) {
    one.second();
}
template <class Body>
void run_chosen(Guards<Body>& several, std::size_t chosen) {
    several.body(several.numbers[chosen]);
}

template <class T>
inline constexpr bool is_guards = false;
template <class Body>
inline constexpr bool is_guards<Guards<Body>> = true;

} // namespace detail

/// The same where one of them is several: `alt(each(inputs, ...), after(time, ...))`. Returns the index among all.
template <class... Alternatives>
requires(detail::is_guards<Alternatives> || ...) std::size_t alt(Alternatives... alternatives) {
    std::vector<Guard> guards;
    auto append = [&](std::span<const Guard> more) { guards.insert(guards.end(), more.begin(), more.end()); };
    (append(detail::guards_of(alternatives)), ...);
    const std::size_t chosen = select(guards, guards.empty() ? SourceLocation{} : guards.front().where);
    std::size_t first = 0;
    auto run = [&](auto& alternative) {
        std::size_t count = detail::guards_of(alternative).size();
        if (chosen >= first && chosen < first + count)
            detail::run_chosen(alternative, chosen - first);
        first += count;
    };
    (run(alternatives), ...);
    return chosen;
}

/// Of one replicated guard alone: `alt(inputs, [&](std::size_t i, T message) { ... })`.
template <class T, std::invocable<std::size_t, T> Body>
std::size_t alt(std::span<const Input<T>> inputs, Body body, const SourceLocation& where = SourceLocation::current()) {
    return alt(each(inputs, std::move(body), where));
}
template <class T, std::invocable<std::size_t, T> Body>
std::size_t alt(const std::vector<Input<T>>& inputs, Body body,
                const SourceLocation& where = SourceLocation::current()) {
    return alt(each(inputs, std::move(body), where));
}

} // namespace placedpar
