#pragma once

#include "runtime/trace.hpp"
#include "text/output_file.hpp"

#include <cstdint>
#include <map>
#include <string>

namespace placedpar {

/// A trace in the Trace Event format, which ui.perfetto.dev and chrome://tracing show as a timeline: a
/// track for each process, grouped by processor, with what it computed and what it waited for.
/// It is written as the run goes.
class PerfettoTrace final : public TraceSink {
public:
    /// REQUIRES: the file outlives it, and nothing has been written to it.
    explicit PerfettoTrace(OutputFile&);
    /// To be called after the run: ends the document, which finishes the file. Throws as OutputFile::finish().
    void finish();

    void computed(const Process&, Time begin, Time end) override;
    void waited(const Process&, Time begin, Time end) override;
    void communicated(const AnyChannel&, Time at) override;

private:
    /// The number of the process's track; announces it when it is new.
    std::uint32_t track(const Process&);
    void slice(const Process&, const std::string& name, const char* category, Time begin, Time end);
    void add(const std::string& event);

    OutputFile& file_;
    bool is_first_ = true;
    std::map<std::string, std::uint32_t> groups_;
    std::map<std::uint32_t, std::uint32_t> group_of_track_;
};

} // namespace placedpar
