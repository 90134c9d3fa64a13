#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/language/names_in_text.hpp"
#include "occam/configuration/configured.hpp"

#include <optional>
#include <string>
#include <vector>

namespace placedpar {
struct StudyNames; // explore/study/study_names.hpp
} // namespace placedpar

namespace placedpar::editor {

struct StudyText; // editor/language/study_text.hpp

// These functions serve requests about the word at a place.

/// Returns lines of plain text that describe a kind, a type, a parameter or attribute with its range, a port, a fault,
/// or a declared name; "" for any other word.
std::string hover_netlist(const NetlistSyntax&, const Catalogue&, const Location&);
/// Returns lines of plain text that describe the declaration of a name: its first line, and the type.
std::string hover_occam(const occam::Program&, const Location&);
/// Returns the same for a name of a configuration; for nodes, also their types, memories and links, for arcs and edges
/// what they join. Describes an attribute in SET.
std::string hover_configuration(const occam::Program&, const occam::Configured&, const Location&);
/// Returns lines of plain text that describe a key of a study with the range of its value, a setting, or a measure.
std::string hover_study(const StudyText&, const StudyNames&, const Location&);

/// Returns where the name at a place is declared. For a string that names a file, returns the beginning of this file.
/// Returns nothing for any other word.
std::optional<Location> definition_in_netlist(const NetlistSyntax&, const Location&);
std::optional<Location> definition_in_occam(const occam::Program&, const Location&);
/// Returns the same for a setting or a measure of a study, which the netlist declares, and for the file of the netlist.
std::optional<Location> definition_in_study(const StudyText&, const StudyNames&, const Location&);

/// Returns all places where `new_name` must replace the name at this place. Throws UserError if the word at this place
/// is not a declared name, if an included file uses the name, if the text has errors, or if `new_name` is not a
/// possible name or is already declared.
std::vector<Location> places_to_rename(const NetlistSyntax&, const Catalogue&, const Location&,
                                       const std::string& new_name);

/// Describes a declaration in the outline of a file.
struct OutlineEntry {
    std::string name, detail;
    Location at;
    bool is_routine = false; ///< a PROC or FUNCTION
};
std::vector<OutlineEntry> outline_of(const NetlistSyntax&);
std::vector<OutlineEntry> outline_of(const occam::Program&);

} // namespace placedpar::editor
