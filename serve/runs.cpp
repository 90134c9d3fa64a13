#include "serve/runs.hpp"

#include "explore/workers.hpp"
#include "text/user_error.hpp"

#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <boost/json.hpp>
#include <fmt/format.h>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <utility>

namespace placedpar::serve {

namespace asio = boost::asio;
using boost::system::error_code;
using Stream = asio::posix::stream_descriptor;

namespace {

constexpr std::uint64_t grace_s = 3; ///< time from the interruption of a run until it is killed

/// Connects two streams by a pipe.
void connect(Stream& to_read, Stream& to_write) {
    std::array<int, 2> ends;
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
        throw UserError("no process can be started for a run: too many files are open; try again later");
    to_read.assign(ends[0]);
    to_write.assign(ends[1]);
}

/// Starts a process of this program for one job. The process inherits `input` and `output` as standard input and
/// output, and no other file. Its standard error is discarded, because it could fill the operator's terminal or log.
pid_t start(int input, int output, const RunLimits& limits) {
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, input, 0);
    ::posix_spawn_file_actions_adddup2(&actions, output, 1);
    ::posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_addclosefrom_np(&actions, 3);
    std::string seconds = std::to_string(limits.seconds), megabytes = std::to_string(limits.megabytes);
    std::array<std::string, 7> words = {"placedpar", "serve", "--job", "--seconds", seconds, "--memory", megabytes};
    std::array<char*, 8> arguments{};
    std::ranges::transform(words, arguments.begin(), [](std::string& word) { return word.data(); });
    std::array<char*, 1> environment{};
    pid_t child = -1;
    const int error = ::posix_spawn(&child, "/proc/self/exe", &actions, nullptr, arguments.data(), environment.data());
    ::posix_spawn_file_actions_destroy(&actions);
    if (error != 0)
        throw UserError("no process can be started for a run");
    return child;
}

std::string refused(const char* ended, const std::string& why) {
    return boost::json::serialize(boost::json::object{{"ended", ended}, {"refused", why}});
}

/// Returns an answer that tells the user why the process of a job gave no answer. A killed process has exceeded a
/// limit.
std::string why_no_answer(int status, const RunLimits& limits) {
    if (!WIFSIGNALED(status) || (WTERMSIG(status) != SIGKILL && WTERMSIG(status) != SIGXCPU))
        return refused("failed", fmt::format("the run has crashed: either it needed more memory than its limit of {} "
                                             "Mbyte, or PlacedPar has a defect",
                                             limits.megabytes));
    return refused(
        "killed",
        fmt::format(
            "the run was killed because it exceeded a limit: {} s of time, {} Mbyte of memory, or {} Mbyte of answer",
            limits.seconds, limits.megabytes, largest_answer_bytes >> 20));
}

} // namespace

/// Controls the process of one job.
class Runs::Process : public std::enable_shared_from_this<Process> {
public:
    Process(Runs& runs, Waiting job)
        : runs_(&runs), job_(std::move(job)), input_(runs.io_), output_(runs.io_), timer_(runs.io_) {}
    ~Process() { kill(); }

    const Waiting& job() const { return job_; }

    void begin() {
        Stream input(runs_->io_), output(runs_->io_); // the process's ends of the pipes
        connect(input, input_);
        connect(output_, output);
        child_ = start(input.native_handle(), output.native_handle(), runs_->limits_.run);
        text_ = std::exchange(job_.job, {})();
        asio::async_write(input_, asio::buffer(text_), [self = shared_from_this()](const error_code&, std::size_t) {
            error_code ignored;
            self->input_.close(ignored);
        });
        asio::async_read(output_, asio::dynamic_buffer(answer_, largest_answer_bytes),
                         [self = shared_from_this()](const error_code& error, std::size_t) { self->read(error); });
        timer_.expires_after(std::chrono::seconds(runs_->limits_.run.seconds + grace_s));
        timer_.async_wait([self = shared_from_this()](const error_code& error) {
            if (!error)
                self->kill();
        });
    }

    /// Kills the process. Its answer is lost.
    void withdraw() {
        runs_ = nullptr;
        kill();
    }

private:
    /// Reads a part of the answer. The answer is finished when it is complete or too long, or when the process has been
    /// killed.
    void read(const error_code& error) {
        kill();
        if (Runs* runs = std::exchange(runs_, nullptr))
            runs->ended(*this, error == asio::error::eof && answer_.ends_with('\n')
                                   ? std::move(answer_)
                                   : why_no_answer(status_, runs->limits_.run));
    }

    void kill() {
        timer_.cancel();
        error_code ignored;
        input_.close(ignored);
        if (child_ < 0)
            return;
        ::kill(child_, SIGKILL); // the process has already ended, or must end now
        ::waitpid(std::exchange(child_, -1), &status_, 0);
        if (!runs_)
            output_.close(ignored);
    }

    Runs* runs_; ///< null if the answer is no longer wanted
    Waiting job_;
    Stream input_, output_; ///< the pipes to and from the process
    asio::steady_timer timer_;
    pid_t child_ = -1;
    int status_ = 0; ///< status of the ended process, as from waitpid()
    std::string text_, answer_;
};

Runs::Runs(asio::io_context& io, const QueueLimits& limits) : io_(io), limits_(limits) {
    if (limits_.at_once == 0)
        limits_.at_once = count_cores();
}

Runs::~Runs() {
    for (const auto& each : running_)
        each->withdraw();
}

bool Runs::has_room_for(const std::string& peer) const {
    const auto of_peer = static_cast<std::size_t>(std::ranges::count(waiting_, peer, &Waiting::peer));
    return waiting_.size() < limits_.most_waiting && of_peer < limits_.most_waiting_of_peer;
}

std::optional<Runs::Number> Runs::add(std::string name, std::string peer, bool is_check, Text job, Done done) {
    if (!has_room_for(peer))
        return std::nullopt;
    auto place = waiting_.end();
    if (is_check)
        place = std::ranges::find_if_not(waiting_, &Waiting::is_check);
    const Number number = ++last_;
    waiting_.insert(place, {number, std::move(name), std::move(peer), is_check, std::move(job), std::move(done)});
    begin_next();
    return number;
}

void Runs::withdraw(Number job) {
    std::erase_if(waiting_, [&](const Waiting& each) { return each.number == job; });
    const auto found = std::ranges::find_if(running_, [&](const auto& each) { return each->job().number == job; });
    if (found == running_.end())
        return;
    (*found)->withdraw();
    running_.erase(found);
    begin_next();
}

std::optional<std::size_t> Runs::place_of(const std::string& name) const {
    if (std::ranges::any_of(running_, [&](const auto& each) { return each->job().name == name; }))
        return 0;
    const auto found = std::ranges::find(waiting_, name, &Waiting::name);
    if (found == waiting_.end())
        return std::nullopt;
    return static_cast<std::size_t>(std::distance(waiting_.begin(), found)) + 1;
}

void Runs::begin_next() {
    while (running_.size() < limits_.at_once && !waiting_.empty()) {
        auto process = std::make_shared<Process>(*this, std::move(waiting_.front()));
        waiting_.pop_front();
        try {
            process->begin();
            running_.push_back(std::move(process));
        } catch (const UserError& error) {
            process->job().done(refused("refused", error.what()));
        }
    }
}

void Runs::ended(Process& process, std::string answer) {
    const auto found = std::ranges::find(running_, &process, &std::shared_ptr<Process>::get);
    const std::shared_ptr<Process> ended = *found;
    running_.erase(found);
    ended->job().done(std::move(answer));
    begin_next();
}

} // namespace placedpar::serve
