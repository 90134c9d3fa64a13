// Tests the bytes of samples, for programs in a transputer's own code.

#include "gaprocs/processes/messages.hpp"
#include "netlist/kinds/description.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <typeindex>
#include <utility>
#include <vector>

using namespace placedpar;

namespace {

HostMessage host_sample(std::vector<double> values, std::uint32_t bytes) {
    HostMessage message;
    message.sample = std::move(values);
    message.bytes = bytes;
    return message;
}

MessageBytes host_bytes(const HostMessage& message) {
    MessageBytes bytes;
    ByteForm<HostMessage>::write(message, bytes);
    return bytes;
}

} // namespace

TEST_CASE("a sample is a counted array of its values") {
    const HostMessage message = host_sample({1.5, -0.25}, 16);
    const MessageBytes bytes = host_bytes(message);
    CHECK(bytes == MessageBytes{2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xf8, 0x3f, 0, 0, 0, 0, 0, 0, 0xd0, 0xbf});
    CHECK(ByteForm<HostMessage>::next_part({}) == 4);
    CHECK(ByteForm<HostMessage>::next_part(std::span(bytes).first(4)) == 16);
    CHECK(ByteForm<HostMessage>::next_part(bytes) == 0);
    CHECK(ByteForm<HostMessage>::read(bytes) == message);
}

TEST_CASE("the bytes of a sample are as many as its form on a wire has") {
    for (const std::uint32_t bytes : {16u, 24u, 40u})
        for (const bool end : {false, true}) {
            HostMessage message = host_sample({1, 2}, bytes);
            message.end = end;
            CHECK(std::cmp_equal(host_bytes(message).size(), wire_form(message).total()));
        }
}

TEST_CASE("the end of the record is an array of NaN") {
    HostMessage message = host_sample({}, 40);
    message.end = true;
    const HostMessage read = ByteForm<HostMessage>::read(host_bytes(message));
    CHECK(read.end);
    CHECK(read.bytes == 40);
    CHECK(std::ranges::all_of(read.sample, [](double each) { return std::isnan(each); }));
    CHECK_FALSE(ByteForm<HostMessage>::read(host_bytes(host_sample({0, 0, 0, 0, 0}, 40))).end);
}

TEST_CASE("a port of samples has the byte form of a counted array of reals") {
    const PortDescription port = description::output<HostMessage>("to_masters", "host message", "");
    CHECK(port.has_byte_form);
    CHECK(port.bytes_as == std::type_index(typeid(std::vector<double>)));
    CHECK(description::output<Emigrants>("out", "emigrants", "").bytes_as == std::type_index(typeid(Emigrants)));
}
