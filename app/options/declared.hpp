#pragma once

#include <string>
#include <vector>

namespace placedpar {

// The command line as it has been declared, for those who describe it or guess what was meant.

struct DeclaredOption {
    std::vector<std::string> names; ///< as they are typed: "--seed", "-I"; none of an argument
    std::string label;              ///< all of them, or what help calls the argument
    std::string type;               ///< of its value, for help: "FILE", "a|b"
    std::string value;              ///< that it has unless it is typed; "": help does not say
    std::string about;
    bool takes_value;
};

/// A command, or the program, which has commands.
struct DeclaredCommand {
    std::string name, about, footer;
    std::vector<DeclaredOption> options;
    std::vector<DeclaredCommand> commands;

    std::vector<std::string> names_of_commands() const;
    std::vector<std::string> names_of_options() const; ///< as they are typed

    // Null where there is none.
    const DeclaredCommand* command(const std::string& called) const;
    const DeclaredOption* option(const std::string& typed) const;
};

} // namespace placedpar
