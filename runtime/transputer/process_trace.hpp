#pragma once

#include "runtime/event.hpp"
#include "runtime/trace.hpp"
#include "runtime/transputer/core.hpp"

#include <array>
#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {
class Kernel;
} // namespace placedpar

namespace placedpar::transputer {

/// Reports to the trace of a run what the processes of an emulated transputer do. The transputer executes ahead of
/// virtual time, so each notice is kept until its time has come. Each workspace counts as a process, but workspaces
/// with the same name count as one process.
class ProcessTrace final : public Core::ProcessWatcher, private Event {
public:
    using Naming = std::function<std::string(Word)>;
    /// `place`: the name of the transputer. `process` and `channel`: functions that return the name of a workspace and
    /// of a channel. REQUIRES: the run is traced; kernel, core and place outlive this object.
    ProcessTrace(Kernel&, const Core&, const std::string& place, Naming process, Naming channel);

private:
    struct Notice {
        Time at;
        std::string process;
        Activity activity;
        std::vector<AwaitedByProgram> awaited{};
        bool awaits_timer = false;
        std::string partner = "";
    };

    void changes(Word workspace, Core::ProcessChange, Word channel) override;
    void happen() noexcept override;
    void wait(Word workspace, Activity, const std::vector<Word>& channels, bool awaits_timer);
    void leave(const std::string& process);
    std::vector<Word> enabled_by(Word workspace);
    AwaitedByProgram awaited(Word channel, bool outputs);
    void add(Notice);

    Kernel& kernel_;
    const Core& core_;
    const std::string& place_;
    Naming name_of_process_, name_of_channel_;
    std::string running_;                              ///< the process that had the processor last
    std::map<Word, std::set<Word>> enabled_;           ///< channels of ALTs that have not begun to wait, by workspace
    std::map<Word, std::array<std::string, 2>> users_; ///< the last processes that waited to input and to output
    std::deque<Notice> notices_;
};

} // namespace placedpar::transputer
