#include "cosim/net/token.hpp"

#include <fmt/format.h>
#include <openssl/crypto.h>
#include <sys/random.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <system_error>

#include "cosim/text/blanks.hpp"

namespace armature::cosim {

bool same_token(std::string_view given, std::string_view token) {
  return given.size() == token.size() && CRYPTO_memcmp(given.data(), token.data(), given.size()) == 0;
}

std::string random_token() {
  std::array<std::uint8_t, 16> bytes{};
  // The system returns so few bytes completely or not at all.
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    throw std::system_error{errno, std::generic_category(), "cannot create a random token"};
  }
  std::string token;
  for (const std::uint8_t byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

Admission check_first_line(std::string_view first_line, const std::optional<std::string>& token) {
  if (first_line.ends_with('\r')) first_line.remove_suffix(1);
  const std::string_view line = trimmed(first_line);
  const std::string_view word = line.substr(0, line.find_first_of(kBlanks));
  const bool is_token = word == "token";
  if (!token) return {.admitted = true, .answer = is_token ? "ok\n" : ""};
  if (!is_token) {
    return {.answer = "error the first line must be 'token TOKEN', with the token that the server printed; closed\n"};
  }
  if (!same_token(trimmed(line.substr(word.size())), *token)) {
    return {.answer =
                "error wrong token: the first line must be 'token TOKEN', with the token that the server printed; "
                "closed\n"};
  }
  return {.admitted = true, .answer = "ok\n"};
}

}  // namespace armature::cosim
