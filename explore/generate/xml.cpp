#include "explore/generate/xml.hpp"

#include "explore/generate/graph.hpp"

#include <fmt/format.h>

#include <expat.h>

#include <exception>
#include <type_traits>

namespace placedpar::generate {

namespace {

std::string local_name(std::string_view name) { return std::string(name.substr(name.find(':') + 1)); }

/// Passes the parts that expat finds to an XmlParts. An exception must not cross expat's functions, which are written
/// in C, so it is stored, and thrown when expat has returned.
class XmlReading {
public:
    XmlReading(const std::shared_ptr<const SourceFile>& file, XmlParts& parts)
        : file_(file), parts_(parts), parser_(XML_ParserCreate(nullptr)) {
        XML_SetUserData(parser_.get(), this);
        XML_SetElementHandler(
            parser_.get(),
            [](void* self, const char* name, const char** attributes) {
                of(self).guard([&] { of(self).begin(name, attributes); });
            },
            [](void* self, const char* name) { of(self).guard([&] { of(self).end(name); }); });
        XML_SetCharacterDataHandler(parser_.get(), [](void* self, const char* text, int bytes) {
            of(self).guard([&] { of(self).parts_.text({text, static_cast<std::size_t>(bytes)}); });
        });
        XML_SetEntityDeclHandler(parser_.get(), [](void* self, const char*, int, const char*, int, const char*,
                                                   const char*, const char*, const char*) {
            of(self).guard([&] {
                of(self).refuse("the document type declares entities",
                                "remove the declarations: a graph in GraphML needs none");
            });
        });
    }

    void read() {
        const std::string& text = file_->text();
        const XML_Status status = XML_Parse(parser_.get(), text.data(), static_cast<int>(text.size()), XML_TRUE);
        if (thrown_)
            std::rethrow_exception(thrown_);
        if (status != XML_STATUS_OK)
            refuse(fmt::format("this is not well-formed XML: {}", XML_ErrorString(XML_GetErrorCode(parser_.get()))));
    }

private:
    static XmlReading& of(void* self) { return *static_cast<XmlReading*>(self); }

    template <class Action>
    void guard(Action action) {
        if (thrown_)
            return; // expat may still call handlers after it was stopped
        try {
            action();
        } catch (...) {
            thrown_ = std::current_exception();
            XML_StopParser(parser_.get(), XML_FALSE);
        }
    }

    void begin(const char* name, const char** attributes) {
        if (++depth_ > deepest_graph)
            refuse(fmt::format("the elements are nested deeper than {} levels", deepest_graph));
        XmlTag tag{.name = local_name(name), .attributes = {}, .line = line()};
        for (; *attributes; attributes += 2)
            tag.attributes[local_name(attributes[0])] = attributes[1];
        parts_.begin(tag);
    }

    void end(const char* name) {
        --depth_;
        parts_.end(local_name(name));
    }

    std::size_t line() const { return XML_GetCurrentLineNumber(parser_.get()); }
    [[noreturn]] void refuse(const std::string& message, const std::string& hint = "") const {
        refuse_graph(file_, line(), message, hint);
    }

    std::shared_ptr<const SourceFile> file_;
    XmlParts& parts_;
    struct Free {
        void operator()(XML_Parser parser) const { XML_ParserFree(parser); }
    };
    std::unique_ptr<std::remove_pointer_t<XML_Parser>, Free> parser_;
    std::size_t depth_ = 0;
    std::exception_ptr thrown_;
};

} // namespace

void read_xml(const std::shared_ptr<const SourceFile>& file, XmlParts& parts) { XmlReading(file, parts).read(); }

} // namespace placedpar::generate
