#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/language/names_in_text.hpp"
#include "occam/language/tree.hpp"

#include <optional>
#include <string>
#include <vector>

namespace placedpar::editor {

// These functions return what an editor shows about the word at a place, as plain text in lines.

/// Describes a kind, a type, a parameter or attribute with its range, a port, a fault, or a declared name; "" for other
/// words.
std::string hover_netlist(const NetlistSyntax&, const Catalogue&, const Location&);
/// Describes the declaration of a name: its first line, and its type.
std::string hover_occam(const occam::Program&, const Location&);

/// Returns where the name at a place is declared, or the beginning of the file that a string there names; nothing for
/// other words.
std::optional<Location> definition_in_netlist(const NetlistSyntax&, const Location&);
std::optional<Location> definition_in_occam(const occam::Program&, const Location&);

/// Returns the places of a name, at each of which `new_name` replaces it. Throws UserError if the word at this place is
/// not a declared name, if an included file uses the name, if the text has errors, or if the new name cannot be one or
/// is taken.
std::vector<Location> places_to_rename(const NetlistSyntax&, const Catalogue&, const Location&,
                                       const std::string& new_name);

/// A declaration in the outline of a file.
struct OutlineEntry {
    std::string name, detail;
    Location at;
    bool is_routine = false; ///< a PROC or FUNCTION
};
std::vector<OutlineEntry> outline_of(const NetlistSyntax&);
std::vector<OutlineEntry> outline_of(const occam::Program&);

} // namespace placedpar::editor
