#pragma once

#include "explore/check/line_cycles.hpp"
#include "explore/occam_check.hpp"
#include "explore/study/study_names.hpp"
#include "netlist/language/names_in_text.hpp"
#include "text/positions.hpp"
#include "text/texts_in_memory.hpp"

#include <boost/json/fwd.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

namespace placedpar::editor {

enum class Language : std::uint8_t { netlist, configuration, occam, study };

/// Holds the results of checking a program or configuration in occam.
struct OccamResults {
    std::shared_ptr<const OccamCheck> present = {}; ///< result for the present text; null: not checked yet
    std::shared_ptr<const OccamCheck> last_parsed =
        {}; ///< result for the last version of the text that could be parsed; null: there is none
    std::optional<std::map<std::size_t, LineCycles>> cycles =
        {}; ///< processor cycles of each line of the present text; nullopt: not computed yet
};

/// Holds a text that an editor has open, and the results of reading this text. The results are kept until the text
/// changes.
struct Document {
    std::string uri;
    std::filesystem::path path;
    Language language = Language::netlist;
    NamesOf names = NamesOf::netlist; ///< language of the names in the diagnostics
    bool is_part = false; ///< the text is meant to be included in other files, so that only its syntax can be checked
    std::optional<std::uint64_t> version = {};
    std::shared_ptr<const SourceFile> file;

    std::set<std::filesystem::path> included = {}; ///< files that the text includes
    std::optional<NetlistSyntax> netlist =
        {};                  ///< syntax of a netlist; nullopt: not parsed yet, or the text is in another language
    OccamResults occam = {}; ///< empty for other languages
    std::optional<StudyNames> study = {}; ///< names that the netlist of a study declares; nullopt: not read yet
    bool failed =
        false; ///< whether the last check has found an error; another file, such as a missing file, may be the cause

    /// Converts a position of the Language Server Protocol to a place in the file. Throws RequestError if the position
    /// is after the end of the text.
    Location location(Position) const;
    /// Discards the results. REQUIRES: called when the text, or a file that it includes, has changed.
    void forget();
};

/// Holds the texts that an editor has open.
class Documents {
public:
    /// Opens a text. The extension of the file name determines the language. If the extension is unknown,
    /// `language_id`, the editor's name of the language, determines it. If this name is unknown, too, the contents of
    /// the text determine the language.
    Document& open(const std::string& uri, const std::string& language_id, std::string text);
    /// Changes the text as the editor says: `changes` is the member "contentChanges" of its notification. If a place of
    /// a change is not in the text, throws RequestError and leaves the text unchanged.
    void change(Document&, const boost::json::array& changes);
    void close(const std::string& uri);

    /// Returns the open text of this URI. Throws RequestError if there is none.
    Document& at(const std::string& uri);
    std::map<std::string, Document>& all() { return documents_; }
    const TextsInMemory& texts() const { return texts_; }
    /// Returns the URI of a file: if the editor has opened the file, the URI that the editor uses.
    std::string uri_of(const std::filesystem::path&) const;

private:
    void set_text(Document&, std::string text);

    std::map<std::string, Document> documents_;
    TextsInMemory texts_;
};

} // namespace placedpar::editor
