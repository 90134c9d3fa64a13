#include "random_program.hpp"

#include "edges.hpp"
#include "runtime/random.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string_view>
#include <vector>

namespace placedpar::test {

namespace random_codes {

using Word = std::uint32_t;

constexpr Word memory_begin = 0x80000000, workspace_bytes = 256, data_bytes = 512;
constexpr int most_processes = 5;

// Operations whose results are defined for all operands.
constexpr std::string_view everywhere[] = {
    "rev",  "bsub", "wsub",  "bcnt",  "wcnt",  "add",   "sub",  "sum",     "diff",  "mul",        "prod", "gt",
    "and",  "or",   "xor",   "not",   "shl",   "shr",   "ladd", "lsub",    "lsum",  "ldiff",      "lmul", "lshl",
    "lshr", "norm", "xdble", "csub0", "csngl", "ccnt1", "mint", "testerr", "ldpri", "testhalterr"};
constexpr std::string_view newer_only[] = {"crcword", "crcbyte", "bitcnt", "bitrevword"};
constexpr std::string_view newer_for_addresses[] = {"dup", "wsubdb"};
constexpr std::string_view real_operations[] = {"fpadd", "fpsub", "fpmul", "fpdiv"};
constexpr std::string_view real_entries[] = {"fpuabs", "fpuexpinc32", "fpuexpdec32", "fpumulby2", "fpudivby2"};
constexpr std::string_view real_tests[] = {"fpgt", "fpeq", "fpordered", "fpnan", "fpnotfinite", "fptesterror"};
constexpr std::string_view roundings[] = {"fpurn", "fpurz", "fpurp", "fpurm"};

/// Writes a program, piece by piece.
class CodeWriter {
public:
    CodeWriter(std::uint64_t seed, const RandomCodeKind& kind)
        : random_(seed, "random code"), kind_(kind), edges_(edges()),
          code_at_(memory_begin + (kind.data_first ? 0x2000 : 0x80)),
          data_at_(memory_begin + (kind.data_first ? 0x80 : 0x8000)) {}

    RandomCode run() && {
        processes_ = kind_.processes ? 1 + below(most_processes) : 1;
        for (int i = 0; i < processes_; ++i)
            high_.push_back(i > 0 && one_in(3));
        start();
        plan_messages();
        for (process_ = 0; process_ < processes_; ++process_)
            write_process();
        finish();
        return {text_, code_at_, workspace(0)};
    }

private:
    // Random choices.
    int below(int n) { return static_cast<int>(random_.below(static_cast<Word>(n))); }
    bool one_in(int n) { return below(n) == 0; }
    template <class List>
    const auto& any(const List& list) {
        return list[static_cast<std::size_t>(below(static_cast<int>(std::size(list))))];
    }
    Word constant() { return one_in(3) ? random_() : any(edges_); }
    bool has_reals() const { return kind_.model & (t800 | t805); }

    // Text.
    /// Writes instructions, with semicolons between them.
    template <class... Values>
    void write(fmt::format_string<Values...> format, Values&&... values) {
        text_ += "    " + fmt::format(format, std::forward<Values>(values)...) + '\n';
    }
    void label(std::string_view name) { text_ += fmt::format("{}:\n", name); }
    std::string new_label() { return fmt::format("l{}", ++labels_); }

    Word workspace(int process) const { return data_at_ + static_cast<Word>(process) * workspace_bytes + 160; }
    Word data(int process) const {
        return data_at_ + (most_processes + 2) * workspace_bytes + static_cast<Word>(process) * data_bytes;
    }
    /// Returns an address in the first or second half of the process's data; `size` bytes there are free to use.
    Word place(int half, int size) { return data(process_) + static_cast<Word>(half * 256 + below(257 - size)); }
    Word word_place(int half) { return place(half, 12) & ~3U; }
    int variable() { return 1 + below(8); }

    // The registers: `defined_` of them have a value that the reference defines.
    void load() {
        if (one_in(3))
            write("ldl {}", variable());
        else if (one_in(8))
            write("ldlp {}", below(30) - 10);
        else
            write("ldc #{:X}", constant());
        defined_ = std::min(defined_ + 1, 3);
    }
    void load_all() {
        while (defined_ < 3 || one_in(2))
            load();
    }
    void store_some() {
        for (int i = below(4); i > 0 && defined_ > 0; --i, --defined_)
            write("stl {}", variable());
    }

    // Pieces.
    void operate() {
        load_all();
        for (int i = below(4); i >= 0; --i) {
            if (one_in(5))
                write("{} #{:X}", any(std::array{"adc", "eqc", "ldnlp"}), constant());
            else if (kind_.model != t414 && one_in(8))
                write("{}", any(newer_only));
            else if (kind_.model != t414 && one_in(8))
                write("{}", any(newer_for_addresses));
            else
                write("{}", any(everywhere));
        }
        store_some();
    }

    /// Writes an operation whose operands are restricted.
    void operate_within_limits() {
        const Word value = constant(), other = std::max(constant() & 0x7FFFFFFF, Word{2});
        const int bit = 1 + below(29);
        switch (below(kind_.model == t414 ? 4 : 5)) {
        case 0: write("ldc #{:X}; ldc #{:X}; {}", value, other, any(std::array{"div", "rem", "fmul"})); break;
        case 1: write("ldc #{:X}; ldc #{:X}; ldc #{:X}; ldiv", value % other, constant(), other); break;
        case 2: write("ldc #{:X}; ldc #{:X}; xword", value & ((2U << bit) - 1), 1U << bit); break;
        case 3: write("ldc #{:X}; ldc #{:X}; cword", value, 1U << bit); break;
        default: write("ldc #{:X}; ldc {}; bitrevnbits", value, below(33));
        }
        write("stl {}", variable());
    }

    void use_memory() {
        const int distance = below(40) - 20;
        const Word base = word_place(0) - 4 * static_cast<Word>(distance);
        load_all();
        switch (below(4)) {
        case 0: write("ldc #{:X}; stnl {}; stl {}", base, distance, variable()); break;
        case 1: write("ldc #{:X}; ldnl {}; stl {}", base, distance, variable()); break;
        case 2: write("ldc #{:X}; sb; stl {}", place(0, 1), variable()); break;
        default: write("ldc #{:X}; lb; stl {}", place(0, 1), variable());
        }
    }

    void move() {
        const int count = one_in(2) ? below(8) : below(250);
        write("ldc #{:X}; ldc #{:X}; ldc {}; move", place(0, count), place(1, count), count);
    }

    void move_block() {
        const int width = 1 + below(9), stride = width + below(10), other = width + below(10);
        write("ldc {}; ldc {}; ldc {}; move2dinit", stride, other, below(6));
        write("ldc #{:X}; ldc #{:X}; ldc {}; {}", place(0, 6 * stride), place(1, 6 * other), width,
              any(std::array{"move2dall", "move2dnonzero", "move2dzero"}));
    }

    void branch(int depth) {
        const auto over = new_label(), end = new_label();
        load_all();
        write("{}; cj {}", any(std::array{"gt", "eqc 0", "eqc 1", "and", "testerr"}), over);
        pieces(1 + below(3), depth + 1);
        const bool has_else = one_in(2);
        if (has_else)
            write("j {}", end);
        label(over);
        if (has_else)
            pieces(1 + below(2), depth + 1);
        label(end);
    }

    void loop(int depth) {
        const auto start = new_label(), end = new_label();
        const int control = 9 + 2 * depth;
        write("ldc #{:X}; stl {}; ldc {}; stl {}", constant(), control, 1 + below(depth ? 3 : 10), control + 1);
        label(start);
        pieces(1 + below(2), depth + 1);
        write("ldlp {}; ldc {} - {}; lend", control, end, start);
        label(end);
    }

    /// Calls a subroutine that stands just behind the jump over it.
    void call(int depth) {
        const auto routine = new_label(), over = new_label();
        load_all();
        write("call {}; j {}; .byte {}, {}", routine, over, below(256), below(256));
        label(routine);
        write("ajw -16");
        pieces(1 + below(2), std::max(depth + 1, 2));
        write("ajw 16; ret");
        label(over);
    }

    /// Changes an instruction before executing it, sometimes after it has run.
    void change_code() {
        const auto changed = new_label(), again = new_label();
        write("ldc {}; stl 15", 1 + below(2));
        label(again);
        write("ldl 15; adc #40; ldc {}; sb", changed);
        label(changed);
        write("ldc {}; stl {}", below(16), variable());
        write("ldl 15; adc -1; stl 15; ldl 15; eqc 0; cj {}", again);
    }

    /// Computes with reals. No operation makes a NaN: its bits are those of the machine.
    void use_reals() {
        const std::string_view length = one_in(2) ? "db" : "sn";
        load_real(length, 0);
        if (one_in(4))
            write("ldc reals_{} + {}; fpldnl{}{}", length, 8 * below(6), any(std::array{"add", "mul"}), length);
        load_real(length, 2);
        if (one_in(3))
            write("{}", any(roundings));
        if (one_in(3))
            write("{}; stl {}", any(real_tests), variable());
        else if (one_in(4))
            convert(length);
        else
            compute(length);
        if (one_in(5))
            write("fpchkerror");
    }

    void load_real(std::string_view length, int first) {
        const int number = first + below(12 - first);
        if (one_in(4))
            write("ldc {}; ldc reals_{}; fpldnl{}i", number, length, length);
        else if (one_in(6) && first == 0)
            write("fpldzero{}", length);
        else
            write("ldc reals_{} + {}; fpldnl{}", length, number * (length == "db" ? 8 : 4), length);
    }

    void compute(std::string_view length) {
        if (one_in(6))
            write("fpuabs; fpusqrtfirst; fpusqrtstep; fpusqrtstep; fpusqrtlast");
        else
            write("{}", one_in(3) ? any(real_entries) : any(real_operations));
        for (int i = below(4); i > 0; --i)
            load();
        write("ldc #{:X}; fpstnl{}", word_place(1), length);
    }

    /// Converts the real on the stack, or an integer.
    void convert(std::string_view length) {
        switch (below(5)) {
        case 0: write("{}", any(std::array{"fprev", "fpdup", "fpint", "fpuchki32", "fpuchki64"})); break;
        case 1:
            write("{}", length == "db" ? "fpur64tor32" : "fpur32tor64");
            length = length == "db" ? "sn" : "db";
            break;
        case 2:
            write("ldc #{:X}; {}", word_place(1), any(std::array{"fpi32tor64", "fpb32tor64"}));
            length = "db";
            break;
        case 3:
            write("ldc #{:X}; fpi32tor32", word_place(1));
            length = "sn";
            break;
        default: return write("fprtoi32; ldc #{:X}; fpstnli32", word_place(1));
        }
        write("ldc #{:X}; fpstnl{}", word_place(1), length);
    }

    /// Uses operations on queues and channels that change nothing for others.
    void use_queues() {
        switch (below(kind_.model & (t425 | t400 | t805) ? 6 : 4)) {
        case 0: return write("ldc #{:X}; {}", word_place(1), any(std::array{"saveh", "savel"}));
        case 1: return write("ldc {}; resetch; stl {}", channel(process_, process_), variable());
        case 2: return write("testerr; stoperr");
        case 3: return write("seterr");
        default:
            const char queue = one_in(2) ? 'h' : 'l';
            write("timerdisable{}", queue);
            operate();
            write("timerenable{}", queue);
        }
    }

    void use_clock() {
        if (one_in(3))
            write("ldtimer; stl {}", variable());
        else
            write("ldtimer; adc {}; tin", below(high_[static_cast<std::size_t>(process_)] ? 60 : 6) - 2);
    }

    void piece(int depth) {
        const bool interrupts = high_[static_cast<std::size_t>(process_)] && one_in(2);
        const int choice = interrupts ? 6 : below(24);
        if (choice > 16)
            return operate();
        if (choice == 0 && depth < 3)
            branch(depth);
        else if (choice == 1 && depth < 3)
            loop(depth);
        else if (choice == 2 && depth < 2)
            call(depth);
        else if (choice == 3 || choice == 12)
            move();
        else if (choice == 4 && kind_.model != t414)
            move_block();
        else if (choice == 5 && depth == 0)
            change_code();
        else if (choice <= 7 && kind_.processes)
            one_in(4) ? use_queues() : use_clock();
        else if (choice <= 10 && has_reals())
            use_reals();
        else if (choice <= 13)
            use_memory();
        else
            operate_within_limits();
        defined_ = 0;
    }

    /// Writes pieces. None relies on what was in registers before.
    void pieces(int count, int depth) {
        defined_ = 0;
        for (int i = 0; i < count; ++i)
            piece(depth);
        defined_ = 0;
    }

    // Processes.
    struct Message {
        int from, to, bytes;
    };

    static std::string channel(int from, int to) { return fmt::format("channel_{}_{}", from, to); }
    static std::string process_label(int process) { return fmt::format("process_{}", process); }
    bool joins(int process) const { return !high_[static_cast<std::size_t>(process)]; }

    /// Decides all messages in one order. Each process follows the order, so they cannot deadlock.
    void plan_messages() {
        for (int i = processes_ > 1 ? 4 * processes_ : 0; i > 0; --i) {
            const int from = below(processes_), to = below(processes_);
            if (from != to)
                messages_.push_back({from, to, one_in(3) ? 1 : one_in(2) ? 4 : 1 + below(60)});
        }
        for (int i = 1; i < processes_; ++i)
            if (!joins(i))
                messages_.push_back({i, 0, 4});
    }

    /// Starts the clocks and all processes; the first process goes on. The low ones join at their end.
    void start() {
        const Word joint = workspace(most_processes);
        write("mint; sthf; mint; stlf; mint; ldc #80000024; stnl 0; mint; ldc #80000028; stnl 0");
        write("ldc #{:X}; sttimer", constant());
        write("ldc joined; ldc #{:X}; stnl 0", joint);
        write("ldc {}; ldc #{:X}; stnl 1", std::count(high_.begin(), high_.end(), false), joint);
        for (int i = 1; i < processes_; ++i) {
            const Word at = workspace(i);
            if (joins(i)) {
                const auto next = new_label();
                write("ldc {} - {}; ldc #{:X}; startp", process_label(i), next, at);
                label(next);
            } else {
                write("ldc {}; ldc #{:X}; stnl -1; ldc #{:X}; runp", process_label(i), at, at);
            }
        }
    }

    void write_process() {
        label(process_label(process_));
        for (int i = 1; i <= 8; ++i)
            write("ldc #{:X}; stl {}", constant(), i);
        pieces(kind_.elements / 2, 0);
        for (const auto& message : messages_) {
            if (message.from == process_)
                send(message);
            else if (message.to == process_)
                one_in(3) ? select(message) : receive(message);
            else
                continue;
            pieces(below(3), 0);
        }
        pieces(kind_.elements / 2, 0);
        if (joins(process_))
            write("ldc #{:X}; endp", workspace(most_processes));
        else
            write("stopp");
    }

    void send(const Message& message) {
        const auto to = channel(message.from, message.to);
        if ((message.bytes == 1 || message.bytes == 4) && one_in(2))
            write("ldc {}; ldc #{:X}; {}", to, constant(), message.bytes == 1 ? "outbyte" : "outword");
        else
            write("ldc #{:X}; ldc {}; ldc {}; out", place(0, message.bytes), to, message.bytes);
    }

    void receive(const Message& message) {
        write("ldc #{:X}; ldc {}; ldc {}; in", place(1, message.bytes), channel(message.from, message.to),
              message.bytes);
    }

    /// Waits for any of several channels, a time, or nothing; then receives the message that is its turn.
    void select(const Message& message) {
        struct Guard {
            std::string operand, enable, disable;
            bool holds;
        };
        std::vector<Guard> guards{{"ldc " + channel(message.from, message.to), "enbc", "disc", true}};
        for (int i = 0; i < processes_; ++i)
            if (i != message.to && i != message.from && one_in(2))
                guards.push_back({"ldc " + channel(i, message.to), "enbc", "disc", one_in(2)});
        const bool timed = one_in(2);
        for (const char* time : {"ldl 15", "ldl 16"})
            if (timed && one_in(2))
                guards.push_back({time, "enbt", "dist", one_in(2)});
        if (one_in(5))
            guards.push_back({"", "enbs", "diss", one_in(2)});
        std::rotate(guards.begin(), guards.begin() + below(static_cast<int>(guards.size())), guards.end());
        for (const int time : {15, 16})
            write("ldtimer; adc {}; stl {}", below(8) - 1, time);
        write("{}", timed ? "talt" : "alt");
        for (const auto& guard : guards)
            write("{}; ldc {}; {}", guard.operand, guard.holds ? 1 : 0, guard.enable);
        write("{}", timed ? "taltwt" : "altwt");
        const auto end = new_label(), join = new_label();
        std::vector<std::string> targets;
        for (const auto& guard : guards) {
            targets.push_back(new_label());
            write("{}; ldc {}; ldc {} - {}; {}; stl {}", guard.operand, guard.holds ? 1 : 0, targets.back(), end,
                  guard.disable, variable());
        }
        write("altend");
        label(end);
        for (std::size_t i = 0; i < targets.size(); ++i) {
            label(targets[i]);
            write("ldc {}; stl {}; j {}", i, variable(), join);
        }
        label(join);
        receive(message);
    }

    void finish() {
        label("joined");
        write("stopp; .align");
        for (int from = 0; from < processes_; ++from)
            for (int to = 0; to < processes_; ++to)
                text_ += fmt::format("{}: .word #80000000\n", channel(from, to));
        text_ += "reals_sn: .word 0, #80000000, #3F800000, #BF800000, #40490FDB, #7F7FFFFF, #00800000, #00000001, "
                 "#3DCCCCCD, "
                 "#4B800001, #CF000000, #34000000\n";
        text_ += "reals_db: .word 0, 0, 0, #80000000, 0, #3FF00000, 0, #BFF00000, #54442D18, #400921FB, #FFFFFFFF, "
                 "#7FEFFFFF, 0, #100000, 1, 0, #9999999A, #3FB99999, 1, #43400000, 0, #C1E00000, 0, #3CB00000\n";
    }

    RandomStream random_;
    RandomCodeKind kind_;
    std::vector<Word> edges_;
    Word code_at_, data_at_;
    std::string text_;
    std::vector<bool> high_;
    std::vector<Message> messages_;
    int processes_ = 1, process_ = 0, labels_ = 0, defined_ = 0;
};

} // namespace random_codes

RandomCode random_code(std::uint64_t seed, const RandomCodeKind& kind) {
    return random_codes::CodeWriter(seed, kind).run();
}

} // namespace placedpar::test
