#pragma once

#include <cstddef>
#include <memory>
#include <openssl/evp.h>
#include <span>
#include <string>

namespace snug::cli {

/// SHA-256 of bytes that come piece by piece.
class Sha256 {
  public:
    Sha256();
    void add(std::span<const std::byte> bytes);
    /// 64 small hexadecimal digits; nothing may be added afterwards.
    [[nodiscard]] std::string digits();

  private:
    struct Free {
        void operator()(EVP_MD_CTX* context) const { EVP_MD_CTX_free(context); }
    };
    std::unique_ptr<EVP_MD_CTX, Free> context_;
};

[[nodiscard]] std::string sha256(std::span<const std::byte> bytes);

}  // namespace snug::cli
