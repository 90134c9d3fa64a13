#pragma once

#include "editor/documents.hpp"
#include "netlist/kinds/catalogue.hpp"

#include <boost/json/fwd.hpp>

#include <map>
#include <string>
#include <vector>

namespace placedpar::editor {

/// Reads and checks a text that an editor has open, and returns its errors and warnings. Keeps results in the Document
/// for later requests. A text in TOML without a line `netlist = ...` is not checked, since only studies, which are
/// experiments with a netlist, have such a line.
std::vector<Diagnostic> check_document(Document&, const Catalogue&);

/// Returns the syntax of a netlist. Parses the text again only if it has changed.
const NetlistSyntax& syntax_of(Document&);
/// Returns the checked program or configuration in occam. Checks the text again only if it has changed.
const OccamCheck& program_of(Document&);
/// Returns the names that a study can use, which its netlist declares; no names if the netlist has an error. Reads the
/// netlist again only if the study or the netlist has changed.
const StudyNames& names_of(Document&, const Catalogue&, const ProblemRegistry&);

/// Writes ranges of text in the format of the Language Server Protocol. Finds the lines of each text only once.
/// REQUIRES: the files outlive this object.
class RangeWriter {
public:
    /// Returns the range of `bytes` bytes from a place, in one line. REQUIRES: the location has a file.
    boost::json::object range(const Location&, std::size_t bytes);
    /// Returns the range from a place to the end of the word there. REQUIRES: the location has a file.
    boost::json::object range_of_word(const Location&, NamesOf);

private:
    std::map<const SourceFile*, Positions> positions_;
};

/// Returns the diagnostics in the format of the Language Server Protocol, by the URI of their file. A diagnostic
/// without a file is put at the beginning of the document.
std::map<std::string, boost::json::array> diagnostics_json(const std::vector<Diagnostic>&, const Document&,
                                                           const Documents&);

} // namespace placedpar::editor
