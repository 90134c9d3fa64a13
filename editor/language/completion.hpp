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

/// Holds a word that an editor can offer at a place of a text.
struct Completion {
    enum class Kind { keyword, kind, port, parameter, value, variable, routine, type, file };
    std::string text;
    Kind kind = Kind::variable;
    std::string detail = ""; ///< short description, such as a range
    std::string about = "";  ///< longer description, in one sentence
};

/// Returns the words that are possible at a place of a netlist, in no particular order. The letters typed so far are
/// not considered: the editor leaves out words that begin with other letters.
std::vector<Completion> complete_netlist(const NetlistSyntax&, const Catalogue&, const Location&);

/// Returns the words that are possible at a place of a program in occam: keywords and visible names; after #USE and
/// #INCLUDE, the names of the libraries that are built into PlacedPar. `parsed` is the last version of the program that
/// could be parsed; null if there is none.
std::vector<Completion> complete_occam(const SourceFile&, const occam::Program* parsed, const Location&);
/// Returns the words that are possible at a place of a configuration in occam: keywords, visible names, and in SET,
/// attributes and types. After a word that only some names can follow, such as PROCESSOR, returns only these names.
std::vector<Completion> complete_configuration(const SourceFile&, const occam::Program* parsed, const Location&);

/// Returns the words that are possible after the text `before`, the beginning of a study. Words are keys of the file
/// and their values, such as the names of parameters and of measured quantities. `names` are the names that the study's
/// netlist declares.
std::vector<Completion> complete_study(const StudyText& before, const StudyNames& names, const Catalogue&);

} // namespace placedpar::editor
