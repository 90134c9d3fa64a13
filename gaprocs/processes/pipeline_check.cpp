#include "gaprocs/processes/pipeline_check.hpp"

#include "gaprocs/processes/peers.hpp"
#include "gaprocs/processes/slave_tree.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <variant>

namespace placedpar {

namespace {

class PipelineCheck {
public:
    PipelineCheck(const Network& network, std::size_t process) : n_(network), process_(process) {}

    std::vector<Complaint> run() {
        complaints_ = follow_slaves(n_, process_).complaints;
        auto tasks = peers_at(n_, process_, "from_masters"), results = peers_at(n_, process_, "to_masters");
        for (std::size_t i = 0; i < tasks.size(); ++i)
            if (tasks[i].process != nowhere && is_master(tasks[i]))
                check_master(tasks[i], i < results.size() ? &results[i] : nullptr);
        return std::move(complaints_);
    }

private:
    const std::string& name(std::size_t process) const { return n_.processes[process].name; }
    const std::string& text(std::size_t process, const char* parameter) const {
        return std::get<std::string>(n_.processes[process].parameters.at(parameter));
    }
    void refuse(std::string about, std::string message, std::string hint) {
        complaints_.push_back({process_, std::move(about), std::move(message), std::move(hint)});
    }

    bool is_master(const Peer& peer) {
        if (n_.processes[peer.process].parameters.contains("slaves"))
            return true;
        refuse(peer.port,
               fmt::format("\"{}.{}\" receives tasks from \"{}\", which is not a master", name(process_), peer.port,
                           name(peer.process)),
               "tasks come from a ga.master or a ga.island");
        return false;
    }

    void check_master(const Peer& tasks, const Peer* results) {
        std::size_t master = tasks.process;
        if (!results || results->process != master)
            refuse(results ? results->port : tasks.port,
                   fmt::format("\"{}.{}\" receives tasks from \"{}\", but does not return the results to it",
                               name(process_), tasks.port, name(master)),
                   fmt::format("connect a master to from_masters[...] and to_masters[...] with the same subscript"));
        if (ends_of(n_, master, "to_slaves").size() > 1)
            refuse(tasks.port, fmt::format("\"{}\" has other slaves besides the slaves that it shares", name(master)),
                   "a master's to_slaves leads to one ga.pipeline and nothing else");
        if (text(master, "split") == "demand")
            refuse(tasks.port,
                   fmt::format("\"{}\" deals out individuals on demand (split = \"demand\"), but masters that share "
                               "slaves must deal out a whole population at once",
                               name(master)),
                   "split = \"individuals\" or \"evaluations\"");
    }

    const Network& n_;
    std::size_t process_;
    std::vector<Complaint> complaints_;
};

} // namespace

std::vector<Complaint> check_pipeline(const Network& network, std::size_t process) {
    return PipelineCheck(network, process).run();
}

} // namespace placedpar
