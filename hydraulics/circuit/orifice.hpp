#pragma once

#include <cmath>

namespace placedpar::hydraulics {

/// The orifice equation, flow = k a sqrt(pressure drop), and its inverse. `conductance` is k a, a flow per root of
/// pressure. Units may be of any consistent system. T is double or an Eigen array of doubles, one entry for each
/// individual of a population, with the same bits as if each were computed alone.

inline double positive_part(double x) { return x < 0 ? 0 : x; } // NaN stays, as in an array
template <typename Array>
Array positive_part(const Array& x) {
    return x.max(0.0);
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

} // namespace placedpar::hydraulics
