// This module is loaded if mpirun has started the program (see explore/study/ranks.hpp).

#include "explore/study/ranks.hpp"

#include <boost/mpi/communicator.hpp>
#include <boost/mpi/environment.hpp>

#include <utility>

namespace placedpar {

namespace {

namespace mpi = boost::mpi;

class MpiRanks final : public Ranks {
public:
    int own() const override { return world_.rank(); }
    int count() const override { return world_.size(); }

    void send(int to, const std::string& text) override {
        world_.send(to, tag, text.data(), static_cast<int>(text.size()));
    }

    std::optional<Message> receive() override {
        std::optional<mpi::status> waiting = probe();
        if (!waiting)
            return std::nullopt;
        Message message{waiting->source(), std::string(static_cast<std::size_t>(*waiting->count<char>()), ' ')};
        world_.recv(message.from, tag, message.text.data(), static_cast<int>(message.text.size()));
        return message;
    }

private:
    static constexpr int tag = 0;

    std::optional<mpi::status> probe() {
        auto found = world_.iprobe(mpi::any_source, tag);
        return found ? std::optional(*found) : std::nullopt;
    }

    /// An exception of one rank is reported to the other ranks by messages and does not end these ranks.
    mpi::environment environment_{mpi::threading::funneled, false};
    mpi::communicator world_;
};

} // namespace

} // namespace placedpar

extern "C" placedpar::Ranks* placedpar_mpi_ranks() { return new placedpar::MpiRanks; }
