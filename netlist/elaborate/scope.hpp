#pragma once

#include "netlist/elaborate/draft.hpp"
#include "netlist/kinds/catalogue.hpp"
#include "netlist/language/syntax.hpp"

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace placedpar {

/// Describes a declared node, connection, edge channel or process, or an array of these. Its elements have the indices
/// `first`, `first + 1`, ... in a vector of the draft. The last subscript varies fastest. For the predefined edge
/// `host`, `first` is nowhere.
struct DeclaredThings {
    enum class Category { node, connection, edge_channel, process };
    Category category;
    std::size_t first = 0;
    std::vector<std::int64_t> dimensions; ///< empty: a single thing
};

/// Describes a type with which processes can be declared: `process`, or a type that a `define` made.
struct ProcessType {
    std::vector<Setting> settings;              ///< a later setting of a name replaces an earlier setting
    std::shared_ptr<const Interface> interface; ///< null if the type has no interface
};

using Type = std::variant<NodeType, ProcessType>;

/// Represents the predefined type `node`. Its attribute `element` says whether a declaration with this type declares
/// processors or processes.
struct AnyElement {};

/// Holds the meaning of a name.
struct Symbol {
    std::variant<Constant, NodeType, ProcessType, AnyElement, DeclaredThings> meaning;
    Location declared; ///< empty if the name is predefined
};

/// Returns a text for messages, such as "an array of nodes".
std::string describe(const Symbol& symbol);

/// Holds the names that are visible at the current statement. A name is visible from its declaration to the end of its
/// block. An inner block may declare the name again. Predefined names belong to a block around the netlist, so that the
/// netlist may declare them again.
class Scopes {
public:
    /// Declares the predefined names, including the types of nodes in the catalogue.
    explicit Scopes(const Catalogue& catalogue);

    void open() {
        scopes_.emplace_back();
        ahead_.emplace_back();
    }
    void close() {
        scopes_.pop_back();
        ahead_.pop_back();
    }
    /// Returns whether no block of the netlist is open.
    bool outermost() const { return scopes_.size() == 2; }

    const Symbol* find(std::string_view name) const;
    /// Returns the declaration of the name in the innermost block; null if this block does not declare the name.
    const Symbol* find_in_this_block(std::string_view name) const;
    void declare(const std::string& name, Symbol symbol);
    void declare_predefined(const std::string& name, Symbol symbol);

    /// Sets the statements of the innermost block that follow the current statement. REQUIRES: the statements outlive
    /// the block.
    void set_ahead(std::span<const Statement> statements) { ahead_.back() = statements; }
    /// Returns where an unknown name is declared later, in the innermost block or in a block around it; nothing if it
    /// is not.
    std::optional<Location> declared_later(std::string_view name) const;

    std::vector<std::string> names() const;
    /// Returns the names of all types of nodes and processes.
    std::vector<std::string> type_names() const;
    /// Returns the names of the predefined node types.
    std::vector<std::string> predefined_node_types() const;

    /// Notes that a declaration of this name was refused, so that a use of it is not reported as a second error.
    void poison(const std::string& name) { poisoned_.insert(name); }
    bool is_poisoned(const std::string& name) const { return poisoned_.contains(name); }

private:
    std::vector<std::map<std::string, Symbol, std::less<>>> scopes_;
    std::vector<std::span<const Statement>> ahead_ =
        std::vector<std::span<const Statement>>(2); ///< for each open block: the statements after the current statement
    std::set<std::string> poisoned_;
};

} // namespace placedpar
