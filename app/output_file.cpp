#include "app/output_file.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace placedpar {

namespace {

namespace fs = std::filesystem;

fs::path temporary_beside(const fs::path& path) {
    fs::path temporary = path;
    temporary += fmt::format(".{}.part", ::getpid());
    return temporary;
}

[[noreturn]] void refuse(const fs::path& path, int error) {
    throw std::runtime_error(fmt::format("{}: cannot be written: {}", path.string(), std::strerror(error)));
}

} // namespace

void write_whole(const fs::path& path, std::string_view content) {
    fs::path temporary = temporary_beside(path);
    std::FILE* file = std::fopen(temporary.c_str(), "wb");
    if (!file)
        refuse(path, errno);
    bool written = std::fwrite(content.data(), 1, content.size(), file) == content.size();
    int error = errno;
    written = std::fclose(file) == 0 && written;
    if (written && std::rename(temporary.c_str(), path.c_str()) == 0)
        return;
    error = written ? errno : error;
    std::remove(temporary.c_str());
    refuse(path, error);
}

void require_writable(const fs::path& path) {
    if (fs::is_directory(path))
        refuse(path, EISDIR);
    fs::path temporary = temporary_beside(path);
    std::FILE* file = std::fopen(temporary.c_str(), "wb");
    if (!file)
        refuse(path, errno);
    std::fclose(file);
    std::remove(temporary.c_str());
}

} // namespace placedpar
