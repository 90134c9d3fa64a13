// Tests how trace formats write slices and messages.

#include "on_one_node.hpp"

#include "observe/trace/perfetto_trace.hpp"
#include "observe/trace/svg_trace.hpp"
#include "observe/trace/vcd_trace.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>

using namespace placedpar;
using test::on_one_node;

namespace {

/// Returns the file that a writer of this format makes from the calls in `tell`.
template <class Writer>
std::string written(const Tracks& tracks, const std::function<void(TraceWriter&)>& tell) {
    const std::filesystem::path path = std::filesystem::temp_directory_path() / "placedpar_writers_test";
    OutputFile file(path);
    Writer writer(file, tracks);
    tell(writer);
    writer.finish(Time{0}, Time{9000}, "completed");
    file.finish();
    std::stringstream text;
    text << std::ifstream(path).rdbuf();
    std::filesystem::remove(path);
    return text.str();
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Returns the line that the Perfetto trace has for one slice of process `p`. Track 0 is the processor, track 1 the
/// process.
std::string shown(const Slice& slice) {
    Tracks tracks(on_one_node({"p"}));
    std::string text = written<PerfettoTrace>(tracks, [&](TraceWriter& writer) { writer.write(slice); });
    std::string lines = text.substr(text.find('\n') + 1);
    return lines.substr(0, lines.find(",\n"));
}

Slice waiting(Activity activity, std::vector<Awaited> awaited = {}, bool timer = false) {
    return {1, activity, Time{1000}, Time{3000}, false, "", 0, std::move(awaited), timer};
}

/// Returns only the slice's value "name".
std::string name_shown(const Slice& slice) {
    std::string text = shown(slice);
    std::size_t begin = text.find("\"name\":\"") + 8;
    return text.substr(begin, text.find('"', begin) - begin);
}

} // namespace

TEST_CASE("Perfetto: a slice has a place, a beginning and a length in microseconds to the picosecond") {
    CHECK(shown({1, Activity::computing, Time{1000}, Time{2500}, false}) ==
          R"({"ph":"X","name":"computes","cat":"compute","pid":1,"tid":3,"ts":0.001000,"dur":0.001500})");
}

TEST_CASE("Perfetto: an open slice has a beginning and no end") {
    CHECK(shown({1, Activity::computing, Time{1000}, Time{2500}, true}) ==
          R"({"ph":"B","name":"computes","cat":"compute","pid":1,"tid":3,"ts":0.001000})");
}

TEST_CASE("Perfetto: a wait names its partner and channel") {
    CHECK(name_shown(waiting(Activity::inputting, {{"c", "q"}})) == "inputs from q");
    CHECK(name_shown(waiting(Activity::inputting, {{"c", ""}})) == "inputs from c");
    CHECK(name_shown(waiting(Activity::inputting)) == "waits for packets to send");
    CHECK(name_shown(waiting(Activity::outputting, {{"c", "q"}})) == "outputs to q");
    CHECK(name_shown(waiting(Activity::joining)) == "waits for its components");
    CHECK(name_shown(waiting(Activity::delayed, {}, true)) == "waits for its timer");
    CHECK(name_shown(waiting(Activity::after_work)) == "waits for the end of the work");
    CHECK(name_shown(waiting(Activity::stopped)) == "has stopped");
    CHECK(has(shown(waiting(Activity::inputting, {{"c", ""}})), R"("args":{"channel":"c","partner":"none yet"})"));
}

TEST_CASE("Perfetto: an alternation names a few partners, but only counts many partners") {
    CHECK(name_shown(waiting(Activity::alternating, {{"c", "q"}, {"d", "r"}})) == "alternates: input from q or r");
    CHECK(name_shown(waiting(Activity::alternating, {{"c", "q"}}, true)) == "alternates: input from q, or its timer");
    CHECK(name_shown(waiting(Activity::alternating, {{"a", ""}, {"b", ""}, {"c", ""}, {"d", ""}})) ==
          "alternates between 4 channels");
    CHECK(name_shown(waiting(Activity::alternating, {}, true)) == "waits for its timer");
}

TEST_CASE("Perfetto: a message is a flow from slice to slice") {
    Tracks tracks(on_one_node({"p", "q"}));
    const std::string channel = "c";
    std::string text = written<PerfettoTrace>(tracks, [&](TraceWriter& writer) {
        writer.write(MessageArrow{channel, 1, 2, Time{10}, Time{20}});
    });
    CHECK(has(text, R"({"ph":"s","name":"c","cat":"message","id":1,"pid":1,"tid":3,"ts":0.000010})"));
    CHECK(has(text, R"({"ph":"f","bp":"e","name":"c","cat":"message","id":1,"pid":1,"tid":4,"ts":0.000020})"));
}

TEST_CASE("Perfetto: the critical path is shown above all tracks, as a whole and by processor and link") {
    Tracks tracks(on_one_node({"p"}));
    const PathPart path[] = {{Activity::computing, "p on t", "t", Time{0}, Time{5}},
                             {Activity::delayed, "p", "", Time{5}, Time{9}}};
    std::string text = written<PerfettoTrace>(tracks, [&](TraceWriter& writer) { writer.draw_path(path); });
    CHECK(has(text, R"("name":"computing: p on t","cat":"critical path","cname":"terrible","pid":4,"tid":5,)"));
    CHECK(has(text, R"("name":"computing: p on t","cat":"critical path","cname":"terrible","pid":4,"tid":6,)"));
    CHECK(has(text, R"("name":"delayed: p","cat":"critical path","cname":"terrible","pid":4,"tid":5,)"));
    CHECK(has(text, R"("args":{"name":"via processor t"})"));
}

TEST_CASE("Perfetto: the end has its reason, and every track its name") {
    Tracks tracks(on_one_node({"p"}));
    std::string text = written<PerfettoTrace>(tracks, [](TraceWriter&) {});
    CHECK(text.starts_with("{\"displayTimeUnit\":\"ns\",\"traceEvents\":[\n"));
    CHECK(has(text, R"({"ph":"i","s":"g","name":"completed","cat":"end","pid":1,"tid":2,"ts":0.009000})"));
    CHECK(has(text, R"("args":{"name":"processor t"})"));
    CHECK(has(text, R"("args":{"name":"p"})"));
    CHECK(text.ends_with("\n]}\n"));
}

namespace {

/// Returns a value change dump of these slices, without the declarations.
std::string changes(const std::vector<Slice>& slices) {
    Tracks tracks(on_one_node({"p"}));
    std::string text = written<VcdTrace>(tracks, [&](TraceWriter& writer) {
        for (const Slice& slice : slices)
            writer.write(slice);
    });
    return text.substr(text.find("$enddefinitions $end\n") + 21);
}

} // namespace

TEST_CASE("VCD: a node is a scope, a processor a wire, and a process has a wire for each activity") {
    Tracks tracks(on_one_node({"p[0]"}));
    std::string text = written<VcdTrace>(tracks, [](TraceWriter&) {});
    CHECK(text.starts_with("$version PlacedPar $end\n$timescale 1 ps $end\n$comment completed at 9.000 ns $end\n"
                           "$scope module machine $end\n$scope module t $end\n$var wire 1 ! busy $end\n"
                           "$scope module p_0 $end\n$var wire 1 4 computes $end\n"));
    CHECK(has(text, " after_work $end\n"));
    CHECK_FALSE(has(text, "joins"));
}

TEST_CASE("VCD: a wire is 1 while a slice lasts") {
    std::string text = changes({{0, Activity::executing, Time{1000}, Time{2000}, false, "p"},
                                {0, Activity::executing, Time{5000}, Time{9000}, true, "p"}});
    CHECK(text.starts_with("#0\n$dumpvars\n0!\n"));
    CHECK(has(text, "$end\n#1000\n1!\n#2000\n0!\n#5000\n1!\n#9000\n"));
}

TEST_CASE("VCD: an immediate successor and a wait for components change no wire") {
    std::string text = changes({{0, Activity::executing, Time{1000}, Time{2000}, false, "p"},
                                {0, Activity::executing, Time{2000}, Time{3000}, false, "q"},
                                {1, Activity::joining, Time{1000}, Time{3000}, false}});
    CHECK(has(text, "$end\n#1000\n1!\n#3000\n0!\n#9000\n"));
}

TEST_CASE("SVG: a slice is a bar from its beginning to its end, in the look of its activity") {
    Tracks tracks(on_one_node({"p"}));
    // The axis has 860 pixels for 9000 ps and begins 60 pixels to the right of the edge.
    std::string text = written<SvgTrace>(tracks, [](TraceWriter& writer) {
        writer.write(Slice{1, Activity::computing, Time{0}, Time{4500}, false});
        writer.write(waiting(Activity::inputting));
    });
    CHECK(has(text, R"(<path class="compute" d="M60 52.5h430v11h-430z"/>)"));
    CHECK(has(text, R"(<path class="wait" d="M155.6 57.2h191.1v1.6h-191.1z"/>)"));
    CHECK(has(text, R"(<text class="title" x="0" y="14">0 to 9 ns: completed</text>)"));
}

TEST_CASE("SVG: a processor names what it executes where the bar has room, and a row without slices is left out") {
    Tracks tracks(on_one_node({"p"}));
    std::string text = written<SvgTrace>(tracks, [](TraceWriter& writer) {
        writer.write(Slice{0, Activity::executing, Time{0}, Time{4500}, false, "p"});
        writer.write(Slice{0, Activity::executing, Time{5000}, Time{5040}, false, "q"});
    });
    CHECK(has(text, R"( y="61.5">processor</text>)"));
    CHECK(has(text, R"( y="61">p</text>)"));
    CHECK(!has(text, ">q</text>"));
    CHECK(!has(text, R"( y="61.5">p</text>)"));
}

TEST_CASE("SVG: bars that touch are joined, and a message is an arrow between two rows") {
    Tracks tracks(on_one_node({"p", "q"}));
    std::string text = written<SvgTrace>(tracks, [](TraceWriter& writer) {
        writer.write(Slice{1, Activity::computing, Time{0}, Time{900}, false});
        writer.write(Slice{1, Activity::computing, Time{901}, Time{1800}, false});
        writer.write(Slice{2, Activity::computing, Time{4500}, Time{9000}, false});
        writer.write(MessageArrow{"c", 1, 2, Time{900}, Time{4500}});
    });
    CHECK(has(text, R"(<path class="compute" d="M60 52.5h172v11h-172z"/>)"));
    CHECK(has(text, R"(x1="146" y1="58" x2="490" y2="74")"));
}
