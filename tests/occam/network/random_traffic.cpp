#include "tests/occam/network/random_traffic.hpp"

#include <fmt/format.h>

#include <array>
#include <random>
#include <set>
#include <vector>

namespace placedpar::test {

namespace {

enum class Form { integer, byte, array, counted_bytes, counted_words, pair, variant, wide };

struct TrafficChannel {
    std::size_t from, to;
    Form form;
};

struct TrafficMessage {
    std::size_t channel;
    std::uint32_t more; ///< what is added to the value
    int tag, count;     ///< of a variant; of an array
};

class TrafficMaker {
public:
    explicit TrafficMaker(std::uint64_t seed) : random_(seed) {}

    RandomTraffic make() {
        processes_ = draw(2, 8);
        sums_.assign(processes_, 1);
        bodies_.assign(processes_, "");
        for (std::size_t i = draw(1, 3 * processes_); i-- > 0;)
            add_channel();
        for (std::size_t i = draw(5, 60); i-- > 0;)
            add_message({draw(0, channels_.size() - 1), static_cast<std::uint32_t>(random_()),
                         static_cast<int>(draw(0, 2)), static_cast<int>(draw(0, 5))});
        RandomTraffic result;
        for (const std::uint32_t each : sums_)
            result.printed += fmt::format("{} ", static_cast<std::int32_t>(each));
        result.files["p.occ"] = program();
        result.files["one.cfs"] = software();
        result.files["many.cfs"] = machine();
        return result;
    }

private:
    std::size_t draw(std::size_t least, std::size_t most) {
        return std::uniform_int_distribution<std::size_t>(least, most)(random_);
    }

    void add_channel() {
        const std::size_t from = draw(0, processes_ - 1), to = (from + draw(1, processes_ - 1)) % processes_;
        channels_.push_back({from, to, static_cast<Form>(draw(0, 7))});
    }

    void say(std::size_t process, const std::string& text) { bodies_[process] += text; }

    /// Adds the statements of both ends, and computes what they do.
    void add_message(const TrafficMessage& message) {
        const TrafficChannel& channel = channels_[message.channel];
        const std::uint32_t value = sums_[channel.from] * 31 + message.more;
        say(channel.from, fmt::format("    v := (sum TIMES 31) PLUS #{:08X}\n", message.more));
        const std::string c = fmt::format("c.{}", message.channel);
        Form form = channel.form;
        std::string tag;
        if (form == Form::variant) {
            constexpr std::array forms = {Form::integer, Form::variant, Form::counted_bytes};
            constexpr std::array tags = {"number; ", "nothing", "text; "};
            form = forms[static_cast<std::size_t>(message.tag)];
            tag = tags[static_cast<std::size_t>(message.tag)];
        }
        add_ends(channel, c, tag, form, message.count, value);
    }

    void add_ends(const TrafficChannel& channel, const std::string& c, const std::string& tag, Form form, int count,
                  std::uint32_t v) {
        const std::size_t from = channel.from, to = channel.to;
        const std::string input = fmt::format("    {} ? {}{}", c, channel.form == Form::variant ? "CASE " : "", tag);
        const std::string output = fmt::format("    {} ! {}", c, tag);
        const auto take = [&](const std::string& items, const std::string& absorbed) {
            say(to, input + items + "\n" + absorbed);
        };
        const std::string of_bytes = "    SEQ i = 0 FOR n\n      take (sum, INT bytes[i])\n";
        const std::string of_words = "    SEQ i = 0 FOR n\n      take (sum, words[i])\n";
        const auto absorb_all = [&](std::uint32_t mask) {
            for (int i = 0; i < count; ++i)
                absorb(to, (v + static_cast<std::uint32_t>(i)) & mask);
        };
        switch (form) {
        case Form::integer:
            say(from, output + "v\n");
            take("x", "    take (sum, x)\n");
            return absorb(to, v);
        case Form::byte:
            say(from, output + "BYTE (v /\\ 255)\n");
            take("y", "    take (sum, INT y)\n");
            return absorb(to, v & 255);
        case Form::array:
            say(from, "    fill (v)\n" + output + "words\n");
            take("words", "    n := 5\n" + of_words);
            count = 5;
            return absorb_all(~0U);
        case Form::counted_bytes:
            say(from, fmt::format("    fill (v)\n{}{}::bytes\n", output, count));
            take("n::bytes", of_bytes);
            return absorb_all(255);
        case Form::counted_words:
            say(from, fmt::format("    fill (v)\n{}{}(BYTE)::words\n", output, count));
            take("y::words", "    n := INT y\n" + of_words);
            return absorb_all(~0U);
        case Form::pair:
            say(from, output + "v; BYTE (v /\\ 255)\n");
            take("x; y", "    take (sum, x)\n    take (sum, INT y)\n");
            absorb(to, v);
            return absorb(to, v & 255);
        case Form::variant:
            say(from, output + "\n");
            take("", "    take (sum, 7)\n");
            return absorb(to, 7);
        case Form::wide:
            say(from, output + "INT64 v\n");
            take("wide", "    take (sum, INT wide)\n");
            return absorb(to, v);
        }
    }

    void absorb(std::size_t process, std::uint32_t value) { sums_[process] = sums_[process] * 33 + value; }

    static const char* protocol(Form form) {
        constexpr std::array names = {"INT",         "BYTE",      "[5]INT", "INT::[]BYTE",
                                      "BYTE::[]INT", "INT; BYTE", "MIXED",  "INT64"};
        return names[static_cast<std::size_t>(form)];
    }

    std::string program() const {
        std::string text = "#INCLUDE \"hostio.inc\"\n#USE \"hostio.lib\"\nPROTOCOL MIXED\n  CASE\n    number; INT\n"
                           "    nothing\n    text; INT::[]BYTE\n:\nPROTOCOL PAIR IS INT; BYTE:\n";
        for (std::size_t i = 0; i < processes_; ++i)
            text += procedure(i);
        return text;
    }

    /// All other processes send their sums to process 0, which prints them.
    std::string procedure(std::size_t process) const {
        std::string parameters = process == 0 ? "CHAN OF SP fs, ts" : "CHAN OF INT end";
        for (std::size_t i = 0; i < channels_.size(); ++i)
            if (channels_[i].from == process || channels_[i].to == process) {
                const std::string name = channels_[i].form == Form::pair ? "PAIR" : protocol(channels_[i].form);
                parameters += fmt::format(", CHAN OF {} c.{}{}", name, i, channels_[i].from == process ? "!" : "?");
            }
        for (std::size_t i = 1; process == 0 && i < processes_; ++i)
            parameters += fmt::format(", CHAN OF INT end.{}", i);
        std::string text = fmt::format("PROC p.{} ({})\n", process, parameters);
        text += "  PROC take (INT sum, VAL INT x)\n    sum := (sum TIMES 33) PLUS x\n  :\n"
                "  INT sum, v, x, n:\n  INT64 wide:\n  BYTE y:\n  [5]INT words:\n  [5]BYTE bytes:\n"
                "  PROC fill (VAL INT v)\n    SEQ i = 0 FOR 5\n      SEQ\n        words[i] := v PLUS i\n"
                "        bytes[i] := BYTE ((v PLUS i) /\\ 255)\n  :\n  SEQ\n    sum := 1\n" +
                bodies_[process];
        if (process != 0)
            return text + "    end ! sum\n:\n";
        const std::string print = "    so.write.int (fs, ts, sum, 0)\n    so.write.char (fs, ts, ' ')\n";
        text += print;
        for (std::size_t i = 1; i < processes_; ++i)
            text += fmt::format("    end.{} ? sum\n", i) + print;
        return text + "    so.exit (fs, ts, sps.success)\n:\n";
    }

    std::string software() const {
        std::string text = fmt::format("process p[{}];\n", processes_);
        for (std::size_t i = 0; i < processes_; ++i)
            text += fmt::format("use \"p.occ#p.{0}\" for p[{0}];\n", i);
        for (std::size_t i = 0; i < channels_.size(); ++i)
            text += fmt::format("connect p[{}].c_{} to p[{}].c_{};\n", channels_[i].from, i, channels_[i].to, i);
        for (std::size_t i = 1; i < processes_; ++i)
            text += fmt::format("connect p[{0}].end to p[0].end_{0};\n", i);
        return text;
    }

    /// A tree of transputers with some wires more. The host takes a link of the first one.
    std::string machine() {
        constexpr std::array types = {"T414", "T425", "T800", "T805"};
        const std::size_t nodes = draw(2, 7);
        std::vector<int> links(nodes, 0);
        std::string text, wires = "connect n_0.link[0] to host;\n";
        links[0] = 1;
        for (std::size_t i = 0; i < nodes; ++i)
            text += fmt::format("{} (memory = 256K) n_{};\n", types[draw(0, 3)], i);
        const auto connect = [&](std::size_t a, std::size_t b) {
            if (a == b || links[a] == 4 || links[b] == 4)
                return false;
            wires += fmt::format("connect n_{}.link[{}] to n_{}.link[{}];\n", a, links[a], b, links[b]);
            ++links[a];
            ++links[b];
            return true;
        };
        for (std::size_t i = 1; i < nodes; ++i)
            while (!connect(draw(0, i - 1), i)) {
            }
        for (std::size_t i = draw(0, 4); i-- > 0;)
            connect(draw(0, nodes - 1), draw(0, nodes - 1));
        text += wires + software();
        for (std::size_t i = 0; i < processes_; ++i)
            if (draw(0, 3) == 0)
                text += fmt::format("p[{}] (priority = HIGH);\n", i);
        for (std::size_t i = 0; i < processes_; ++i)
            text += fmt::format("place p[{}] on n_{};\n", i, i == 0 ? 0 : draw(0, nodes - 1));
        return text;
    }

    std::mt19937_64 random_;
    std::size_t processes_ = 0;
    std::vector<TrafficChannel> channels_;
    std::vector<std::uint32_t> sums_;
    std::vector<std::string> bodies_;
};

} // namespace

RandomTraffic random_traffic(std::uint64_t seed) { return TrafficMaker(seed).make(); }

} // namespace placedpar::test
