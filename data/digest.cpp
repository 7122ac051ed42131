#include "data/digest.h"

#include "data/scene.h"

#include <openssl/evp.h>

#include <new>
#include <stdexcept>
#include <vector>

namespace rayshoot {

namespace {

void require(int openssl_result) {
    if (openssl_result != 1) throw std::runtime_error("OpenSSL cannot compute SHA-256");
}

using EvpContext = std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)>;

EvpContext new_context() {
    EvpContext context(EVP_MD_CTX_new(), &EVP_MD_CTX_free);
    if (!context) throw std::bad_alloc();
    return context;
}

}  // namespace

/// Small values are gathered here: a call into OpenSSL costs more than hashing 64 bytes.
struct Digest::Context {
    static constexpr std::size_t block = 4096;  // bytes

    EvpContext evp = new_context();
    std::vector<std::byte> pending;
};

Digest::Digest() : context_(std::make_unique<Context>()) {
    require(EVP_DigestInit_ex(context_->evp.get(), EVP_sha256(), nullptr));
    context_->pending.reserve(Context::block);
}
Digest::~Digest() = default;
Digest::Digest(Digest&&) noexcept = default;
Digest& Digest::operator=(Digest&&) noexcept = default;

void Digest::add(std::span<const std::byte> bytes) {
    std::vector<std::byte>& pending = context_->pending;
    if (pending.size() + bytes.size() > Context::block) {
        require(EVP_DigestUpdate(context_->evp.get(), pending.data(), pending.size()));
        pending.clear();
    }
    if (bytes.size() > Context::block)
        require(EVP_DigestUpdate(context_->evp.get(), bytes.data(), bytes.size()));
    else pending.insert(pending.end(), bytes.begin(), bytes.end());
}

void Digest::add(std::string_view text) {
    add(static_cast<std::uint64_t>(text.size()));
    add(std::as_bytes(std::span(text)));
}

std::string Digest::hex() const {
    const EvpContext copy = new_context();
    require(EVP_MD_CTX_copy_ex(copy.get(), context_->evp.get()));
    require(EVP_DigestUpdate(copy.get(), context_->pending.data(), context_->pending.size()));
    std::array<unsigned char, EVP_MAX_MD_SIZE> hash{};
    unsigned int size = 0;
    require(EVP_DigestFinal_ex(copy.get(), hash.data(), &size));
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text;
    for (unsigned int i = 0; i < size; ++i) {
        text += digits[hash[i] >> 4];
        text += digits[hash[i] & 15];
    }
    return text;
}

}  // namespace rayshoot
