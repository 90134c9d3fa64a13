#include "app/recorders.hpp"

#include "app/standard_error.hpp"
#include "text/output_file.hpp"

namespace placedpar {

Recorders::Recorders(const Network& network, const RecordedFiles& files, TraceSink* another) : page_path_(files.page) {
    std::vector<TraceSink*> sinks;
    if (another)
        sinks.push_back(another);
    if (!files.trace.empty())
        sinks.push_back(&trace_.emplace(files.trace, network, files.window).sink());
    if (!files.page.empty())
        sinks.push_back(&page_.emplace(network, files.window).sink());
    if (!sinks.empty())
        fork_.emplace(std::move(sinks));
}

void Recorders::finish(const PageContent& content, std::span<const PathPart> critical_path) {
    if (page_) {
        write_whole(page_path_, page_->html(content, critical_path));
        print_warnings(page_->warnings(page_path_));
    }
    if (trace_)
        print_warnings(trace_->finish(content.report.result, critical_path, name_of(content.report.outcome())));
}

} // namespace placedpar
