#include "gaprocs/processes/pair_checks.hpp"

#include "gaprocs/processes/kind_checks.hpp"
#include "gaprocs/processes/parameters.hpp"
#include "gaprocs/processes/peers.hpp"
#include "gaprocs/recoded_problem.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>
#include <variant>

namespace placedpar {

namespace {

class PairCheck {
public:
    PairCheck(const Network& network, std::size_t process, const ProblemRegistry& problems)
        : network_(network), process_(process), problems_(problems) {}

    std::vector<Complaint> run() {
        check_recoding();
        if (self().kind == "ga.fine")
            check_coarse();
        return std::move(complaints_);
    }

private:
    const ProcessInstance& self() const { return network_.processes[process_]; }
    const std::string& text(const char* parameter) const {
        return std::get<std::string>(self().parameters.at(parameter));
    }
    void refuse(std::string about, std::string message, std::string hint = "") {
        complaints_.push_back({process_, std::move(about), std::move(message), std::move(hint)});
    }

    void check_recoding() {
        const RecordedProblem* recorded = named_problem(problems_, self());
        if (!recorded)
            return;
        if (text("coding").starts_with("real"))
            return refuse("coding", "the searches of a pair breed fields of bits, but real numbers have no such fields",
                          "coding = \"natural\" or \"gray\"");
        try {
            RecodedProblem(*recorded->problem(), read_recoding(self()));
        } catch (const UserError& not_the_problems) {
            refuse("fields", not_the_problems.what());
        } catch (const std::invalid_argument& not_bred) {
            refuse("bits", not_bred.what());
        }
    }

    void check_coarse() {
        auto end = other_end(network_, process_, "from_coarse");
        if (end->at_edge() || network_.processes[end->process].kind != "ga.coarse")
            return refuse("from_coarse",
                          fmt::format("\"{}.from_coarse\" is not connected to a ga.coarse", self().name));
        const ProcessInstance& coarse = network_.processes[end->process];
        for (const char* parameter : {"problem", "fields", "coding", "window", "first_window", "trials", "bias"})
            check_equal(parameter, coarse);
        if (other_end(network_, process_, "from_host")->process !=
            other_end(network_, end->process, "from_host")->process)
            refuse("from_host", fmt::format("\"{}\" does not get its samples from the same process as \"{}\"",
                                            self().name, coarse.name));
    }

    void check_equal(const char* parameter, const ProcessInstance& coarse) {
        const Value &ours = self().parameters.at(parameter), &theirs = coarse.parameters.at(parameter);
        auto text = [](const Value& value) {
            return std::visit([](const auto& each) { return fmt::format("{}", each); }, value);
        };
        if (ours != theirs)
            refuse(parameter,
                   fmt::format("{} is {} for \"{}\", but {} for \"{}\"", parameter, text(ours), self().name,
                               text(theirs), coarse.name),
                   "a coarse search and its fine search must have the same problem, fields, coding, window, "
                   "first_window, trials and bias");
    }

    const Network& network_;
    std::size_t process_;
    const ProblemRegistry& problems_;
    std::vector<Complaint> complaints_;
};

} // namespace

std::vector<Complaint> check_pair(const Network& network, std::size_t process, const ProblemRegistry& problems) {
    return PairCheck(network, process, problems).run();
}

} // namespace placedpar
