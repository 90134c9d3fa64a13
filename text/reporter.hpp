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
/// Reading stops at this number of errors. Errors beyond the first most_errors are only counted.
inline constexpr std::size_t most_counted_errors = 1000;
inline constexpr std::size_t most_warnings = 200;
/// Reading also stops after this many errors at places that already have an error. A statement in a loop can cause such
/// errors.
inline constexpr std::size_t most_repeated = 50;

/// Thrown to stop reading a text after too many errors, or when a limit is exceeded. The function that owns the
/// Reporter catches this exception and shows the diagnostics; the last one gives the reason.
struct GiveUp {};

/// Collects the errors and warnings that are found while a user's text, such as a netlist, is read.
class Reporter {
public:
    /// Adds an error. Ignores it if its place already has an error. Keeps only the first most_errors errors, and counts
    /// the others. Throws GiveUp when most_counted_errors errors have been counted, or most_repeated errors have been
    /// ignored.
    void error(const Location& location, std::string message, std::string hint = "",
               std::vector<SecondPlace> others = {});
    /// Adds an error, and throws GiveUp: reading cannot continue after this error.
    [[noreturn]] void give_up(const Location& location, std::string message, std::vector<SecondPlace> others = {});
    void warning(const Location& location, std::string message, std::string hint = "");
    /// Tells that `file` is included at `at`. Each later diagnostic in `file` gets the note "included here".
    void add_included(const std::shared_ptr<const SourceFile>& file, const Location& at) { included_[file] = at; }
    /// Tells that an option has given `name` another value; `at` is the place of the option. Each later diagnostic in a
    /// line that uses the name also shows the option, since its value may be the cause.
    void add_option(const std::string& name, const Location& at) { options_[name] = at; }
    /// Replaces all errors and warnings so far by this error.
    void replace_all(const Location& location, std::string message, std::string hint);

    bool failed() const { return errors_ > 0; }
    /// Returns whether another error would be kept. If not, the caller need not compute a hint.
    bool keeps_more() const { return errors_ < most_errors; }
    /// Returns the file of the first error; null if there is no error or the error has no file.
    std::shared_ptr<const SourceFile> first_file() const;
    std::vector<Diagnostic> take() { return std::move(diagnostics_); }
    /// Returns a text that tells how many errors and warnings were not kept; "" if all were kept.
    std::string not_shown() const;

private:
    void keep(Diagnostic diagnostic);
    void note_options(Diagnostic& diagnostic) const;
    /// Returns false if the place has an error already.
    bool is_first_at(const Location& place);

    std::vector<Diagnostic> diagnostics_;
    std::set<std::tuple<std::shared_ptr<const SourceFile>, std::size_t, std::size_t>> places_; ///< places of errors
    std::map<std::shared_ptr<const SourceFile>, Location> included_; ///< place at which each file is included
    std::map<std::string, Location, std::less<>> options_;           ///< place at which each name is set
    std::size_t errors_ = 0, repeated_ = 0, warnings_ = 0;
};

} // namespace placedpar
