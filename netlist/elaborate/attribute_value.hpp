#pragma once

#include "netlist/elaborate/draft.hpp"
#include "netlist/kinds/device_kind.hpp"
#include "text/reporter.hpp"

#include <string>
#include <vector>

namespace placedpar {

/// Converts and checks the value that a netlist gives to one attribute, such as `memory = 4M`. All functions throw
/// StatementRefused after reporting an error.
class AttributeValue {
public:
    AttributeValue(const Setting& setting, Reporter& reporter) : setting_(setting), reporter_(reporter) {}

    /// Returns the value, converted to the attribute's type. Refuses a value outside the attribute's range.
    Value as(const AttributeDescription& attribute) const;
    /// Returns the value of an attribute that only INMOS's configurer icconf uses, so that its type is not known.
    /// Accepts any value except an array.
    Value any() const;
    std::string text() const;

    [[noreturn]] void illegal(const std::string& value, const std::string& hint) const;
    /// Reports that `whose`, such as "a connection", has no attribute of this name. A hint suggests a name of `known`.
    [[noreturn]] void refuse_name(const std::string& whose, const std::vector<std::string>& known) const;
    [[noreturn]] void refuse(std::string message, std::string hint) const;

private:
    std::string word(const ParameterDescription& description) const;
    const Integer& integer() const;
    double real(const ParameterDescription& description) const;
    void check_range(const ParameterDescription& description, double number, const std::string& shown_number) const;
    [[noreturn]] void wrong_type(const std::string& wanted) const;

    const Setting& setting_;
    Reporter& reporter_;
};

/// Returns whether `names` contains the attribute, or the group to which the attribute belongs: "order" for
/// "order.code".
bool names_attribute(const std::vector<std::string>& names, const std::string& attribute);

} // namespace placedpar
