#include "hydraulics/data/record_table.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

using namespace placedpar;
using namespace placedpar::hydraulics;

namespace {

constexpr const char* boom_columns = "time [s],boom.inlet_pressure [psi],boom.angle [deg],boom.spool [in]\n";

std::string row(double time_s) {
    return fmt::format("{:.3f},{:.2f},{:.3f},{:.4f}\n", time_s, 1555 + 1000 * time_s, 20 + time_s, 0.13 + time_s / 10);
}

std::string rows(int first, int last) {
    std::string text;
    for (int i = first; i < last; ++i)
        text += row(0.02 * i);
    return text;
}

/// Returns each fault as "error 3:5: message | hint".
std::string record_faults(const std::string& text) {
    ReadRecord read = read_record(text);
    CHECK(read.record.has_value() != has_errors(read.faults));
    std::string all;
    for (const Diagnostic& fault : read.faults)
        all += fmt::format("{} {}:{}: {}{}{}\n", fault.severity == Severity::error ? "error" : "warning",
                           fault.location.line, fault.location.column, fault.message, fault.hint.empty() ? "" : " | ",
                           fault.hint);
    return all;
}

} // namespace

TEST_CASE("a record is read with its description and readings") {
    ReadRecord read = read_record("# boom, seed 1\n# by hand\n" + (boom_columns + rows(0, 10)));
    REQUIRE(read.record);
    CHECK(read.faults.empty());
    const Record& record = *read.record;
    CHECK(record.description == "boom, seed 1\nby hand\n");
    CHECK(record.size() == 10);
    CHECK(record.period_s == doctest::Approx(0.02));
    CHECK(record.links() == LinkSet{Link::boom});
    CHECK(record.of(Link::boom, Sensor::inlet_pressure)[5] == doctest::Approx(1655));
    CHECK(record.has(Link::boom, Sensor::spool));
    CHECK_FALSE(record.has(Link::boom, Sensor::servo));
    CHECK_FALSE(record.has(Link::bucket, Sensor::angle));
    REQUIRE(record.stretches().size() == 1);
    CHECK(record.stretches()[0].last == 10);
}

TEST_CASE("columns may be in any order, named by a link's symbol, and in other units") {
    std::string si = "BO.spool [mm],BO.angle [rad],time [ms],BO.inlet_pressure [kPa]\n";
    for (int i = 0; i < 10; ++i) {
        double time_s = 0.02 * i;
        si +=
            fmt::format("{:.9f},{:.12f},{:.6f},{:.9f}\n", (0.13 + time_s / 10) * 25.4,
                        (20 + time_s) * std::acos(-1.0) / 180, 1000 * time_s, (1555 + 1000 * time_s) * 6.894757293168);
    }
    ReadRecord inch = read_record(boom_columns + rows(0, 10)), metric = read_record(si);
    REQUIRE(metric.record);
    CHECK(metric.faults.empty());
    for (Sensor sensor : {Sensor::inlet_pressure, Sensor::angle, Sensor::spool})
        for (std::size_t i = 0; i < 10; ++i)
            CHECK(metric.record->of(Link::boom, sensor)[i] ==
                  doctest::Approx(inch.record->of(Link::boom, sensor)[i]).epsilon(1e-9));
    CHECK(metric.record->period_s == doctest::Approx(inch.record->period_s).epsilon(1e-12));
}

TEST_CASE("a record written by a spreadsheet is read: byte order mark, CR LF, quotes, plus signs") {
    std::string text = "\xef\xbb\xbf\"time [s]\",\"boom.angle [deg]\"\r\n";
    for (int i = 0; i < 6; ++i)
        text += fmt::format("\"{:.2f}\",+{}\r\n", 0.02 * i, i);
    ReadRecord read = read_record(text);
    CHECK(read.faults.empty());
    REQUIRE(read.record);
    CHECK(read.record->of(Link::boom, Sensor::angle)[5] == 5);
}

TEST_CASE("a wrong header is refused with its place") {
    CHECK(record_faults("") ==
          "error 0:0: the header is missing | write a header such as time [s],boom.inlet_pressure [psi]\n");
    CHECK(record_faults("boom.angle [deg]\n1\n") ==
          "error 1:1: the column \"time\" is missing | add the column time [s], usually the first; or name an existing "
          "column: --column time=NAME\n");
    CHECK(record_faults("time [s]\n"
                        "0\n") ==
          "error 1:1: the record has no column of a sensor | add a column LINK.SENSOR, such as boom.inlet_pressure "
          "[psi]; or name an existing column: --column boom.inlet_pressure=NAME\n");
    CHECK(record_faults("time [s],boom.angle\n0,1\n") ==
          "error 1:10: column \"boom.angle\" has no unit | write boom.angle [UNIT], where UNIT is deg or rad\n");
    CHECK(record_faults("time [s],boom.angle [psi]\n0,1\n") ==
          "error 1:10: \"psi\" is not a unit of angle | write boom.angle [UNIT], where UNIT is deg or rad\n");
    CHECK(record_faults("time [s],boom.angle [deg],BO.angle [rad]\n0,1,2\n") ==
          "error 1:27: column \"BO.angle\" occurs twice | the first is column 2 of the table\n");
    std::string text = "time [s],boom.angle [deg],boom.temperature [C],motor.angle [deg]\n";
    for (int i = 0; i < 5; ++i)
        text += fmt::format("{},{},x,y\n", 0.02 * i, i);
    CHECK(
        record_faults(text) ==
        "warning 1:27: columns \"boom.temperature\", \"motor.angle\" are not used | columns are time and "
        "LINK.SENSOR, such as boom.inlet_pressure or bucket.angle; --column boom.angle=NAME reads a column of another "
        "name\n");
}

TEST_CASE("a wrong reading is refused with its place") {
    constexpr const char* missing = "leave a row out where a reading is missing";
    constexpr const char* skip = "write a number such as 1830.5 or -2e-3; \"placedpar identify --missing skip\" leaves "
                                 "out rows with missing readings";
    CHECK(record_faults(boom_columns + rows(0, 5) + "0.100,nan,20,0.2\n") ==
          fmt::format("error 7:7: \"nan\" is not a reading | {}\n", skip));
    CHECK(record_faults(boom_columns + rows(0, 5) + "0.100,,20,inf\n") ==
          fmt::format("error 7:7: the value is missing | {}\nerror 7:11: \"inf\" is not a finite "
                      "number | write a number such as 1830.5 or -2e-3; {}\n",
                      skip, missing));
    CHECK(record_faults(boom_columns + rows(0, 5) + "0.100,1e300,20,0.2\n") ==
          fmt::format("error 7:7: 1e300 is too large for a reading | {}\n", missing));
    CHECK(record_faults("time [s],boom.inlet_pressure [bar]\n0,1e308\n0.02,1\n0.04,2\n0.06,3\n0.08,4\n")
              .starts_with("error 2:3: 1e308 is too large for a reading"));
    CHECK(record_faults(boom_columns + rows(0, 5) + "0.100,1600,20\n") ==
          "error 7:12: the row has the wrong number of values: 3, expected 4 | the header on line 1 has 4 columns\n");
}

TEST_CASE("wrong times are refused with their place") {
    CHECK(record_faults(boom_columns + rows(0, 4)) == "error 0:0: the record has 4 samples, expected at least 5\n");
    auto rowless = "error 0:0: the record has 0 samples, expected at least 5 | write a line for each instant below "
                   "the header; lines end in LF or in CR LF\n";
    CHECK(record_faults(boom_columns) == rowless);
    CHECK(record_faults("time [s],boom.angle [deg]0.00,20.0,0.02,20.1") == rowless); // the line ends were lost
    CHECK(record_faults("time [s],boom.angle [deg]0.00,20.0,boom.spool [in]") == rowless);
    CHECK(record_faults(boom_columns + rows(0, 6) + rows(8, 12)) ==
          "warning 8:1: 2 samples are missing before this one | windows and slopes do not extend across the gap\n");
    CHECK(record_faults(boom_columns + rows(0, 6) + rows(5, 9)) ==
          "warning 8:1: the row repeats line 7 | the row is used once\n");
    CHECK(record_faults(boom_columns + rows(0, 6) + "0.100,1700,20,0.2\n" + rows(6, 9)) ==
          "error 8:1: the time is the same as on line 7, but the readings differ | leave out the row that is wrong\n");
    CHECK(record_faults(boom_columns + rows(0, 6) + row(0.06) + rows(6, 9)) ==
          "error 8:1: the time is 0.04 s before the time on line 7 | rows must be in order of time\n"
          "warning 9:1: 2 samples are missing before this one | windows and slopes do not extend across the gap\n");
    CHECK(record_faults(boom_columns + rows(0, 6) + row(0.127) + rows(7, 12)) ==
          "error 8:1: the time is 0.027 s after the time on line 7 | steps must be whole numbers of sampling periods "
          "of 0.02 s (the median step), within 25 %\n"
          "error 9:1: the time is 0.013 s after the time on line 8 | steps must be whole numbers of sampling periods "
          "of 0.02 s (the median step), within 25 %\n");
    std::string backwards = boom_columns;
    for (int i = 9; i >= 0; --i)
        backwards += row(0.02 * i);
    CHECK(record_faults(backwards) == "error 3:1: most times do not rise | rows must be in order of time\n");
    std::string milliseconds = "boom.angle [deg],time [s]\n";
    for (int i = 0; i < 6; ++i)
        milliseconds += fmt::format("{},{}\n", i, 20 * i);
    CHECK(record_faults(milliseconds) ==
          "warning 1:18: samples are 20 s apart, which is unusual | the value would be usual in ms\n");
    CHECK(record_faults("boom.angle [deg],time [s]\n1,0\n2,0.02\n3,0.04\n4,0.06\n5,0.08\n6,0.01\n")
              .starts_with("error 7:3: the time is 0.07 s before"));
}

TEST_CASE("suspicious channels give warnings") {
    std::string text = "time [s],boom.inlet_pressure [psi],boom.spool [mm],boom.servo [V],bucket.angle [deg]\n";
    for (int i = 0; i < 6; ++i)
        text += fmt::format("{},{},{},{},7\n", 0.02 * i, 110 + i, 0.13 + 0.01 * i, 340 + i);
    CHECK(record_faults(text) ==
          "warning 1:10: boom.inlet_pressure reaches 115 psi, which is unusual | the value would be usual in bar\n"
          "warning 1:36: boom.spool reaches 0.18 mm, which is unusual | the value would be usual in in, cm\n"
          "warning 1:52: boom.servo reaches 345 V, which is unusual | the value would be usual in mV\n"
          "warning 1:67: bucket.angle is 7 deg in every sample | the sensor may not be connected, or the link was not "
          "moved\n");
}

TEST_CASE("pressures below vacuum and a frozen pressure give warnings") {
    std::string text = "time [s],boom.inlet_pressure [bar],boom.angle [deg]\n";
    for (int i = 0; i < 12; ++i)
        text += fmt::format("{},{},{}\n", 0.02 * i,
                            i == 1  ? -1.5
                            : i < 4 ? 100.0 + i
                            : i < 9 ? 104.0
                                    : 99.5 + i,
                            7 + i);
    CHECK(record_faults(text) ==
          "warning 3:6: boom.inlet_pressure is -1.5 bar, below vacuum (1 of 12 samples) | no pressure is below vacuum: "
          "check the sign of the sensor's readings\n"
          "warning 6:6: boom.inlet_pressure stays at 104 bar up to line 10, and then jumps by 4.5 bar | the sensor or "
          "the logger may have stopped for a time: leave these rows out\n");
}

TEST_CASE("a pressure that starts smoothly from rest is not frozen, and neither is one that moves a little") {
    for (double step : {49.0, 19.0}) {
        std::string text = "time [s],boom.inlet_pressure [psi],boom.angle [deg]\n";
        for (int i = 0; i < 12; ++i)
            text += fmt::format("{},{},{}\n", 0.02 * i, i < 8 ? 1555.0 : 1555 + step * (i - 7) * (i - 7), 7 + i);
        CHECK(record_faults(text).empty());
    }
}

TEST_CASE("jittering times are resampled to whole periods, but not across a gap") {
    std::string text = "time [ms],boom.angle [deg]\n";
    std::vector<int> off{0, 1, -1, 1, 0, -1, 1, -1, 0, 0}; // ms
    for (int i = 0; i < 10; ++i) {
        int time = 20 * (i < 6 ? i : i + 3) + off[static_cast<std::size_t>(i)];
        // After the gap the angle follows another line.
        text += fmt::format("{},{}\n", time, time < 110 ? time / 4.0 : 300 - time / 4.0);
    }
    ReadRecord read = read_record(text);
    REQUIRE(read.record);
    const Record& record = *read.record;
    CHECK(record.period_s == doctest::Approx(0.02));
    REQUIRE(record.stretches().size() == 2);
    for (std::size_t i = 0; i < record.size(); ++i) {
        double time_ms = 20.0 * (i < 6 ? static_cast<double>(i) : static_cast<double>(i) + 3);
        CHECK(1000 * record.time_s[i] == doctest::Approx(time_ms));
        CHECK(record.of(Link::boom, Sensor::angle)[i] ==
              doctest::Approx(time_ms < 110 ? time_ms / 4 : 300 - time_ms / 4));
    }
    CHECK(record_faults(text) ==
          "warning 1:1: the times differ by up to 1 ms from whole periods of 20 ms | readings at whole periods are "
          "interpolated linearly between neighbouring samples\nwarning 8:1: 3 samples are missing before this one | "
          "windows and slopes do not extend across the gap\n");
}

TEST_CASE("a record whose clock changes its rate is refused") {
    std::string text = "time [ms],boom.angle [deg]\n";
    for (int i = 0; i < 60; ++i)
        text += fmt::format("{},{}\n", i < 30 ? 20 * i : 600 + 24 * (i - 30), i);
    CHECK(record_faults(text) ==
          "error 1:1: the sampling period changes: the times differ from whole periods by more than half a period "
          "| write a separate record for each sampling rate\n");
}

TEST_CASE("gaps divide a record into stretches") {
    ReadRecord read = read_record(boom_columns + rows(0, 6) + rows(8, 12) + rows(20, 21));
    REQUIRE(read.record);
    auto stretches = read.record->stretches();
    REQUIRE(stretches.size() == 3);
    CHECK(stretches[1].first == 6);
    CHECK(stretches[1].last == 10);
    CHECK(stretches[2].last == 11);
}

TEST_CASE("the earliest impossible reading is found, and at one instant the reading of the first channel") {
    ReadRecord read = read_record(boom_columns + rows(0, 6));
    REQUIRE(read.record);
    Record& record = *read.record;
    CHECK(!first_unmeasurable(record));
    record.of(Link::boom, Sensor::inlet_pressure)[4] = -1e13;
    record.of(Link::boom, Sensor::spool)[3] = NAN;
    record.of(Link::boom, Sensor::angle)[3] = INFINITY;
    auto reading = first_unmeasurable(record);
    REQUIRE(reading);
    CHECK(reading->sensor == Sensor::angle);
    CHECK(reading->time_s == 0.06);
    record.of(Link::boom, Sensor::angle)[3] = record.of(Link::boom, Sensor::spool)[3] = 0;
    REQUIRE(first_unmeasurable(record));
    CHECK(first_unmeasurable(record)->value == -1e13);
}

TEST_CASE("a printed record reads back and prints identically") {
    Record record;
    record.description = "first line\n\n  third\n";
    for (int i = 0; i < 12; ++i) {
        record.time_s.push_back(0.02 * i);
        for (Sensor sensor : all_sensors)
            record.of(Link::stick, sensor).push_back(1000.0 / 3 * std::sin(i) + static_cast<int>(sensor));
        record.of(Link::boom, Sensor::angle).push_back(-1e-9 * i);
    }
    std::string text = print_record(record);
    CHECK(text.find("-0.0000000") == std::string::npos);
    CHECK(text.starts_with("# first line\n# \n#   third\ntime [s],boom.angle [deg],stick.inlet_pressure [psi]"));
    ReadRecord read = read_record(text);
    REQUIRE(read.record);
    CHECK(read.record->description == record.description);
    CHECK(print_record(*read.record) == text);
    for (Sensor sensor : all_sensors)
        for (std::size_t i = 0; i < 12; ++i)
            CHECK(std::abs(read.record->of(Link::stick, sensor)[i] - record.of(Link::stick, sensor)[i]) <=
                  (quantity_of(sensor) == Quantity::pressure ? 0.51e-4 : 0.51e-7));
}

TEST_CASE("times are printed with the decimals that the period needs") {
    Record record;
    for (int i = 0; i < 8; ++i) {
        record.time_s.push_back(i / 1024.0);
        record.of(Link::boom, Sensor::angle).push_back(i);
    }
    ReadRecord read = read_record(print_record(record));
    REQUIRE(read.record);
    CHECK(read.record->period_s == doctest::Approx(1 / 1024.0).epsilon(1e-6));
}

namespace {

/// Returns every channel of the boom except its spool.
ChannelSet all_but_spool(const ChannelSet& there) {
    ChannelSet needed;
    for (Sensor sensor : all_sensors)
        if (sensor != Sensor::spool && there.contains(Link::boom, sensor))
            needed.insert(Link::boom, sensor);
    return needed;
}

std::string all_faults(const std::vector<Diagnostic>& faults) {
    std::string text;
    for (const Diagnostic& fault : faults)
        text += fmt::format("{}:{} ", fault.location.line, fault.message);
    return text;
}

} // namespace

TEST_CASE("a record read in pieces equals the whole record, with its lines and one warning about the header") {
    const std::string head = "time [s],boom.inlet_pressure [psi],boom.angle [deg],boom.spool [mm],crane [m]\n";
    std::vector<std::string> lines;
    for (int i = 0; i < 60; ++i)
        lines.push_back(fmt::format("{:.2f},{},{},{},0\n", 0.02 * (i + (i > 40 ? 3 : 0)), 1500 + i * i, 20 + 0.1 * i,
                                    5 + 0.01 * i));
    std::string text = head;
    for (const std::string& line : lines)
        text += line;
    const ReadRecord whole = read_record(text);
    REQUIRE(whole.record);
    for (std::size_t size : {5, 12, 41, 59}) {
        RecordReader reader;
        std::vector<double> times, pressures;
        std::vector<Diagnostic> faults;
        for (std::size_t first = 0; first < lines.size(); first += size) {
            std::string piece = first == 0 ? head : "";
            for (std::size_t i = first; i < std::min(first + size, lines.size()); ++i)
                piece += lines[i];
            ReadRecord read = reader.read(piece);
            REQUIRE(read.record);
            std::ranges::copy(read.record->time_s, std::back_inserter(times));
            std::ranges::copy(read.record->of(Link::boom, Sensor::inlet_pressure), std::back_inserter(pressures));
            std::ranges::copy(read.faults, std::back_inserter(faults));
        }
        std::ranges::copy(reader.finish(), std::back_inserter(faults));
        std::ranges::stable_sort(faults, {}, [](const Diagnostic& fault) { return fault.location.line; });
        CHECK(times == whole.record->time_s);
        CHECK(pressures == whole.record->of(Link::boom, Sensor::inlet_pressure));
        CHECK(all_faults(faults) == all_faults(whole.faults));
    }
    RecordReader reader;
    REQUIRE(reader.read(head + lines[0] + lines[1] + lines[2] + lines[3] + lines[4]).record);
    const ReadRecord back = reader.read(lines[5] + lines[4]);
    CHECK(!back.record);
    CHECK(all_faults(back.faults).find("8:the time is 0.02 s before the time on line 7") != std::string::npos);
}

TEST_CASE("rows without a needed reading are skipped on request; an unneeded reading may be empty") {
    const std::string text =
        boom_columns + rows(0, 5) + "0.100,-,20,0.2\n" + rows(6, 11) + "0.220,1600,20,\n" + rows(12, 15);
    CHECK(!read_record(text).record);
    const ReadRecord skipped = read_record(text, {{}, true});
    REQUIRE(skipped.record);
    CHECK(skipped.record->size() == 13);
    CHECK(skipped.record->stretches().size() == 3);
    CHECK(all_faults(skipped.faults).find("7:readings are missing") != std::string::npos);
    const ReadRecord without = read_record(text, {all_but_spool, true});
    REQUIRE(without.record);
    CHECK(without.record->size() == 14);
    CHECK(!without.record->has(Link::boom, Sensor::spool));
    CHECK(!read_record(text, {all_but_spool, false}).record); // the pressure of line 7 is needed
}

TEST_CASE("rows that are left out in several pieces are counted together") {
    RecordReader reader({{}, true});
    REQUIRE(reader.read(boom_columns + rows(0, 5)).record);
    const ReadRecord second = reader.read("0.100,-,20,0.2\n" + rows(6, 11) + "0.220,1600,20,\n");
    REQUIRE(second.record);
    CHECK(all_faults(second.faults).find("missing before") != std::string::npos);
    CHECK(all_faults(second.faults).find("readings are missing") == std::string::npos);
    REQUIRE(reader.read("0.240,1600,-,0.2\n" + rows(13, 15)).record);
    const std::vector<Diagnostic> at_end = reader.finish();
    REQUIRE(!at_end.empty());
    CHECK(at_end.front().location.line == 7);
    CHECK(at_end.front().message == "readings are missing");
    CHECK(at_end.front().hint == "3 rows left out, beginning with this row");
}

TEST_CASE("the first time that is not missing tells whether times are dates") {
    std::string text = "time,boom.angle [deg]\n#N/A,20\n";
    for (int i = 0; i < 8; ++i)
        text += fmt::format("2024-03-05T14:30:00.{:02},{}\n", 2 * i, 20 + i);
    const ReadRecord skipped = read_record(text, {{}, true});
    REQUIRE(skipped.record);
    CHECK(skipped.record->size() == 8);
    CHECK(skipped.record->period_s == doctest::Approx(0.02));
    CHECK(all_faults(read_record(text).faults).starts_with("2:\"#N/A\" is not a reading"));
}

TEST_CASE("a column of configurations is read, and a cell without a known letter is unknown") {
    std::string text = "time [s],boom.angle [deg],configuration\n";
    for (int i = 0; i < 6; ++i)
        text += fmt::format("{},{},{}\n", 0.02 * i, i, std::vector<std::string>{"a", "e", "f", "", "d", "aa"}[i]);
    const ReadRecord read = read_record(text);
    REQUIRE(read.record);
    CHECK(read.faults.empty());
    CHECK(read.record->configuration == "ae--d-");
}

namespace {

constexpr const char* logger_columns = "Zeit [s];P_boom_in [bar];Phi [\u00b0];X (mm)\n";

std::vector<ColumnName> logger_names() {
    return {column_name("time=Zeit"), column_name("pressure=P_boom_in"), column_name("boom.angle=Phi"),
            column_name("BO.spool = X")};
}

std::string logger_rows() {
    std::string text;
    for (int i = 0; i < 6; ++i)
        text += fmt::format("0,{:02};{}7,5;{},25;3\n", 2 * i, i, i);
    return text;
}

std::string refused_name(std::string_view name) {
    try {
        column_name(name);
    } catch (const UserError& refused) {
        return refused.what();
    }
    return "";
}

std::string faults_with(const std::string& text, std::vector<ColumnName> names) {
    return all_faults(read_record(text, {{}, false, std::move(names)}).faults);
}

} // namespace

TEST_CASE("columns are read by the names that the user gives, with semicolons, decimal commas and other brackets") {
    for (const char* above : {"", "sep=;\r\n", "\xef\xbb\xbfsep=;\n", "Logger 7\nOperator;Brown;;\n\n"}) {
        const ReadRecord read = read_record(above + (logger_columns + logger_rows()), {{}, false, logger_names()});
        REQUIRE(read.record);
        CHECK(read.record->time_s == std::vector<double>{0, 0.02, 0.04, 0.06, 0.08, 0.10});
        CHECK(read.record->of(Link::boom, Sensor::inlet_pressure)[2] == doctest::Approx(27.5 * 14.5037738));
        CHECK(read.record->of(Link::boom, Sensor::angle)[3] == 3.25);
        CHECK(read.record->of(Link::boom, Sensor::spool)[0] == doctest::Approx(3 / 25.4));
    }
    CHECK(refused_name("pressure") ==
          "\"pressure\": expected NAME=NAME_IN_FILE, such as boom.inlet_pressure=P_boom_in");
    CHECK(refused_name("presure=P").starts_with("\"presure\" is not a channel: expected time, LINK.SENSOR"));
    CHECK(refused_name("angle [bar]=Phi") == "\"bar\" is not a unit of angle: expected deg or rad");
}

TEST_CASE("a name that the file lacks is refused, and so are thousands separators and a mixture of decimal signs") {
    CHECK(faults_with(logger_columns + logger_rows(), {column_name("time=Zeit"), column_name("pressure=P_boom_im")}) ==
          "1:columns \"P_boom_in\", \"Phi\", \"X\" are not used 1:no column is named \"P_boom_im\" ");
    CHECK(faults_with(logger_columns + logger_rows() + "0,12;1.007,5;7,25;3\n", logger_names()) ==
          "8:\"1.007,5\" is not a finite number ");
    CHECK(faults_with("time [s];boom.angle [deg]\n0.00;1,007\n0.02;2,000\n0.04;3,000\n0.06;4\n0.08;5\n", {})
              .starts_with("2:\"1,007\" is not a finite number"));
    const std::string whole = "time [s];boom.inlet_pressure [psi]\n0;1,567\n1;-2,345,678\n2;999\n3;12,000\n";
    CHECK(faults_with(whole + "4;1,568\n", {}).find("2:1,567 may be 1567 or 1.567 ") != std::string::npos);
    for (const char* clear : {"4;0,568\n", "4;1568,123\n", "4;1,5\n", "4,5;1568\n"})
        CHECK(faults_with(whole + clear, {}).find("may be") == std::string::npos);
}

TEST_CASE("a row of units, and lines of words below it, are not samples") {
    std::string text = "\"TOA5\",\"x\"\n\"TS\",\"P\",\"Phi\"\n\"TS\",\"bar\",\"degrees\"\n\"\",\"Smp\",\"Smp\"\n";
    for (int i = 0; i < 6; ++i)
        text += fmt::format("\"2024-02-29 23:59:59.{:02}\",{},{}\n", 90 + 2 * i > 99 ? 0 : 90 + 2 * i, 20 + i, i);
    const std::string last = "\"2024-03-01 00:00:00\",25,5\n";
    text.erase(text.rfind("\"2024"));
    const ReadRecord read = read_record(
        text + last, {{}, false, {column_name("time=TS"), column_name("pressure=P"), column_name("angle=Phi")}});
    REQUIRE(read.record);
    CHECK(read.record->description == "\"TOA5\",\"x\"\n");
    CHECK(read.record->time_s == std::vector<double>{0, 0.02, 0.04, 0.06, 0.08, 0.10});
    RecordReader reader({{}, false, {column_name("time=TS"), column_name("pressure=P"), column_name("angle=Phi")}});
    CHECK(!reader.begun_s());
    REQUIRE(reader.read(text + last).record);
    CHECK(reader.begun_s() == 1709251199.9); // by date -ud "2024-02-29 23:59:59" +%s
    CHECK(read.record->of(Link::boom, Sensor::inlet_pressure)[5] == doctest::Approx(25 * 14.5037738));
}

TEST_CASE("times with a zone and times without one are not mixed") {
    std::string text = "time,boom.angle [deg]\n";
    for (int i = 0; i < 6; ++i)
        text += fmt::format("2024-03-05T14:30:00.{:02}{},{}\n", 2 * i, i == 4 ? "" : "Z", i);
    CHECK(faults_with(text, {}) == "6:2024-03-05T14:30:00.08 has no time zone, unlike the times before it ");
}

TEST_CASE("the usual words for a missing reading are recognised, also at the start of a line") {
    for (const char* word :
         {"", "-", "nan", "-nan", "NaN", "NAN", "#N/A", "N/A", "n/a", "NA", "None", "NULL", "null"}) {
        const std::string text = boom_columns + rows(0, 5) + fmt::format("{0},{0},20,0.2\n", word) + rows(6, 11);
        CHECK(!read_record(text).record);
        const ReadRecord skipped = read_record(text, {{}, true});
        REQUIRE((skipped.record && skipped.record->size() == 10));
        CHECK(skipped.faults.front().location.line == 7);
    }
}
