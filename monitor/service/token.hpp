#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace placedpar::monitor {

/// The word that everybody has to know who wants to be served; none: everybody is.
class Token {
public:
    Token() = default;
    /// The file's text without the space around it. Throws UserError when it cannot be read, others may read it, or it
    /// is no word of 16 to 1000 visible characters.
    explicit Token(const std::filesystem::path& file);

    const std::string& word() const { return word_; }
    bool wanted() const { return !word_.empty(); }
    /// Takes as long whatever is right of it.
    bool is(std::string_view word) const;

private:
    std::string word_;
};

} // namespace placedpar::monitor
