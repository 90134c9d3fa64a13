#pragma once

#include "netlist/elaborate/draft.hpp"
#include "netlist/kinds/device_kind.hpp"
#include "text/reporter.hpp"

#include <string>
#include <vector>

namespace placedpar {

/// Converts and checks the value that a netlist gives to one attribute. All functions throw StatementRefused after
/// reporting an error.
class AttributeValue {
public:
    AttributeValue(const Setting& setting, Reporter& reporter) : setting_(setting), reporter_(reporter) {}

    /// Returns the value, converted to the type in the description. Refuses a value outside the described range.
    Value as(const AttributeDescription& attribute) const;
    /// Returns the value of an attribute that only icconf uses. Accepts any value except an array.
    Value any() const;
    std::string text() const;

    [[noreturn]] void illegal(const std::string& value, const std::string& hint) const;
    /// Reports that `whose` has no such attribute: "a connection has no attribute ...".
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

/// Returns whether `names` contains the attribute or its group.
bool names_attribute(const std::vector<std::string>& names, const std::string& attribute);

} // namespace placedpar
