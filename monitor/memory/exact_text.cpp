#include "monitor/memory/exact_text.hpp"

#include "text/number.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <stdexcept>

namespace placedpar::monitor {

namespace {

std::vector<std::string_view> words(std::string_view text) {
    std::vector<std::string_view> found;
    for (std::size_t begin = 0; begin < text.size();) {
        std::size_t end = std::min(text.find(' ', begin), text.size());
        if (end > begin)
            found.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return found;
}

template <typename T, typename... Base>
T value_of(std::string_view word, Base... base) {
    std::optional<T> value = parse_number<T>(word, base...);
    if (!value)
        throw std::runtime_error(fmt::format("\"{}\" is not a number", word));
    return *value;
}

} // namespace

std::string exact_text(std::span<const double> numbers) {
    std::string text;
    for (double each : numbers)
        text += fmt::format("{}{}", text.empty() ? "" : " ", each);
    return text;
}

std::vector<double> numbers_from(std::string_view text) {
    std::vector<double> numbers;
    for (std::string_view word : words(text))
        numbers.push_back(value_of<double>(word));
    return numbers;
}

std::string exact_text(std::span<const Genome> strings) {
    std::string text = fmt::format("{}", strings.empty() ? 0 : strings.front().size());
    for (const Genome& each : strings)
        text += fmt::format(" {:x}", each.field(0, each.size()));
    return text;
}

std::vector<Genome> genomes_from(std::string_view text) {
    std::vector<Genome> strings;
    std::optional<std::size_t> bits;
    for (std::string_view word : words(text))
        if (!bits) {
            bits = value_of<std::size_t>(word);
        } else {
            auto value = value_of<std::uint64_t>(word, 16);
            if (*bits == 0 || *bits > 64 || (*bits < 64 && value >> *bits != 0))
                throw std::runtime_error(fmt::format("\"{}\" does not have {} bits", word, *bits));
            strings.emplace_back(*bits).set_field(0, *bits, value);
        }
    return strings;
}

} // namespace placedpar::monitor
