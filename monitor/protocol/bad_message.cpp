#include "monitor/protocol/bad_message.hpp"

#include <fmt/format.h>

#include <variant>

namespace placedpar::monitor {

using namespace hydraulics;
using namespace identification;

namespace {

BadMessage in_words_of_protocol(const NoConfiguration&) {
    return {"type", "a sample arrived before the configuration",
            "first {\"type\":\"configuration\",\"configuration\":\"a\",\"active\":[\"BU\",\"BO\"]}"};
}

BadMessage in_words_of_protocol(const LinkNotRead& missing) {
    return {fmt::format("links.{}", symbol_of(missing.link)), "it is missing, but the link is active",
            "a reading of each active link, or a configuration without the link"};
}

BadMessage in_words_of_protocol(const TimeNotLater& time) {
    return {"time_s", fmt::format("it is {}, not later than the time of the last sample", time.time_s),
            fmt::format("a time later than {}, or a new hello to restart time", time.last_time_s)};
}

} // namespace

BadMessage::BadMessage(const RefusedSample& refused)
    : BadMessage(std::visit([](const auto& reason) { return in_words_of_protocol(reason); }, refused.reason())) {}

} // namespace placedpar::monitor
