#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/language/names_in_text.hpp"
#include "occam/language/tree.hpp"

#include <string>
#include <vector>

namespace placedpar {
struct StudyNames; // explore/study/study_names.hpp
} // namespace placedpar

namespace placedpar::editor {

struct StudyText; // editor/language/study_text.hpp

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
/// #INCLUDE, the names of PlacedPar's own files. `parsed` is the last version of the program without errors of syntax;
/// null if there is none.
std::vector<Completion> complete_occam(const SourceFile&, const occam::Program* parsed, const Location&);
/// Returns the same for a configuration, and attributes and types in SET. After a word that only some names can follow,
/// such as PROCESSOR, returns only these names.
std::vector<Completion> complete_configuration(const SourceFile&, const occam::Program* parsed, const Location&);

/// Returns the words that are possible at the end of the text: keys, settings, measures and other values. `names` are
/// the names of the study's netlist.
std::vector<Completion> complete_study(const StudyText& before, const StudyNames& names, const Catalogue&);

} // namespace placedpar::editor
