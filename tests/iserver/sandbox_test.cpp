#include <doctest/doctest.h>

#include "tests/iserver/served_program.hpp"
#include "text/user_error.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <thread>
#include <vector>

using namespace placedpar;
using iserver::Bytes;
using test::Request;
using test::ScratchFolder;
using test::ServedProgram;
namespace fs = std::filesystem;

namespace {

/// Checks that no request with this name does anything.
void check_refused(ServedProgram& program, std::string_view name) {
    INFO("name " << std::string(name));
    for (int mode = 1; mode <= 6; ++mode)
        CHECK(program.open(name, mode) == -1);
    CHECK_FALSE(program.succeeds(Request(21).text(name)));
    CHECK_FALSE(program.succeeds(Request(22).text("own").text(name)));
    CHECK_FALSE(program.succeeds(Request(22).text(name).text("stolen")));
}

std::uintmax_t bytes_in(const fs::path& folder) {
    std::uintmax_t bytes = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
        bytes += entry.is_regular_file() ? entry.file_size() : 0;
    return bytes;
}

} // namespace

TEST_CASE("without a folder there are no files") {
    ServedProgram program;
    check_refused(program, "file");
    CHECK_THROWS_WITH_AS(ServedProgram({.host_folder = "/nowhere/at/all"}),
                         "cannot use \"/nowhere/at/all\" as the host's folder: No such file or directory", UserError);
    CHECK_THROWS_AS(ServedProgram({.host_folder = "/dev/null"}), UserError);
}

TEST_CASE("names lead to files below the folder only") {
    ScratchFolder folder;
    fs::create_directories(folder.path() / "a/b");
    folder.write("own", "own");
    ServedProgram program({.host_folder = folder.path()});
    for (const char* name : {"a/b/file", "./file", "a//file", "a/./file", "..file", "a/...", "file name", "xy:z"})
        CHECK(program.open(name, 2) >= 3);
    for (const std::string& name : {std::string(),
                                    std::string("/"),
                                    folder.secret().string(),
                                    std::string(".."),
                                    std::string("../secret"),
                                    std::string("a/../../secret"),
                                    std::string("a/b/../../../secret"),
                                    std::string("./../secret"),
                                    std::string("a/.."),
                                    std::string("a/../own"),
                                    std::string("c:own"),
                                    std::string("C:\\own"),
                                    std::string("own\0x", 5),
                                    std::string("own\n"),
                                    std::string("\x1b[2J"),
                                    std::string("own/"),
                                    std::string("a/b"),
                                    std::string("a"),
                                    std::string("."),
                                    std::string("own/own"),
                                    std::string("absent/own"),
                                    std::string("/own"),
                                    std::string(256, 'x'),
                                    std::string(400, 'y')})
        check_refused(program, name);
    CHECK(program.open(std::string(255, 'x'), 2) >= 3);
    std::string long_way = "own";
    while (long_way.size() <= 255) {
        CHECK(program.succeeds(Request(11).word(program.open(long_way, 1))));
        long_way = "./" + long_way;
    }
    check_refused(program, long_way);
    CHECK(folder.content("own") == "own");
    CHECK(folder.content("../secret") == "unseen");
}

TEST_CASE("no link is followed, at the end of a name or before") {
    ScratchFolder folder;
    folder.write("own", "own");
    fs::create_directory(folder.path() / "inside");
    fs::create_symlink(folder.secret(), folder.path() / "absolute");
    fs::create_symlink("../secret", folder.path() / "relative");
    fs::create_symlink("..", folder.path() / "up");
    fs::create_symlink("/", folder.path() / "root");
    fs::create_symlink("inside", folder.path() / "sibling");
    fs::create_symlink("../new", folder.path() / "dangling");
    fs::create_symlink("chain", folder.path() / "chain");
    ServedProgram program({.host_folder = folder.path()});
    for (const char* name : {"absolute", "relative", "up/secret", "root/etc/passwd", "sibling/file", "dangling",
                             "chain", "inside/../up/secret"})
        check_refused(program, name);
    CHECK(folder.content("../secret") == "unseen");
    CHECK_FALSE(fs::exists(folder.path() / "../new"));
    CHECK(fs::is_symlink(folder.path() / "relative"));
    CHECK(fs::is_empty(folder.path() / "inside"));
}

TEST_CASE("the folder itself may be reached by a link") {
    ScratchFolder folder;
    folder.write("own", "own");
    fs::create_directory_symlink(folder.path(), folder.path() / "../shortcut");
    ServedProgram program({.host_folder = folder.path() / "../shortcut"});
    CHECK(program.read(program.open("own", 1), 10) == "own");
}

TEST_CASE("a folder or file that is exchanged for a link at the same time leads nowhere else") {
    ScratchFolder folder;
    const fs::path here = folder.path();
    fs::create_directories(here / "a");
    fs::create_directories(here / "../outside");
    folder.write("a/file", "inside");
    folder.write("file", "inside");
    folder.write("../outside/file", "unseen");
    fs::create_symlink("../outside", here / "folder-link");
    fs::create_symlink("../secret", here / "file-link");
    std::atomic<bool> over = false;
    std::thread exchanger([&] {
        while (!over)
            for (auto [one, other] : {std::pair{"a", "folder-link"}, {"file", "file-link"}})
                ::renameat2(AT_FDCWD, (here / one).c_str(), AT_FDCWD, (here / other).c_str(), RENAME_EXCHANGE);
    });
    ServedProgram program({.host_folder = here});
    int opened = 0;
    int leaks = 0;
    for (int attempt = 0; attempt < 5'000; ++attempt)
        for (const std::string name : {"a/file", "folder-link/file", "file", "file-link"})
            if (std::int64_t stream = program.open(name, 4); stream >= 0) {
                ++opened;
                leaks += program.read(stream, 100) == "inside" ? 0 : 1;
                program.reply(Request(11).word(stream));
            }
    over = true;
    exchanger.join();
    CHECK(opened > 0);
    CHECK(leaks == 0);
}

TEST_CASE("pipes, devices and folders are not opened, and nothing waits for them") {
    ScratchFolder folder;
    folder.write("own", "own");
    ::mkfifo((folder.path() / "pipe").c_str(), 0600);
    ::mknod((folder.path() / "null").c_str(), S_IFCHR | 0600, makedev(1, 3)); // fails without privileges
    fs::create_directory(folder.path() / "folder");
    ServedProgram program({.host_folder = folder.path()});
    for (const char* name : {"pipe", "null", "folder"})
        if (fs::exists(folder.path() / name))
            check_refused(program, name);
    CHECK(fs::exists(folder.path() / "pipe"));
    CHECK(fs::is_empty(folder.path() / "folder"));
    CHECK(folder.content("own") == "own");
}

TEST_CASE("a hundred thousand opens take 253 streams and no more of the host") {
    ScratchFolder folder;
    folder.write("file", "x");
    ServedProgram program({.host_folder = folder.path()});
    int opened = 0;
    for (int attempt = 0; attempt < 100'000; ++attempt)
        opened += program.open("file", 1) >= 0 ? 1 : 0;
    CHECK(opened == 253);
    const std::ptrdiff_t descriptors = std::distance(fs::directory_iterator("/proc/self/fd"), {});
    CHECK(descriptors < 300);
    CHECK(program.succeeds(Request(11).word(100)));
    CHECK(program.open("file", 1) == 100);
    CHECK(program.open("file", 1) == -1);
}

TEST_CASE("a program without free descriptors fails to open, and goes on") {
    ScratchFolder folder;
    folder.write("file", "x");
    ServedProgram program({.host_folder = folder.path()});
    rlimit usual{};
    ::getrlimit(RLIMIT_NOFILE, &usual);
    const rlimit few{.rlim_cur = 20, .rlim_max = usual.rlim_max};
    ::setrlimit(RLIMIT_NOFILE, &few);
    int opened = 0;
    while (program.open("file", 1) >= 0 && opened < 100)
        ++opened;
    ::setrlimit(RLIMIT_NOFILE, &usual);
    CHECK(opened < 20);
    CHECK(program.open("file", 1) >= 3);
}

TEST_CASE("what a program writes is limited over all files, modes and the terminal") {
    ScratchFolder folder;
    const std::uint64_t limit = 100'000;
    ServedProgram program({.host_folder = folder.path(), .write_limit_bytes = limit});
    const std::string block(500, 'x');
    std::size_t written = 0;
    for (int round = 0; round < 1000; ++round)
        for (int mode : {2, 3, 5, 6}) {
            const std::int64_t stream = program.open("file" + std::to_string(mode), mode);
            written += program.write(stream, block);
            program.reply(Request(11).word(stream));
        }
    CHECK(written == limit - 4 * iserver::WriteQuota::new_file);
    CHECK(program.server().exceeded_write_limit());
    CHECK(bytes_in(folder.path()) < limit);
    CHECK(program.write(1, "x") == 0);
    CHECK(program.screen() == "");
    const std::int64_t stream = program.open("file2", 3);
    CHECK(program.reply(Request(13).word(stream).text("more")) == Bytes{6, 0, 0, 0, 0, 0, 0, 0});
    CHECK(program.reply(Request(24).word(stream).text("more"))[2] == 129);
    CHECK(program.reply(Request(15).word(stream).text("more"))[2] == 129);
    CHECK(program.reply(Request(20).word(stream))[2] == 0); // there was an error
}

TEST_CASE("a write that only partly fits is cut at the limit") {
    ScratchFolder folder;
    ServedProgram program({.host_folder = folder.path(), .write_limit_bytes = 4096 + 7});
    const std::int64_t stream = program.open("file", 2);
    CHECK_FALSE(program.server().exceeded_write_limit());
    CHECK(program.write(stream, "0123456789") == 7);
    CHECK(folder.content("file") == "0123456");
    CHECK(program.server().exceeded_write_limit());
}

TEST_CASE("a write far beyond the end of a file counts as all that it adds") {
    ScratchFolder folder;
    folder.write("file", "0123456789");
    ServedProgram program({.host_folder = folder.path(), .write_limit_bytes = 1000});
    const std::int64_t stream = program.open("file", 4);
    auto write_at = [&](std::int64_t position) {
        CHECK(program.succeeds(Request(17).word(stream).word(position).word(1)));
        return program.write(stream, "end");
    };
    CHECK(write_at(0x7ffffff0) == 0);
    CHECK(fs::file_size(folder.path() / "file") == 10);
    CHECK(write_at(110) == 3);
    CHECK(fs::file_size(folder.path() / "file") == 113);
    CHECK(write_at(1010) == 0); // 1000 - 103 are left: too few for the gap of 897 bytes and any more
    CHECK(write_at(1009) == 1);
    CHECK(fs::file_size(folder.path() / "file") == 1010);
}

TEST_CASE("a program cannot make files without end") {
    ScratchFolder folder;
    ServedProgram program({.host_folder = folder.path(), .write_limit_bytes = 10 * iserver::WriteQuota::new_file});
    int made = 0;
    for (int file = 0; file < 1000; ++file) {
        const std::int64_t stream = program.open("file" + std::to_string(file), 2);
        made += stream >= 0 ? 1 : 0;
        program.reply(Request(11).word(stream));
    }
    CHECK(made == 10);
    CHECK(std::distance(fs::directory_iterator(folder.path()), {}) == 10);
}
