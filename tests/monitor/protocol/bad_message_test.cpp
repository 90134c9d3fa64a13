#include "monitor/protocol/bad_message.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace placedpar;
using namespace placedpar::identification;
using namespace placedpar::monitor;

namespace {

void check(const RefusedSample::Reason& reason, const std::string& field, const std::string& wrong,
           const std::string& right) {
    BadMessage bad{RefusedSample(reason)};
    CHECK(bad.field() == field);
    CHECK(bad.what() == wrong);
    CHECK(bad.right() == right);
    CHECK_FALSE(bad.column());
}

} // namespace

TEST_CASE("a refused sample is reported in the terms of the protocol") {
    check(NoConfiguration{}, "type", "a sample arrived before the configuration",
          R"(first {"type":"configuration","configuration":"a","active":["BU","BO"]})");
    check(LinkNotRead{hydraulics::Link::boom}, "links.BO", "it is missing, but the link is active",
          "a reading of each active link, or a configuration without the link");
    check(TimeNotLater{3, 4.5}, "time_s", "it is 3, not later than the time of the last sample",
          "a time later than 4.5, or a new hello to restart time");
}
