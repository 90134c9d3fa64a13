#include "identification/on_line/refused_sample.hpp"

#include <fmt/format.h>

#include <string>

namespace placedpar::identification {

namespace {

std::string sentence(const NoConfiguration&) { return "a sample arrived before the configuration"; }

std::string sentence(const LinkNotRead& missing) {
    return fmt::format("the sample has no reading of the active link {}", name_of(missing.link));
}

std::string sentence(const TimeNotLater& time) {
    return fmt::format("the sample's time, {} s, is not later than the last sample's time, {} s", time.time_s,
                       time.last_time_s);
}

} // namespace

RefusedSample::RefusedSample(const Reason& reason)
    : UserError(std::visit([](const auto& each) { return sentence(each); }, reason)), reason_(reason) {}

} // namespace placedpar::identification
