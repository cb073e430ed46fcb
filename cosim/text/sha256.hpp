// SHA-256 of a stream of bytes.
#pragma once

#include <memory>
#include <string>
#include <string_view>

struct evp_md_ctx_st;  // OpenSSL's EVP_MD_CTX

namespace armature::cosim {

// From OpenSSL's libcrypto, which uses the SHA instructions of the processor, because every tick is hashed. Users can
// check the hash with `sha256sum`.
class Sha256 {
 public:
  Sha256();
  void add(std::string_view bytes);
  // Of everything added so far, 64 lower-case hexadecimal digits; more may be added afterwards.
  [[nodiscard]] std::string hex() const;

 private:
  struct Free {
    void operator()(evp_md_ctx_st* context) const noexcept;
  };
  std::unique_ptr<evp_md_ctx_st, Free> context_, finished_;
};

// Of these bytes alone.
[[nodiscard]] std::string sha256_hex(std::string_view bytes);

}  // namespace armature::cosim
