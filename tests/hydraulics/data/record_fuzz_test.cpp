#include "hydraulics/data/record_table.hpp"
#include "runtime/random.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

using namespace placedpar;
using namespace placedpar::hydraulics;

namespace {

std::string good_record() {
    std::string text = "# boom\ntime [s],boom.inlet_pressure [psi],boom.angle [deg],\"boom.spool [in]\"\n";
    for (int i = 0; i < 12; ++i)
        text += fmt::format("{:.3f},{:.2f},{:.3f},{:.4f}\n", 0.02 * i, 1555 + 20.0 * i, 20 + 0.1 * i, 0.13 + 0.01 * i);
    return text;
}

/// Changes a text at random places: replaces, removes, inserts or doubles bytes, or inserts pieces that often break
/// records.
std::string mutated(std::string text, RandomStream& random) {
    static constexpr std::array<std::string_view, 28> pieces{"\"",  "\"\"",    ",",      ",,",
                                                             "\n",  "\r",      "\r\n",   "nan",
                                                             "inf", "1e999",   "-1e308", "1e308",
                                                             "#",   "[",       "]",      "\xef\xbb\xbf",
                                                             "+",   "-",       "1e12",   "boom.angle [rad]",
                                                             ";",   "\t",      "(",      ")",
                                                             ":",   "sep=;\n", "#N/A",   "2024-03-05T14:30:00.02Z"};
    for (std::uint32_t changes = 1 + random.below(6); changes > 0; --changes) {
        std::size_t at = random.below(static_cast<std::uint32_t>(text.size() + 1));
        std::size_t length = random.below(20);
        switch (random.below(5)) {
        case 0: text.insert(at, pieces[random.below(static_cast<std::uint32_t>(pieces.size()))]); break;
        case 1: text.erase(at, length); break;
        case 2: text.insert(at, text.substr(at, length)); break;
        case 3: text.insert(at, 1, static_cast<char>(random.below(256))); break;
        default:
            if (at < text.size())
                text[at] = static_cast<char>(random.below(256));
        }
    }
    return text;
}

void check_faults(const ReadRecord& read, const std::string& text) {
    auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1;
    for (const Diagnostic& fault : read.faults) {
        CHECK(fault.location.line <= lines);
        CHECK(fault.location.column <= text.size() + 1);
        CHECK((fault.location.line == 0) == (fault.location.column == 0));
        CHECK_FALSE(fault.message.empty());
    }
}

void check_record(const Record& record) {
    CHECK(record.size() >= fewest_samples);
    CHECK(record.period_s > 0);
    CHECK_FALSE(record.links().empty());
    for (std::size_t i = 1; i < record.size(); ++i) {
        double periods = (record.time_s[i] - record.time_s[i - 1]) / record.period_s;
        CHECK(periods > 0);
        CHECK(std::abs(periods - std::round(periods)) <= sampling_tolerance * 1.001);
    }
    for (Link link : all_links)
        for (Sensor sensor : all_sensors) {
            const auto& values = record.of(link, sensor);
            CHECK((values.empty() || values.size() == record.size()));
            for (double value : values)
                CHECK(std::isfinite(value));
        }
}

} // namespace

TEST_CASE("a mutated record is either usable or refused with a place") {
    RandomStream random(11, "mutations of a record");
    const std::string good = good_record();
    int read_well = 0, refused = 0;
    for (int i = 0; i < 20000; ++i) {
        std::string text = mutated(good, random);
        CAPTURE(text);
        ReadRecord read = read_record(text);
        REQUIRE(read.record.has_value() != has_errors(read.faults));
        check_faults(read, text);
        (read.record ? read_well : refused)++;
        if (read.record)
            check_record(*read.record);
    }
    CHECK(read_well > 500); // both outcomes must occur
    CHECK(refused > 1000);
}

TEST_CASE("random bytes are refused") {
    RandomStream random(12, "rubbish");
    for (int i = 0; i < 2000; ++i) {
        std::string text;
        for (std::uint32_t length = random.below(300); length > 0; --length)
            text += static_cast<char>(random.below(256));
        ReadRecord read = read_record(text);
        CHECK_FALSE(read.record.has_value());
        check_faults(read, text);
    }
}

TEST_CASE("a mutated file of a logger or a spreadsheet is either usable or refused with a place") {
    RandomStream random(13, "mutations of loggers");
    const std::vector<ColumnName> names{column_name("time=TIMESTAMP"), column_name("time=Zeit"),
                                        column_name("pressure [psi]=P_boom_in"), column_name("angle=Winkel"),
                                        column_name("spool=X_boom")};
    int read_well = 0, refused = 0, files = 0;
    const std::filesystem::directory_iterator folder(PLACEDPAR_SOURCE_DIR "/examples/hydraulics/loggers");
    for (const std::filesystem::path& path : std::set<std::filesystem::path>(begin(folder), end(folder))) {
        std::ifstream in(path, std::ios::binary);
        std::string good(std::istreambuf_iterator<char>(in), {});
        good.resize(good.rfind('\n', 1000) + 1); // short, so that changes often meet the header
        RecordNeeds needs{{}, true};
        for (const ColumnName& name : names)
            if (good.find(name.in_file) != good.npos)
                needs.names.push_back(name);
        ++files;
        for (int i = 0; i < 300; ++i) {
            const std::string text = mutated(good, random);
            CAPTURE(path.string());
            CAPTURE(text);
            const ReadRecord read = read_record(text, needs);
            REQUIRE(read.record.has_value() != has_errors(read.faults));
            check_faults(read, text);
            (read.record ? read_well : refused)++;
            if (read.record)
                check_record(*read.record);
        }
    }
    CHECK(files == 22); // with the page and the file of names
    CHECK(read_well > 300);
    CHECK(refused > 1000);
}
