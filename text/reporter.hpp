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
/// Further errors are only counted; reading stops when this many errors were found.
inline constexpr std::size_t most_counted_errors = 1000;
inline constexpr std::size_t most_warnings = 200;
/// Reading stops after this many errors at places that already have an error, as a line in a loop would cause.
inline constexpr std::size_t most_repeated = 50;

/// Thrown to stop reading after too many errors or an exceeded bound. The last diagnostic gives the reason. The reader
/// that owns the reporter catches this exception, so it never reaches the user.
struct GiveUp {};

/// Collects what is wrong while a text is read.
class Reporter {
public:
    /// Keeps at most one error per place and most_errors in total. Throws GiveUp when there are most_counted_errors
    /// errors, or most_repeated at places that already had an error.
    void error(const Location& location, std::string message, std::string hint = "",
               std::vector<SecondPlace> others = {});
    /// Reports the last error, after which it makes no sense to read on.
    [[noreturn]] void give_up(const Location& location, std::string message, std::vector<SecondPlace> others = {});
    void warning(const Location& location, std::string message, std::string hint = "");
    /// Makes each later diagnostic in this file say where the file is included.
    void add_included(const std::shared_ptr<const SourceFile>& file, const Location& at) { included_[file] = at; }
    /// Records that an option gave the name another value. Each later diagnostic in a line that uses the name says so,
    /// since the value may be the cause.
    void add_option(const std::string& name, const Location& at) { options_[name] = at; }
    /// Forgets all earlier reports and keeps only this error.
    void replace_all(const Location& location, std::string message, std::string hint);

    bool failed() const { return errors_ > 0; }
    /// Returns whether another error would be kept, so that computing a hint for it is worthwhile.
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
    std::set<std::tuple<std::shared_ptr<const SourceFile>, std::size_t, std::size_t>> places_; ///< of errors
    std::map<std::shared_ptr<const SourceFile>, Location> included_; ///< where each is included
    std::map<std::string, Location, std::less<>> options_;           ///< where each name is set
    std::size_t errors_ = 0, repeated_ = 0, warnings_ = 0;
};

} // namespace placedpar
