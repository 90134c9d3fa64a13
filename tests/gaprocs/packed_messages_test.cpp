// Tests that the messages of genetic algorithms travel to another copy of the program without any loss.

#include "gaprocs/processes/messages.hpp"
#include "runtime/random.hpp"

#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

using namespace placedpar;

namespace {

template <class Message>
Message sent_by_bytes(const Message& message) {
    MessageBytes bytes;
    pack(message, bytes);
    for (std::size_t length = 0; length < bytes.size(); ++length)
        CHECK_THROWS_AS(unpack<Message>(std::span(bytes).first(length)), NoMessage);
    return unpack<Message>(bytes);
}

std::vector<Genome> strings_of_all_lengths() {
    RandomStream random(1, "strings");
    std::vector<Genome> strings;
    for (const std::size_t bits : {0u, 1u, 7u, 63u, 64u, 65u, 128u, 200u})
        strings.push_back(Genome::random(bits, random));
    return strings;
}

} // namespace

TEST_CASE("a task travels with its strings, its window and its coding") {
    Task task;
    task.bytes = 240;
    task.kind = Task::Kind::rehearse;
    task.slave = 1;
    task.master = 2;
    task.address = 3;
    task.share = {4, 5, 6};
    task.strings = strings_of_all_lengths();
    task.window = std::make_shared<const std::vector<Sample>>(std::vector<Sample>{{1, 2}, {3}});
    task.bias = 0.5;
    task.coding = Coding(NaturalCoding{2});
    task.results_in_order = true;
    task.tasks_under_way = 7;
    const Task read = sent_by_bytes(task);
    CHECK(read.bytes == 240);
    CHECK(read.kind == Task::Kind::rehearse);
    CHECK((read.slave == 1 && read.master == 2 && read.address == 3));
    CHECK((read.share.first == 4 && read.share.last == 5 && read.share.window == 6));
    CHECK(read.strings == task.strings);
    CHECK(*read.window == *task.window);
    CHECK(read.bias == 0.5);
    CHECK(read.coding == task.coding);
    CHECK((read.results_in_order && read.tasks_under_way == 7));
    CHECK(sent_by_bytes(Task()).window == nullptr);
}

TEST_CASE("answers, emigrants, estimates, findings, bias points and samples travel whole") {
    const std::vector<Genome> strings = strings_of_all_lengths();
    Fitnesses fitnesses;
    fitnesses.bytes = 8;
    fitnesses.end = true;
    fitnesses.slave = 1;
    fitnesses.master = 2;
    fitnesses.hops = 3;
    fitnesses.share = {0, 2, 1};
    fitnesses.terms = {1.5, -0.0};
    const Fitnesses answer = sent_by_bytes(fitnesses);
    CHECK((answer.bytes == 8 && answer.end && answer.slave == 1 && answer.master == 2 && answer.hops == 3));
    CHECK((answer.share.last == 2 && answer.terms == fitnesses.terms));

    Emigrants emigrants;
    emigrants.bytes = 4;
    emigrants.end = true;
    emigrants.generation = 9;
    for (const Genome& string : strings)
        emigrants.individuals.push_back({string, 0.1});
    const Emigrants arrived = sent_by_bytes(emigrants);
    CHECK((arrived.bytes == 4 && arrived.end && arrived.generation == 9));
    CHECK(arrived.individuals == emigrants.individuals);

    EstimateMessage estimate;
    estimate.bytes = 5;
    estimate.end = true;
    estimate.generation = 3;
    estimate.samples = 4;
    estimate.best = {strings.back(), -2};
    const EstimateMessage best = sent_by_bytes(estimate);
    CHECK((best.bytes == 5 && best.end && best.generation == 3 && best.samples == 4 && best.best == estimate.best));

    Finding finding;
    finding.bytes = 6;
    finding.end = true;
    finding.sample = 1;
    finding.read_at = Time(2);
    finding.sent_at = Time(3);
    finding.parameters = {4, 5};
    const Finding found = sent_by_bytes(finding);
    CHECK((found.bytes == 6 && found.end && found.sample == 1 && found.read_at == Time(2) && found.sent_at == Time(3)));
    CHECK(found.parameters == finding.parameters);

    BiasPoint point;
    point.bytes = 7;
    point.string = strings[3];
    const BiasPoint received = sent_by_bytes(point);
    CHECK((received.bytes == 7 && received.string == strings[3]));

    HostMessage sample;
    sample.bytes = 148; // longer than the values
    sample.end = true;
    sample.sample = {1, 2};
    sample.read_at = Time(9);
    const HostMessage taken = sent_by_bytes(sample);
    CHECK((taken == sample && taken.read_at == Time(9)));
}

TEST_CASE("a string longer than its bytes, and an unknown coding, are no messages") {
    MessageBytes bytes;
    pack(std::uint64_t{1} << 60, bytes);
    CHECK_THROWS_AS(unpack<Genome>(bytes), NoMessage);
    bytes.clear();
    pack(std::string("morse"), bytes);
    CHECK_THROWS_AS(unpack<Coding>(bytes), NoMessage);
}
