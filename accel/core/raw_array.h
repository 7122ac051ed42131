#pragma once

#include "accel/core/pages.h"

#include <cstring>
#include <memory>
#include <type_traits>

/// Memory that a builder fills itself.
namespace rayshoot::inline RAYSHOOT_ISA {

/// A fixed number of elements, each written before it is read: none is touched by the constructor.
template <class T>
requires std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>
class RawArray {
public:
    RawArray() = default;
    explicit RawArray(std::size_t size, PageUse use = PageUse::dense)
        : elements_(static_cast<T*>(allocate_pages(size * sizeof(T), use))), size_(size) {}

    RawArray copy() const {
        RawArray copied(size_);
        std::memcpy(static_cast<void*>(copied.data()), data(), size_ * sizeof(T));
        return copied;
    }

    /// Gives up the elements from `size` on; their memory stays, but if none was touched yet the
    /// system has none there.
    void shrink(std::size_t size) { size_ = size; }

    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    T* data() { return elements_.get(); }
    const T* data() const { return elements_.get(); }
    T& operator[](std::size_t i) { return elements_.get()[i]; }
    const T& operator[](std::size_t i) const { return elements_.get()[i]; }
    const T& front() const { return elements_.get()[0]; }
    T* begin() { return data(); }
    T* end() { return data() + size_; }
    const T* begin() const { return data(); }
    const T* end() const { return data() + size_; }

private:
    struct Free {
        void operator()(T* pages) const { free_pages(pages); }
    };
    std::unique_ptr<T, Free> elements_;
    std::size_t size_ = 0;
};

}  // namespace rayshoot::inline RAYSHOOT_ISA
