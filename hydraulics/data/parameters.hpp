#pragma once

#include "text/table.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace placedpar::hydraulics {

/// A constant of the machine.
struct Parameter {
    std::string name;   // "boom.inlet_area"
    double value;       // in this room's unit of its quantity
    std::string unit;   // the room's
    std::string mark;   // thesis, fitted, ours; measured in a user's file
    std::string source; // where it comes from
};

/// The constants of a machine by name, from a text in the form of excavator.csv:
///
///     name,value,unit,mark,source
///     boom.inlet_area,206.5,cm^2,measured,"data sheet, both cylinders"
class Parameters {
public:
    /// Those of excavator.csv, which is part of the program.
    static const Parameters& excavator();

    /// Throws std::invalid_argument when there is no such parameter.
    double operator[](std::string_view name) const;
    const Parameter* find(std::string_view name) const;
    const std::vector<Parameter>& all() const { return parameters_; }
    void set(std::string_view name, double value);
    /// In place of the parameter of the same name. Throws std::invalid_argument when there is none.
    void put(Parameter parameter);

    /// Reads a text whose rows take the place of those of the same name; all units of a quantity are converted.
    /// Faults: a name that is not there, a unit of another quantity, no number or one
    /// out of the parameter's range (parameter_range.hpp), a mark that is none.
    void read(std::string_view text, std::vector<TextFault>& faults);

private:
    Parameter* entry(std::string_view name);
    void read_row(const TextRow& row, std::vector<TextFault>& faults);

    std::vector<Parameter> parameters_;
};

/// The text of excavator.csv.
std::string_view excavator_text();

} // namespace placedpar::hydraulics
