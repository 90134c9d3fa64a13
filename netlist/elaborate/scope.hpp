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

/// Describes a declared thing or array. Its elements have the indices `first`, `first + 1`, ... in the draft; the last
/// subscript varies fastest. For the predefined edge, `first` is nowhere.
struct DeclaredThings {
    enum class Category { node, connection, edge_channel, process };
    Category category;
    std::size_t first = 0;
    std::vector<std::int64_t> dimensions; ///< empty: a single thing
};

/// Describes a type with which processes can be declared: `process`, or a type that a `define` made.
struct ProcessType {
    std::vector<Setting> settings;              ///< in order: a later setting overrides an earlier setting
    std::shared_ptr<const Interface> interface; ///< null if the type has no interface
};

using Type = std::variant<NodeType, ProcessType>;

/// Stands for the type `node`. The attribute `element` says whether a declaration with this type declares processors or
/// processes.
struct AnyElement {};

/// Holds the meaning of a name.
struct Symbol {
    std::variant<Constant, NodeType, ProcessType, AnyElement, DeclaredThings> meaning;
    Location declared; ///< empty if the name is predefined
};

std::string describe(const Symbol& symbol);

/// Holds the visible names. A name is visible from its declaration to the end of its block; an inner block may declare
/// it again. Predefined names belong to a block around the netlist, so they may be declared again.
class Scopes {
public:
    /// Declares the predefined names, including the catalogue's node types.
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
    /// Returns the declaration of the name in this block; null if the name is free here.
    const Symbol* find_in_this_block(std::string_view name) const;
    void declare(const std::string& name, Symbol symbol);
    void declare_predefined(const std::string& name, Symbol symbol);

    /// Sets the statements of this block that follow the current statement. REQUIRES: the statements outlive the block.
    void set_ahead(std::span<const Statement> statements) { ahead_.back() = statements; }
    /// Returns where an unknown name is declared later, in this block or in an enclosing block.
    std::optional<Location> declared_later(std::string_view name) const;

    std::vector<std::string> names() const;
    /// Returns the names of all types with which things can be declared.
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
