// Checks at compile time that programs which occam's compiler refuses do not compile, as far as types can express it.
// Types cannot express the ownership of ends. Its misuse is reported at run time (misuse_test.cpp).

#include "runtime/alternation.hpp"
#include "runtime/channel.hpp"
#include "runtime/parallel.hpp"
#include "runtime/protocol.hpp"
#include "runtime/recovery.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"

#include <array>
#include <concepts>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace placedpar::refused_by_types {

struct Sample {
    double pressure, angle;
};
struct Named {
    std::string name;
};
struct Counted {
    std::string text;
    WireForm wire_form() const { return WireForm(4u, text.size()); }
};
struct MayThrow {
    MayThrow(MayThrow&&) {}
    WireForm wire_form() const { return WireForm(4u); }
};
struct Stop {};
using Measurements = std::variant<Stop, int, std::vector<Sample>>;

template <class End, class Message>
concept Outputs = requires(const End end, Message message) {
    end.output(message);
};
template <class End, class... Arguments>
concept Inputs = requires(const End end, Arguments... arguments) {
    end.input(arguments...);
};

// An input end cannot output, and an output end cannot input: neither `in ! x` nor `out ? x`.
static_assert(Outputs<Output<int>, int> && Inputs<Input<int>>);
static_assert(!Outputs<Input<int>, int> && !Inputs<Output<int>>);
static_assert(!Inputs<Channel<int>> && !Outputs<Channel<int>, int>);

// An end converts neither to the opposite end nor to another protocol.
static_assert(!std::convertible_to<Input<int>, Output<int>> && !std::constructible_from<Input<int>, Output<int>>);
static_assert(!std::constructible_from<Output<double>, Output<int>> &&
              !std::constructible_from<Input<double>, Input<int>>);
static_assert(!std::constructible_from<Output<int>, Channel<int>&>); // .out() states which end is meant

// Channels cannot be copied or moved, so a program cannot use one that was moved from.
static_assert(!std::copy_constructible<Channel<int>> && !std::move_constructible<Channel<int>>);
static_assert(!std::is_copy_assignable_v<Channel<int>> && !std::is_move_assignable_v<Channel<int>>);
static_assert(!std::copy_constructible<std::array<Channel<int>, 2>>);
static_assert(!std::move_constructible<std::pair<Channel<int>, int>>);

// An end of a temporary channel is refused, because the channel would be destroyed at the end of the statement.
template <class C>
concept HasEnds = requires(C&& channel) {
    std::forward<C>(channel).out();
    std::forward<C>(channel).in();
};
static_assert(HasEnds<Channel<int>&> && !HasEnds<Channel<int>> && !HasEnds<const Channel<int>&>);

// Messages have a protocol, which excludes shared memory.
static_assert(Protocol<int> && Protocol<Sample> && Protocol<std::array<Sample, 3>> && Protocol<bool>);
static_assert(Protocol<std::vector<Sample>> && Protocol<Measurements> && Protocol<Counted>);
static_assert(!Protocol<std::string> && !Protocol<Named> && !Protocol<std::vector<std::string>>);
static_assert(!Protocol<std::variant<int, Named>> && !Protocol<std::vector<std::vector<int>>>);
static_assert(!Protocol<int*> && !Protocol<int&> && !Protocol<const int> && !Protocol<void> && !Protocol<int[3]>);
static_assert(!Protocol<std::span<int>> && !Protocol<std::string_view> && !Protocol<std::vector<const char*>>);
static_assert(!Protocol<std::shared_ptr<int>> && !Protocol<std::function<void()>>);
static_assert(!Protocol<std::variant<Stop, int*>>);
static_assert(!Protocol<MayThrow>);

// A message has its channel's protocol; another type is converted only if nothing is lost.
static_assert(Outputs<Output<double>, int> && Outputs<Output<Counted>, Counted>);
static_assert(!Outputs<Output<int>, double> && !Outputs<Output<std::int64_t>, float> && !Outputs<Output<bool>, double>);
static_assert(!Outputs<Output<bool>, const char*> && !Outputs<Output<bool>, int*>);
static_assert(!Outputs<Output<int>, Sample> && !Outputs<Output<Sample>, int> && !Outputs<Output<int>, std::string>);

// A message of a variant protocol must be one of the alternatives, without ambiguity.
static_assert(Outputs<Output<Measurements>, Stop> && Outputs<Output<Measurements>, std::vector<Sample>>);
static_assert(!Outputs<Output<Measurements>, double> && !Outputs<Output<Measurements>, Sample>);
static_assert(!Outputs<Output<Measurements>, std::vector<int>>);

// A guard is an input, a time-out or SKIP. It cannot be an output or a channel.
struct Take {
    void operator()(int) const {}
};
struct Nothing {
    void operator()() const {}
};
template <class End, class Body>
concept CanGuard = requires(End end, Body body) {
    on(end, body);
};
static_assert(CanGuard<Input<int>, Take>);
static_assert(!CanGuard<Output<int>, Take> && !CanGuard<Channel<int>&, Take>);

// The guarded process takes exactly one message, of the channel's protocol.
struct TakeTwo {
    void operator()(int, int) const {}
};
struct TakeText {
    void operator()(const std::string&) const {}
};
static_assert(!CanGuard<Input<int>, Nothing> && !CanGuard<Input<int>, TakeTwo>);
static_assert(!CanGuard<Input<int>, TakeText>);

struct TakeOf {
    void operator()(std::size_t, int) const {}
};
template <class Ends, class Body>
concept Replicates = requires(Ends ends, Turn turn, Body body) {
    each(ends, body);
    each(ends, turn, body);
    alt(ends, body);
};
static_assert(Replicates<std::span<const Input<int>>, TakeOf>);
static_assert(!Replicates<std::span<const Output<int>>, TakeOf>);
static_assert(!Replicates<std::span<const Input<int>>, Take>);

template <class... Alternatives>
concept Alternates = requires(Alternatives... alternatives) {
    alt(alternatives...);
};
using InputGuard = decltype(on(std::declval<Input<int>>(), Take()));
static_assert(Alternates<InputGuard> && Alternates<InputGuard, decltype(after(Time{5}, Nothing()))>);
static_assert(!Alternates<> && !Alternates<Input<int>> && !Alternates<InputGuard, Input<int>>);

template <class Due>
concept TimesOut = requires(Due due) {
    after(due, Nothing());
    wait_until(due);
    wait_for(due);
};
static_assert(TimesOut<Time> && TimesOut<std::chrono::microseconds>);
static_assert(!TimesOut<int> && !TimesOut<Cycles>); // a number has no unit, and cycles are not a time

template <class Work>
concept Computes = requires(Work work) {
    compute(work);
};
static_assert(Computes<Cycles> && !Computes<int> && !Computes<Time>);

// The condition of a guard is a Boolean and not an end.
template <class Condition>
concept IsCondition = requires(Condition condition, InputGuard guard) {
    when(condition, guard);
};
static_assert(IsCondition<bool> && !IsCondition<Input<int>> && !IsCondition<std::string>);

// The components of a PAR are processes without parameters.
template <class... Bodies>
concept InParallel = requires(Bodies... bodies) {
    par(bodies...);
};
static_assert(InParallel<Nothing, Nothing>);
static_assert(!InParallel<> && !InParallel<Nothing, int> && !InParallel<Take, Nothing>);
static_assert(!InParallel<Nothing, InputGuard>);
struct TakeNumber {
    void operator()(std::size_t) const {}
};
template <class Body>
concept InReplicatedParallel = requires(Body body) {
    par_for(3, body);
};
static_assert(InReplicatedParallel<TakeNumber> && !InReplicatedParallel<Nothing>);
template <class... Bodies>
concept InPriorities = requires(Bodies... bodies) {
    pri_par(bodies...);
};
static_assert(InPriorities<Nothing, Nothing>);
static_assert(!InPriorities<Nothing> && !InPriorities<Nothing, Take>);
static_assert(!InPriorities<Nothing, Nothing, Nothing>); // occam's PRI PAR has two

// An attempt needs an end, and a message of the end's protocol. Only ends can be reset.
template <class End, class Message>
concept OutputsOrFails = requires(End end, Message message) {
    output_or_fail(end, message, Time{5});
};
static_assert(OutputsOrFails<Output<int>, int> && !OutputsOrFails<Input<int>, int> &&
              !OutputsOrFails<Output<int>, double>);
template <class End, class Message>
concept InputsOrFails = requires(End end, Message message) {
    input_or_fail(end, message, Time{5});
};
static_assert(InputsOrFails<Input<int>, int> && !InputsOrFails<Output<int>, int> && !InputsOrFails<Input<int>, double>);
template <class End>
concept IsReset = requires(End end) {
    reset(end);
};
static_assert(IsReset<Input<int>> && IsReset<Output<int>> && !IsReset<Channel<int>&>);

} // namespace placedpar::refused_by_types
