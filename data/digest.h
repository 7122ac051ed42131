#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

/// SHA-256 of values, the same on every machine: numbers go in little-endian.
namespace rayshoot {

class Digest {
public:
    Digest();
    ~Digest();
    Digest(Digest&&) noexcept;
    Digest& operator=(Digest&&) noexcept;

    void add(std::span<const std::byte> bytes);
    void add(std::string_view text);  ///< its length, then its bytes

    template <class Number>
    requires std::integral<Number> || std::floating_point<Number>
    void add(Number value) {
        auto bytes = std::bit_cast<std::array<std::byte, sizeof(Number)>>(value);
        if constexpr (std::endian::native == std::endian::big) std::ranges::reverse(bytes);
        add(std::span<const std::byte>(bytes));
    }

    /// 64 lower-case hexadecimal digits of everything added so far; more may be added after it.
    std::string hex() const;

private:
    struct Context;
    std::unique_ptr<Context> context_;
};

}  // namespace rayshoot
