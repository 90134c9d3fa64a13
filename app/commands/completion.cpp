#include "app/command.hpp"
#include "app/options.hpp"
#include "text/output_file.hpp"

#include <boost/algorithm/string/replace.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

namespace placedpar {

namespace {

using Words = std::vector<std::string>;

/// The completion scripts for bash and zsh. In both scripts PROGRAM is replaced by the program's name.
constexpr const char* bash_script =
    R"bash(# Asks the program for the words that may come next. If there are none, bash completes file names.
_PROGRAM() {
    local IFS=$'\n'
    COMPREPLY=($(PROGRAM completion words -- "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null))
}
complete -o default -F _PROGRAM PROGRAM
)bash";

constexpr const char* zsh_script = R"zsh(#compdef PROGRAM
# Asks the program for the words that may come next. If there are none, zsh completes file names.
_PROGRAM() {
    local -a found
    found=(${(f)"$(PROGRAM completion words -- "${(@)words[2,CURRENT]}" 2>/dev/null)"})
    if (( $#found )); then compadd -a found; else _files; fi
}
if [[ $funcstack[1] == _PROGRAM ]]; then _PROGRAM "$@"; else compdef _PROGRAM PROGRAM; fi
)zsh";

/// Returns the words in "auto|none|INCHES" that are typed literally.
Words choices_in(const std::string& type) {
    if (type.find('|') == std::string::npos)
        return {};
    Words choices{""};
    for (char c : type)
        if (c == '|')
            choices.emplace_back();
        else
            choices.back() += c;
    std::erase_if(choices, [](const std::string& word) {
        return std::ranges::any_of(word, [](unsigned char c) { return std::isupper(c) != 0; });
    });
    return choices;
}

Words first_words(const DeclaredCommand& program) {
    Words names = program.names_of_options();
    std::ranges::move(program.names_of_commands(), std::back_inserter(names));
    return names;
}

Words values_of(const std::string& command) {
    for (const Command& each : commands())
        if (command == each.name && each.values)
            return each.values();
    return {};
}

/// Removes "=", because bash splits --format=svg into three words.
Words without_equals(const Words& typed) {
    Words words;
    for (const std::string& word : typed)
        if (word != "=")
            words.push_back(word);
    if (!typed.empty() && typed.back() == "=")
        words.emplace_back();
    return words;
}

/// Returns all candidates for the last word, also candidates that do not begin as the typed word does.
Words candidates(const DeclaredCommand& program, const Words& words) {
    if (words.size() < 2)
        return first_words(program);
    const DeclaredCommand* command = program.command(words.front());
    if (!command)
        return {};
    const DeclaredOption* option = command->option(words[words.size() - 2]);
    if (option && option->takes_value)
        return choices_in(option->type);
    return words.back().starts_with('-') ? command->names_of_options() : values_of(words.front());
}

/// Cuts the option off a last word such as --format=s, so that only the value is completed. bash has already split such
/// a word; zsh has not. Returns the option with "=", or "".
std::string cut_option_off(Words& words) {
    if (words.empty() || !words.back().starts_with("--") || words.back().find('=') == std::string::npos)
        return "";
    std::string last = words.back(), option = last.substr(0, last.find('='));
    words.back() = option;
    words.push_back(last.substr(option.size() + 1));
    return option + "=";
}

std::string list_words(const DeclaredCommand& program, const Words& typed) {
    Words words = without_equals(typed);
    std::string option = cut_option_off(words), begun = words.empty() ? "" : words.back(), out;
    auto is_short_option = [](const std::string& word) { return word.size() == 2 && word[0] == '-'; };
    for (const std::string& each : candidates(program, words))
        if (each.starts_with(begun) && (begun == "-" || begun == each || !is_short_option(each)))
            out += option + each + "\n";
    return out;
}

std::string script(std::string text) {
    boost::algorithm::replace_all(text, "PROGRAM", program_name());
    return text;
}

std::string refuse_shell(const std::string& name) {
    bool known = name == "bash" || name == "zsh" || name == "words"; // "words" is for the scripts
    return known ? "" : fmt::format("no completion for the shell \"{}\"; expected bash or zsh", name);
}

struct CompletionOptions {
    std::string shell;
    Words words;
};

Action declare_completion(Options& command, const std::string&) {
    auto options = std::make_shared<CompletionOptions>();
    command
        .add("SHELL", options->shell,
             fmt::format("prints a script for this shell, which loads it by: source <({} completion bash)",
                         program_name()))
        .required()
        .check(refuse_shell)
        .type("bash|zsh");
    command.add("WORDS", options->words,
                "internal: the scripts use it to ask for the possible values of the last word");
    return [options, command] {
        print_out(options->shell == "bash"  ? script(bash_script)
                  : options->shell == "zsh" ? script(zsh_script)
                                            : list_words(command.program(), options->words));
        return ExitCode::success;
    };
}

} // namespace

extern const Command completion_command{
    .name = "completion",
    .about = "Prints a script with which a shell completes commands, options and names",
    .place = 110,
    .declare = declare_completion,
    .values =
        [] {
            return std::vector<std::string>{"bash", "zsh"};
        },
};

} // namespace placedpar
