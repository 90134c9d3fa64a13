#include "observe/page/encoding.hpp"

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <zlib.h>

#include <new>

namespace placedpar::page {

void append_number(std::string& bytes, std::uint64_t number) {
    for (; number >= 128; number /= 128)
        bytes += static_cast<char>(number % 128 + 128);
    bytes += static_cast<char>(number);
}

std::string deflated(std::string_view bytes) {
    constexpr int level = 4; // typical output is 5 % larger than at the usual level 6, but takes half the time
    uLongf size = compressBound(bytes.size());
    std::string out(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                  bytes.size(), level) != Z_OK)
        throw std::bad_alloc(); // the only other error would be a buffer that is too small
    out.resize(size);
    return out;
}

std::string base64(std::string_view bytes) {
    using namespace boost::archive::iterators;
    using Digits = base64_from_binary<transform_width<std::string_view::const_iterator, 6, 8>>;
    std::string text(Digits(bytes.begin()), Digits(bytes.end()));
    return text.append((3 - bytes.size() % 3) % 3, '=');
}

} // namespace placedpar::page
