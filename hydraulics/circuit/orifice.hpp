#pragma once

#include <Eigen/Core>

#include <cmath>

namespace placedpar::hydraulics {

/// The square root of doubles, and of as many at once as the processor takes. Without EIGEN_FAST_MATH Eigen's own
/// sqrt() does so too, but not with AVX-512: there it takes one after the other.
struct ExactRoot {
    double operator()(double x) const { return std::sqrt(x); }
    template <typename Packet>
    Packet packetOp(const Packet& x) const {
        return Eigen::internal::psqrt(x);
    }
};

} // namespace placedpar::hydraulics

template <>
struct Eigen::internal::functor_traits<placedpar::hydraulics::ExactRoot>
    : Eigen::internal::functor_traits<Eigen::internal::scalar_sqrt_op<double>> {
    enum { PacketAccess = Eigen::internal::packet_traits<double>::Vectorizable };
};

namespace placedpar::hydraulics {

/// The orifice equation, flow = k a sqrt(pressure drop), and its inverse. `conductance` is k a, a flow per root of
/// pressure. Units may be of any consistent system. T is double or an Eigen array of doubles, one entry for each
/// individual of a population, with the same bits as if each were computed alone.

inline double positive_part(double x) { return x < 0 ? 0 : x; } // NaN stays, as in an array
template <typename Array>
Array positive_part(const Array& x) {
    return x.max(0.0);
}

inline double square_root(double x) { return std::sqrt(x); }
/// An expression of Eigen's: `x` must outlive it.
template <typename Array>
auto square_root(const Array& x) {
    return x.unaryExpr(ExactRoot());
}

/// Never backwards: 0 for a drop below 0.
template <typename T>
T orifice_flow(double conductance, const T& drop) {
    return conductance * square_root(positive_part(drop));
}

/// The pressure drop that drives a flow through the orifice. REQUIRES: conductance > 0.
template <typename T>
T orifice_drop(double conductance, const T& flow) {
    T root = flow / conductance;
    return root * root;
}

} // namespace placedpar::hydraulics
