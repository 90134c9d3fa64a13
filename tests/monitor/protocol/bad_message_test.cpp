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

TEST_CASE("a sample that cannot be taken is refused in the words of the protocol") {
    check(NoConfiguration{}, "type", "a sample before any configuration",
          R"(first {"type":"configuration","configuration":"a","active":["BU","BO"]})");
    check(LinkNotRead{hydraulics::Link::boom}, "links.BO", "it is missing, and the link is active",
          "a reading of each active link, or a configuration without it");
    check(TimeNotLater{3, 4.5}, "time_s", "it is 3, not after the last sample's",
          "more than 4.5; send hello again to restart time");
}
