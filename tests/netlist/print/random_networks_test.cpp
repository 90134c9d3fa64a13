// Tests that the printed form of random networks loads again as an equal network, and prints the same text again. A
// failure prints the number of the network; the same number makes the same network again.

#include "netlist/print/print.hpp"
#include "netlist/read.hpp"
#include "tests/netlist/numbers.hpp"
#include "tests/netlist/small_catalogue.hpp"
#include "tests/sanitized.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

/// Writes a random netlist that loads: a chain of processors, through a switch here and there, with processes that have
/// interfaces of every kind of entry in any order, and channels from each process to the next.
class RandomNetlist {
public:
    explicit RandomNetlist(std::uint64_t number) : numbers_(number) {}

    std::string text() {
        processors_ = 1 + numbers_.below(5);
        write("connection (length = 0.25) wire[{}], channel[2][20];\n", processors_);
        for (std::size_t i = 0; i < processors_; ++i)
            declare_processor(i);
        for (std::size_t i = 0; i + 1 < processors_; ++i)
            connect_processors(i);
        if (processors_ == 1 || chance(2))
            write("connect t0.link[3] to host;\n");
        for (std::size_t i = 0, arrays = 1 + numbers_.below(4); i < arrays; ++i)
            declare_processes(i);
        connect_processes();
        return std::move(text_);
    }

private:
    template <class... Arguments>
    void write(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        text_ += fmt::format(format, std::forward<Arguments>(arguments)...);
    }

    bool chance(std::size_t one_in) { return numbers_.below(one_in) == 0; }
    std::string one_of(const std::vector<std::string>& choices) { return choices[numbers_.below(choices.size())]; }

    void declare_processor(std::size_t i) {
        auto type = one_of({"T800", "t805", "B404", "B403_T414", "processor (type = \"t425\")", "T225"});
        std::string attributes =
            type.find('(') != std::string::npos || chance(2)
                ? ""
                : fmt::format(" (clock = {}M, memory = {}k, channelcall = {}, reserved = 0{})", 1 + numbers_.below(40),
                              1 + numbers_.below(type == "T225" ? 64 : 4000), numbers_.below(200), numbers_.below(8));
        write("{}{} t{};\n", type, attributes, i);
    }

    void connect_processors(std::size_t i) {
        if (chance(3))
            write("C004 s{0}; connect t{0}.link[2] to s{0}.link[3]; connect s{0}.link[3] to s{0}.link[31];\n"
                  "connect s{0}.link[31] to t{1}.link[1] by wire[{0}];\n",
                  i, i + 1);
        else
            write("connect t{0}.link[2] to t{1}.link[1]{2};\n", i, i + 1,
                  chance(2) ? fmt::format(" by wire[{}]", i) : "");
        if (chance(4))
            write("wire[{}] (linkspeed = {}M);\n", i, 5 * (1 + numbers_.below(4)));
    }

    struct Array {
        std::string name;
        std::size_t size; ///< 0: a single process, not an array
        std::string element(std::size_t i) const { return size == 0 ? name : fmt::format("{}[{}]", name, i); }
        std::size_t count() const { return std::max<std::size_t>(size, 1); }
    };

    void declare_processes(std::size_t index) {
        Array array{fmt::format("p{}", index), numbers_.below(4)};
        entries_ = {"input in[2]", "output out[2]"};
        common_.clear();
        individual_.clear();
        for (std::size_t i = 0, parameters = numbers_.below(9); i < parameters; ++i)
            add_parameter(fmt::format("v{}", i));
        for (std::size_t i = entries_.size(); i-- > 1;)
            std::swap(entries_[i], entries_[numbers_.below(i + 1)]);
        write("{} ({}interface ({})) {};\n", one_of({"process", "highprocess", "LOWPROCESS"}),
              chance(2) ? fmt::format("stacksize = {}k, order.code = {}, ", numbers_.below(90), numbers_.below(9)) : "",
              fmt::join(entries_, ", "), array.size == 0 ? array.name : fmt::format("{}[{}]", array.name, array.size));
        set_parameters(array);
        arrays_.push_back(array);
    }

    void set_parameters(const Array& array) {
        if (!common_.empty())
            write("{} ({});\n", array.name, fmt::join(common_, ", "));
        for (std::size_t i = 0; i < array.count(); ++i) {
            if (!individual_.empty())
                write("{} (", array.element(i));
            for (std::size_t k = 0; k < individual_.size(); ++k)
                write("{}{} = {}", k == 0 ? "" : ", ", individual_[k].first, value(individual_[k].second));
            if (!individual_.empty())
                write(");\n");
            write("use \"{}.lku\" for {};\nplace {} on t{};\n", one_of({"farm", "work"}), array.element(i),
                  array.element(i), place());
        }
    }

    /// Places the first process on t0, and each further process on the processor of the preceding process or on the
    /// next processor, since channels lead only to neighbours.
    std::size_t place() {
        placed_ = first_ ? 0 : std::min(processors_ - 1, placed_ + (chance(3) ? 1 : 0));
        first_ = false;
        return placed_;
    }

    void add_parameter(const std::string& name) {
        auto type = one_of({"int", "char", "short", "long", "unsigned", "float", "double", "int [3]", "char [6]",
                            "char [2][6]", "short [2][2]", "double [1][2][2]"});
        auto space = type.find(' ');
        auto declaration =
            type.substr(0, space) + " " + name + (space == std::string::npos ? "" : type.substr(space + 1));
        if (chance(3)) {
            entries_.push_back(declaration + " = " + value(type));
            return;
        }
        entries_.push_back(declaration);
        if (chance(2))
            common_.push_back(name + " = " + value(type));
        else
            individual_.emplace_back(name, type);
    }

    std::string value(const std::string& type) {
        auto space = type.find(' ');
        if (space == std::string::npos)
            return scalar(type);
        bool text = type.starts_with("char");
        auto size = static_cast<std::size_t>(type[space + 2] - '0');
        auto rest = type.substr(space + 4);
        if (text && rest.empty())
            return string(size);
        auto inner = type.substr(0, space) + (rest.empty() ? "" : " " + rest);
        std::string result;
        for (std::size_t i = 0; i < size; ++i)
            result += (i == 0 ? "{" : ", ") + value(inner);
        return result + "}";
    }

    std::string scalar(const std::string& type) {
        if (type == "double" || type == "float")
            return one_of({"0.1", "-2.5e10", "3", "1e-7", "0.0", "123456.789"});
        if (type == "long")
            return one_of({"-9223372036854775807 - 1", "1 << 40", "9223372036854775807", "0"});
        return one_of({"0", "017", "'a'", "127 & ~1", "1 > 0 ? 5 : 6", "size(\"four\")", "3 ^ 1 | 8"});
    }

    std::string string(std::size_t most) {
        static const std::vector<std::string> characters{"a", " ", "\\\"", "\\\\", "\\n", "\\001", "\\377", "*", "]"};
        std::string text;
        for (auto i = numbers_.below(most + 1); i > 0; --i)
            text += one_of(characters);
        return "\"" + text + "\"";
    }

    /// Connects each process with the next. Unused ports lead to the edge of the network or back to their own process.
    void connect_processes() {
        std::vector<std::string> ring;
        for (const auto& array : arrays_)
            for (std::size_t i = 0; i < array.count(); ++i)
                ring.push_back(array.element(i));
        for (std::size_t i = 0; i < ring.size(); ++i) {
            write("connect {0}.in[0] to {0}.out[1]{1};\n", ring[i],
                  i < 20 && chance(3) ? fmt::format(" by channel[0][{}]", i) : "");
            if (i + 1 < ring.size())
                write("connect {}.out[0] to {}.in[1];\n", ring[i], ring[i + 1]);
        }
        write("input first_in; output last_out; edge front, back;\n"
              "connect first_in, {}.in[1]; connect {}.out[0], last_out; connect t0.link[0] to front;\n"
              "connect t{}.link[{}] to back; place first_in on front; place last_out on back;\n",
              ring.front(), ring.back(), placed_, placed_ == 0 ? 1 : 0);
    }

    Numbers numbers_;
    std::string text_;
    std::size_t processors_ = 0, placed_ = 0;
    bool first_ = true;
    std::vector<std::string> entries_, common_;
    std::vector<std::pair<std::string, std::string>> individual_; ///< name and type
    std::vector<Array> arrays_;
};

std::string all_but_source(Network network) {
    network.source_path = "";
    return print_json(network);
}

bool same_interfaces(const Network& a, const Network& b) {
    return std::ranges::equal(a.processes, b.processes, [](const auto& x, const auto& y) {
        return x.interface && y.interface && *x.interface == *y.interface;
    });
}

} // namespace

TEST_CASE("printed random networks load again") {
    for (std::uint64_t number = 0; number < (test::sanitized ? 20u : 400u); ++number) {
        CAPTURE(number);
        auto text = RandomNetlist(number).text();
        auto result = read_netlist_text(text, small_catalogue());
        INFO(text);
        INFO(render(result.diagnostics));
        REQUIRE(result.network);
        auto printed = print_cfs(*result.network);
        const WrittenOut out = write_out(*result.network, printed.size());
        REQUIRE(out.text == printed);
        REQUIRE(out.hash == network_hash(canonical_form(*result.network)));
        REQUIRE(write_out(*result.network, printed.size() - 1).bytes == printed.size());
        auto again = read_netlist_text(printed, small_catalogue());
        INFO(printed);
        INFO(render(again.diagnostics));
        REQUIRE(again.network);
        REQUIRE(print_cfs(*again.network) == printed);
        REQUIRE(all_but_source(*again.network) == all_but_source(*result.network));
        REQUIRE(same_interfaces(*again.network, *result.network));
    }
}
