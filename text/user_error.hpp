#pragma once

#include <stdexcept>

namespace placedpar {

/// Reports that something from the user cannot be used: a file, an option, a value, a place to write to. what() is one
/// line, without a newline at its end. It says what is wrong and, if possible, what would be right.
///
/// Throw this class, or a class derived from it, for every error that a user can cause. The program then prints the
/// message and exits with the code for wrong use. For a defect of the program itself, throw a std::logic_error, such as
/// std::invalid_argument, for which the program exits with another code.
class UserError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Reports that a user's file was refused. what() has several lines: the text of the diagnostics, as render() returns
/// it (text/diagnostic.hpp).
class RefusedInput : public UserError {
public:
    using UserError::UserError;
};

} // namespace placedpar
