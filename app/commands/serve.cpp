#include "app/command.hpp"
#include "app/options/common_options.hpp"
#include "app/standard_error.hpp"
#include "experiments/kit/examples_folder.hpp"
#include "serve/job.hpp"
#include "serve/service.hpp"
#include "text/output_file.hpp"
#include "web/listener.hpp"

#include <fmt/format.h>

#include <memory>
#include <string>

namespace placedpar::serve {

namespace {

struct ServeOptions {
    ServiceSettings settings;
    bool job = false;
};

ExitCode serve_page(ServiceSettings settings) {
    settings.examples = examples_folder();
    Service service(settings,
                    [](const std::string& sentence) { print_error(fmt::format("placedpar serve: {}\n", sentence)); });
    print_out(
        fmt::format("placedpar serve: page at http://{}:{}/\n", web::address_in_url(settings.address), service.port()));
    service.run();
    return ExitCode::success;
}

ExitCode start(const ServeOptions& options) {
    if (!options.job)
        return serve_page(options.settings);
    return do_job(options.settings.queue.run) ? ExitCode::success : ExitCode::bad_input;
}

Action declare(Options& command, const std::string&) {
    auto options = std::make_shared<ServeOptions>();
    ServiceSettings& settings = options->settings;
    command
        .add("--address", settings.address, "address to listen on; needs --token-file if other computers can reach it")
        .show_default();
    add_number(command, "--port", settings.port, 0, 65535, "port to listen on; 0: any free port, which is printed")
        .show_default();
    add_file(command, "--token-file", settings.token_file, "file with the token that browsers must send as a password");
    command.add("--host-name", settings.host_names,
                "host name that browsers use for this server, such as a proxy's; may be repeated");
    add_file(command, "--keep", settings.keep, "stores each program that is run, with its answer, in this folder",
             "FOLDER");
    add_jobs(command, settings.queue.at_once, "number of runs at a time; others wait. Default: number of cores");
    add_number(command, "--seconds", settings.queue.run.seconds, 1, 3600, "seconds that a run may take").show_default();
    add_number(command, "--memory", settings.queue.run.megabytes, 256, 1 << 20, "Mbyte of memory that a run may take")
        .show_default();
    command.add_flag("--job", options->job,
                     "serves no page: reads one job as JSON from standard input, confines itself as each run of the "
                     "page is confined, and writes the answer");
    return [options] { return start(*options); };
}

} // namespace
} // namespace placedpar::serve

namespace placedpar {

extern const Command serve_command{
    .name = "serve",
    .about = "Serves a page on which netlists and programs in occam are written and run",
    .place = 95,
    .declare = serve::declare,
};

} // namespace placedpar
