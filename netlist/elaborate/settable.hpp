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

/// Describes an attribute or a parameter that an option can set.
struct SettableMember {
    std::string name;
    const ParameterDescription* description = nullptr; ///< null if only an interface declares the parameter
    bool takes_text = false;

    /// Returns a text about the allowed values, such as "expected an integer at least 1"; "" if the allowed
    /// values are not known.
    std::string what_it_takes() const;
};

/// Describes a node, a connection or a process whose attributes and parameters an option can set.
struct Settable {
    std::string name;
    std::variant<Node*, DraftConnection*, DraftProcess*> thing;
    std::shared_ptr<const std::vector<SettableMember>> members; ///< attributes and parameters that affect a simulation
    const ProcessKind* kind = nullptr;                          ///< kind of a process; null for a stand-in

    const char* noun() const;
    const char* noun_of_member() const;
    /// Returns the member of that name; null if there is none, or if only icconf uses the member.
    const SettableMember* member(const std::string& name) const { return find_named(*members, name); }
    /// Returns whether an option can set the member. Members that only icconf uses count, too. When an option
    /// sets every element, a connection without a `linkspeed` is skipped: its speed follows from its ends.
    bool has(const std::string& member, bool as_every_element = false) const;
    /// REQUIRES: has(setting.name). Throws StatementRefused after reporting an error. Values of parameters are checked
    /// later, together with the values in the netlist.
    void set(const Setting& setting, Reporter&) const;
    /// Returns "it has memory, clock ..."; a long list is cut short. For a process with a kind, the text then names the
    /// command that lists all parameters.
    std::string text_of_members() const;
};

/// Returns all settable elements of a draft, in the draft's order. The elements point into the draft.
std::vector<Settable> settable_elements(Draft&, const Catalogue&);

/// Returns notes that list the vals, and the elements with their attributes and parameters. Long lists are cut short.
std::vector<SecondPlace> what_can_be_set(const std::vector<std::pair<std::string, Constant>>& vals,
                                         const std::vector<Settable>&);

} // namespace placedpar
