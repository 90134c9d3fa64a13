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

/// Holds the results of checking a program in occam or a configuration.
struct OccamResults {
    std::shared_ptr<const OccamCheck> present = {};     ///< check of the present text; null: not checked yet
    std::shared_ptr<const OccamCheck> last_parsed = {}; ///< check of the last version without errors of syntax; null:
                                                        ///< there is none
    std::optional<std::map<std::size_t, LineCycles>> cycles = {}; ///< cycles of each line of the present text
};

/// Holds a text that an editor has open, and the results of reading the text. The results are kept until the text
/// changes.
struct Document {
    std::string uri;
    std::filesystem::path path;
    Language language = Language::netlist;
    NamesOf names = NamesOf::netlist; ///< language in which diagnostics of the text write names
    bool is_part = false;             ///< other files include this text, so only its syntax is checked
    std::optional<std::uint64_t> version = {};
    std::shared_ptr<const SourceFile> file;

    std::set<std::filesystem::path> included = {}; ///< files that the text includes
    std::optional<NetlistSyntax> netlist = {};     ///< syntax of a netlist; nullopt: not read yet, or another language
    OccamResults occam = {};                       ///< empty for other languages
    std::optional<StudyNames> study = {};          ///< names of a study's netlist; nullopt: not read yet
    bool failed = false; ///< whether the last check has found an error; a missing file may be the reason

    /// Converts a position of the protocol to a place in the file. Throws RequestError if the position is after the end
    /// of the text.
    Location location(Position) const;
    /// Discards the results. Call it when the text or an included file has changed.
    void forget();
};

/// Holds the texts that an editor has open.
class Documents {
public:
    /// Opens a text. The extension of the file name determines the language. If it is unknown, `language_id` determines
    /// the language; if this name is unknown, too, the text itself does.
    Document& open(const std::string& uri, const std::string& language_id, std::string text);
    /// Applies the member "contentChanges" of a notification. Throws RequestError, and leaves the text unchanged, if a
    /// place is not in the text.
    void change(Document&, const boost::json::array& changes);
    void close(const std::string& uri);

    /// Throws RequestError if no text of this URI is open.
    Document& at(const std::string& uri);
    std::map<std::string, Document>& all() { return documents_; }
    const TextsInMemory& texts() const { return texts_; }
    /// Returns the URI of a file. If the editor has opened the file, returns the URI that the editor used.
    std::string uri_of(const std::filesystem::path&) const;

private:
    void set_text(Document&, std::string text);

    std::map<std::string, Document> documents_;
    TextsInMemory texts_;
};

} // namespace placedpar::editor
