#pragma once

#include <pybind11/pybind11.h>

#include <algorithm>
#include <concepts>
#include <limits>
#include <string>

namespace placedpar::python {

/// Returns the values of type T in words, for messages to Python users, such as "a whole number from 0 to 255".
template <class T>
std::string kind_of_value() {
    if constexpr (std::same_as<T, std::string>)
        return "a text";
    else if constexpr (std::same_as<T, bool>)
        return "True or False";
    else if constexpr (requires { typename T::mapped_type; })
        return "a dictionary of texts";
    else if constexpr (requires { typename T::value_type; })
        return "a list in which each element is " + kind_of_value<typename T::value_type>();
    else if constexpr (std::floating_point<T>)
        return "a number";
    else
        return "a whole number from " + std::to_string(std::numeric_limits<T>::min()) + " to " +
               std::to_string(std::numeric_limits<T>::max());
}

/// Returns the value as a T. If it cannot be a T, throws pybind11::type_error with the name of the argument.
template <class T>
T given(pybind11::handle value, const char* name) {
    pybind11::detail::make_caster<T> caster;
    if (caster.load(value, true))
        return pybind11::detail::cast_op<T>(caster);
    throw pybind11::type_error(
        pybind11::str("{} is {!r}, expected {}").format(name, value, kind_of_value<T>()).template cast<std::string>());
}

/// The name of an argument, in a form that can be a template argument.
template <std::size_t n>
struct Name {
    consteval Name(const char (&text)[n]) {
        std::copy_n(text, n, characters);
    } // implicit, so that a text can be a template argument
    char characters[n];
};

/// An argument of a function that Python calls. given() checks its type, so that the user gets a short message.
/// pybind11's own message would list all signatures in C++.
template <class T, Name name>
struct Given {
    T value{};
    operator T() const { return value; }
};

/// Returns a function that refuses any arguments, with a short message. Declared as the last overload, it takes the
/// place of pybind11's message, which would list all signatures in C++. `usage` is the correct call, such as
/// "below(n)".
template <class Result = pybind11::object>
auto refusal(const char* usage) {
    return [usage](const pybind11::args&, const pybind11::kwargs&) -> Result {
        throw pybind11::type_error(std::string("wrong number or names of arguments, expected ") + usage);
    };
}

} // namespace placedpar::python

namespace pybind11::detail {

template <class T, placedpar::python::Name called>
struct type_caster<placedpar::python::Given<T, called>> {
    using Given = placedpar::python::Given<T, called>;
    PYBIND11_TYPE_CASTER(Given, make_caster<T>::name);
    bool load(handle object, bool) {
        value.value = placedpar::python::given<T>(object, called.characters);
        return true;
    }
};

} // namespace pybind11::detail
