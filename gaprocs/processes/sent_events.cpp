#include "gaprocs/processes/sent_events.hpp"

#include "gaprocs/processes/messages.hpp"
#include "runtime/packed_form.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

namespace {

/// The first byte of a packed event.
enum class SentKind : std::uint8_t { generation, migration, answer, state };

template <class... Parts>
MessageBytes packed_event(SentKind kind, const Parts&... parts) {
    MessageBytes bytes;
    pack(kind, bytes);
    (pack(parts, bytes), ...);
    return bytes;
}

template <class T>
T next_packed(PackedReader& from) {
    return PackedForm<T>::read(from);
}

std::vector<RealRange> ranges_of(const RealVector& reals) {
    std::vector<RealRange> ranges;
    for (std::size_t i = 0; i < reals.parameters(); ++i)
        ranges.push_back(reals.range(i));
    return ranges;
}

/// Returns the data that determine a representation: the ranges of the numbers for real vectors, otherwise the size.
std::pair<std::uint64_t, std::vector<RealRange>> parts_of(const Representation& representation) {
    switch (representation.kind()) {
    case StringKind::binary: return {representation.bits(), {}};
    case StringKind::real: return {0, ranges_of(representation.reals())};
    case StringKind::permutation: return {representation.permutation().places(), {}};
    }
    return {};
}

Representation next_representation(PackedReader& from) {
    const auto kind = next_packed<StringKind>(from);
    const auto size = next_packed<std::uint64_t>(from);
    auto ranges = next_packed<std::vector<RealRange>>(from);
    switch (kind) {
    case StringKind::binary: return BitString(size);
    case StringKind::real: return RealVector(std::move(ranges));
    case StringKind::permutation: return Permutation(size);
    }
    throw NoMessage("a representation of an unknown kind");
}

void tell_generation(PackedReader& from, SearchObserver& observer) {
    const auto search = next_packed<std::string>(from);
    const auto number = next_packed<std::uint64_t>(from);
    const auto time = next_packed<std::optional<Time>>(from);
    const Representation representation = next_representation(from);
    const auto population = next_packed<std::vector<Genome>>(from);
    const auto fitness = next_packed<std::vector<double>>(from);
    const auto goal = next_packed<std::optional<Goal>>(from);
    observer.observe(ObservedGeneration{search, number, time, representation, population, fitness, goal});
}

void tell_migration(PackedReader& from, SearchObserver& observer) {
    const auto source = next_packed<std::string>(from), to = next_packed<std::string>(from);
    const auto generation = next_packed<std::uint64_t>(from);
    const auto time = next_packed<std::optional<Time>>(from);
    const auto fitness = next_packed<double>(from);
    observer.observe(ObservedMigration{source, to, generation, time, fitness, next_packed<bool>(from)});
}

void tell_answer(PackedReader& from, SearchObserver& observer) {
    const auto analyst = next_packed<std::string>(from), chosen = next_packed<std::string>(from);
    const auto generation = next_packed<std::uint64_t>(from);
    const auto time = next_packed<std::optional<Time>>(from);
    const auto names = next_packed<std::vector<std::string>>(from);
    const auto values = next_packed<std::vector<double>>(from);
    observer.observe(ObservedAnswer{analyst, chosen, generation, time, names, values});
}

void keep_state(PackedReader& from, Checkpoints& checkpoints) {
    const auto search = next_packed<std::string>(from);
    SearchCheckpoint checkpoint;
    checkpoint.search.generation = next_packed<std::uint64_t>(from);
    checkpoint.search.redraws = next_packed<std::uint64_t>(from);
    checkpoint.search.drawn = next_packed<std::uint64_t>(from);
    checkpoint.search.population = next_packed<std::vector<Genome>>(from);
    checkpoint.search.best = next_packed<std::optional<Individual>>(from);
    checkpoint.populations = next_packed<std::uint64_t>(from);
    checkpoint.best = next_packed<Individual>(from);
    checkpoint.improvements = next_packed<std::vector<Improvement>>(from);
    checkpoints.keep(search, checkpoint);
}

} // namespace

void SentCheckpoints::keep(const std::string& search, const SearchCheckpoint& checkpoint) {
    const SearchState& state = checkpoint.search;
    send_(packed_event(SentKind::state, search, state.generation, state.redraws, state.drawn, state.population,
                       state.best, checkpoint.populations, checkpoint.best, checkpoint.improvements));
}

void SentEvents::observe(const ObservedGeneration& event) {
    const auto [size, ranges] = parts_of(event.representation);
    send_(packed_event(SentKind::generation, std::string(event.search), event.number, event.time,
                       event.representation.kind(), size, ranges,
                       std::vector<Genome>(event.population.begin(), event.population.end()),
                       std::vector<double>(event.fitness.begin(), event.fitness.end()), event.goal));
}

void SentEvents::observe(const ObservedMigration& event) {
    send_(packed_event(SentKind::migration, std::string(event.from), std::string(event.to), event.generation,
                       event.time, event.fitness, event.accepted));
}

void SentEvents::observe(const ObservedAnswer& event) {
    send_(packed_event(SentKind::answer, std::string(event.analyst), std::string(event.chosen), event.generation,
                       event.time, std::vector<std::string>(event.names.begin(), event.names.end()),
                       std::vector<double>(event.values.begin(), event.values.end())));
}

void tell_event(std::span<const std::uint8_t> packed, SearchObserver* observer, Checkpoints* checkpoints) {
    PackedReader from(packed);
    switch (next_packed<SentKind>(from)) {
    case SentKind::generation: return tell_generation(from, *observer);
    case SentKind::migration: return tell_migration(from, *observer);
    case SentKind::answer: return tell_answer(from, *observer);
    case SentKind::state: return keep_state(from, *checkpoints);
    }
}

} // namespace placedpar
