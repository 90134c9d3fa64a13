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
/// The number of errors at which reading stops. Errors beyond most_errors are only counted.
inline constexpr std::size_t most_counted_errors = 1000;
inline constexpr std::size_t most_warnings = 200;
/// Reading also stops after this many errors at places that already have an error. A line in a loop causes such errors.
inline constexpr std::size_t most_repeated = 50;

/// Thrown to stop reading after too many errors, or when a limit is exceeded. The last diagnostic gives the reason. The
/// reader that owns the reporter catches this exception, so it never reaches the user.
struct GiveUp {};

/// Collects the errors and warnings that are found while a text is read.
class Reporter {
public:
    /// Keeps at most one error per place, and most_errors in total. Throws GiveUp at error number most_counted_errors,
    /// and at the most_repeated-th error at a place that already had one.
    void error(const Location& location, std::string message, std::string hint = "",
               std::vector<SecondPlace> others = {});
    /// Reports the last error, and throws GiveUp.
    [[noreturn]] void give_up(const Location& location, std::string message, std::vector<SecondPlace> others = {});
    void warning(const Location& location, std::string message, std::string hint = "");
    /// Adds the note "included here", with the place `at`, to each later diagnostic in `file`.
    void add_included(const std::shared_ptr<const SourceFile>& file, const Location& at) { included_[file] = at; }
    /// Records that an option at `at` gave `name` another value. Each later diagnostic in a line that uses the name
    /// refers to the option, since the value may be the cause.
    void add_option(const std::string& name, const Location& at) { options_[name] = at; }
    /// Forgets all earlier reports and keeps only this error.
    void replace_all(const Location& location, std::string message, std::string hint);

    bool failed() const { return errors_ > 0; }
    /// Returns whether another error would be kept. Only then is it worthwhile to compute a hint.
    bool keeps_more() const { return errors_ < most_errors; }
    /// Returns the file of the first error; null if there is no error or the error has no file.
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
    std::set<std::tuple<std::shared_ptr<const SourceFile>, std::size_t, std::size_t>> places_; ///< places of errors
    std::map<std::shared_ptr<const SourceFile>, Location> included_; ///< place at which each file is included
    std::map<std::string, Location, std::less<>> options_;           ///< place at which each name is set
    std::size_t errors_ = 0, repeated_ = 0, warnings_ = 0;
};

} // namespace placedpar
