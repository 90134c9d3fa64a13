#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/language/names_in_text.hpp"

#include <optional>
#include <string>
#include <vector>

namespace placedpar::editor {

/// Tells which words an editor can offer at a place of a netlist. The preceding words of the statement determine them.
struct NetlistContext {
    enum class Place {
        statement, ///< a statement begins here
        file,      ///< the name of an included file
        program,   ///< the string after `use`
        member,    ///< after `owner` and a dot: a port, a link, a parameter or an attribute
        attribute, ///< in the parentheses after `owner`: the name of an attribute or parameter
        value,     ///< an expression; the value of an attribute if `attribute` is set
        thing,     ///< a declared name, after `connect`, `place`, `to`, `on`, `by` and the like
        fault,     ///< the name of a fault
        new_name,  ///< a name that is being declared
        nothing    ///< nothing can be offered here
    };
    Place place = Place::statement;
    std::string owner = "";     ///< the name or type before the dot or the parentheses
    std::string attribute = ""; ///< for Place::value, the attribute that gets the value; "" if none
    std::string fault = "";     ///< fault to which the attributes in the parentheses belong; "": they belong to `owner`
    std::string word = "";      ///< for Place::thing, the word before this place, such as "place"
};

/// Returns the context at the token with this index.
NetlistContext context_of(const std::vector<Token>&, std::size_t index);

/// Describes a declared name or a type, so that an editor can offer its ports, links, parameters and attributes.
struct NetlistOwner {
    const NetlistName* name = nullptr; ///< declaration of the name; null for a predefined name or type
    const ProcessKind* kind = nullptr; ///< kind of a process; null if the kind is unknown
    std::shared_ptr<const DeviceKind> device =
        nullptr;   ///< device of a node, or of a type of nodes; null if it is unknown
    int links = 0; ///< number of links of a node or type
};
NetlistOwner owner_of(const NetlistSyntax&, const Catalogue&, const std::string& name);

/// Returns the attributes and parameters that are possible in the parentheses at a place.
std::vector<ParameterDescription> attributes_in(const NetlistSyntax&, const Catalogue&, const NetlistContext&);
/// Returns the faults that a device, or one of its links, can have.
std::vector<FaultKind> faults_of(const NetlistOwner&);

} // namespace placedpar::editor
