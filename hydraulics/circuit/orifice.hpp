#pragma once

#include <algorithm>
#include <cmath>

namespace placedpar::hydraulics {

/// These functions are the orifice equation, flow = k a sqrt(pressure drop), and its inverse. `conductance` is k a,
/// with k the orifices' constant and a the area. The functions hold in any consistent system of units. T is double, or
/// a class with the arithmetic of double and with max, abs and sqrt. Such a class may hold several doubles, to compute
/// several flows at once.

/// Returns max(x, 0); NaN stays NaN.
template <typename T>
T positive_part(const T& x) {
    using std::max;
    return max(x, T(0.0));
}

/// Returns the flow; 0 for a negative drop.
template <typename T>
T orifice_flow(double conductance, const T& drop) {
    using std::sqrt;
    return conductance * sqrt(positive_part(drop));
}

/// Returns the pressure drop that drives a flow through the orifice. REQUIRES: conductance > 0.
template <typename T>
T orifice_drop(double conductance, const T& flow) {
    T root = flow / conductance;
    return root * root;
}
/// Returns the pressure drop as orifice_drop() does, given `resistance` = 1 / (k a). For many flows through one orifice
/// this function is faster, since it multiplies instead of dividing.
template <typename T>
T resisted_drop(double resistance, const T& flow) {
    T root = flow * resistance;
    return root * root;
}

} // namespace placedpar::hydraulics
