#pragma once

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace placedpar {

// Commands declare their options with these classes, and help and completion read them. CLI11, the library behind them,
// takes seconds to compile, so only options.cpp and command_line.cpp include it.

/// A reference to an option or an argument of a command, through which the command declares its properties. A copy
/// refers to the same option.
class Option {
public:
    explicit Option(CLI::Option& option) : option_(&option) {}

    Option type(const std::string& name); ///< `name` names the option's value in help: "FILE"
    /// `wrong` returns what is wrong with a value, or "".
    Option check(const std::function<std::string(const std::string&)>& wrong);
    Option one_of(const std::vector<std::string>& words); ///< accepts only these words; help lists them
    Option required();
    Option show_default();                    ///< help shows the option's present value
    Option group(const std::string& heading); ///< help lists the option below this heading
    Option needs(Option other);               ///< the option is refused unless `other` is typed, too

private:
    CLI::Option* option_;
};

struct DeclaredOption {
    std::vector<std::string> names; ///< as typed: "--seed", "-I"; empty for an argument
    std::string label;              ///< text in help: all names of an option, or the name of an argument
    std::string type;
    std::string value; ///< value if the option is not typed; "": help shows no value
    std::string about;
    bool takes_value;
};

/// Describes a command or the program itself.
struct DeclaredCommand {
    std::string name, about, footer;
    std::vector<DeclaredOption> options;
    std::vector<DeclaredCommand> commands; ///< commands of the program; empty for a command

    std::vector<std::string> names_of_commands() const;
    std::vector<std::string> names_of_options() const;
    // These functions return null if there is no such command or option.
    const DeclaredCommand* command(const std::string& called) const;
    const DeclaredOption* option(const std::string& typed) const;
};

/// Returns the program with all commands and options declared so far.
DeclaredCommand declared(const CLI::App&);

/// Declares the options of a command, in the order in which help lists them. A copy declares for the same command.
class Options {
public:
    explicit Options(CLI::App& command) : command_(&command) {}

    /// `name` is "--seed", "-o,--out" or the name of an argument, "FILE". If the option is not typed, `value` stays
    /// unchanged. REQUIRES: `value` outlives the command's action and has one of the types that options.cpp lists.
    template <class Value>
    Option add(const std::string& name, Value& value, const std::string& about);
    /// Declares an option that may be repeated and takes one value each time. add() with a list would take all words
    /// that follow the option.
    Option add_list(const std::string& name, std::vector<std::string>& values, const std::string& type,
                    const std::string& about);
    Option add_flag(const std::string& name, bool& value, const std::string& about);
    void add_footer(const std::string& text); ///< help shows the text below the options

    /// Returns whether the option was typed. REQUIRES: the command line has been parsed.
    bool is_given(const std::string& name) const;
    /// Returns the program that contains the command. REQUIRES: all commands have been declared.
    DeclaredCommand program() const;

private:
    CLI::App* command_;
};

} // namespace placedpar
