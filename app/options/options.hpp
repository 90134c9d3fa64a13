#pragma once

#include "app/options/declared.hpp"
#include "runtime/time.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace placedpar {

// What commands say of their options. The library that reads command lines, CLI11, takes seconds to compile: only
// options.cpp and app/command_line.cpp include it.

/// An option of a command, or an argument without a name. Refers to it: a copy is the same option.
class Option {
public:
    explicit Option(CLI::Option& option) : option_(&option) {}

    /// What help calls its value: "FILE".
    Option type(const std::string& name);
    /// `wrong` says what is wrong with a value; "" if nothing is.
    Option check(const std::function<std::string(const std::string&)>& wrong);
    /// Takes none but these words, and help shows them.
    Option one_of(const std::vector<std::string>& words);
    Option required();
    /// Help shows the value that it has now.
    Option show_default();
    Option group(const std::string& heading); ///< in help
    /// Refused without `other`.
    Option needs(Option other);

private:
    CLI::Option* option_;
};

/// The options of a command, in the order of help. Refers to the command, as an Option does.
class Options {
public:
    explicit Options(CLI::App& command) : command_(&command) {}

    /// `name` is typed, "-o,--out", or else that of an argument, in capitals. Where nothing is typed, `value` stays as
    /// it is. It outlives the command's action, and has one of the types that options.cpp lists.
    template <class Value>
    Option add(const std::string& name, Value& value, const std::string& about);
    /// Takes a moment or a span of virtual time: see parse_time().
    Option add(const std::string& name, Time& value, const std::string& about);
    Option add(const std::string& name, std::optional<Time>& value, const std::string& about);
    /// Takes one of the values each time that it is typed, as often as wanted; add() takes all words that follow.
    Option add_list(const std::string& name, std::vector<std::string>& values, const std::string& type,
                    const std::string& about);
    /// Takes no value: `value` is set where it is typed.
    Option add_flag(const std::string& name, bool& value, const std::string& about);
    /// The lines below the options in help.
    void add_footer(const std::string& text);

    /// Whether it was typed. REQUIRES: the command line has been read.
    bool is_given(const std::string& name) const;
    /// The program that has the command. REQUIRES: all commands have been declared.
    DeclaredCommand program() const;

private:
    CLI::App* command_;
};

/// What has been declared so far.
DeclaredCommand declared(const CLI::App&);

} // namespace placedpar
