#include "problems/benchmark/fronts.hpp"

#include <cmath>
#include <numbers>

namespace placedpar {

double mean_distance(std::span<const double> x) {
    double sum = 0;
    for (double each : x)
        sum += each;
    return 1 + 9 * sum / static_cast<double>(x.size());
}

double Zdt1::second(double f, double g) { return g * (1 - std::sqrt(f / g)); }

double Zdt2::second(double f, double g) { return g * (1 - f / g * (f / g)); }

double Zdt3::second(double f, double g) {
    return g * (1 - std::sqrt(f / g) - f / g * std::sin(10 * std::numbers::pi * f));
}

ParameterCoding Zdt4::representation() const {
    std::vector<ParameterField> fields(dimensions, {-5, 5, bits});
    fields.front() = {0, 1, bits};
    return ParameterCoding(std::move(fields));
}

double Zdt4::second(double f, double g) { return Zdt1::second(f, g); }

double Zdt4::distance(std::span<const double> x) {
    double sum = 1 + 10 * static_cast<double>(x.size());
    for (double each : x)
        sum += each * each - 10 * std::cos(4 * std::numbers::pi * each);
    return sum;
}

} // namespace placedpar
