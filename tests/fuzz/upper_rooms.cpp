// Readers of the monitor, of studies and of experiments. Fuzzing them is a separate study, since all rooms must be
// compiled.

#include "app/command.hpp"
#include "app/record/scenario_record.hpp"
#include "editor/language/completion.hpp"
#include "editor/language/navigation.hpp"
#include "editor/language/study_text.hpp"
#include "editor/protocol/message_stream.hpp"
#include "editor/server.hpp"
#include "explore/generate/generate.hpp"
#include "explore/generate/graph_topology.hpp"
#include "explore/problems.hpp"
#include "explore/study/measure.hpp"
#include "explore/study/results.hpp"
#include "explore/study/setting_value.hpp"
#include "explore/study/study_file.hpp"
#include "explore/study/study_names.hpp"
#include "explore/study/summary.hpp"
#include "explore/time_text.hpp"
#include "gaprocs/initial_population.hpp"
#include "gaprocs/policies/nouns.hpp"
#include "gaprocs/representation/representation.hpp"
#include "hydraulics/data/parameters.hpp"
#include "identification/on_line/diagnosis.hpp"
#include "monitor/memory/diagnosis_json.hpp"
#include "monitor/memory/state_file.hpp"
#include "monitor/protocol/bad_message.hpp"
#include "monitor/protocol/message.hpp"
#include "monitor/service/send_command.hpp"
#include "netlist/language/layout.hpp"
#include "netlist/language/names_in_text.hpp"
#include "netlist/read.hpp"
#include "problems/benchmark/tour_file.hpp"
#include "serve/job.hpp"
#include "tests/fuzz/reader.hpp"
#include "text/number.hpp"
#include "text/user_error.hpp"
#include "web/host_names.hpp"
#include "web/listener.hpp"
#include "web/server.hpp"
#include "web/token.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/json.hpp>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numeric>
#include <sstream>

namespace placedpar::fuzz {

namespace {

/// Writes a file in memory, alone in its folder, and returns its path.
std::string file_of(const std::string& content, const std::string& name) {
    const std::string folder = fmt::format("/dev/shm/placedpar-fuzz-{}", ::getpid());
    std::filesystem::remove_all(folder);
    std::filesystem::create_directory(folder);
    std::ofstream(folder + "/" + name, std::ios::binary) << content;
    return folder + "/" + name;
}

void read_study_text(const std::string& text) { read_study(file_of(text, "study.toml")); }

std::string content_of(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Replaces bytes of a good file: of each three input bytes, two choose the position and one is the new value.
std::string patched(std::string good, const std::string& input) {
    auto byte = [&](std::size_t at) { return static_cast<unsigned char>(input[at]); };
    for (std::size_t at = 0; at + 2 < input.size(); at += 3)
        good[(byte(at) * 256u + byte(at + 1)) % good.size()] = input[at + 2];
    return good;
}

std::string made_results() {
    const std::string path = file_of("", "results.sqlite");
    {
        StudyResults results(path, {"ring.cfs", {{"ring.cfs", "host h;"}}, "{}"});
        results.set_measures({"time"});
        for (std::uint64_t seed = 1; seed <= 3; ++seed)
            results.keep({{{"n", "1"}}, seed}, {.ended = "completed", .figures = {{"time", {0.1, "ms"}}}});
    }
    return content_of(path);
}

void read_results(const std::string& patches) {
    static const std::string good = made_results();
    StudyResults results(file_of(patched(good, patches), "results.sqlite"));
    summary_of(results);
}

void read_message(const std::string& line) {
    try {
        monitor::parse_message(line);
    } catch (const monitor::BadMessage&) { // the service answers with an error
    }
}

std::string made_state() {
    const std::string path = file_of("", "state");
    {
        monitor::StateContent content;
        monitor::StateFile file(path, "settings", 10, content);
    }
    return content_of(path);
}

void read_state(const std::string& patches) {
    static const std::string good = made_state();
    monitor::StateContent content;
    monitor::StateFile file(file_of(patched(good, patches), "state"), "settings", 10, content);
}

std::string text_of(const identification::Diagnosis::State& state) {
    return boost::json::serialize(monitor::state_json(state));
}

std::string made_diagnosis() {
    const auto machine = hydraulics::Parameters::excavator();
    return text_of(identification::Diagnosis("m", identification::excavator_parameters(machine), {}, 1).state());
}

/// Reads a damaged machine state. The state is patched itself, since the state file's checksums would reject any
/// damage.
void read_diagnosis(const std::string& patches) {
    static const std::string good = made_diagnosis();
    try {
        text_of(monitor::state_from(boost::json::parse(patched(good, patches)), {}));
    } catch (const std::runtime_error&) { // the state was refused
    }
}

template <class Read>
void attempt_to(Read read) {
    try {
        read();
    } catch (const UserError&) { // the text was refused
    }
}

void read_policies(const std::string& text) {
    for (const Noun& noun : policy_nouns())
        attempt_to([&] {
            if (noun.policies.empty())
                return;
            for (double number : read_policy(text, noun.policies).numbers)
                require(std::isfinite(number), "a policy's numbers are finite");
            const std::string printed = noun.printed(text);
            require(noun.printed(printed) == printed, "a policy is read as it is printed");
        });
}

void read_strings(const std::string& text) {
    const Representation representations[] = {BitString(5), RealVector({{-2, 2}, {0, 1e300}}), Permutation(4)};
    for (const Representation& each : representations)
        attempt_to([&] {
            Genome genome = each.read(text);
            require(each.read(each.text(genome)) == genome, "a string is read as it is printed");
        });
}

void read_population(const std::string& text) {
    const Representation representations[] = {BitString(5), RealVector({{-2, 2}, {0, 1e300}}), Permutation(4)};
    for (const Representation& each : representations)
        attempt_to([&] { load_population(file_of(text, "population"), each); });
}

void read_tour(const std::string& text) {
    attempt_to([&] {
        const TableTour tour = read_tour_file(file_of(text, "tour.tsp"));
        std::vector<std::size_t> order(tour.representation().places());
        std::iota(order.begin(), order.end(), std::size_t{0});
        require(tour.objective(order) >= 0, "a tour has a length");
    });
}

/// Reads hosts and passwords as browsers send them, the service's names, and its token.
void read_names(const std::string& text) {
    web::host_in(text);
    web::from_base64(text);
    attempt_to([&] { web::HostNames("127.0.0.1", {text}); });
    attempt_to([&] {
        const std::string path = file_of(text, "token");
        std::filesystem::permissions(path, std::filesystem::perms::owner_read);
        require(web::Token(path).wanted(), "a token that is taken is wanted");
    });
}

void read_answer(const std::string& line) { monitor::require_answer("monitor", line); }

/// Reads addresses for the monitor to listen on. A Unix socket gets its own folder.
void read_place(const std::string& text) {
    boost::asio::io_context io;
    attempt_to([&] { web::Listener::at_port(io, text, 0, "--port"); });
    const std::string folder = std::filesystem::path(file_of("", "file")).parent_path();
    std::string name = text;
    std::ranges::replace(name, '/', '_');
    attempt_to([&] { web::Listener::at_path(io, folder + "/" + name); });
}

/// The input is everything that one connection sends before it closes.
void read_request(const std::string& all) {
    const std::string text = all.substr(0, 1000); // the answers must fit into the unread socket
    int ends[2];
    require(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) == 0, "there are sockets");
    boost::asio::io_context io;
    web::Server server(
        {.realm = "a test", .token = {}, .names = web::HostNames("127.0.0.1", {}), .most_body_bytes = 100},
        [](const web::Request& request, const web::Reply& reply) {
            reply({200, "text/plain", request.path + request.body});
            return web::Withdraw();
        },
        [](const std::string&) {});
    web::Listener::Socket socket(io, web::Listener::Socket::protocol_type(AF_UNIX, 0), ends[0]);
    server.welcome(std::move(socket), {"loopback", "a test", "127.0.0.1"});
    for (std::size_t sent = 0; sent < text.size();) {
        const ssize_t more = ::send(ends[1], text.data() + sent, text.size() - sent, MSG_NOSIGNAL | MSG_DONTWAIT);
        if (more < 0)
            break;
        sent += static_cast<std::size_t>(more);
        io.poll();
    }
    ::shutdown(ends[1], SHUT_WR);
    io.run();
    char begin[5] = {};
    const ssize_t answered = ::recv(ends[1], begin, sizeof begin, MSG_DONTWAIT);
    ::close(ends[1]);
    require(answered <= 0 || std::string_view(begin, sizeof begin) == "HTTP/", "what is answered is HTTP");
}

/// Reads a job as the process of a run does, after it has confined itself. A run is interrupted after a second.
void read_job(const std::string& text) {
    const std::string answer = serve::answer_of(text, {.seconds = 1});
    require(boost::json::parse(answer).is_object(), "the answer of a job is an object");
}

/// Hides everything written to the standard streams while it exists.
class Quiet {
public:
    Quiet() {
        const int null_device = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
        for (int stream : {STDOUT_FILENO, STDERR_FILENO})
            ::dup2(null_device, stream);
        ::close(null_device);
    }
    ~Quiet() {
        ::dup2(out_, STDOUT_FILENO);
        ::dup2(error_, STDERR_FILENO);
    }
    Quiet(const Quiet&) = delete;
    Quiet& operator=(const Quiet&) = delete;

private:
    // The copies are made once and stay open.
    static inline const int out_ = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3),
                            error_ = ::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3);
};

/// The input's lines are the program's arguments. They are parsed but not carried out.
void read_words(const std::string& text) {
    std::vector<std::string> words{"placedpar"};
    std::istringstream lines(text.substr(0, text.find("\0", 0, 1)));
    for (std::string line; std::getline(lines, line);)
        words.push_back(line);
    std::vector<char*> pointers;
    for (std::string& word : words)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);
    std::vector<Command> commands = program_commands();
    std::ranges::move(further_commands(), std::back_inserter(commands));
    Quiet quiet;
    read_command_line(commands, static_cast<int>(words.size()), pointers.data());
}

/// A netlist of searches is checked by their processes, too.
void read_searches(const std::string& text) {
    static const ProblemRegistry problems = known_problems(1);
    static const Catalogue kinds = known_kinds(problems);
    ReadResult result = read_netlist_text(text, kinds);
    render(result);
    require(result.network.has_value() != has_errors(result.diagnostics), "what is refused is refused with an error");
}

/// Reads a graph of GraphML or Graphviz as a machine. A graph of many nodes takes too long.
void read_graph(const std::string& text) {
    static const ProblemRegistry problems = known_problems(0);
    static const Catalogue kinds = known_kinds(problems);
    const char* name = text.find("<graph") == text.npos ? "graph.dot" : "graph.graphml";
    generate::TopologyRequest wish;
    wish.topology = file_of(text, name);
    wish.split = text.size() % 2 == 0;
    wish.host = "node";
    generate::topology_of_graph(wish, kinds);
    if (text.size() < 4000)
        generate::generate(wish, kinds);
}

/// Reads a table of tasks, and the netlist that it becomes.
void read_tasks(const std::string& text) {
    static const ProblemRegistry problems = known_problems(0);
    static const Catalogue kinds = known_kinds(problems);
    generate::TopologyRequest wish;
    wish.topology = "ring";
    wish.size = "4";
    wish.job = file_of(text, "tasks.csv");
    generate::generate(wish, kinds);
}

/// The input's lines are a topology, a size and further numbers; each may be missing.
void read_topology_request(const std::string& text) {
    static const ProblemRegistry problems = known_problems(1);
    static const Catalogue kinds = known_kinds(problems);
    std::vector<std::string> lines(5);
    for (std::size_t line = 0; char c : text)
        if (c == '\n' && line + 1 < lines.size())
            ++line;
        else
            lines[line] += c;
    if (lines[1].size() > 2 && lines[1].find('x') == lines[1].npos)
        return; // large machines take too long
    generate::TopologyRequest wish;
    wish.topology = lines[0];
    wish.size = lines[1];
    wish.branches = parse_number<std::size_t>(lines[2]);
    wish.chord = parse_number<std::size_t>(lines[3]);
    wish.job = lines[4];
    generate::generate(wish, kinds);
}

void read_scenario_settings(const std::string& text) {
    const std::size_t equals = std::min(text.find('='), text.size());
    for (const hydraulics::RecordScenario& scenario : hydraulics::record_scenarios())
        attempt_to([&] {
            const auto machine = hydraulics::Parameters::excavator();
            const Overrides set{{text.substr(0, equals), text.substr(std::min(equals + 1, text.size()))}};
            const auto parameters = scenario_parameters(scenario, machine, "", set);
            for (const hydraulics::Parameter& each : parameters.all())
                require(std::isfinite(each.value), "parameters are finite");
        });
}

/// The input is all that an editor sends.
void serve_an_editor(const std::string& text) {
    std::istringstream in(text);
    std::ostringstream out;
    editor::serve_editor(in, out);
    std::istringstream sent(out.str());
    editor::MessageStream answers(sent, out);
    while (const auto answer = answers.read())
        boost::json::parse(*answer);
}

/// Asks about every few places of a netlist, and lays it out.
void ask_about_netlist(const std::string& text) {
    static const ProblemRegistry problems = known_problems(1);
    static const Catalogue kinds = known_kinds(problems);
    const auto file = std::make_shared<const SourceFile>("/nowhere/input.cfs", text);
    const NetlistSyntax syntax = read_syntax(file);
    for (std::size_t line = 1; line < 30 && !file->line(line).empty(); ++line)
        for (std::size_t column = 1; column < 100 && column <= file->line(line).size() + 1; column += 3) {
            const Location at{file, line, column};
            editor::complete_netlist(syntax, kinds, at);
            editor::hover_netlist(syntax, kinds, at);
            editor::definition_in_netlist(syntax, at);
            attempt_to([&] { editor::places_to_rename(syntax, kinds, at, "another"); });
        }
    if (const auto once = laid_out_netlist(file)) {
        const auto again = laid_out_netlist(std::make_shared<const SourceFile>("/nowhere/input.cfs", *once));
        require(again == once, "a second layout is as the first");
    }
}

/// Asks about every few places of a study.
void ask_about_study(const std::string& text) {
    static const Catalogue kinds;
    const StudyNames names{
        .settings = {{"master.trials", {}}, {"slaves", {}}}, .measures = {{"t.busy", {}}}, .programs = {}};
    const auto file = std::make_shared<const SourceFile>("/nowhere/input.toml", text);
    const editor::StudyText words = editor::read_study_text(text);
    for (std::size_t end = 0; end <= text.size() && end < 3000; end += 3)
        editor::complete_study(editor::read_study_text(std::string_view(text).substr(0, end)), names, kinds);
    for (const editor::StudyWord& each : words.words)
        require(each.first <= each.end && each.end <= text.size(), "a word is in the text");
    for (std::size_t line = 1; line < 30 && !file->line(line).empty(); ++line)
        for (std::size_t column = 1; column < 100 && column <= file->line(line).size() + 1; column += 3) {
            editor::hover_study(words, names, {file, line, column});
            editor::definition_in_study(words, names, {file, line, column});
        }
}

void read_arguments(const std::string& text) {
    attempt_to([&] { parse_time(text); });
    attempt_to([&] { StudyMeasure{text}; });
    attempt_to([&] { StudyExpression{text}; });
    attempt_to([&] {
        const StudyAxis axis = read_axis(text);
        if (axis.count() > 0)
            axis.at(axis.count() - 1);
    });
    SettingValue value("clock", text);
    require(value == SettingValue("clock", value.spelling()), "a value is equal to itself");
    attempt_to([&] {
        std::string figures;
        try {
            figures = figures_text(figures_from(text));
        } catch (const std::exception&) {
            return; // the row was refused
        }
        require(figures_text(figures_from(figures)) == figures, "figures are read as they are written");
    });
}

} // namespace

std::span<const Reader> readers() {
    static const Reader all[] = {{"study", read_study_text},      {"results", read_results},
                                 {"message", read_message},       {"state", read_state},
                                 {"arguments", read_arguments},   {"policies", read_policies},
                                 {"strings", read_strings},       {"diagnosis", read_diagnosis},
                                 {"population", read_population}, {"tour", read_tour},
                                 {"names", read_names},           {"searches", read_searches},
                                 {"wish", read_topology_request}, {"graph", read_graph},
                                 {"tasks", read_tasks},           {"scenario", read_scenario_settings},
                                 {"answer", read_answer},         {"places", read_place},
                                 {"request", read_request},       {"job", read_job},
                                 {"command", read_words},         {"editor", serve_an_editor},
                                 {"words", ask_about_netlist},    {"keys", ask_about_study}};
    return all;
}

} // namespace placedpar::fuzz
