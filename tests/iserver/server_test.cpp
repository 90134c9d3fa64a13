#include <doctest/doctest.h>

#include "tests/iserver/served_program.hpp"
#include "text/user_error.hpp"

using namespace placedpar;
using iserver::Bytes;
using iserver::ServerState;
using test::Request;
using test::ScratchFolder;
using test::ServedProgram;
using test::text_of;
using test::word_of;
using namespace std::chrono_literals;

namespace {

const Bytes done{6, 0, 0, 0, 0, 0, 0, 0};
const Bytes failed{6, 0, 129, 0, 0, 0, 0, 0};
const Bytes not_implemented{6, 0, 1, 0, 0, 0, 0, 0};

/// Returns the time of tag 33 after a microsecond count.
std::int64_t time_after(ServedProgram& program, std::chrono::microseconds passed) {
    return word_of(program.answer(Request(33), passed).reply);
}

} // namespace

TEST_CASE("a file is written, read back and closed") {
    ScratchFolder folder;
    ServedProgram program({.host_folder = folder.path()});
    CHECK(program.reply(Request(10).text("new").byte(1).byte(2)) == Bytes{6, 0, 0, 3, 0, 0, 0, 0});
    CHECK(program.reply(Request(13).word(3).text("hello\nworld")) == Bytes{6, 0, 0, 11, 0, 0, 0, 0});
    CHECK(folder.content("new") == "hello\nworld");
    CHECK(program.reply(Request(11).word(3)) == done);
    CHECK(program.reply(Request(11).word(3)) == failed);
    REQUIRE(program.open("new", 1) == 3);
    CHECK(program.reply(Request(12).word(3).count(4)) == Bytes{8, 0, 0, 4, 0, 'h', 'e', 'l', 'l', 0});
    CHECK(program.read(3, 500) == "o\nworld");
    CHECK(program.reply(Request(12).word(3).count(4)) == done);
}

TEST_CASE("a read never returns more than a packet holds") {
    ScratchFolder folder;
    folder.write("long", std::string(2000, 'x'));
    ServedProgram program({.host_folder = folder.path()});
    const std::int64_t stream = program.open("long", 1);
    CHECK(program.reply(Request(12).word(stream).count(65535)).size() == 512);
    CHECK(program.reply(Request(23).word(stream).count(507)).size() == 512);
    CHECK(text_of(program.reply(Request(14).word(stream).count(65535))).size() == 507);
    CHECK(program.read(stream, 65535).size() == 2000 - 3 * 507);
}

TEST_CASE("the six modes of opening are those of fopen") {
    ScratchFolder folder;
    ServedProgram program({.host_folder = folder.path()});
    for (int mode : {1, 4})
        CHECK(program.open("absent", mode) == -1);
    struct Expected {
        int mode;
        std::string read;    ///< by a program that opens the file, which has "old"
        std::string content; ///< after it has written "+" there
    };
    for (const Expected& each : {Expected{1, "old", "old"}, Expected{2, "", "+"}, Expected{3, "", "old+"},
                                 Expected{4, "old", "old+"}, Expected{5, "", "+"}, Expected{6, "old", "old+"}}) {
        INFO("mode " << each.mode);
        folder.write("file", "old");
        const std::int64_t stream = program.open("file", each.mode, 2);
        CHECK(program.read(stream, 100) == each.read);
        program.write(stream, "+");
        CHECK(folder.content("file") == each.content);
        CHECK(program.succeeds(Request(11).word(stream)));
        CHECK((program.open("made" + std::to_string(each.mode), each.mode) >= 0) == (each.mode != 1 && each.mode != 4));
    }
    for (int mode : {0, 7, 255})
        CHECK(program.open("file", mode) == -1);
    for (int type : {0, 3})
        CHECK(program.open("file", 1, type) == -1);
    CHECK(folder.content("file") == "old+");
}

TEST_CASE("an append goes to the end, wherever the program sought") {
    ScratchFolder folder;
    folder.write("file", "old");
    ServedProgram program({.host_folder = folder.path()});
    const std::int64_t stream = program.open("file", 6);
    CHECK(program.succeeds(Request(17).word(stream).word(0).word(1)));
    CHECK(program.write(stream, "new") == 3);
    CHECK(folder.content("file") == "oldnew");
    ServedProgram limited({.host_folder = folder.path(), .write_limit_bytes = 100});
    const std::int64_t other = limited.open("file", 3);
    CHECK(limited.succeeds(Request(17).word(other).word(1000).word(1)));
    CHECK(limited.write(other, "more") == 4); // no gap is filled
}

TEST_CASE("seek and tell count from the start, here and the end") {
    ScratchFolder folder;
    folder.write("file", "0123456789");
    ServedProgram program({.host_folder = folder.path()});
    const std::int64_t stream = program.open("file", 4);
    auto after = [&](std::int64_t offset, std::int64_t origin) {
        CHECK(program.reply(Request(17).word(stream).word(offset).word(origin)) == done);
        return word_of(program.reply(Request(18).word(stream)));
    };
    CHECK(after(4, 1) == 4);
    CHECK(after(-1, 2) == 3);
    CHECK(program.read(stream, 2) == "34");
    CHECK(after(-2, 3) == 8);
    CHECK(after(0x7fffffff, 1) == 0x7fffffff);
    for (std::int64_t origin : {0, 4, -1})
        CHECK(program.reply(Request(17).word(stream).word(0).word(origin)) == failed);
    CHECK(program.reply(Request(17).word(stream).word(-1).word(1)) == failed);
    CHECK(program.reply(Request(17).word(stream).word(1).word(2)) == failed); // beyond 31 bits
    CHECK(word_of(program.reply(Request(18).word(stream))) == 0x7fffffff);
}

TEST_CASE("the end of a file is met by the read that finds nothing more") {
    ScratchFolder folder;
    folder.write("file", "ab");
    ServedProgram program({.host_folder = folder.path()});
    const std::int64_t stream = program.open("file", 1);
    CHECK(program.read(stream, 2) == "ab");
    CHECK(program.reply(Request(19).word(stream)) == failed);
    CHECK(program.reply(Request(23).word(stream).count(1)) == failed);
    CHECK(program.reply(Request(19).word(stream)) == done);
    CHECK(program.succeeds(Request(17).word(stream).word(0).word(1)));
    CHECK(program.reply(Request(19).word(stream)) == failed);
    CHECK(text_of(program.reply(Request(23).word(stream).count(9))) == "ab");
    CHECK(program.reply(Request(19).word(stream)) == done);
}

TEST_CASE("lines come without their newline, and long ones in parts") {
    ScratchFolder folder;
    folder.write("file", "one\n\nthree\r\nfo");
    ServedProgram program({.host_folder = folder.path()});
    const std::int64_t stream = program.open("file", 1);
    auto next = [&](std::size_t most) { return text_of(program.reply(Request(14).word(stream).count(most))); };
    CHECK(next(100) == "one");
    CHECK(next(100) == "");
    CHECK(next(4) == "thre");
    CHECK(program.reply(Request(19).word(stream)) == failed);
    CHECK(next(100) == "e\r"); // text mode changes nothing
    CHECK(program.reply(Request(19).word(stream)) == failed);
    CHECK(next(100) == "fo");
    CHECK(program.reply(Request(19).word(stream)) == done);
    CHECK(program.reply(Request(14).word(stream).count(100)) == failed);
}

TEST_CASE("put line, put block and flush write to a file") {
    ScratchFolder folder;
    ServedProgram program({.host_folder = folder.path()});
    const std::int64_t stream = program.open("file", 2);
    CHECK(program.reply(Request(15).word(stream).text("one")) == done);
    CHECK(program.reply(Request(24).word(stream).text("two")) == Bytes{6, 0, 0, 3, 0, 0, 0, 0});
    CHECK(program.reply(Request(24).word(stream).text("")) == failed);
    CHECK(program.reply(Request(16).word(stream)) == done);
    CHECK(folder.content("file") == "one\ntwo");
}

TEST_CASE("an error of a stream has a number and a message") {
    ScratchFolder folder;
    folder.write("file", "x");
    ServedProgram program({.host_folder = folder.path()});
    const std::int64_t stream = program.open("file", 1);
    CHECK(program.reply(Request(20).word(stream)) == failed);
    CHECK(program.write(stream, "x") == 0);
    const Bytes error = program.reply(Request(20).word(stream));
    CHECK(error.at(2) == 0);
    CHECK(word_of(error) == EBADF);
    CHECK(std::string(error.begin() + 9, error.begin() + 9 + error.at(7)) == "Bad file descriptor");
}

TEST_CASE("files are removed and renamed") {
    ScratchFolder folder;
    folder.write("one", "1");
    folder.write("two", "2");
    ServedProgram program({.host_folder = folder.path()});
    CHECK(program.reply(Request(22).text("one").text("three")) == done);
    CHECK(program.reply(Request(22).text("one").text("three")) == failed);
    CHECK(program.reply(Request(22).text("three").text("two")) == done);
    CHECK(folder.content("two") == "1");
    CHECK(program.reply(Request(21).text("two")) == done);
    CHECK(program.reply(Request(21).text("two")) == failed);
    CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("streams 0, 1 and 2 are the terminal") {
    ServedProgram program({}, "first line\nsecond\nrest");
    CHECK(program.write(1, "out\x01\x1b[") == 6);
    CHECK(program.write(2, "1mcolour") == 8);
    CHECK(program.screen() == "out^A\x1b[1mcolour");
    CHECK(program.reply(Request(15).word(1).text("line")) == done);
    CHECK(text_of(program.reply(Request(14).word(0).count(100))) == "first line");
    CHECK(program.read(0, 3) == "sec");
    CHECK(program.read(0, 100) == "ond\nrest");
    CHECK(program.reply(Request(19).word(0)) == done);
    CHECK(program.read(0, 100) == "");
    CHECK(program.reply(Request(14).word(0).count(100)) == failed);
    for (std::int64_t stream : {0, 1, 2}) {
        CHECK(program.reply(Request(17).word(stream).word(0).word(1)) == failed);
        CHECK(program.reply(Request(18).word(stream)) == failed);
        CHECK(program.reply(Request(25).word(stream)) == done);
        CHECK(program.reply(Request(11).word(stream)) == done);
    }
    CHECK(program.read(1, 100) == "");
    CHECK(program.write(0, "x") == 0);
    CHECK(program.write(1, "still ") == 6);
    CHECK(program.write(2, "open") == 4);
    program.server().finish();
    CHECK(program.screen() == "out^A\x1b[1mcolourline\nstill open\x1b[0m");
}

TEST_CASE("a stream that nobody opened fails in every request") {
    ServedProgram program;
    for (std::int64_t stream : {3L, 255L, 256L, -1L, 0x7fffffffL, -0x80000000L})
        for (int tag : {11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 23, 24, 25}) {
            Request request(static_cast<std::uint8_t>(tag));
            request.word(stream).count(1).byte('x').word(0).word(0);
            CHECK(program.reply(request) == failed);
        }
}

TEST_CASE("keys come one by one") {
    ServedProgram program({}, "ab\xff");
    CHECK(program.reply(Request(30)) == Bytes{6, 0, 0, 'a', 0, 0, 0, 0});
    CHECK(program.reply(Request(31)) == Bytes{6, 0, 0, 'b', 0, 0, 0, 0});
    CHECK(program.reply(Request(31)) == Bytes{6, 0, 0, 0xff, 0, 0, 0, 0});
    CHECK(program.reply(Request(31)) == failed);
}

TEST_CASE("a program that waits for a key that will not come is reported") {
    ServedProgram program({}, "a");
    CHECK(program.answer(Request(30)).state == ServerState::running);
    const iserver::Answer answer = program.answer(Request(30));
    CHECK(answer.state == ServerState::waits_for_input);
    CHECK(answer.reply.empty());
    CHECK(program.answer(Request(33)).state == ServerState::waits_for_input);
}

TEST_CASE("a program may poll for a key while it works, but not for ever") {
    ServedProgram program;
    for (std::size_t poll = 1; poll < iserver::Server::most_polls; ++poll)
        REQUIRE(program.answer(Request(31)).state == ServerState::running);
    CHECK(program.server().was_out_of_keys());
    CHECK(program.succeeds(Request(19).word(0))); // eof
    CHECK(program.write(1, ".") == 1);
    for (std::size_t poll = 1; poll < iserver::Server::most_polls; ++poll)
        REQUIRE(program.answer(Request(31)).reply == failed);
    CHECK(program.answer(Request(31)).state == ServerState::waits_for_input);
}

TEST_CASE("a program that asks again and again for a line after the end is reported") {
    ServedProgram program;
    std::size_t requests = 0;
    while (program.answer(Request(14).word(0).count(80)).state == ServerState::running && requests < 10'000) {
        program.write(1, "Your name? ");
        ++requests;
    }
    CHECK(requests == iserver::Server::most_requests_at_end);
}

TEST_CASE("the environment is what was given") {
    ServedProgram program({.environment = {{"IBOARDSIZE", "#200000"}, {"EMPTY", ""}}});
    CHECK(text_of(program.reply(Request(32).text("IBOARDSIZE"))) == "#200000");
    CHECK(program.reply(Request(32).text("EMPTY")) == done);
    for (const char* name : {"PATH", "HOME", "iboardsize", ""})
        CHECK(program.reply(Request(32).text(name)) == failed);
}

TEST_CASE("the date is a fixed one plus the time of the run") {
    ServedProgram program;
    CHECK(time_after(program, 0us) == 662'688'000); // date -u -d 1991-01-01 +%s
    CHECK(time_after(program, 999'999us) == 662'688'000);
    CHECK(time_after(program, 61s) == 662'688'061);
    const Bytes reply = program.answer(Request(33), 5s).reply;
    CHECK(reply.size() == 12);
    CHECK(word_of(reply, 7) == 662'688'005);
    ServedProgram later({.date = std::chrono::sys_days(std::chrono::year(2026) / 11 / 28)});
    CHECK(time_after(later, 0us) == 1'795'824'000);
}

TEST_CASE("no command of the host is executed") {
    ScratchFolder folder;
    ServedProgram program({.host_folder = folder.path()});
    CHECK(program.reply(Request(34).text("touch " + (folder.path() / "made").string())) == failed);
    CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("a program ends with success, with failure or with its own status") {
    for (auto [status, expected] : {std::pair{999'999'999, 0}, {-999'999'999, 1}, {0, 0}, {7, 7}, {-1, -1}}) {
        ServedProgram program;
        const iserver::Answer answer = program.answer(Request(35).word(status));
        CHECK(answer.reply == done);
        CHECK(answer.state == ServerState::exited);
        CHECK(answer.exit == expected);
        CHECK(program.answer(Request(42)).reply.empty());
    }
    ServedProgram program;
    program.write(1, "\x1b[31");
    program.reply(Request(35).word(0));
    CHECK(program.screen() == "^[[31");
}

TEST_CASE("the command line comes without and with the server's own options") {
    ServedProgram program({.command_line = "10 20", .whole_command_line = "run x.btl -- 10 20"});
    CHECK(text_of(program.reply(Request(40).byte(0))) == "10 20");
    CHECK(text_of(program.reply(Request(40).byte(1))) == "run x.btl -- 10 20");
    CHECK_THROWS_WITH_AS(ServedProgram({.command_line = std::string(508, 'x')}),
                         "the program's command line has 508 bytes; a reply of the host's server can hold at most 507",
                         UserError);
    CHECK_THROWS_WITH_AS(
        ServedProgram({.environment = {{"LONG", std::string(600, 'x')}}}),
        "the value of \"LONG\" in the environment has 600 bytes; a reply of the host's server can hold at most 507",
        UserError);
}

TEST_CASE("memory that was read before the boot is returned in parts") {
    ServedProgram program({.core = Bytes{10, 11, 12, 13, 14}});
    CHECK(program.reply(Request(41).word(1).count(3)) == Bytes{6, 0, 0, 3, 0, 11, 12, 13});
    CHECK(text_of(program.reply(Request(41).word(3).count(500))) == "\x0d\x0e");
    CHECK(program.reply(Request(41).word(0).count(0)) == done);
    for (std::int64_t offset : {5L, -1L, 0x7fffffffL})
        CHECK(program.reply(Request(41).word(offset).count(1)) == failed);
    ServedProgram without;
    CHECK(without.reply(Request(41).word(0).count(0)) == failed);
}

TEST_CASE("the server is version 1.0 on a Sun-3 with a B008") {
    ServedProgram program;
    CHECK(program.reply(Request(42)) == Bytes{6, 0, 0, 10, 4, 4, 2, 0});
}

TEST_CASE("an unknown request is not implemented, and a request that is too short fails") {
    ScratchFolder folder;
    ServedProgram program({.host_folder = folder.path()});
    for (int tag : {0, 9, 26, 29, 36, 39, 43, 50, 128, 255})
        CHECK(program.reply(Request(static_cast<std::uint8_t>(tag)).word(0)) == not_implemented);
    CHECK(program.server().answer({}, 0us).reply == failed);
    CHECK(program.reply(Request(10).count(400).byte('a').byte(1).byte(2)) == failed);
    const std::int64_t stream = program.open("file", 2);
    for (int tag : {13, 15, 24})
        CHECK(program.reply(Request(static_cast<std::uint8_t>(tag)).word(stream).count(9).byte('x')) == failed);
    CHECK(folder.content("file") == "");
    CHECK(program.reply(Request(22).text("file").count(9)) == failed);
    CHECK(program.answer(Request(35).count(1)).state == ServerState::running);
}
