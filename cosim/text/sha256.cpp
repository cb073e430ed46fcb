#include "cosim/text/sha256.hpp"

#include <openssl/evp.h>

#include <array>
#include <stdexcept>

namespace armature::cosim {
namespace {

void require(int openssl_result) {
  if (openssl_result != 1) throw std::runtime_error{"SHA-256 is not available from OpenSSL"};
}

}  // namespace

void Sha256::Free::operator()(evp_md_ctx_st* context) const noexcept {
  EVP_MD_CTX_free(context);
}

Sha256::Sha256() : context_{EVP_MD_CTX_new()}, finished_{EVP_MD_CTX_new()} {
  require(context_ == nullptr || finished_ == nullptr ? 0 : 1);
  require(EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr));
}

void Sha256::add(std::string_view bytes) {
  require(EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()));
}

std::string Sha256::hex() const {
  // Finishing ends a context, so a copy is finished.
  require(EVP_MD_CTX_copy_ex(finished_.get(), context_.get()));
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  require(EVP_DigestFinal_ex(finished_.get(), digest.data(), &size));
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text(std::size_t{2} * size, '\0');
  char* out = text.data();
  for (const unsigned char* byte = digest.data(); byte != digest.data() + size; ++byte) {
    *out++ = kDigits[*byte >> 4U];
    *out++ = kDigits[*byte & 0xFU];
  }
  return text;
}

std::string sha256_hex(std::string_view bytes) {
  Sha256 hash;
  hash.add(bytes);
  return hash.hex();
}

}  // namespace armature::cosim
