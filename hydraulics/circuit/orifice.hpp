#pragma once

#include <algorithm>
#include <cmath>

namespace placedpar::hydraulics {

/// The orifice equation, flow = k a sqrt(pressure drop), and its inverse. `conductance` is k a, a flow per root of
/// pressure. Units may be of any consistent system. T is double or any class that has the arithmetic of double, with
/// max, abs and sqrt beside it, such as several doubles at once.

/// NaN stays.
template <typename T>
T positive_part(const T& x) {
    using std::max;
    return max(x, T(0.0));
}

/// Never backwards: 0 for a drop below 0.
template <typename T>
T orifice_flow(double conductance, const T& drop) {
    using std::sqrt;
    return conductance * sqrt(positive_part(drop));
}

/// The pressure drop that drives a flow through the orifice. REQUIRES: conductance > 0.
template <typename T>
T orifice_drop(double conductance, const T& flow) {
    T root = flow / conductance;
    return root * root;
}
/// The same by `resistance`, 1 / (k a), where one orifice is asked for many flows: a product takes a fraction of the
/// time of a quotient.
template <typename T>
T resisted_drop(double resistance, const T& flow) {
    T root = flow * resistance;
    return root * root;
}

} // namespace placedpar::hydraulics
