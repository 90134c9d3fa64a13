#include "serve/site.hpp"

#include "explore/exercise/course.hpp"
#include "explore/problems.hpp"
#include "report/kinds_report.hpp"
#include "serve/job_text.hpp"
#include "serve/page.hpp"
#include "text/output_file.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <stdexcept>

namespace placedpar::serve {

namespace json = boost::json;

namespace {

constexpr const char *json_type = "application/json", *html_type = "text/html; charset=utf-8",
                     *plain = "text/plain; charset=utf-8";
constexpr std::size_t longest_name = 64, most_files = 20; ///< values of our choice

std::string json_of(const Texts& texts) {
    json::object object;
    for (const auto& [name, text] : texts)
        object[name] = text;
    return json::serialize(object);
}

std::string exercises_json() {
    json::array all;
    for (const Exercise& each : exercises())
        all.push_back(json::object{{"number", each.number}, {"title", each.title()}, {"start", each.start}});
    return json::serialize(all);
}

std::string catalogue_json() {
    const ProblemRegistry problems = known_problems(0);
    return json::serialize(kinds_json(known_kinds(problems)));
}

/// Returns the job's member "do". Throws std::invalid_argument if the text is not a job.
std::string task_of(const std::string& text) { return job_of(text, most_files).task; }

} // namespace

Site::Site(Runs& runs, Texts examples, std::string keep)
    : runs_(runs), examples_(std::move(examples)), keep_(std::move(keep)), page_(page_html()),
      examples_json_(json_of(examples_)), exercises_json_(exercises_json()), catalogue_json_(catalogue_json()) {
    if (!keep_.empty() && !std::filesystem::is_directory(keep_))
        throw UserError(fmt::format("--keep {}: this folder does not exist", keep_));
}

web::Withdraw Site::answer(const web::Request& request, const web::Reply& reply) {
    if (request.path == "/healthz")
        reply({200, plain, "ok\n"});
    else if (!request.trusted)
        reply({401, plain, "a token is required: send it as Bearer, or as the password of Basic with any user name\n"});
    else if (request.posts && request.path == "/job")
        return begin(request, reply);
    else if (request.posts)
        reply({405, plain, "POST is allowed only to /job\n"});
    else
        reply(data(request));
    return {};
}

web::Answer Site::data(const web::Request& request) const {
    if (request.path == "/")
        return {200, html_type, page_};
    if (request.path == "/examples")
        return {200, json_type, examples_json_};
    if (request.path == "/exercises")
        return {200, json_type, exercises_json_};
    if (request.path == "/catalogue")
        return {200, json_type, catalogue_json_};
    if (request.path == "/place") {
        const std::optional<std::size_t> place = runs_.place_of(request.query);
        return {200, json_type, place ? fmt::format("{{\"place\":{}}}", *place) : "{}"};
    }
    return {404, plain, "not found: the page is at /\n"};
}

std::string Site::completed(const std::string& body) const {
    json::value value = json::parse(body);
    json::object& job = value.as_object();
    json::object& files = job.at("files").as_object();
    for (const auto& [name, text] : examples_)
        files.emplace(name, text); // a file of the page replaces an example of the same name
    return json::serialize(job);
}

web::Withdraw Site::begin(const web::Request& request, const web::Reply& reply) {
    std::string task;
    try {
        task = task_of(request.body);
    } catch (const std::exception& wrong) {
        reply({400, plain, fmt::format("the request is not a job: {}\n", wrong.what())});
        return {};
    }
    const bool is_check = task == "check";
    auto job = [this, body = request.body] { return completed(body); };
    auto done = [this, reply, kept = keep_.empty() || is_check ? std::string() : request.body](std::string answer) {
        if (!kept.empty())
            keep(kept, answer);
        reply({200, json_type, std::move(answer)});
    };
    const auto number =
        runs_.add(request.query.substr(0, longest_name), request.peer, is_check, std::move(job), std::move(done));
    if (!number) {
        reply({503, plain, "too many jobs are waiting: try again later\n"});
        return {};
    }
    return [this, job_number = *number] { runs_.withdraw(job_number); };
}

/// Stores a job with its answer, but without the page of the run. Only reports an error, because a full disk must not
/// stop the service.
void Site::keep(const std::string& job, const std::string& answer) {
    try {
        json::object answered = json::parse(answer).as_object();
        answered.erase("page");
        const std::string name =
            fmt::format("{:%Y-%m-%dT%H-%M-%S}Z-{:06}.json", fmt::gmtime(std::chrono::system_clock::now()), ++kept_);
        write_whole(std::filesystem::path(keep_) / name,
                    json::serialize(json::object{{"job", json::parse(job)}, {"answer", std::move(answered)}}) + "\n");
    } catch (const std::exception& failed) {
        print_error(fmt::format("placedpar serve: {}\n", failed.what()));
    }
}

} // namespace placedpar::serve
