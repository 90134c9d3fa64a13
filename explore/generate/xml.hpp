#pragma once

#include "text/source.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace placedpar::generate {

/// A piece of an XML text: a tag that begins or ends an element, or text between tags.
struct XmlPiece {
    enum class Kind { begin, end, text, nothing_more } kind = Kind::nothing_more;
    std::string name;                                   ///< of the element, without the prefix of its namespace
    std::string text;                                   ///< with entities replaced
    std::map<std::string, std::string> attributes = {}; ///< of the element, by names without prefix
    std::size_t line = 0;
};

/// Reads the pieces of an XML text in order. An empty element gives a beginning and an end. Comments, processing
/// instructions and a document type are skipped. Only the five predefined entities and characters by number are
/// replaced; an own entity is refused, as are elements deeper than `deepest_graph`. Throws RefusedText.
class XmlReader {
public:
    explicit XmlReader(std::shared_ptr<const SourceFile> file) : file_(std::move(file)), left_(file_->text()) {}

    XmlPiece next();

private:
    bool skip_unused();
    std::string_view take(std::size_t bytes);
    std::string_view take_to(std::string_view end, const char* what);
    std::string_view take_tag();
    XmlPiece tag();
    void read_attributes(XmlPiece&, std::string_view tag);
    std::string decoded(std::string_view) const;
    [[noreturn]] void refuse(const std::string& message, const std::string& hint = "") const;

    std::shared_ptr<const SourceFile> file_;
    std::string_view left_;
    std::size_t line_ = 1;
    std::vector<std::string> open_;
    bool end_follows_ = false; ///< the element was empty, so its end is the next piece
};

} // namespace placedpar::generate
