#pragma once

#include "text/source.hpp"

#include <cstddef>
#include <string_view>
#include <vector>

namespace placedpar {

/// A place in a text as the Language Server Protocol of editors counts it. Lines count from 0. Within a line, units of
/// UTF-16 count from 0; a character beyond the Basic Multilingual Plane has two units.
struct Position {
    std::size_t line = 0, character = 0;
};

/// Converts between positions and offsets in bytes of one text. A byte that is not UTF-8 counts as one unit.
class Positions {
public:
    /// REQUIRES: the text outlives this object and does not change.
    explicit Positions(std::string_view text);

    /// Returns the number of lines. Lines end with a line feed, a carriage return, or both. What follows the last line
    /// end is a line, too.
    std::size_t lines() const { return starts_.size(); }
    /// Returns the offset of a position. A position beyond the end of its line counts as the end of the line. A
    /// position within a character counts as the beginning of the character. A position in the line after the last line
    /// counts as the end of the text. For later lines throws std::out_of_range.
    std::size_t offset(Position) const;
    Position position(std::size_t offset) const;

private:
    std::string_view text_;
    std::vector<std::size_t> starts_;
};

/// Returns the offset of a location in the text of its file. REQUIRES: the location has a file.
std::size_t offset_of(const Location&);

/// Selects the language of a text. In occam, a name may contain dots; in a netlist, a dot ends a name.
enum class NamesOf { netlist, occam };

/// Returns the place after the word that begins at a location. A word is a name, a number, a string in quotes, or one
/// other character. Returns the location itself at the end of a line, and if the location means a whole file (line 0).
Location end_of_word(const Location&, NamesOf);

} // namespace placedpar
