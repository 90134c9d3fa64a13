#pragma once

#include "text/source.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace placedpar::generate {

/// The tag that begins an element. Names have no prefix of a namespace.
struct XmlTag {
    std::string name;
    std::map<std::string, std::string> attributes;
    std::size_t line = 0;
};

/// Receives the parts of an XML text in their order. The functions may throw.
class XmlParts {
public:
    virtual ~XmlParts() = default;
    virtual void begin(const XmlTag&) = 0;
    virtual void end(const std::string& name) = 0;
    /// Receives text between tags, perhaps in several pieces.
    virtual void text(std::string_view) = 0;
};

/// Reads an XML text with the library expat. Throws RefusedText for a text that is not well-formed, that declares
/// entities, or whose elements are nested deeper than `deepest_graph`. Rethrows exceptions of XmlParts.
void read_xml(const std::shared_ptr<const SourceFile>&, XmlParts&);

} // namespace placedpar::generate
