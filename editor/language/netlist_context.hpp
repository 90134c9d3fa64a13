#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/language/names_in_text.hpp"

#include <optional>
#include <string>
#include <vector>

namespace placedpar::editor {

/// What stands at a place of a netlist, as far as the words before it in its statement say.
struct NetlistContext {
    enum class Place {
        statement, ///< a statement begins here
        file,      ///< the name of an included file
        program,   ///< the string behind `use`
        member,    ///< behind a dot: a port, a link, a parameter or an attribute of `owner`
        attribute, ///< in the parentheses of `owner`: the name of an attribute or parameter
        value,     ///< an expression; of an attribute if `attribute` is set
        thing,     ///< a declared thing, behind `connect`, `place`, `to`, `on`, `by` and the like
        fault,     ///< the name of a fault
        new_name,  ///< a name that is being declared
        nothing    ///< within a word that no completion suits
    };
    Place place = Place::statement;
    std::string owner = "";     ///< the name or type before the dot or the parentheses
    std::string attribute = ""; ///< of a value
    std::string fault = "";     ///< the attributes are those of this fault of `owner`
    std::string word = "";      ///< the word before a thing, such as "place"
};

/// Returns what stands at the token of this index.
NetlistContext context_of(const std::vector<Token>&, std::size_t index);

/// The members of a thing, by what it is.
struct NetlistOwner {
    const NetlistName* name = nullptr;                  ///< null for a type or a predefined name
    const ProcessKind* kind = nullptr;                  ///< of a process; null if it is not known
    std::shared_ptr<const DeviceKind> device = nullptr; ///< of a node or its type; null if it is not known
    int links = 0;                                      ///< of a node or its type
};
NetlistOwner owner_of(const NetlistSyntax&, const Catalogue&, const std::string& name);

/// Returns the attributes and parameters that can be given in the parentheses of a context.
std::vector<ParameterDescription> attributes_in(const NetlistSyntax&, const Catalogue&, const NetlistContext&);
/// Returns the faults that the thing, or one of its links, can have.
std::vector<FaultKind> faults_of(const NetlistOwner&);

} // namespace placedpar::editor
