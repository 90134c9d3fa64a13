#include "identification/report/compliance_text.hpp"

#include "hydraulics/data/units.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <cmath>

namespace placedpar {

using namespace identification;

std::string print_compliance(std::string_view name, double compliance, double standard_error) {
    static const double m3_per_pascal = hydraulics::unit_named("m^3/Pa")->factor; // 1 m^3/Pa in in^3/psi
    if (!std::isfinite(compliance))                                               // readings such as 1e9 can cause this
        return fmt::format("{:<7} {:>9}  {:>9}  {:>9}  {:>9}", name, "-", "-", "-", "-");
    if (!std::isfinite(standard_error))
        return fmt::format("{:<7} {:9.5f}  {:>9}  {:9.3e}  {:>9}", name, compliance, "-", compliance / m3_per_pascal,
                           "-");
    return fmt::format("{:<7} {:9.5f}  {:9.5f}  {:9.3e}  {:9.1e}", name, compliance, standard_error,
                       compliance / m3_per_pascal, standard_error / m3_per_pascal);
}

std::string compliance_heading() { return "         in^3/psi  std.error     m^3/Pa  std.error"; }

std::string print_flags(std::string_view name, const std::vector<Flag>& flags) {
    std::string text;
    for (const Flag& flag : flags)
        text += fmt::format("! {}: {}\n", name, flag.text);
    return text;
}

boost::json::array flags_json(const std::vector<Flag>& flags) {
    boost::json::array array;
    for (const Flag& flag : flags)
        array.push_back({{"kind", name_of(flag.kind)}, {"text", flag.text}});
    return array;
}

boost::json::value or_null(std::optional<double> number) {
    return number && std::isfinite(*number) ? boost::json::value(*number) : nullptr;
}

} // namespace placedpar
