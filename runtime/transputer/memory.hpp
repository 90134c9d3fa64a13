#pragma once

#include "runtime/transputer/model.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <span>
#include <stdexcept>

namespace placedpar::transputer {

static_assert(std::endian::native == std::endian::little, "words of a transputer are stored as the host stores them");

/// The memory of an emulated transputer: bytes from MostNeg on, 0 before the boot. The host gives a page when it is
/// first used. Addresses below are offsets from MostNeg, unless stated otherwise.
class NodeMemory {
public:
    /// Code is forgotten by pages of this size when it is written to.
    static constexpr Word page_bytes = 256;

    /// Throws std::invalid_argument unless 2048 <= bytes < 4 GB and bytes is a multiple of 256; std::bad_alloc.
    /// `bytes_on_chip`: they hide as many bytes at the beginning of the memory outside of the chip, which programs
    /// reach at addresses that wrap.
    NodeMemory(std::uint64_t bytes, Word bytes_on_chip) : size_(static_cast<Word>(bytes)), hidden_(bytes_on_chip) {
        if (bytes < 2048 || bytes > 0xffff'ff00 || bytes % page_bytes != 0)
            throw std::invalid_argument("a transputer's memory has 2048 bytes to 4 Gbyte, in steps of 256");
        bytes_.reset(static_cast<std::uint8_t*>(std::calloc(bytes + hidden_ + 8, 1))); // 8: reals are read as a whole
        pages_.reset(static_cast<std::uint8_t*>(std::calloc((bytes + hidden_) / page_bytes + 1, 1)));
        if (!bytes_ || !pages_)
            throw std::bad_alloc();
    }

    static constexpr Word offset_of(Word address) { return address - most_negative; }
    Word size() const { return size_; }
    /// Returns where an offset outside of the memory is when addresses wrap: in the memory, or in the bytes behind it,
    /// which are those that the memory on the chip hides.
    Word wrapped(Word offset) const {
        offset %= size_;
        return offset < hidden_ ? size_ + offset : offset;
    }
    /// Returns the same for an offset that may be in the memory.
    Word wrapped_or_not(Word offset) const { return offset < size_ ? offset : wrapped(offset); }
    /// Returns the end of the memory, or of the bytes behind it, in which a place is that wrapped() returned.
    Word end_around(Word place) const { return place < size_ ? size_ : size_ + hidden_; }
    bool holds(Word offset, Word bytes) const { return offset <= size_ && bytes <= size_ - offset; }

    std::uint8_t* data() { return bytes_.get(); }
    const std::uint8_t* data() const { return bytes_.get(); }
    /// Returns a flag for each page; not 0 if instructions of the page are decoded.
    std::uint8_t* code_flags() { return pages_.get(); }

    /// Returns whether instructions of a byte's page may be decoded.
    bool has_code(Word offset) const { return pages_[offset / page_bytes] != 0; }
    /// Returns whether instructions of these bytes may be decoded. REQUIRES: holds(offset, bytes), bytes > 0.
    bool has_code(Word offset, Word bytes) const {
        for (Word page = offset / page_bytes; page <= (offset + bytes - 1) / page_bytes; ++page)
            if (pages_[page])
                return true;
        return false;
    }

    /// REQUIRES: holds(offset, 4).
    Word word(Word offset) const {
        Word result;
        std::memcpy(&result, &bytes_[offset], sizeof result);
        return result;
    }
    void set_word(Word offset, Word value) { std::memcpy(&bytes_[offset], &value, sizeof value); }
    std::uint8_t byte(Word offset) const { return bytes_[offset]; }
    std::span<std::uint8_t> bytes(Word offset, Word count) { return {&bytes_[offset], count}; }

private:
    struct Free {
        void operator()(std::uint8_t* p) const { std::free(p); }
    };
    Word size_, hidden_;
    std::unique_ptr<std::uint8_t[], Free> bytes_, pages_;
};

} // namespace placedpar::transputer
