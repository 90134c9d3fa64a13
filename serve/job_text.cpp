#include "serve/job_text.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace placedpar::serve {

namespace json = boost::json;

namespace {

/// Returns the member as a string. Returns "" if the job does not have the member.
std::string text_in(const json::object& job, const char* name) {
    const json::value* found = job.if_contains(name);
    if (found && !found->is_string())
        throw std::invalid_argument(fmt::format("\"{}\" must be a string", name));
    return found ? std::string(found->as_string()) : "";
}

std::string task_in(const json::object& job) {
    constexpr std::array tasks = {"check", "run", "explain", "listing", "exercise"};
    const std::string task = text_in(job, "do");
    if (std::ranges::find(tasks, task) == tasks.end())
        throw std::invalid_argument("\"do\" must be check, run, explain, listing or exercise");
    return task;
}

const json::object& files_in(const json::object& job, std::size_t most_files) {
    const json::value& files = job.at("files");
    if (!files.is_object())
        throw std::invalid_argument("\"files\" must be an object");
    if (files.as_object().size() > most_files)
        throw std::invalid_argument(fmt::format("the job has more than {} files", most_files));
    for (const auto& [name, text] : files.as_object())
        if (!text.is_string() || name.empty() || name.front() == '/' || name.find("..") != name.npos)
            throw std::invalid_argument(
                "the text of each file must be a string, and its name must have no \"..\" and not begin with \"/\"");
    if (!files.as_object().contains(text_in(job, "main")))
        throw std::invalid_argument("\"main\" must be the name of one of the files");
    return files.as_object();
}

std::uint64_t seed_in(const json::object& job) {
    const json::value* seed = job.if_contains("seed");
    boost::system::error_code error;
    const std::uint64_t found = seed ? seed->to_number<std::uint64_t>(error) : 1;
    if (error)
        throw std::invalid_argument("\"seed\" must be a whole number");
    return found;
}

/// Parses the text. The message of an error of Boost would name a line of Boost's source.
json::value parsed(const std::string& text) {
    boost::system::error_code error;
    json::value value = json::parse(text, error);
    if (error)
        throw std::invalid_argument(fmt::format("it is not JSON: {}", error.message()));
    if (!value.is_object())
        throw std::invalid_argument("it must be a JSON object");
    return value;
}

} // namespace

Job job_of(const std::string& text, std::size_t most_files) {
    const json::value value = parsed(text);
    const json::object& object = value.as_object();
    for (const char* name : {"do", "main", "files"})
        if (!object.contains(name))
            throw std::invalid_argument(fmt::format("\"{}\" is missing", name));
    const json::object& files = files_in(object, most_files);
    Job job{.task = task_in(object),
            .main = text_in(object, "main"),
            .exercise = text_in(object, "exercise"),
            .keys = text_in(object, "keys"),
            .files = {},
            .seed = seed_in(object)};
    for (const auto& [name, content] : files)
        job.files.emplace_back(name, content.as_string());
    if (object.contains("expected"))
        job.expected = text_in(object, "expected");
    return job;
}

bool is_job(const std::string& text) {
    try {
        job_of(text);
        return true;
    } catch (const std::exception&) { // even std::bad_alloc: this process has limits
        return false;
    }
}

} // namespace placedpar::serve
