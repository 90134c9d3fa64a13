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

// These functions answer an editor's requests about the word at a place of a text. A study is a file about experiments
// with a netlist.

/// Returns lines of plain text that explain a word of a netlist: a kind, a type, a parameter or attribute with its
/// range, a port, a fault, or a declared name. Returns "" for any other word.
std::string hover_netlist(const NetlistSyntax&, const Catalogue&, const Location&);
/// Returns lines of plain text about a name in a program: the first line of its declaration, its type, and where it is
/// declared; "" for any other word.
std::string hover_occam(const occam::Program&, const Location&);
/// Returns the text of hover_occam() for a name in a configuration. Adds type, memory and links of a node, and what an
/// arc or edge joins. Also explains an attribute in SET.
std::string hover_configuration(const occam::Program&, const occam::Configured&, const Location&);
/// Returns lines of plain text that explain a word of a study: a key with the range of its value, a parameter of the
/// netlist, or a measured quantity; "" for any other word.
std::string hover_study(const StudyText&, const StudyNames&, const Location&);

/// Return where the name at a place is declared. If the word is a string that names a file, return the beginning of
/// this file. Return nothing for any other word.
std::optional<Location> definition_in_netlist(const NetlistSyntax&, const Location&);
std::optional<Location> definition_in_occam(const occam::Program&, const Location&);
/// Returns where the netlist declares a name that the study uses. For the name of the netlist's file, returns the
/// beginning of this file. Returns nothing for any other word.
std::optional<Location> definition_in_study(const StudyText&, const StudyNames&, const Location&);

/// Returns all places in a netlist where `new_name` must replace the name at this place. Throws UserError if the name
/// is not declared in this text, if an included file uses it, or if the text has errors. Also throws UserError if
/// `new_name` cannot be a name, or is already declared.
std::vector<Location> places_to_rename(const NetlistSyntax&, const Catalogue&, const Location&,
                                       const std::string& new_name);

/// Describes a declaration in the outline of a file, which an editor shows as a list.
struct OutlineEntry {
    std::string name, detail;
    Location at;
    bool is_routine = false; ///< a PROC or FUNCTION
};
std::vector<OutlineEntry> outline_of(const NetlistSyntax&);
std::vector<OutlineEntry> outline_of(const occam::Program&);

} // namespace placedpar::editor
