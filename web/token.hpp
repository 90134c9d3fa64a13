#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace placedpar::web {

/// The secret word that a client of a service must send. If the token is empty, every client is served.
class Token {
public:
    Token() = default;
    /// Reads the token from a file, ignoring surrounding white space. Throws UserError if the file cannot be read, if
    /// other users may read it, or if it does not contain one word of 16 to 1000 visible characters.
    explicit Token(const std::filesystem::path& file);

    const std::string& word() const { return word_; }
    bool wanted() const { return !word_.empty(); }
    /// Compares in constant time, so that the time taken does not reveal how much of a guess is right.
    bool is(std::string_view word) const;

private:
    std::string word_;
};

} // namespace placedpar::web
