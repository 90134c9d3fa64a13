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

/// A guard of an ALT, without the process that it guards. A guard of kind `never` has a false condition.
struct Guard {
    enum Kind { never, input, timeout, skip } kind;
    AnyChannel* channel = nullptr; ///< only for an input guard
    Time due{};                    ///< only for a timeout guard
    SourceLocation where{};        ///< place in the program
};

/// Waits until a guard is ready and returns its index. If several guards are ready, returns the first of them, as
/// occam's PRI ALT does. (A transputer executes an ALT in this way, too.) Guards of kind `never` are ignored. Does not
/// input the message of an input guard. Throws std::logic_error if all guards are of kind `never`; in occam such an ALT
/// acts as STOP.
std::size_t select(std::span<const Guard> guards, const SourceLocation& = SourceLocation::current());

/// Makes an input guard with the process that it guards: `on(c, [&](int x) { ... })`.
template <class T, std::invocable<T> Body>
auto on(Input<T> from, Body body, const SourceLocation& where = SourceLocation::current()) {
    return std::pair(Guard{Guard::input, &from.channel(), Time{}, where},
                     [from, body = std::move(body), where]() mutable { body(from.input(where)); });
}

/// Makes a timeout guard, occam's `timer ? AFTER t`. The guard is ready once virtual time has reached `due`.
template <std::invocable Body>
auto after(Time due, Body body, const SourceLocation& where = SourceLocation::current()) {
    return std::pair(Guard{Guard::timeout, nullptr, due, where}, std::move(body));
}

/// Makes occam's SKIP guard, which is always ready. Earlier guards are chosen if they are ready; later guards are never
/// chosen. A process uses a SKIP guard to poll. On a processor, polling costs cycles. Without a processor, polling
/// takes no virtual time: other processes get their turn, but time passes only when the polling process waits.
template <std::invocable Body>
auto skip(Body body, const SourceLocation& where = SourceLocation::current()) {
    return std::pair(Guard{Guard::skip, nullptr, Time{}, where}, std::move(body));
}

/// Adds a condition to a guard: `when(free > 0, on(c, ...))`.
template <class Body>
auto when(bool condition, std::pair<Guard, Body> guarded) {
    if (!condition)
        guarded.first.kind = Guard::never;
    return guarded;
}

/// Several guards that are passed to alt() like one guard: a replicated guard, or an ALT within an ALT.
template <class Body>
struct Guards {
    std::vector<Guard> guards;
    std::vector<std::size_t> numbers; ///< the replicator's value for each guard
    Body body;                        ///< called with the number of the chosen guard
};
template <class Body>
Guards(std::vector<Guard>, std::vector<std::size_t>, Body) -> Guards<Body>;

/// The index of the input that a fair ALT tests first. The caller keeps the object from one execution of the ALT to the
/// next.
struct Turn {
    std::size_t next = 0;
};

namespace detail {

/// Makes one guard for each input, beginning with inputs[first]. `body` is called with the index of the chosen input.
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

/// Makes a replicated guard, `ALT i = 0 FOR n`: `each(inputs, [&](std::size_t i, T message) { ... })`. If several
/// inputs are ready, the first of them is chosen. REQUIRES: the inputs outlive the returned guards.
template <class T, std::invocable<std::size_t, T> Body>
auto each(std::span<const Input<T>> inputs, Body body, const SourceLocation& where = SourceLocation::current()) {
    auto take = [inputs, body = std::move(body), where](std::size_t i) mutable { body(i, inputs[i].input(where)); };
    return detail::replicated(inputs, 0, std::move(take), where);
}

/// Makes a fair replicated guard: `each(inputs, turn, [&](std::size_t i, T message) { ... })`. The input after the last
/// chosen input is tested first. So an input that is ready is chosen before any other input is chosen twice (G. Jones,
/// Carefully scheduled selection with ALT, occam user group newsletter 10, 1989). REQUIRES: the inputs and the turn
/// outlive the returned guards.
template <class T, std::invocable<std::size_t, T> Body>
auto each(std::span<const Input<T>> inputs, Turn& turn, Body body,
          const SourceLocation& where = SourceLocation::current()) {
    auto take = [inputs, &turn, body = std::move(body), where](std::size_t i) mutable {
        turn.next = i + 1;
        body(i, inputs[i].input(where));
    };
    return detail::replicated(inputs, turn.next, std::move(take), where);
}

// The next two functions take a vector of inputs. The vector may be a temporary in the call of alt().
template <class T, std::invocable<std::size_t, T> Body>
auto each(const std::vector<Input<T>>& inputs, Body body, const SourceLocation& where = SourceLocation::current()) {
    return each(std::span<const Input<T>>(inputs), std::move(body), where);
}
template <class T, std::invocable<std::size_t, T> Body>
auto each(const std::vector<Input<T>>& inputs, Turn& turn, Body body,
          const SourceLocation& where = SourceLocation::current()) {
    return each(std::span<const Input<T>>(inputs), turn, std::move(body), where);
}

/// Makes an ALT within an ALT. The outer ALT tests the inner guards in their order, in place of the inner ALT.
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

/// Adds a condition to each guard of a group, as in occam's `ALT i = 0 FOR n wanted[i] & c[i] ? x`:
/// `when([&](std::size_t i) { return wanted[i]; }, each(...))`.
template <std::predicate<std::size_t> Condition, class Body>
auto when(Condition condition, Guards<Body> several) {
    for (std::size_t k = 0; k < several.guards.size(); ++k)
        if (!condition(several.numbers[k]))
            several.guards[k].kind = Guard::never;
    return several;
}

/// Adds the same condition to all guards of a group.
template <class Body>
auto when(bool condition, Guards<Body> several) {
    return when([=](std::size_t) { return condition; }, std::move(several));
}

/// Runs occam's PRI ALT: waits for the first ready guard, inputs the message if the guard is an input guard, and runs
/// the guarded body. Returns the index of the guard.
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

/// Runs a PRI ALT in which some alternatives are groups of guards: `alt(each(inputs, ...), after(time, ...))`. Returns
/// the index of the chosen guard, counted over all groups.
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

/// Runs an ALT that consists of one replicated guard: `alt(inputs, [&](std::size_t i, T message) { ... })`.
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
