#pragma once

#include "text/source.hpp"

#include <cstddef>
#include <string_view>
#include <vector>

namespace placedpar {

/// A place in a text as editors count it: lines from 0, characters from 0 in units of UTF-16. Characters beyond the
/// Basic Multilingual Plane have two units.
struct Position {
    std::size_t line = 0, character = 0;
};

/// Converts between positions and offsets in bytes. A byte that is not UTF-8 counts as one unit.
class Positions {
public:
    /// REQUIRES: the text outlives this object and does not change.
    explicit Positions(std::string_view text);

    /// Returns the number of lines. Lines end with a line feed, a carriage return, or both; the last line has no end.
    std::size_t lines() const { return starts_.size(); }
    /// Returns the offset of a position. A position beyond the end of its line means the end of the line. A position in
    /// the middle of a character means the beginning of the character. The line directly after the last line means the
    /// end of the text; for later lines throws std::out_of_range.
    std::size_t offset(Position) const;
    Position position(std::size_t offset) const;

private:
    std::string_view text_;
    std::vector<std::size_t> starts_;
};

/// Returns the offset of a location in the text of its file. REQUIRES: the location has a file.
std::size_t offset_of(const Location&);

/// Selects the form of the names in a text. In occam, dots are part of a name; in a netlist, a dot ends the name.
enum class NamesOf { netlist, occam };

/// Returns the place after the word that begins at a location: after a name, a number or a string in quotes, or after
/// one other character. Returns the location itself at the end of a line, and if
/// the location is a whole file (its line is 0).
Location end_of_word(const Location&, NamesOf);

} // namespace placedpar
