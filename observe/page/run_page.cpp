#include "observe/page/run_page.hpp"

#include "observe/page/encoding.hpp"
#include "observe/page/parts.hpp"
#include "picture/svg.hpp"
#include "text/standard_streams.hpp"
#include "text/utf8.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace placedpar {

namespace {

/// The largest number of parts of a network that is drawn. A browser would be too slow with larger networks.
constexpr std::size_t most_drawn = 20'000;
/// The largest number of rows of a table. Longer tables are only in the report of `--json`.
constexpr std::size_t most_rows = 3000;
constexpr std::size_t most_generations = 500;

TraceWindow without_limit(TraceWindow window) {
    window.most_entries = std::numeric_limits<std::size_t>::max();
    return window;
}

boost::json::object process_on_page(const Network& network, const ProcessInstance& process) {
    const Location& declared = process.declared;
    std::string_view text = declared.file ? declared.file->line(declared.line) : "";
    return {{"name", process.name},
            {"kind", process.kind},
            {"node", network.nodes[process.node].name},
            {"place", declared.file ? fmt::format("{}:{}", declared.file->path(), declared.line) : ""},
            {"line", text}};
}

boost::json::array processes_on_page(const Network& network) {
    boost::json::array all;
    for (const ProcessInstance& process : network.processes)
        all.push_back(process_on_page(network, process));
    return all;
}

boost::json::value finite_or_null(double number) {
    return std::isfinite(number) ? boost::json::value(number) : boost::json::value();
}

/// Returns [generation, time, best so far, mean, diversity].
boost::json::array generation_on_page(std::size_t number, const LoggedGeneration& generation) {
    return {number, generation.time ? boost::json::value(generation.time->count()) : boost::json::value(),
            finite_or_null(generation.best_so_far), finite_or_null(generation.mean),
            finite_or_null(generation.diversity)};
}

boost::json::object search_on_page(const GenerationLog& log, std::size_t search) {
    std::span<const LoggedGeneration> all = log.of(search);
    boost::json::array some;
    std::size_t step = all.size() / most_generations + 1;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (i % step == 0 || i + 1 == all.size())
            some.push_back(generation_on_page(i + 1, all[i]));
    return {{"name", log.searches()[search]},
            {"minimises", log.minimises(search)},
            {"objective", log.has_objective(search)},
            {"generations", std::move(some)}};
}

boost::json::array searches_on_page(const GenerationLog& log) {
    boost::json::array all;
    for (std::size_t i = 0; i < log.searches().size(); ++i)
        all.push_back(search_on_page(log, i));
    return all;
}

/// Returns the report of `--json` without tables that are too long to read.
boost::json::object report_on_page(const PageContent& content) {
    boost::json::object report = report_json(content.report, content.network, content.manifest, content.searches);
    for (auto& [name, part] : report)
        if (part.is_array() && part.get_array().size() > most_rows)
            part = nullptr;
    return report;
}

/// Returns the data as JSON without the character `<`, so that no text can end the HTML element.
std::string text_of_data(const boost::json::object& data) {
    std::string text;
    for (char each : as_json(boost::json::serialize(data)))
        each == '<' ? text += "\\u003c" : text += each;
    return text;
}

/// Returns an HTML element for each stretch. The page reads an element only when its interval is shown.
std::string stretch_elements(const page::Stretches& stretches) {
    std::string text;
    for (const page::PackedStretch* each : stretches.all())
        text.append("<script class=\"stretch\" type=\"text/plain\">")
            .append(page::base64(each->bytes))
            .append("</script>\n");
    return text;
}

/// A placeholder and the part of the page that replaces it; parts are listed in the order of the frame.
using Part = std::pair<const char*, std::string>;

std::string filled(const std::string& frame, std::span<const Part> parts) {
    std::string out;
    std::size_t at = 0, size = frame.size();
    for (const Part& each : parts)
        size += each.second.size();
    out.reserve(size); // avoids copies of a large page
    for (const auto& [mark, text] : parts) {
        std::size_t found = frame.find(mark, at);
        out.append(frame, at, found - at).append(text);
        at = found + std::string_view(mark).size();
    }
    return out.append(frame, at);
}

bool is_small(const Network& network) {
    return network.nodes.size() <= most_drawn && network.processes.size() <= most_drawn;
}

std::string machine_or_nothing(const Network& network) {
    const bool has_programs = !network.processes.empty() || has_bootable_file(network);
    return is_small(network) && has_programs ? print_svg(network) : "";
}

std::string software_or_nothing(const Network& network) {
    return is_small(network) && !network.processes.empty() ? print_software_svg(network) : "";
}

} // namespace

RunPage::RunPage(const Network& network, const TraceWindow& window)
    : tracks_(network), recorder_(tracks_, require_time_in(window).from),
      timeline_(tracks_, without_limit(window), recorder_) {}

std::string RunPage::html(const PageContent& content, std::span<const PathPart> critical_path) {
    recorder_.draw_path(critical_path);
    timeline_.finish(content.report.result, name_of(content.report.outcome()));
    boost::json::object data{{"processes", processes_on_page(content.network)},
                             {"report", report_on_page(content)},
                             {"searches", searches_on_page(content.searches)},
                             {"timeline", recorder_.json()}};
    std::string title = std::filesystem::path(content.network.source_path).filename().string();
    const Part parts[] = {{"@TITLE@", as_markup(title)},
                          {"@STYLE@", page::style_css()},
                          {"@MACHINE@", machine_or_nothing(content.network)},
                          {"@SOFTWARE@", software_or_nothing(content.network)},
                          {"@LIBRARY@", page::library_js()},
                          {"@DATA@", text_of_data(data)},
                          {"@STRETCHES@", stretch_elements(recorder_.stretches())},
                          {"@PROGRAM@", page::program_js()}};
    return filled(page::frame_html(), parts);
}

std::string RunPage::warnings(const std::filesystem::path& path) const {
    std::string why = timeline_.why_empty();
    return why.empty() ? "" : fmt::format("{}: the timelines of the page are empty: {}\n", shown_output(path), why);
}

} // namespace placedpar
