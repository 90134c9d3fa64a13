#include "editor/protocol/file_uri.hpp"
#include "editor/protocol/message_stream.hpp"
#include "editor/server.hpp"

#include <doctest/doctest.h>

#include <sstream>
#include <string>
#include <vector>

namespace placedpar::editor {

TEST_CASE("messages are read from a stream, also behind what is none") {
    std::istringstream in("Content-Length: 2\r\n\r\n{}"
                          "garbage\r\n\r\n"
                          "content-length:3\r\nContent-Type: text\r\n\r\n[1]"
                          "rest of a messageContent-Length: 4\n\nnull"
                          "Content-Length: 9\r\n\r\ncut");
    std::ostringstream out;
    MessageStream stream(in, out);
    CHECK(stream.read() == "{}");
    CHECK_THROWS_AS(stream.read(), BadHeader);
    CHECK(stream.read() == "[1]");
    CHECK(stream.read() == "null");
    CHECK(stream.has_more());
    CHECK_FALSE(stream.read());
    stream.write("[]");
    CHECK(out.str() == "Content-Length: 2\r\n\r\n[]");
}

TEST_CASE("a file's URI and its path name each other") {
    CHECK(path_of_uri("file:///a%20b/%C3%A9.cfs") == "/a b/\xc3\xa9.cfs");
    CHECK(path_of_uri("file://host/a/../b.occ") == "/b.occ");
    CHECK_FALSE(path_of_uri("untitled:Untitled-1"));
    CHECK_FALSE(path_of_uri("file://"));
    CHECK(path_of_uri("file:///100%/%4") == "/100%/%4");
    CHECK(uri_of_path("/a b/\xc3\xa9#?.cfs") == "file:///a%20b/%C3%A9%23%3F.cfs");
    CHECK(path_of_uri(uri_of_path("/x/%41:+ y")) == "/x/%41:+ y");
}

TEST_CASE("a text that was never saved is checked") {
    std::vector<std::string> sent;
    LanguageServer server([&](const std::string& message) { sent.push_back(message); });
    server.take(R"({"id": 1, "method": "initialize", "params": {}})");
    server.take(R"({"method": "textDocument/didOpen", "params": {"textDocument":
        {"uri": "untitled:Untitled-1", "languageId": "occam", "version": 1, "text": "PROC p ()\n  x := 1\n:\n"}}})");
    REQUIRE(sent.size() == 1);
    server.publish();
    REQUIRE(sent.size() == 2);
    CHECK(
        sent.back().find(R"("uri":"untitled:Untitled-1","diagnostics":[{"range":{"start":{"line":1,"character":2})") !=
        std::string::npos);
}

} // namespace placedpar::editor
