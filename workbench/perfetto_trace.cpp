#include "workbench/perfetto_trace.hpp"

#include "runtime/channel.hpp"
#include "runtime/deadlock.hpp"
#include "runtime/executive.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <utility>

namespace placedpar {

namespace {

std::string json_text(const std::string& text) { return boost::json::serialize(boost::json::string(text)); }

/// The format counts microseconds; three digits more keep nanoseconds, the rest of a picosecond is dropped
/// from the picture only.
std::string microseconds(Time t) { return fmt::format("{:.6f}", static_cast<double>(t.count()) * 1e-6); }

} // namespace

PerfettoTrace::PerfettoTrace(OutputFile& file) : file_(file) {
    file_.write("{\"displayTimeUnit\":\"ns\",\"traceEvents\":[\n");
}

void PerfettoTrace::finish() {
    file_.write("\n]}\n");
    file_.finish();
}

void PerfettoTrace::add(const std::string& event) {
    if (!std::exchange(is_first_, false))
        file_.write(",\n");
    file_.write(event);
}

std::uint32_t PerfettoTrace::track(const Process& process) {
    std::string group = process.executive() ? process.executive()->name() : "not on a processor";
    auto [found, is_new] = groups_.try_emplace(group, static_cast<std::uint32_t>(groups_.size() + 1));
    if (is_new)
        add(fmt::format(R"({{"ph":"M","name":"process_name","pid":{},"args":{{"name":{}}}}})", found->second,
                        json_text(group)));
    if (group_of_track_.try_emplace(process.ordinal(), found->second).second)
        add(fmt::format(R"({{"ph":"M","name":"thread_name","pid":{},"tid":{},"args":{{"name":{}}}}})", found->second,
                        process.ordinal(), json_text(process.path())));
    return found->second;
}

void PerfettoTrace::slice(const Process& process, const std::string& name, const char* category, Time begin, Time end) {
    std::uint32_t group = track(process);
    add(fmt::format(R"({{"ph":"X","name":{},"cat":"{}","pid":{},"tid":{},"ts":{},"dur":{}}})", json_text(name),
                    category, group, process.ordinal(), microseconds(begin), microseconds(end - begin)));
}

void PerfettoTrace::computed(const Process& process, Time begin, Time end) {
    slice(process, "computes", "compute", begin, end);
}

void PerfettoTrace::waited(const Process& process, Time begin, Time end) {
    std::string name = name_of(process.activity());
    for (const AnyChannel* channel : process.awaited_channels())
        name += " " + channel->name();
    slice(process, name, "wait", begin, end);
}

void PerfettoTrace::communicated(const AnyChannel& channel, Time at) {
    const Process& receiver = *channel.inputter();
    std::uint32_t group = track(receiver);
    add(fmt::format(R"({{"ph":"i","s":"t","name":{},"cat":"message","pid":{},"tid":{},"ts":{}}})",
                    json_text(channel.name()), group, receiver.ordinal(), microseconds(at)));
}

} // namespace placedpar
