#pragma once

#include "netlist/elaborate/draft.hpp"
#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/names.hpp"
#include "text/reporter.hpp"

#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace placedpar {

/// Describes an attribute or a parameter that the option `--set NAME=VALUE` can set.
struct SettableMember {
    std::string name;
    const ParameterDescription* description =
        nullptr; ///< null if only the interface in the netlist declares the parameter
    bool takes_text = false;

    /// Returns a hint such as "expected an integer at least 1"; "" if the allowed values are not known.
    std::string what_it_takes() const;
};

/// Describes a node, a connection or a process whose attributes and parameters (members) an option can set.
struct Settable {
    std::string name;
    std::variant<Node*, DraftConnection*, DraftProcess*> thing;
    std::shared_ptr<const std::vector<SettableMember>> members; ///< the members that affect a simulation
    const ProcessKind* kind = nullptr;                          ///< kind of a process; null if the catalogue lacks it

    const char* noun() const;
    const char* noun_of_member() const;
    /// Returns the member of that name; null if there is none, or if only INMOS's configurer icconf uses the member.
    const SettableMember* member(const std::string& name) const { return find_named(*members, name); }
    /// Returns whether an option can set the member; also true for members that only icconf uses. `as_every_element` is
    /// true for an option without the name of an element, which sets every element that has the member. Such an option
    /// does not set `linkspeed` of a connection for which the netlist states none: its speed is that of its ends.
    bool has(const std::string& member, bool as_every_element = false) const;
    /// Sets a member. Values of parameters are checked later, together with the values in the netlist. REQUIRES:
    /// has(setting.name). Throws StatementRefused after reporting an error.
    void set(const Setting& setting, Reporter&) const;
    /// Returns a text such as "it has memory, clock ...". A long list is cut short; for a process with a kind, the text
    /// then names the command that lists all parameters.
    std::string text_of_members() const;
};

/// Returns all settable elements of a draft, in the draft's order. The elements point into the draft.
std::vector<Settable> settable_elements(Draft&, const Catalogue&);

/// Returns notes for an error message that list the vals, and the elements with their members. Long lists are cut
/// short.
std::vector<SecondPlace> what_can_be_set(const std::vector<std::pair<std::string, Constant>>& vals,
                                         const std::vector<Settable>&);

} // namespace placedpar
