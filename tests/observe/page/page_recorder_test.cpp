// Tests which parts of a trace a page keeps.

#include "observe/page/page_recorder.hpp"

#include "netlist/kinds/device_kind.hpp"

#include <boost/json.hpp>
#include <doctest/doctest.h>

#include <memory>
#include <string>
#include <vector>

using namespace placedpar;
using page::PageRecorder;

namespace {

/// A node "t" with a process "p": tracks 0 and 1.
Network a_node_with_a_process() {
    Network network;
    DeviceKind kind;
    kind.executes = Execution::in_time;
    Node node;
    node.name = "t";
    node.type = "T800";
    node.kind = std::make_shared<const DeviceKind>(kind);
    network.nodes.push_back(node);
    ProcessInstance process;
    process.name = "p";
    process.node = 0;
    network.processes.push_back(process);
    return network;
}

/// A recorder of ten nanoseconds in which `p` computes, is ready, and waits.
struct Recorded {
    Recorded() {
        auto slice = [&](Activity activity, int begin, int end) {
            recorder.write(Slice{1, activity, Time{begin}, Time{end}, false});
        };
        slice(Activity::computing, 0, 2000);
        slice(Activity::ready, 2000, 6000);
        slice(Activity::inputting, 6000, 10000);
    }
    boost::json::object json(std::span<const PathPart> path = {}) {
        recorder.draw_path(path);
        recorder.finish(Time{0}, Time{10000}, "completed");
        return recorder.json();
    }

    Tracks tracks{a_node_with_a_process()};
    PageRecorder recorder{tracks, Time{0}};
};

} // namespace

TEST_CASE("the page has its beginning, its end, and the reason for the trace's end") {
    boost::json::object json = Recorded().json();
    CHECK(json.at("begin") == 0);
    CHECK(json.at("end") == 10000);
    CHECK(json.at("why") == "completed");
    CHECK(json.at("left_out") == 0);
    CHECK_FALSE(json.contains("lost"));
}

TEST_CASE("activities have names in the order of their numbers in stretches") {
    boost::json::array names = Recorded().json().at("doing").as_array();
    REQUIRE(names.size() == 11);
    CHECK(names[static_cast<std::size_t>(Activity::executing)] == "executes");
    CHECK(names[static_cast<std::size_t>(Activity::carrying)] == "carries");
    CHECK(names[static_cast<std::size_t>(Activity::computing)] == "computes");
    CHECK(names[static_cast<std::size_t>(Activity::inputting)] == "inputs");
    CHECK(names[static_cast<std::size_t>(Activity::after_work)] == "after work");
    CHECK(names[static_cast<std::size_t>(Activity::stopped)] == "stopped");
}

TEST_CASE("each track has its name, place and load, without waits") {
    boost::json::array tracks = Recorded().json().at("tracks").as_array();
    REQUIRE(tracks.size() == 2);
    CHECK(tracks[0].at("kind") == "processor");
    CHECK(tracks[0].at("running") == "");
    CHECK(tracks[1].at("name") == "p");
    CHECK(tracks[1].at("kind") == "process");
    CHECK(tracks[1].at("place") == 1);
    CHECK(tracks[1].at("running") == "//");
    CHECK(tracks[1].at("ready") == "AA////");
}

TEST_CASE("slices are stored in stretches") {
    Recorded recorded;
    boost::json::object json = recorded.json();
    CHECK(json.at("stretches") == boost::json::array{0, 10000, 3});
    CHECK(json.at("deflated") == false);
    CHECK(recorded.recorder.stretches().all().size() == 1);
}

TEST_CASE("the critical path is drawn at parts with a track") {
    const PathPart path[] = {{Activity::delayed, "q", "", Time{0}, Time{1000}},
                             {Activity::computing, "p on t", "t", Time{1000}, Time{3000}}};
    boost::json::object json = Recorded().json(path);
    CHECK(json.at("path") == boost::json::array{0, 1000, 2000, 1});
    CHECK(json.at("texts") == boost::json::array{"", "computing: p on t"});
}
