#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <vector>

namespace placedpar {

inline constexpr std::size_t the_master = static_cast<std::size_t>(-1);

/// Gives the parent of each slave: `the_master`, or the number of an earlier slave.
using SlaveForm = std::vector<std::size_t>;

inline SlaveForm chain_of(std::size_t slaves) {
    SlaveForm form;
    for (std::size_t i = 0; i < slaves; ++i)
        form.push_back(i - 1); // the first slave's parent is the master
    return form;
}

inline SlaveForm star_of(std::size_t slaves) { return SlaveForm(slaves, the_master); }

/// Returns a tree in which the master and every slave have `branches` children.
inline SlaveForm tree_of(std::size_t slaves, std::size_t branches) {
    SlaveForm form;
    for (std::size_t i = 0; i < slaves; ++i)
        form.push_back(i < branches ? the_master : i / branches - 1);
    return form;
}

/// Returns a form with `chains` chains of slaves behind the master.
inline SlaveForm chains_of(std::size_t slaves, std::size_t chains) {
    SlaveForm form;
    for (std::size_t i = 0; i < slaves; ++i)
        form.push_back(i < chains ? the_master : i - chains);
    return form;
}

/// A netlist of a master with slaves in any form, by default for the line problem.
struct FarmOfForm {
    SlaveForm form;
    bool on_links = true; ///< true: a processor for each process, so at most three children; false: one processor for
                          ///< all
    std::string master_parameters = "rehearsals = 1";
    std::string host_parameters = "problem = \"line\"";
    std::vector<std::string> processors = {"clock = 20M"}; ///< attributes of the processors, used in turn

    std::string netlist() const {
        std::string text = fmt::format("workstation sun;\nprocess host, master, slave[{}];\nuse \"ga.host\" for host; "
                                       "use \"ga.master\" for master;\nconnect host.to_masters[0] to "
                                       "master.from_host;\nplace host on sun;\nhost ({});\n"
                                       "master (problem = \"line\", stream = \"one stream\", slaves = {}, {});\n",
                                       form.size(), host_parameters, form.size(), master_parameters);
        for (std::size_t node = 0; node <= (on_links ? form.size() : 0); ++node)
            text += fmt::format("T800 ({}) t{};\n", processors[node % processors.size()], node);
        text += "connect sun.link[0] to t0.link[0];\nplace master on t0;\n";
        std::vector<std::size_t> behind(form.size() + 1, 0); // number of children so far, of the master and of each
                                                             // slave
        for (std::size_t i = 0; i < form.size(); ++i)
            text += slave(i, behind[form[i] + 1]++);
        return text;
    }

private:
    std::string slave(std::size_t i, std::size_t channel) const {
        auto before = form[i] == the_master ? "master" : fmt::format("slave[{}]", form[i]);
        auto text = fmt::format("use \"ga.slave\" for slave[{0}]; slave[{0}] (problem = \"line\");\n"
                                "place slave[{0}] on t{1};\nconnect {2}.to_slaves[{3}] to slave[{0}].from_master;\n"
                                "connect slave[{0}].to_master to {2}.from_slaves[{3}];\n",
                                i, on_links ? i + 1 : 0, before, channel);
        if (on_links)
            text += fmt::format("connect t{}.link[{}] to t{}.link[0];\n", form[i] + 1, channel + 1, i + 1);
        return text;
    }
};

} // namespace placedpar
