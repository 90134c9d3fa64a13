#pragma once

#include "tests/scratch.hpp"

#include <sys/resource.h>

#include <csignal>
#include <cstddef>

/// While the object exists, the size of all files is limited, as on a full disk.
class FullDisk {
public:
    explicit FullDisk(std::size_t bytes) : former_signal_(std::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &former_);
        rlimit limit{bytes, former_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FullDisk() {
        ::setrlimit(RLIMIT_FSIZE, &former_);
        std::signal(SIGXFSZ, former_signal_);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

private:
    rlimit former_{};
    void (*former_signal_)(int);
};
