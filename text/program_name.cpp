#include "text/program_name.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

namespace placedpar {

namespace {

std::string& name_of_program() {
    static std::string name = "placedpar";
    return name;
}

bool is_plain(char character) {
    return std::isalnum(static_cast<unsigned char>(character)) != 0 ||
           std::string_view("_.,=+-/:@%").find(character) != std::string_view::npos;
}

} // namespace

const std::string& program_name() { return name_of_program(); }

void set_program_name(std::string name) { name_of_program() = std::move(name); }

std::string shell_word(const std::string& text) {
    if (!text.empty() && std::ranges::all_of(text, is_plain))
        return text;
    std::string out = "'";
    for (char character : text)
        out += character == '\'' ? "'\\''" : std::string(1, character);
    return out + "'";
}

} // namespace placedpar
