#pragma once

#include "netlist/language/lexer.hpp"
#include "text/load_source.hpp"

#include <deque>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

/// Limits the number of tokens. A chain of files in which each file includes the next file twice could otherwise give
/// too many tokens.
inline constexpr std::size_t most_tokens = 8'000'000;
inline constexpr std::size_t most_includes = 1000;
inline constexpr std::size_t most_included_bytes = 4 * largest_source_bytes;

/// Gives the tokens of a netlist and of the files that it includes as one sequence, with lookahead. Refuses a file that
/// includes itself, directly or through other files.
class TokenStream {
public:
    /// Searches for an included file first in the folder of the file that includes it, then in `include_folders`.
    /// `origins` gives the places of the tokens of `main`, if this text was made from another file (Lexer).
    TokenStream(std::shared_ptr<const SourceFile> main, const std::filesystem::path& path, Reporter& reporter,
                std::vector<std::filesystem::path> include_folders = {}, std::vector<PartOrigin> origins = {});

    const Token& peek(std::size_t ahead = 0);
    Token take();
    /// Returns the place after the token that was taken last.
    const Location& behind_last() const { return behind_last_; }
    /// Returns the paths of the files included so far.
    std::vector<std::string> take_included() { return std::move(included_); }
    /// Returns whether an `#include` of a file of INMOS's toolset has been read so far. The file need not exist.
    bool includes_toolset() const { return includes_toolset_; }

private:
    struct Open {
        Lexer lexer;
        std::filesystem::path path; ///< canonical path, which is compared to find cycles of includes
        Location included_at;
    };

    void fill(std::size_t count);
    Token next_token();
    void obey(const Token& directive);
    void include(const Token& directive);
    std::vector<std::filesystem::path> folders_for(const Token& name) const;
    void open(const Token& name);
    void refuse_missing(const Token& name);
    bool includes_itself(const std::filesystem::path& real, const Token& name);
    void report_problems(const LoadedSource& loaded, const Token& name);

    Reporter& reporter_;
    std::vector<std::filesystem::path> include_folders_;
    std::vector<Open> open_;
    std::vector<std::string> included_;
    bool includes_toolset_ = false;
    std::deque<Token> ahead_;
    Location behind_last_;
    std::size_t tokens_ = 0, includes_ = 0, included_bytes_ = 0;
};

} // namespace placedpar
