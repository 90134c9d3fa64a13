#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/language/names_in_text.hpp"

#include <optional>
#include <string>
#include <vector>

namespace placedpar::editor {

/// Describes which words are possible at a place of a netlist, according to the preceding words of the statement.
struct NetlistContext {
    enum class Place {
        statement, ///< a statement begins here
        file,      ///< the name of an included file
        program,   ///< the string after `use`
        member,    ///< after a dot: a port, a link, a parameter or an attribute of `owner`
        attribute, ///< in the parentheses of `owner`: the name of an attribute or parameter
        value,     ///< an expression; the value of an attribute if `attribute` is set
        thing,     ///< a declared thing, after `connect`, `place`, `to`, `on`, `by` and the like
        fault,     ///< the name of a fault
        new_name,  ///< a name that is being declared
        nothing    ///< within a word that cannot be completed
    };
    Place place = Place::statement;
    std::string owner = "";     ///< the name or type before the dot or the parentheses
    std::string attribute = ""; ///< the attribute whose value is at this place
    std::string fault = "";     ///< if set, the attributes belong to this fault of `owner`
    std::string word = "";      ///< the word before a thing, such as "place"
};

/// Returns the context at the token of this index.
NetlistContext context_of(const std::vector<Token>&, std::size_t index);

/// Describes a thing whose members an editor can suggest.
struct NetlistOwner {
    const NetlistName* name = nullptr;                  ///< null for a type or a predefined name
    const ProcessKind* kind = nullptr;                  ///< kind of a process; null if the kind is unknown
    std::shared_ptr<const DeviceKind> device = nullptr; ///< device of a node or type; null if it is unknown
    int links = 0;                                      ///< number of links of a node or type
};
NetlistOwner owner_of(const NetlistSyntax&, const Catalogue&, const std::string& name);

/// Returns the attributes and parameters that can be given in the parentheses of a context.
std::vector<ParameterDescription> attributes_in(const NetlistSyntax&, const Catalogue&, const NetlistContext&);
/// Returns the faults that the thing, or one of its links, can have.
std::vector<FaultKind> faults_of(const NetlistOwner&);

} // namespace placedpar::editor
