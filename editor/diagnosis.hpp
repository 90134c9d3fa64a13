#pragma once

#include "editor/documents.hpp"
#include "netlist/kinds/catalogue.hpp"

#include <boost/json/fwd.hpp>

#include <map>
#include <string>
#include <vector>

namespace placedpar::editor {

/// Reads and checks a text that is open. Keeps in the document what can be used again. A text in TOML that names no
/// netlist is not a study, and nothing is wrong with it.
std::vector<Diagnostic> check_document(Document&, const Catalogue&);

/// Reads the syntax of a netlist, or returns what was read before.
const NetlistSyntax& syntax_of(Document&);
/// Reads and checks a program in occam, or returns what was read before.
const OccamCheck& program_of(Document&);

/// Writes ranges as the protocol has them. Each text is measured once. REQUIRES: the files outlive this object.
class RangeWriter {
public:
    /// Returns a range in one line. REQUIRES: the location has a file.
    boost::json::object range(const Location&, std::size_t bytes);
    /// Returns the range from a place to the end of the word there. REQUIRES: the location has a file.
    boost::json::object range_of_word(const Location&, NamesOf);

private:
    std::map<const SourceFile*, Positions> positions_;
};

/// Returns the diagnostics as the protocol has them, by the URI of their files. What is not about a file, such as a
/// setting of a study, is at the beginning of the document.
std::map<std::string, boost::json::array> diagnostics_json(const std::vector<Diagnostic>&, const Document&,
                                                           const Documents&);

} // namespace placedpar::editor
