#pragma once

#include "netlist/language/syntax.hpp"
#include "netlist/language/token.hpp"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

/// Describes a name that a netlist declares. The structures in this file serve editors, which explain and complete
/// names.
struct NetlistName {
    enum class Category { val, type, node, process, connection, edge_channel, replicator };
    std::string name = "";
    Location at = {};
    Category category = Category::val;
    std::string type = "";    ///< for a node, a process or a type: the name of its type, such as "T800"
    std::string program = ""; ///< for a process: the program that a `use` statement names; "" if none
    std::vector<std::string> inputs = {}, outputs = {}, parameters = {}; ///< for a process: the names in its interface
};

/// Describes a place where a netlist uses a name.
struct NetlistNameUse {
    Location at;
    std::size_t name = 0; ///< index in NetlistSyntax::names
};

/// Holds the words and statements of a netlist, and the declaration of each name.
struct NetlistSyntax {
    std::shared_ptr<const SourceFile> file;
    std::vector<Token> tokens = {}; ///< tokens of the file itself, without tokens of included files
    Statements statements = {};
    std::vector<NetlistName> names =
        {}; ///< names that the file and its included files declare, in the order of the text
    std::vector<NetlistNameUse> uses = {};
    std::vector<Diagnostic> diagnostics = {}; ///< errors that the lexer and the parser found
    std::vector<std::string> included = {};   ///< paths of the included files

    /// Returns the name that is declared or used at a place; null if there is none.
    const NetlistName* name_at(const Location&) const;
    /// Returns the last declaration of this name; null if there is none.
    const NetlistName* find(std::string_view name) const;
};

NetlistSyntax read_syntax(std::shared_ptr<const SourceFile>, std::vector<std::filesystem::path> include_folders = {});

/// Returns the tokens of a text, without reporting errors. Illegal tokens are included. The last token is of kind
/// `end`.
std::vector<Token> tokens_of(const std::shared_ptr<const SourceFile>&);

/// Returns the index of the token that contains this place, or that ends there; nothing if there is none.
std::optional<std::size_t> token_at(const std::vector<Token>&, const Location&);

} // namespace placedpar
