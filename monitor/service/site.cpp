#include "monitor/service/site.hpp"

#include "monitor/service/page.hpp"

#include <boost/asio/post.hpp>
#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace placedpar::monitor {

namespace {

constexpr std::uint64_t most_rows = 500; ///< largest number of estimates, and of alarms, on the page
constexpr const char *json_type = "application/json", *html_type = "text/html; charset=utf-8",
                     *metrics_type = "text/plain; version=0.0.4; charset=utf-8";

} // namespace

Site::Site(boost::asio::io_context& io, Dispatcher& dispatcher, StateStore* store, web::Token token,
           web::HostNames names, std::function<void(const std::string&)> say)
    : io_(io), dispatcher_(dispatcher), store_(store),
      server_(
          {.realm = "placedpar monitor", .token = std::move(token), .names = std::move(names)},
          [this](const web::Request& request, const web::Reply& reply) {
              answer(request, reply);
              return web::Withdraw();
          },
          std::move(say)) {}

void Site::answer(const web::Request& request, const web::Reply& reply) {
    const std::string& path = request.path;
    if (path == "/healthz")
        reply(health());
    else if (!request.trusted)
        reply({401, "text/plain; charset=utf-8",
               "token required, as Bearer, or as the Basic password with any user name\n"});
    else if (path == "/")
        reply({200, html_type, page_html});
    else if (path == "/snapshot")
        reply({200, json_type, snapshot_json(dispatcher_.snapshot())});
    else if (path == "/metrics")
        reply({200, metrics_type, metrics_text(dispatcher_.snapshot())});
    else if (path == "/history")
        answer_history(request.query, reply);
    else
        reply({404, "text/plain; charset=utf-8",
               "not found; the pages are /, /snapshot, /history, /metrics and /healthz\n"});
}

web::Answer Site::health() const {
    ServiceSnapshot snapshot = dispatcher_.snapshot();
    if (snapshot.kept)
        return {200, "text/plain; charset=utf-8", "ok\n"};
    return {503, "text/plain; charset=utf-8", fmt::format("not kept: {}\n", snapshot.trouble)};
}

/// Reads the history in the writer's thread, so that the event loop does not wait for the disk.
void Site::answer_history(const std::string& query, const web::Reply& reply) {
    constexpr std::string_view name = "machine=";
    if (!query.starts_with(name)) {
        reply({400, "text/plain; charset=utf-8", "the request names no machine; expected /history?machine=NAME\n"});
        return;
    }
    if (!store_) {
        reply({200, json_type, history_json({}, {})});
        return;
    }
    store_->look([this, reply, machine = query.substr(name.size())](StateFile& file) {
        web::Answer answer{200, json_type, ""};
        try {
            History& history = file.history();
            answer.text = history_json(history.estimates(machine, most_rows), history.alarms(machine, most_rows));
        } catch (const std::exception& error) {
            answer = {500, "text/plain; charset=utf-8", fmt::format("{}\n", error.what())};
        }
        boost::asio::post(io_, [reply, answer = std::move(answer)] { reply(answer); });
    });
}

} // namespace placedpar::monitor
