#pragma once

#include <boost/describe.hpp>
#include <boost/mp11.hpp>

#include <string>
#include <type_traits>

namespace placedpar::monitor {

template <typename T>
using MembersOf = boost::describe::describe_members<std::remove_const_t<T>, boost::describe::mod_public>;

/// Calls use(name, member) for each member of a struct that Boost.Describe describes. Code that stores any struct uses
/// this function.
template <typename T, typename Use>
void for_each_member(T& object, Use use) {
    boost::mp11::mp_for_each<MembersOf<T>>([&](auto member) { use(std::string(member.name), object.*member.pointer); });
}

} // namespace placedpar::monitor
