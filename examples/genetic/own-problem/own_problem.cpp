// A search problem of our own, and with it the whole command line for netlists.

#include <placedpar/app/program.hpp>
#include <placedpar/gaprocs/objective_problem.hpp>

#include <cmath>
#include <numbers>

using namespace placedpar;

/// A tin that holds so much, from as little sheet metal as can be.
struct Tin {
    static constexpr std::string_view name = "own.tin", about = "a tin of the least sheet metal";
    double volume = 500; // cm^3
    static constexpr auto numbers() { return std::tuple(PolicyNumber{"volume", &Tin::volume, 1, 1e6}); }

    ParameterCoding representation() const { return ParameterCoding({{1, 33, 12}, {1, 33, 12}}); }
    double objective(std::span<const double> x) const {
        double radius = x[0], height = x[1];
        if (std::numbers::pi * radius * radius * height < volume)
            return std::nan(""); // too small: worse than any tin that is not
        return 2 * std::numbers::pi * radius * (radius + height);
    }

    std::vector<std::string> parameter_names() const { return {"radius", "height"}; }
    std::vector<std::string> parameter_units() const { return {"cm", "cm"}; }
    std::string_view objective_unit() const { return "cm^2"; }
    double optimum() const { return 3 * std::cbrt(2 * std::numbers::pi * volume * volume); }
};

int main(int argc, char** argv) { return run_program(argc, argv, {}, {minimised<Tin>()}); }
