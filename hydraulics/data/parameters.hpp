#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {
struct Diagnostic; // text/diagnostic.hpp
struct TextRow;    // text/table.hpp
} // namespace placedpar

namespace placedpar::hydraulics {

/// A constant of the excavator that is simulated or measured.
struct Parameter {
    std::string name;   ///< "boom.inlet_area"
    double value;       ///< in the unit `unit`
    std::string unit;   ///< the unit that units.hpp gives for the quantity
    std::string mark;   ///< origin in one word: "thesis", "fitted" or "ours" (chosen by this project); in a user's file
                        ///< also "measured"
    std::string source; ///< origin in a sentence, such as a table or a data sheet
};

/// Reports a name that no parameter has.
class UnknownParameter : public std::invalid_argument {
public:
    explicit UnknownParameter(std::string_view name);
};

/// The constants of the machine by name, from a text in the form of excavator.csv:
///
///     name,value,unit,mark,source
///     boom.inlet_area,206.5,cm^2,measured,"data sheet, both cylinders"
class Parameters {
public:
    /// Returns the constants of excavator.csv, which is part of the program.
    static const Parameters& excavator();

    /// Returns the value of a parameter in the unit of units.hpp. Throws UnknownParameter.
    double operator[](std::string_view name) const;
    /// Returns null if there is no such parameter.
    const Parameter* find(std::string_view name) const;
    const std::vector<Parameter>& all() const { return parameters_; }
    /// Sets the value of a parameter, in the unit of units.hpp. Throws UnknownParameter.
    void set(std::string_view name, double value);
    /// Replaces the parameter of the same name. Throws UnknownParameter if there is none.
    void put(Parameter parameter);

    /// Reads a text whose rows replace the parameters of the same name. A row may have any unit of its quantity; its
    /// value is converted. Adds a fault for an unknown name, for a unit of another quantity, and for an unknown mark.
    /// Also adds a fault for a value that is not a number or is outside the parameter's range (parameter_range.hpp).
    void read(std::string_view text, std::vector<Diagnostic>& faults);

private:
    /// Throws UnknownParameter.
    Parameter& entry(std::string_view name);
    void read_row(const TextRow& row, std::vector<Diagnostic>& faults);

    std::vector<Parameter> parameters_;
};

/// The text of excavator.csv.
std::string_view excavator_text();

} // namespace placedpar::hydraulics
