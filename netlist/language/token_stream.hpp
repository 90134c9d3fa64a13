#pragma once

#include "netlist/language/lexer.hpp"
#include "text/load_source.hpp"

#include <deque>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

/// No netlist needs more; a chain of files each of which includes the next one twice would.
inline constexpr std::size_t most_tokens = 4'000'000;
inline constexpr std::size_t most_includes = 1000;
inline constexpr std::size_t most_included_bytes = 4 * largest_source_bytes;

/// The tokens of a source and of all that it includes, as one sequence with lookahead. A file that includes
/// itself, directly or through others, is refused.
class TokenStream {
public:
    TokenStream(std::shared_ptr<const SourceFile> main, const std::filesystem::path& path, Reporter& reporter);

    const Token& peek(std::size_t ahead = 0);
    Token take();
    /// The paths of the files included so far.
    std::vector<std::string> take_included() { return std::move(included_); }

private:
    struct Open {
        Lexer lexer;
        std::filesystem::path path; ///< canonical; compared to find cycles
        Location included_at;
    };

    void fill(std::size_t count);
    void include(const Token& directive);
    void open(const std::filesystem::path& path, const Token& name, const Token& directive);
    bool includes_itself(const std::filesystem::path& real, const Token& name);
    void report_problems(const LoadedSource& loaded, const Token& name);

    Reporter& reporter_;
    std::vector<Open> open_;
    std::vector<std::string> included_;
    std::deque<Token> ahead_;
    std::size_t tokens_ = 0, includes_ = 0, included_bytes_ = 0;
};

} // namespace placedpar
