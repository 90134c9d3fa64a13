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

/// Describes a name that a netlist declares.
struct NetlistName {
    enum class Category { val, type, node, process, connection, edge_channel, replicator };
    std::string name = "";
    Location at = {};
    Category category = Category::val;
    std::string type = "";    ///< word with which a node, a process or a type is declared
    std::string program = ""; ///< program that `use` gives a process; "" if none
    std::vector<std::string> inputs = {}, outputs = {}, parameters = {}; ///< interface of a process
};

/// Describes a place where a netlist uses a name.
struct NetlistNameUse {
    Location at;
    std::size_t name = 0; ///< index in NetlistSyntax::names
};

/// Holds the syntax of a netlist for an editor: words, statements, and the meaning of names.
struct NetlistSyntax {
    std::shared_ptr<const SourceFile> file;
    std::vector<Token> tokens = {}; ///< tokens of the file itself, without tokens of included files
    Statements statements = {};
    std::vector<NetlistName> names = {}; ///< names of the file and of included files, in the order of the text
    std::vector<NetlistNameUse> uses = {};
    std::vector<Diagnostic> diagnostics = {}; ///< diagnostics of lexer and parser
    std::vector<std::string> included = {};   ///< paths of the included files

    /// Returns the name that is declared or used at a place; null if there is none.
    const NetlistName* name_at(const Location&) const;
    /// Returns the last declaration of this name; null if there is none.
    const NetlistName* find(std::string_view name) const;
};

NetlistSyntax read_syntax(std::shared_ptr<const SourceFile>, std::vector<std::filesystem::path> include_folders = {});

/// Returns the tokens of a text, including tokens that the lexer refuses, without reporting errors. The last token is
/// the end.
std::vector<Token> tokens_of(const std::shared_ptr<const SourceFile>&);

/// Returns the index of the token that contains this place or ends there; nothing if there is none.
std::optional<std::size_t> token_at(const std::vector<Token>&, const Location&);

} // namespace placedpar
