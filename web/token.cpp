#include "web/token.hpp"

#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace placedpar::web {

namespace fs = std::filesystem;

Token::Token(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    auto refuse = [&](const std::string& why) {
        throw UserError(fmt::format("--token-file {}: {}", file.string(), why));
    };
    if (!in || !fs::is_regular_file(file))
        refuse("the file cannot be read");
    if ((fs::status(file).permissions() & fs::perms::others_all) != fs::perms::none)
        refuse("every user of this computer may read or write the file; protect it: chmod o= " + file.string());
    std::string text(std::istreambuf_iterator<char>(in), {});
    auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
    auto begin = std::ranges::find_if_not(text, is_space);
    auto end = std::find_if_not(text.rbegin(), std::make_reverse_iterator(begin), is_space).base();
    word_.assign(begin, end);
    auto visible = [](char c) { return c > ' ' && c <= '~'; };
    if (word_.size() < 16 || word_.size() > 1000 || !std::ranges::all_of(word_, visible))
        refuse("the file has no valid token; expected one word of 16 to 1000 visible ASCII characters, such as the "
               "output of openssl rand -hex 16");
}

bool Token::is(std::string_view word) const {
    if (word.size() != word_.size())
        return false;
    unsigned different = 0;
    for (std::size_t i = 0; i < word.size(); ++i)
        different |= static_cast<unsigned char>(word[i] ^ word_[i]);
    return different == 0;
}

} // namespace placedpar::web
