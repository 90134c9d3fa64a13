#pragma once

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace placedpar {

// What commands say of their options, and what can be read of it. CLI11, the library behind it, takes seconds to
// compile: only options.cpp and command_line.cpp include it.

/// Stands for an option of a command, or for an argument. A copy is the same option.
class Option {
public:
    explicit Option(CLI::Option& option) : option_(&option) {}

    Option type(const std::string& name); ///< what help calls its value: "FILE"
    /// `wrong` says what is wrong with a value; "" if nothing is.
    Option check(const std::function<std::string(const std::string&)>& wrong);
    Option one_of(const std::vector<std::string>& words); ///< takes no other, and they are its type
    Option required();
    Option show_default();                    ///< help shows the value that it has now
    Option group(const std::string& heading); ///< in help
    Option needs(Option other);               ///< refused without that

private:
    CLI::Option* option_;
};

struct DeclaredOption {
    std::vector<std::string> names; ///< as they are typed: "--seed", "-I"; none of an argument
    std::string label;              ///< all of them, or what help calls the argument
    std::string type;
    std::string value; ///< where none is typed; "": help does not show it
    std::string about;
    bool takes_value;
};

/// Describes a command, or the program itself.
struct DeclaredCommand {
    std::string name, about, footer;
    std::vector<DeclaredOption> options;
    std::vector<DeclaredCommand> commands; ///< of the program

    std::vector<std::string> names_of_commands() const;
    std::vector<std::string> names_of_options() const;
    // These return null where there is none.
    const DeclaredCommand* command(const std::string& called) const;
    const DeclaredOption* option(const std::string& typed) const;
};

/// Describes what has been declared so far.
DeclaredCommand declared(const CLI::App&);

/// Declares the options of a command, in the order in which help shows them. A copy declares for the same command.
class Options {
public:
    explicit Options(CLI::App& command) : command_(&command) {}

    /// `name` is "--seed", "-o,--out", or that of an argument, "FILE". `value` stays as it is where nothing is typed,
    /// outlives the command's action, and has one of the types that options.cpp lists.
    template <class Value>
    Option add(const std::string& name, Value& value, const std::string& about);
    /// Takes one value each time that it is typed; of a list add() would take all words that follow.
    Option add_list(const std::string& name, std::vector<std::string>& values, const std::string& type,
                    const std::string& about);
    Option add_flag(const std::string& name, bool& value, const std::string& about);
    void add_footer(const std::string& text); ///< in help, below the options

    /// Says whether the option was typed. REQUIRES: the command line has been read.
    bool is_given(const std::string& name) const;
    /// Describes the program that has the command. REQUIRES: all commands have been declared.
    DeclaredCommand program() const;

private:
    CLI::App* command_;
};

} // namespace placedpar
