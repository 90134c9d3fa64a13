#pragma once

#include <stdexcept>

namespace placedpar {

/// Something that a user gave, or asked for, cannot be used: a file, an option, a value, a place to write to. what()
/// says what is wrong, and what would be right where that can be said, in one line without its end.
///
/// Throw it, or a class derived from it, wherever a user can be the cause, however deep in a room; the program prints
/// it and ends with its exit code for wrong use. A defect of the program itself is a std::logic_error, such as
/// std::invalid_argument: the program calls it a defect, with an exit code of its own.
class UserError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A user's file that was refused. what() is the rendered diagnostics, whole lines: it is printed as it is.
class RefusedInput : public UserError {
public:
    using UserError::UserError;
};

} // namespace placedpar
