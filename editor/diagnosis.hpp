#pragma once

#include "editor/documents.hpp"
#include "netlist/kinds/catalogue.hpp"

#include <boost/json/fwd.hpp>

#include <map>
#include <string>
#include <vector>

namespace placedpar::editor {

/// Reads and checks an open text. Keeps results in the document for later requests. A text in TOML without a line
/// `netlist = ...` is not a study, and is not checked.
std::vector<Diagnostic> check_document(Document&, const Catalogue&);

/// Returns the syntax of a netlist. Reads the text again only if it has changed.
const NetlistSyntax& syntax_of(Document&);
/// Returns the checked program in occam, or the configuration. Checks the text again only if it has changed.
const OccamCheck& program_of(Document&);
/// Returns the names of a study's netlist; no names if the netlist has an error. Reads the netlist again only if a text
/// has changed.
const StudyNames& names_of(Document&, const Catalogue&, const ProblemRegistry&);

/// Writes ranges in the format of the protocol. Computes the line lengths of each text only once. REQUIRES: the files
/// outlive this object.
class RangeWriter {
public:
    /// Returns a range in one line. REQUIRES: the location has a file.
    boost::json::object range(const Location&, std::size_t bytes);
    /// Returns the range from a place to the end of the word there. REQUIRES: the location has a file.
    boost::json::object range_of_word(const Location&, NamesOf);

private:
    std::map<const SourceFile*, Positions> positions_;
};

/// Returns the diagnostics in the format of the protocol, by the URI of their file. A diagnostic without a file, such
/// as a diagnostic about a study's setting, is reported at the beginning of the document.
std::map<std::string, boost::json::array> diagnostics_json(const std::vector<Diagnostic>&, const Document&,
                                                           const Documents&);

} // namespace placedpar::editor
