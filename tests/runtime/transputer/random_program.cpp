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

namespace {

using Word = std::uint32_t;

constexpr Word base = 0x80000000, workspace_bytes = 256, data_bytes = 512;
constexpr int most_processes = 5;

// Operations whose results are defined for all operands.
constexpr std::string_view everywhere[] = {
    "rev",  "bsub", "wsub",  "bcnt",  "wcnt",  "add",   "sub",  "sum",     "diff",  "mul",        "prod", "gt",
    "and",  "or",   "xor",   "not",   "shl",   "shr",   "ladd", "lsub",    "lsum",  "ldiff",      "lmul", "lshl",
    "lshr", "norm", "xdble", "csub0", "csngl", "ccnt1", "mint", "testerr", "ldpri", "testhalterr"};
constexpr std::string_view newer_only[] = {"crcword", "crcbyte", "bitcnt", "bitrevword"};
constexpr std::string_view t8_only[] = {"dup", "wsubdb"};
constexpr std::string_view real_operations[] = {"fpadd", "fpsub", "fpmul", "fpdiv"};
constexpr std::string_view real_entries[] = {"fpuabs",    "fpuexpinc32", "fpuexpdec32",
                                             "fpumulby2", "fpudivby2",   "fpusqrtfirst"};
constexpr std::string_view roundings[] = {"fpurn", "fpurz", "fpurp", "fpurm"};

/// Writes a program, piece by piece.
class CodeWriter {
public:
    CodeWriter(std::uint64_t seed, const RandomCodeKind& kind)
        : random_(seed, "random code"), kind_(kind), edges_(edges()),
          code_at_(base + (kind.data_first ? 0x2000 : 0x80)), data_at_(base + (kind.data_first ? 0x80 : 0x8000)) {}

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

    // Text.
    template <class... Values>
    void line(fmt::format_string<Values...> format, Values&&... values) {
        text_ += "    " + fmt::format(format, std::forward<Values>(values)...) + '\n';
    }
    void label(std::string_view name) { text_ += fmt::format("{}:\n", name); }
    std::string new_label() { return fmt::format("l{}", ++labels_); }
    /// Writes `ldc` with a number as the assembler reads it.
    void constant(Word value) { line("ldc #{:X}", value); }

    Word workspace(int process) const { return data_at_ + static_cast<Word>(process) * workspace_bytes + 160; }
    Word data(int process) const {
        return data_at_ + (most_processes + 2) * workspace_bytes + static_cast<Word>(process) * data_bytes;
    }
    /// Returns an address in the first or second half of the process's data; `size` bytes there are free to use.
    Word place(int half, int size) { return data(process_) + static_cast<Word>(half * 256 + below(257 - size)); }

    // The registers: `defined_` of them have a value that the reference defines.
    void load() {
        if (one_in(3))
            line("ldl {}", 1 + below(8));
        else if (one_in(8))
            line("ldlp {}", below(30) - 10);
        else
            constant(constant());
        defined_ = std::min(defined_ + 1, 3);
    }
    void load_all() {
        while (defined_ < 3 || one_in(2))
            load();
    }
    void store_some() {
        for (int i = below(4); i > 0 && defined_ > 0; --i, --defined_)
            line("stl {}", 1 + below(8));
    }

    // Pieces.
    void operate() {
        load_all();
        for (int i = below(4); i >= 0; --i) {
            if (one_in(5))
                line("{} {}", any(std::array{"adc", "eqc", "ldnlp"}), static_cast<std::int32_t>(constant()));
            else if (kind_.model != t414 && one_in(8))
                line("{}", any(newer_only));
            else if (kind_.model & (t800 | t805) && one_in(8))
                line("{}", any(t8_only));
            else
                line("{}", any(everywhere));
        }
        store_some();
    }

    /// Writes an operation whose operands are restricted.
    void operate_within_limits() {
        const Word value = constant(), other = std::max(constant() & 0x7FFFFFFF, Word{2});
        constant(constant());
        switch (below(kind_.model == t414 ? 4 : 5)) {
        case 0:
            constant(value);
            constant(other);
            line("{}", any(std::array{"div", "rem", "fmul"}));
            break;
        case 1:
            constant(value % other);
            constant(constant());
            constant(other);
            line("ldiv");
            break;
        case 2: {
            const int bit = 1 + below(29);
            constant(value & ((2U << bit) - 1));
            constant(1U << bit);
            line("xword");
            break;
        }
        case 3:
            constant(value);
            constant(1U << (1 + below(29)));
            line("cword");
            break;
        default:
            constant(value);
            constant(static_cast<Word>(below(33)));
            line("bitrevnbits");
        }
        line("stl {}", 1 + below(8));
        defined_ = 0;
    }

    void use_memory() {
        const Word word = place(0, 8) & ~3U;
        const int distance = below(40) - 20;
        switch (below(4)) {
        case 0:
            load_all();
            constant(word - 4 * static_cast<Word>(distance));
            line("stnl {}", distance);
            break;
        case 1:
            constant(word - 4 * static_cast<Word>(distance));
            line("ldnl {}", distance);
            break;
        case 2:
            load_all();
            constant(place(0, 1));
            line("sb");
            break;
        default: constant(place(0, 1)); line("lb");
        }
        line("stl {}", 1 + below(8));
        defined_ = 0;
    }

    void move() {
        const int count = one_in(2) ? below(8) : below(100);
        constant(place(0, count));
        constant(place(1, count));
        constant(static_cast<Word>(count));
        line("move");
        defined_ = 0;
    }

    void move_block() {
        const int width = 1 + below(9), rows = below(6), stride = width + below(10), other = width + below(10);
        constant(static_cast<Word>(stride));
        constant(static_cast<Word>(other));
        constant(static_cast<Word>(rows));
        line("move2dinit");
        constant(place(0, 6 * stride));
        constant(place(1, 6 * other));
        constant(static_cast<Word>(width));
        line("{}", any(std::array{"move2dall", "move2dnonzero", "move2dzero"}));
        defined_ = 0;
    }

    void branch(int depth) {
        const auto over = new_label();
        load_all();
        line("{}", any(std::array{"gt", "eqc 0", "eqc 1", "and", "testerr"}));
        line("cj {}", over);
        defined_ = 0;
        pieces(1 + below(3), depth + 1);
        if (one_in(2)) {
            const auto end = new_label();
            line("j {}", end);
            label(over);
            defined_ = 0;
            pieces(1 + below(2), depth + 1);
            label(end);
        } else {
            label(over);
        }
        defined_ = 0;
    }

    void loop(int depth) {
        const auto start = new_label(), end = new_label();
        const int control = 9 + 2 * depth;
        constant(constant());
        line("stl {}", control);
        line("ldc {}", 1 + below(depth ? 3 : 10));
        line("stl {}", control + 1);
        label(start);
        defined_ = 0;
        pieces(1 + below(2), depth + 1);
        line("ldlp {}", control);
        line("ldc {} - {}", end, start);
        line("lend");
        label(end);
        defined_ = 0;
    }

    /// Calls a subroutine that stands just behind the jump over it.
    void call(int depth) {
        const auto routine = new_label(), over = new_label();
        load_all();
        line("call {}", routine);
        line("j {}", over);
        line(".byte {}, {}", below(256), below(256));
        label(routine);
        line("ajw -16");
        defined_ = 0;
        pieces(1 + below(2), std::max(depth + 1, 2));
        line("ajw 16");
        line("ret");
        label(over);
        defined_ = 0;
    }

    /// Changes an instruction before executing it, sometimes after it has run.
    void change_code() {
        const auto changed = new_label(), again = new_label();
        const bool twice = one_in(2);
        line("ldc {}", twice ? 2 : 1);
        line("stl 15");
        label(again);
        line("ldl 15");
        line("adc #40");
        line("ldc {}", changed);
        line("sb");
        label(changed);
        line("ldc {}", below(16));
        line("stl {}", 1 + below(8));
        line("ldl 15");
        line("adc -1");
        line("stl 15");
        line("ldl 15");
        line("eqc 0");
        line("cj {}", again);
        defined_ = 0;
    }

    void use_reals() {
        const bool is_double = one_in(2);
        const std::string_view length = is_double ? "db" : "sn";
        const auto operand = [&] {
            line("ldc reals_{} + {}", length, below(12) * (is_double ? 8 : 4));
            line("fpldnl{}", length);
        };
        operand();
        operand();
        if (one_in(3))
            line("{}", any(roundings));
        if (one_in(3)) {
            line("{}", any(std::array{"fpgt", "fpeq", "fpordered", "fpnan", "fpnotfinite", "fptesterror"}));
            line("stl {}", 1 + below(8));
        } else {
            line("{}", one_in(4) ? any(real_entries) : any(real_operations));
            for (int i = below(4); i > 0; --i)
                load();
            constant(place(1, 12) & ~3U);
            line("fpstnl{}", length);
        }
        defined_ = 0;
    }

    void use_clock() {
        line("ldtimer");
        if (one_in(2)) {
            line("stl {}", 1 + below(8));
        } else {
            line("adc {}", below(6) - 2);
            line("tin");
        }
        defined_ = 0;
    }

    void piece(int depth) {
        const int choice = below(24);
        if (choice == 0 && depth < 3)
            return branch(depth);
        if (choice == 1 && depth < 3)
            return loop(depth);
        if (choice == 2 && depth < 2)
            return call(depth);
        if (choice == 3)
            return move();
        if (choice == 4 && kind_.model != t414)
            return move_block();
        if (choice == 5 && depth == 0)
            return change_code();
        if (choice <= 7 && kind_.processes)
            return use_clock();
        if (choice <= 10 && kind_.model & (t800 | t805))
            return use_reals();
        if (choice <= 13)
            return use_memory();
        if (choice <= 16)
            return operate_within_limits();
        operate();
    }

    void pieces(int count, int depth) {
        for (int i = 0; i < count; ++i)
            piece(depth);
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
        for (const auto* text :
             {"mint", "sthf", "mint", "stlf", "mint", "ldc #80000024", "stnl 0", "mint", "ldc #80000028", "stnl 0"})
            line("{}", text);
        constant(constant());
        line("sttimer");
        line("ldc joined");
        constant(workspace(most_processes));
        line("stnl 0");
        line("ldc {}", std::count(high_.begin(), high_.end(), false));
        constant(workspace(most_processes));
        line("stnl 1");
        for (int i = 1; i < processes_; ++i) {
            if (joins(i)) {
                const auto next = new_label();
                line("ldc {} - {}", process_label(i), next);
                constant(workspace(i));
                line("startp");
                label(next);
            } else {
                line("ldc {}", process_label(i));
                constant(workspace(i));
                line("stnl -1");
                constant(workspace(i));
                line("runp");
            }
        }
    }

    void write_process() {
        label(process_label(process_));
        for (int i = 1; i <= 8; ++i) {
            constant(constant());
            line("stl {}", i);
        }
        defined_ = 0;
        pieces(kind_.elements / 2, 0);
        for (const auto& message : messages_) {
            if (message.from == process_)
                send(message);
            else if (message.to == process_)
                one_in(3) ? select(message) : receive(message);
            else
                continue;
            defined_ = 0;
            pieces(below(3), 0);
        }
        pieces(kind_.elements / 2, 0);
        if (joins(process_)) {
            constant(workspace(most_processes));
            line("endp");
        } else {
            line("stopp");
        }
    }

    void send(const Message& message) {
        const auto to = channel(message.from, message.to);
        const bool as_value = (message.bytes == 1 || message.bytes == 4) && one_in(2);
        if (!as_value)
            constant(place(0, message.bytes));
        line("ldc {}", to);
        constant(as_value ? constant() : static_cast<Word>(message.bytes));
        line("{}", !as_value ? "out" : message.bytes == 1 ? "outbyte" : "outword");
    }

    void receive(const Message& message) {
        constant(place(1, message.bytes));
        line("ldc {}", channel(message.from, message.to));
        line("ldc {}", message.bytes);
        line("in");
    }

    /// Waits for any of several channels, a time, or nothing; then receives the message that is its turn.
    void select(const Message& message) {
        struct Guard {
            std::string operand, enable, disable;
            bool holds;
        };
        std::vector<Guard> guards{{fmt::format("ldc {}", channel(message.from, message.to)), "enbc", "disc", true}};
        for (int i = 0; i < processes_; ++i)
            if (i != message.to && i != message.from && one_in(2))
                guards.push_back({fmt::format("ldc {}", channel(i, message.to)), "enbc", "disc", one_in(2)});
        const bool timed = one_in(2);
        if (timed)
            guards.push_back({"ldl 15", "enbt", "dist", one_in(2)});
        if (timed && one_in(3))
            guards.push_back({"ldl 16", "enbt", "dist", one_in(2)});
        if (one_in(5))
            guards.push_back({"", "enbs", "diss", one_in(2)});
        std::rotate(guards.begin(), guards.begin() + below(static_cast<int>(guards.size())), guards.end());
        for (const int time : {15, 16}) {
            line("ldtimer");
            line("adc {}", below(8) - 1);
            line("stl {}", time);
        }
        line("{}", timed ? "talt" : "alt");
        for (const auto& guard : guards) {
            line("{}", guard.operand);
            line("ldc {}", guard.holds ? 1 : 0);
            line("{}", guard.enable);
        }
        line("{}", timed ? "taltwt" : "altwt");
        const auto end = new_label(), join = new_label();
        std::vector<std::string> targets;
        for (const auto& guard : guards) {
            targets.push_back(new_label());
            line("{}", guard.operand);
            line("ldc {}", guard.holds ? 1 : 0);
            line("ldc {} - {}", targets.back(), end);
            line("{}", guard.disable);
            line("stl {}", 1 + below(8));
        }
        line("altend");
        label(end);
        for (std::size_t i = 0; i < targets.size(); ++i) {
            label(targets[i]);
            line("ldc {}", i);
            line("stl {}", 1 + below(8));
            line("j {}", join);
        }
        label(join);
        receive(message);
    }

    void finish() {
        label("joined");
        line("stopp");
        line(".align");
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

} // namespace

RandomCode random_code(std::uint64_t seed, const RandomCodeKind& kind) { return CodeWriter(seed, kind).run(); }

} // namespace placedpar::test
