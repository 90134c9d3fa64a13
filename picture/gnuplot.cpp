#include "picture/gnuplot.hpp"

#include "text/user_error.hpp"

#define BOOST_PROCESS_USE_STD_FS // otherwise Boost.Filesystem would have to be linked
#include <boost/asio/io_context.hpp>
#include <boost/process/args.hpp>
#include <boost/process/async.hpp>
#include <boost/process/child.hpp>
#include <boost/process/io.hpp>
#include <boost/process/search_path.hpp>
#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <future>
#include <memory>

namespace placedpar {

namespace {

namespace process = boost::process;

std::filesystem::path find_gnuplot() {
    auto path = process::search_path("gnuplot");
    if (path.empty())
        throw UserError(
            "plots are drawn by gnuplot, which is not installed; install it with apt-get install gnuplot-nox");
    return path;
}

/// Returns an unnamed file that contains the script. A file is safer than a pipe, because writing to a pipe fails if
/// gnuplot has already ended with an error.
std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_of(const std::string& script) {
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::tmpfile(), std::fclose);
    if (!file || std::fwrite(script.data(), 1, script.size(), file.get()) != script.size() ||
        std::fflush(file.get()) != 0)
        throw UserError(fmt::format("cannot store the script for gnuplot: {}", std::strerror(errno)));
    std::rewind(file.get());
    return file;
}

} // namespace

void require_gnuplot() { find_gnuplot(); }

std::string run_gnuplot(const std::string& script) {
    boost::asio::io_context context;
    std::future<std::string> drawing, complaint;
    auto file = file_of(script);
    process::child gnuplot(find_gnuplot(), process::args("-d"), process::std_in<file.get(), process::std_out> drawing,
                           process::std_err > complaint, context);
    context.run();
    gnuplot.wait();
    if (gnuplot.exit_code() != 0)
        throw UserError(fmt::format("gnuplot cannot draw the plot: {}", complaint.get()));
    return drawing.get();
}

} // namespace placedpar
