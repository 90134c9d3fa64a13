#include "gaprocs/processes/kind_checks.hpp"

#include "gaprocs/processes/messages.hpp"
#include "gaprocs/processes/parameters.hpp"
#include "gaprocs/processes/peers.hpp"
#include "gaprocs/processes/search_description.hpp"
#include "gaprocs/processes/slave_tree.hpp"
#include "gaprocs/usual_settings.hpp"
#include "netlist/network/names.hpp"
#include "text/counted.hpp"
#include "text/program_name.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <memory>
#include <string>
#include <utility>

namespace placedpar {

namespace {

class Check {
public:
    Check(const Network& network, std::size_t process, const ProblemRegistry& problems)
        : network_(network), process_(process), problems_(problems) {
        try {
            recorded_ = &problems.find(text("problem"));
        } catch (const UserError& unknown) {
            if (!refused_before())
                refuse("problem", unknown.what());
        }
    }

    void host() {
        check_estimates();
        if (!recorded_)
            return;
        check_samples_for_code();
        if (has_objective())
            return say_ignored({"samples", "sample_bytes"});
        refuse_generations();
        if (integer("samples") > record_length())
            refuse("samples", fmt::format("samples = {}, but the record of \"{}\" has only {}", integer("samples"),
                                          text("problem"), record_length()));
    }

    void search() {
        if (has_objective())
            check_objective();
        else
            check_window();
        if (integer("elite") > integer("population") - 2)
            refuse("elite",
                   fmt::format("an elite of {} in a population of {} leaves no pair to breed", integer("elite"),
                               integer("population")),
                   fmt::format("the greatest possible elite is {}", integer("population") - 2));
        check_coding();
        warn_of_short_strings();
        check_operators();
        auto host = other_end(network_, process_, "from_host");
        if (host && !host->at_edge() && network_.processes[host->process].kind == "ga.host")
            check_host(host->process);
        if (other_end(network_, process_, "to_slaves"))
            check_slaves();
    }

    void slave() {
        for (const char* port : {"from_master", "to_master"})
            check_single(port);
        auto circle = circle_of(network_, process_);
        if (circle.empty() || *std::ranges::min_element(circle) != process_) // only the slave that is declared first
                                                                             // reports the circle
            return;
        std::string names;
        for (auto each = circle.rbegin(); each != circle.rend(); ++each)
            names += (names.empty() ? "\"" : ", \"") + name(*each) + "\"";
        refuse("from_master",
               fmt::format("the slaves {} are connected in a circle, so no master's tasks reach them", names));
    }

    std::vector<Complaint> take() { return std::move(complaints_); }

private:
    std::int64_t integer(const char* parameter) const { return integer_of(process_, parameter); }
    std::int64_t integer_of(std::size_t process, const char* parameter) const {
        return std::get<std::int64_t>(network_.processes[process].parameters.at(parameter));
    }
    double number(const char* parameter) const {
        return std::get<double>(network_.processes[process_].parameters.at(parameter));
    }
    const std::string& text(const char* parameter) const { return text_of(process_, parameter); }
    const std::string& text_of(std::size_t process, const char* parameter) const {
        return std::get<std::string>(network_.processes[process].parameters.at(parameter));
    }
    const std::string& name(std::size_t process) const { return network_.processes[process].name; }
    std::int64_t record_length() const { return static_cast<std::int64_t>(recorded_->samples()); }
    bool has_objective() const { return recorded_ && recorded_->problem()->objective(); }
    bool given(const std::string& parameter) const { return network_.processes[process_].given.contains(parameter); }

    /// Returns whether an earlier process names the same problem. The check of that process has then reported that the
    /// problem does not exist.
    bool refused_before() const {
        auto first = network_.processes.begin(), self = first + static_cast<std::ptrdiff_t>(process_);
        return std::any_of(first, self, [&](const ProcessInstance& other) {
            return other.kind.starts_with("ga.") && is_same(other, "problem");
        });
    }

    void refuse(std::string about, std::string message, std::string hint = "") {
        refuse_of(process_, std::move(about), std::move(message), std::move(hint));
    }
    void refuse_of(std::size_t process, std::string about, std::string message, std::string hint = "") {
        complaints_.push_back({process, std::move(about), std::move(message), std::move(hint)});
    }

    /// Checks that the port is a single end instead of an array.
    void check_single(const char* port) {
        for (const PortBinding& binding : network_.processes[process_].ports)
            if (base_name(binding.port) == port && binding.port != port)
                return refuse(binding.port,
                              fmt::format("\"{}.{}\" must be a single channel, not an array: a slave is connected to "
                                          "one master or to one preceding slave",
                                          name(process_), port),
                              fmt::format("write {}.{} without a subscript", name(process_), port));
    }

    void warn(std::string about, std::string message, std::string hint) {
        complaints_.push_back({process_, std::move(about), std::move(message), std::move(hint), true});
    }

    /// Warns about settings that do not suit the problem's measurements (RecordAdvice). If several processes have the
    /// same setting, only the check of the first process warns.
    void warn_of_advice() {
        const RecordAdvice& advice = recorded_->advice();
        if (advice.trials != 0 && std::cmp_not_equal(integer("trials"), advice.trials) && !is_as_before("trials"))
            warn(given("trials") ? "trials" : "",
                 fmt::format("trials = {}, but the record of \"{}\" has one sample for every {}, so the changes in the "
                             "record come at other generations than documented",
                             integer("trials"), text("problem"),
                             advice.trials == 1 ? "generation" : counted(advice.trials, "generation")),
                 fmt::format("trials = {}", advice.trials));
        if (advice.bias != 0 && !given("bias") && !is_as_before("bias"))
            warn("",
                 fmt::format("bias = {:g} was chosen for the problem \"boom\"; it is so much larger than the errors of "
                             "\"{}\" that fitness hardly varies",
                             number("bias"), text("problem")),
                 fmt::format("bias = {:g}", advice.bias));
    }

    void warn_of_short_strings() {
        if (!coded_problem_ || is_as_before("string_bytes"))
            return;
        auto stated = integer("string_bytes"), needed = static_cast<std::int64_t>(string_bytes(0, *coded_problem_));
        if (stated != 0 && stated < needed)
            warn("string_bytes",
                 fmt::format("string_bytes = {}, but a string of \"{}\" has {} bytes: it does not fit into the message",
                             stated, text("problem"), needed),
                 "leave string_bytes out: the default is the length of the problem's strings");
    }

    /// Returns whether an earlier process has the same problem and the same value of the parameter.
    bool is_as_before(const char* parameter) const {
        auto first = network_.processes.begin(), self = first + static_cast<std::ptrdiff_t>(process_);
        return std::any_of(first, self, [&](const ProcessInstance& other) {
            return other.kind.starts_with("ga.") && is_same(other, "problem") && is_same(other, parameter);
        });
    }
    bool is_same(const ProcessInstance& other, const char* parameter) const {
        auto found = other.parameters.find(parameter);
        return found != other.parameters.end() &&
               found->second == network_.processes[process_].parameters.at(parameter);
    }

    /// Warns about parameters that have no effect on a problem with an objective. If several processes have the same
    /// setting, only the check of the first process warns.
    void say_ignored(std::initializer_list<const char*> parameters) {
        std::vector<std::string> ignored;
        for (const char* parameter : parameters)
            if (given(parameter) && !is_as_before(parameter))
                ignored.emplace_back(parameter);
        if (!ignored.empty())
            warn(ignored.front(),
                 fmt::format("the problem \"{}\" has no record of measurements, so these settings have no effect: {}",
                             text("problem"), fmt::join(ignored, ", ")),
                 "\"generations\" of ga.host sets the length of the search");
    }

    /// Checks that each estimate comes from a search that gets its samples from this host. To measure response times,
    /// the host must know when the search has taken each sample.
    void check_estimates() {
        for (const Peer& search : peers_at(network_, process_, "from_masters")) {
            auto host = search.process == nowhere ? std::nullopt : other_end(network_, search.process, "from_host");
            if (!host || host->process != process_)
                refuse(
                    search.port,
                    fmt::format(
                        "\"{}.{}\" receives estimates from a process that does not get its samples from this host",
                        name(process_), search.port),
                    fmt::format("connect {}.to_masters[...] to the from_host of the process that sends the estimates",
                                name(process_)));
        }
    }

    void refuse_generations() {
        if (given("generations"))
            refuse("generations",
                   fmt::format("generations applies only to problems without a record: \"{}\" has a record of {}",
                               text("problem"), counted(recorded_->samples(), "sample")),
                   "\"samples\" sets how many samples are sent; \"trials\" of a master sets the number of generations "
                   "for each sample");
    }

    /// Checks that a crossover or a mutation fits the strings of the problem.
    void check_operator(const char* parameter, void (*set)(SearchSettings&, const std::string&)) {
        if (!coded_problem_ || text(parameter) == search_description::usual)
            return;
        SearchSettings settings = usual_settings(*coded_problem_);
        set(settings, text(parameter));
        try {
            require_fitting_operators(coded_problem_->representation(), settings);
        } catch (const UserError& unfit) {
            refuse(parameter, unfit.what());
        }
    }

    void check_operators() {
        check_operator("crossover_operator", [](SearchSettings& settings, const std::string& name) {
            settings.crossover = Crossover::named(name);
        });
        check_operator("mutation_operator", [](SearchSettings& settings, const std::string& name) {
            settings.mutation = Mutation::named(name);
        });
    }

    void check_objective() {
        if (const std::size_t count = recorded_->problem()->objective_names().size(); count > 0)
            refuse(
                "problem",
                fmt::format("\"{}\" has {} objectives, but a process can search with only one", text("problem"), count),
                fmt::format("{} front {} finds the front; in Python, search_front() finds it", program_name(),
                            shell_word(text("problem"))));
        say_ignored({"window", "first_window", "trials", "bias", "measurement_bytes", "cycles_per_measurement_word",
                     "measurements"});
        if (text("reproduction") != search_description::usual)
            try {
                require_fitting_reproduction(*recorded_->problem(), Reproduction::named(text("reproduction")));
            } catch (const UserError& unfit) {
                refuse("reproduction", unfit.what());
            }
    }

    void check_window() {
        if (recorded_)
            warn_of_advice();
        if (recorded_ && integer("window") > record_length())
            refuse("window", fmt::format("the window holds {} samples, but the record of \"{}\" has only {}",
                                         integer("window"), text("problem"), record_length()));
        bool stated = network_.processes[process_].given.contains("first_window");
        if (stated && integer("first_window") > integer("window"))
            refuse("first_window", fmt::format("the first generation waits for {} samples, but the window holds {}",
                                               integer("first_window"), integer("window")));
        if (recorded_ && recorded_->problem()->depends_on_window() && given("split") && text("split") == "evaluations")
            refuse("split",
                   fmt::format("single evaluations of \"{}\" cannot be dealt out: its error at a sample depends on the "
                               "earlier samples in the window",
                               text("problem")),
                   "split = \"individuals\" deals out whole individuals");
    }

    void check_host(std::size_t host) {
        check_problem(host, process_);
        auto sent = integer_of(host, "samples"); // 0: all samples
        auto first = static_cast<std::int64_t>(samples_needed(network_.processes[process_]));
        if (recorded_ && !has_objective() && sent > 0 && sent < first)
            refuse(
                "first_window",
                fmt::format("the first generation waits for {} samples, but \"{}\" sends {}", first, name(host), sent),
                fmt::format("set \"samples\" of \"{}\" to {} or more", name(host), first));
    }

    /// Checks that each message contains all values of its sample, because a program in transputer code receives the
    /// bytes of a sample.
    void check_samples_for_code() {
        for (const PortBinding& each : ends_of(network_, process_, "to_masters")) {
            const std::size_t node = end_beyond(network_, each).node;
            if (node == nowhere || !network_.nodes[node].runs_own_code)
                continue;
            const auto bytes = static_cast<std::int64_t>(recorded_->problem()->channels() * sizeof(double));
            if (has_objective())
                refuse("problem", fmt::format("\"{}\" has no record, but the program of \"{}\" waits for samples",
                                              text("problem"), network_.nodes[node].name));
            else if (integer("sample_bytes") != bytes)
                refuse("sample_bytes",
                       fmt::format("sample_bytes = {}, but the program of \"{}\" must receive all values of a sample",
                                   integer("sample_bytes"), network_.nodes[node].name),
                       fmt::format("set sample_bytes to {}, the length of all values as REAL64", bytes));
            return;
        }
    }

    void check_coding() {
        if (!recorded_)
            return;
        try {
            coded_problem_ = recorded_->problem()->coded(Coding::named(text("coding")));
        } catch (const UserError& refused) {
            refuse("coding", refused.what());
        }
    }

    void check_problem(std::size_t process, std::size_t other) {
        const RecordedProblem* problem = named_problem(problems_, network_.processes[process]);
        if (problem && problem != named_problem(problems_, network_.processes[other]))
            refuse_of(process, "problem",
                      fmt::format("\"{}\" works on the problem \"{}\", but \"{}\" works on \"{}\"", name(process),
                                  text_of(process, "problem"), name(other), text_of(other, "problem")));
    }

    void check_that_each_slave_has_work(std::int64_t population, std::int64_t slaves) {
        const bool master_works = number("own_share") > 0 || text("split") == "demand";
        if (slaves + (master_works ? 1 : 0) > population)
            refuse("slaves",
                   fmt::format("slaves = {}, but a population of {} has work for at most {}{}", slaves, population,
                               counted(static_cast<std::size_t>(population - (master_works ? 1 : 0)), "slave"),
                               master_works ? ", because the master also evaluates" : ""));
    }

    void check_slaves() {
        std::int64_t population = integer("population"), slaves = integer("slaves");
        SlaveTree tree = follow_slaves(network_, process_);
        complaints_.insert(complaints_.end(), tree.complaints.begin(), tree.complaints.end());
        if (tree.complaints.empty() && tree.others == 0 && std::cmp_not_equal(tree.slaves.size(), slaves))
            refuse("slaves", fmt::format("slaves = {}, but the number of slaves connected to \"{}.to_slaves\" is {}",
                                         slaves, name(process_), tree.slaves.size()));
        else
            check_that_each_slave_has_work(population, slaves);
        std::size_t individuals =
            most_individuals(static_cast<std::size_t>(population), static_cast<std::size_t>(slaves),
                             split_named(text("split")), number("own_share"));
        if (coded_problem_)
            check_message(process_, individuals, "string_bytes", string_bytes(integer("string_bytes"), *coded_problem_),
                          integer("measurement_bytes"));
        if (integer("tasks_under_way") > 1 && text("split") != "demand")
            refuse("tasks_under_way",
                   fmt::format("tasks_under_way = {}, but with the split \"{}\" each slave is sent one task",
                               integer("tasks_under_way"), text("split")),
                   "split = \"demand\" sends several tasks to each slave");
        if (given("own_share") && text("split") == "demand")
            refuse("own_share",
                   "own_share has no effect with the split \"demand\": the master evaluates whenever it is idle",
                   "own_share is for the splits \"individuals\" and \"evaluations\"");
        for (std::size_t slave : tree.slaves) {
            check_problem(slave, process_);
            check_message(slave, individuals, "fitness_bytes", integer_of(slave, "fitness_bytes"), 0);
        }
    }

    void check_message(std::size_t process, std::size_t individuals, const char* parameter, std::int64_t bytes_each,
                       std::int64_t others) {
        try {
            message_bytes(individuals, static_cast<std::uint32_t>(bytes_each), static_cast<std::uint32_t>(others));
        } catch (const UserError& too_long) {
            refuse_of(process, parameter, too_long.what());
        }
    }

    const Network& network_;
    std::size_t process_;
    const ProblemRegistry& problems_;
    const RecordedProblem* recorded_ = nullptr;
    std::shared_ptr<const SearchProblem> coded_problem_; ///< the problem in this process's coding; null if the problem
                                                         ///< does not exist or cannot have this coding
    std::vector<Complaint> complaints_;
};

} // namespace

std::vector<Complaint> check_host(const Network& network, std::size_t process, const ProblemRegistry& problems) {
    Check check(network, process, problems);
    check.host();
    return check.take();
}

std::vector<Complaint> check_slave(const Network& network, std::size_t process, const ProblemRegistry& problems) {
    Check check(network, process, problems);
    check.slave();
    return check.take();
}

std::vector<Complaint> check_search(const Network& network, std::size_t process, const ProblemRegistry& problems) {
    Check check(network, process, problems);
    check.search();
    return check.take();
}

const RecordedProblem* named_problem(const ProblemRegistry& problems, const ProcessInstance& process) {
    try {
        return &problems.find(std::get<std::string>(process.parameters.at("problem")));
    } catch (const UserError&) {
        return nullptr;
    }
}

} // namespace placedpar
