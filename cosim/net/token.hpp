// Access control of a server: a TCP client must know the token that the server printed.
//
// Every user of this machine can connect to a TCP port. So can every web page in the user's browser, which can send
// bytes inside an HTTP request. Only its user can connect to a socket file, so it needs no token.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace armature::cosim {

// 32 hexadecimal digits, 128 bits of the system's randomness. Throws std::system_error.
[[nodiscard]] std::string random_token();

// True when both are equal. The time that it takes does not depend on where they differ.
[[nodiscard]] bool same_token(std::string_view given, std::string_view token);

// Result of the check of a client's first line.
struct Admission {
  bool admitted = false;
  std::string_view answer;  // with its end; empty: the line is a command
};

// Checks the first line of a client: the word `token`, then the value of `token`. If `token` is none, every client is
// admitted, and the text after the word is ignored.
[[nodiscard]] Admission check_first_line(std::string_view first_line, const std::optional<std::string>& token);

}  // namespace armature::cosim
