#pragma once

#include "text/diagnostic.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace placedpar {

inline constexpr std::size_t most_errors = 20;
/// Errors beyond those that are kept are counted, up to so many in all.
inline constexpr std::size_t most_counted_errors = 1000;
inline constexpr std::size_t most_warnings = 200;
/// Errors at places that have one already: what is read in a loop goes wrong each time.
inline constexpr std::size_t most_repeated = 50;

/// Thrown when reading on makes no sense: too many errors, a bound exceeded. The last diagnostic says why. It is not
/// an error of its own: the reader that owns the reporter catches it.
struct GiveUp {};

/// Collects what is wrong while a text is read.
class Reporter {
public:
    /// Keeps one error a place, a second one there says nothing new, and no more than most_errors. Throws GiveUp when
    /// most_counted_errors were found.
    void error(const Location& location, std::string message, std::string hint = "",
               std::vector<SecondPlace> others = {});
    /// Reports the last error, after which it makes no sense to read on.
    [[noreturn]] void give_up(const Location& location, std::string message, std::vector<SecondPlace> others = {});
    void warning(const Location& location, std::string message, std::string hint = "");
    /// Each diagnostic in this file will say where the file is included.
    void add_included(const std::shared_ptr<const SourceFile>& file, const Location& at) { included_[file] = at; }
    /// An option gave the name another value: each error in a line that uses it will say so, since that may be why.
    void add_option(const std::string& name, const Location& at) { options_[name] = at; }
    /// One error says it all: forgets what was reported before.
    void replace_all(const Location& location, std::string message, std::string hint);

    bool failed() const { return errors_ > 0; }
    /// Whether one more error would be kept, and is worth a good hint.
    bool keeps_more() const { return errors_ < most_errors; }
    /// The file of the first error; null without one.
    std::shared_ptr<const SourceFile> first_file() const;
    std::vector<Diagnostic> take() { return std::move(diagnostics_); }
    /// Returns a note on the errors and warnings that were not kept; "" if all were kept.
    std::string not_shown() const;

private:
    void keep(Diagnostic diagnostic);
    void note_options(Diagnostic& diagnostic) const;
    /// Returns false if the place has an error already.
    bool is_first_at(const Location& place);

    std::vector<Diagnostic> diagnostics_;
    std::set<std::tuple<std::shared_ptr<const SourceFile>, std::size_t, std::size_t>> places_; ///< of errors
    std::map<std::shared_ptr<const SourceFile>, Location> included_;                           ///< at
    std::map<std::string, Location, std::less<>> options_;                                     ///< by name: at
    std::size_t errors_ = 0, repeated_ = 0, warnings_ = 0;
};

} // namespace placedpar
