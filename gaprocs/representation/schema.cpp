#include "gaprocs/representation/schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace placedpar {

namespace {

/// Adds all schemata that begin with the first `first` characters of `begun` and have exactly `order` fixed positions
/// (0 or 1) after these characters.
void add_schemata(std::string& begun, std::size_t first, std::size_t order, std::vector<Schema>& all) {
    if (begun.size() - first < order)
        return;
    if (first == begun.size()) {
        all.push_back(Schema::from_string(begun));
        return;
    }
    for (char character : order == 0 ? std::string("*") : std::string("*01")) {
        begun[first] = character;
        add_schemata(begun, first + 1, order - (character != '*'), all);
    }
}

} // namespace

Schema Schema::from_string(std::string_view text) {
    if (text.empty())
        throw std::invalid_argument("the schema has 0 positions, expected at least 1");
    Schema schema;
    schema.fixed_ = schema.values_ = Genome(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '0' && text[i] != '1' && text[i] != '*')
            throw std::invalid_argument(fmt::format(
                "a schema has only the characters 0, 1 and *: '{}' has '{}' at position {}", text, text[i], i));
        schema.fixed_.set(i, text[i] != '*');
        schema.values_.set(i, text[i] == '1');
    }
    return schema;
}

std::size_t Schema::defining_length() const {
    Genome none(size());
    return fixed_ == none ? 0 : last_difference(fixed_, none) - first_difference(fixed_, none);
}

bool Schema::matches(const Genome& genome) const {
    for (std::size_t word = 0; word < fixed_.words().size(); ++word)
        if (((genome.words()[word] ^ values_.words()[word]) & fixed_.words()[word]) != 0)
            return false;
    return true;
}

std::string Schema::to_string() const {
    std::string text = values_.to_string();
    for (std::size_t i = 0; i < text.size(); ++i)
        if (!fixed_.bit(i))
            text[i] = '*';
    return text;
}

std::size_t count_matches(const Schema& schema, std::span<const Genome> population) {
    return static_cast<std::size_t>(
        std::ranges::count_if(population, [&](const Genome& genome) { return schema.matches(genome); }));
}

std::vector<Schema> schemata_of_order(std::size_t size, std::size_t order) {
    std::vector<Schema> all;
    std::string begun(size, '*');
    add_schemata(begun, 0, order, all);
    return all;
}

} // namespace placedpar
