#include "bus_model.hpp"

#include <fmt/format.h>

#include <optional>

namespace placedpar::test {

namespace {

class BusModel {
public:
    explicit BusModel(const BusWorld& world) : w_(world), masters_(world.masters.size()), ends_(masters_.size()) {
        for (std::size_t m = 0; m < masters_.size(); ++m)
            masters_[m].asks_at = w_.masters[m].blocks.front().pause;
    }

    std::vector<std::vector<int>> run() {
        for (now_ = 0; now_ < 10'000; ++now_) {
            end_word();
            decide();
            for (std::size_t m = 0; m < masters_.size(); ++m)
                if (masters_[m].asks_at == now_)
                    ask(m);
        }
        return ends_;
    }

private:
    struct State {
        int asks_at = -1;
        bool asking = false;
        std::size_t block = 0;
        int words_done = 0;
    };

    const BusWorld::Block& block(std::size_t m) const { return w_.masters[m].blocks[masters_[m].block]; }

    void ask(std::size_t m) {
        masters_[m].asks_at = -1;
        if (holder_ == m)
            return begin_word(); // the master has kept the bus
        masters_[m].asking = true;
        if (holder_ && word_ends_ < 0)
            holder_.reset(); // the master that kept the bus does not use it
        if (!holder_ && decides_at_ < 0)
            decides_at_ = now_ + w_.arbitration;
    }

    void begin_word() { word_ends_ = now_ + w_.word; }

    void end_word() {
        if (word_ends_ != now_)
            return;
        word_ends_ = -1;
        std::size_t m = *holder_;
        bool whole = ++masters_[m].words_done == block(m).words;
        bool release = others_win(m) || (whole && !w_.masters[m].on_request);
        if (whole)
            finish(m);
        else if (!release)
            begin_word();
        else
            masters_[m].asking = true;
        if (release)
            let_go();
        if (whole && masters_[m].asks_at == now_)
            ask(m);
    }

    void finish(std::size_t m) {
        ends_[m].push_back(now_);
        masters_[m].words_done = 0;
        if (++masters_[m].block < w_.masters[m].blocks.size())
            masters_[m].asks_at = now_ + block(m).pause;
    }

    void let_go() {
        holder_.reset();
        for (const State& each : masters_)
            if (each.asking && decides_at_ < 0)
                decides_at_ = now_ + w_.arbitration;
    }

    bool others_win(std::size_t m) const {
        for (std::size_t other = 0; other < masters_.size(); ++other)
            if (other != m && masters_[other].asking &&
                (w_.masters[m].on_request ||
                 (w_.rule == BusWorld::Rule::priority && w_.masters[other].level > w_.masters[m].level)))
                return true;
        return false;
    }

    /// Decides between the masters: checks the levels in order, and the slots within each level.
    void decide() {
        if (decides_at_ != now_)
            return;
        decides_at_ = -1;
        int first = w_.rule == BusWorld::Rule::round_robin ? (last_level_ + 3) % 4 : 3;
        for (int i = 0; i < 4; ++i)
            for (int slot = 1; slot <= 21; ++slot)
                for (std::size_t m = 0; m < masters_.size(); ++m)
                    if (masters_[m].asking && w_.masters[m].level == (first - i + 4) % 4 &&
                        w_.masters[m].slot == slot) {
                        holder_ = m;
                        last_level_ = w_.masters[m].level;
                        masters_[m].asking = false;
                        return begin_word();
                    }
    }

    const BusWorld& w_;
    std::vector<State> masters_;
    std::vector<std::vector<int>> ends_;
    std::optional<std::size_t> holder_;
    int now_ = 0, word_ends_ = -1, decides_at_ = -1, last_level_ = 0;
};

} // namespace

std::string BusWorld::text() const {
    std::string text = fmt::format("rule {} word {} arbitration {}", static_cast<int>(rule), word, arbitration);
    for (const Master& master : masters) {
        text += fmt::format(" | BR{} slot {} {}", master.level, master.slot, master.on_request ? "ROR" : "RWD");
        for (const Block& block : master.blocks)
            text += fmt::format(" +{}:{}", block.pause, block.words);
    }
    return text;
}

std::vector<std::vector<int>> ends_of_blocks(const BusWorld& world) { return BusModel(world).run(); }

} // namespace placedpar::test
