#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/language/names_in_text.hpp"
#include "occam/language/tree.hpp"

#include <string>
#include <vector>

namespace placedpar::editor {

/// Holds a word that is possible at a place.
struct Completion {
    enum class Kind { keyword, kind, port, parameter, value, variable, routine, type, file };
    std::string text;
    Kind kind = Kind::variable;
    std::string detail = ""; ///< short description, such as a range
    std::string about = "";  ///< longer description, in one sentence
};

/// Returns the words that are possible at a place of a netlist, in no particular order. The list is not limited to
/// words that begin with the letters typed so far; the editor filters it.
std::vector<Completion> complete_netlist(const NetlistSyntax&, const Catalogue&, const Location&);

/// Returns the words that are possible at a place of a program in occam: keywords and visible names; after #USE and
/// #INCLUDE, the names of PlacedPar's own files. `checked` is the last version of the program without errors.
std::vector<Completion> complete_occam(const SourceFile&, const occam::Program* checked, const Location&);

} // namespace placedpar::editor
