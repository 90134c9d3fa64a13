#pragma once

#include <stdexcept>

namespace placedpar {

/// Reports that something from the user cannot be used: a file, an option, a value, a place to write to. what() is one
/// line without its newline. The line says what is wrong and, if possible, what would be right.
///
/// Throw this class, or a class derived from it, wherever the user can be the cause. The program prints the message and
/// ends with the exit code for wrong use. A defect of the program itself is a std::logic_error, such as
/// std::invalid_argument, and has another exit code.
class UserError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Reports that a user's file was refused. what() is the rendered diagnostics in whole lines, which are printed
/// unchanged.
class RefusedInput : public UserError {
public:
    using UserError::UserError;
};

} // namespace placedpar
