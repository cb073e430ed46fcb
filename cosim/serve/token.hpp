// Who may talk to the server: over TCP, whoever knows the token that it has printed.
//
// Every user of this machine reaches a TCP port of it, and so does every web page in the user's browser, which can send
// bytes to it inside an HTTP request. A socket file is its user's alone and asks for no token.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace armature::cosim {

// 32 hexadecimal digits, 128 bits of the system's randomness. Throws std::system_error.
[[nodiscard]] std::string random_token();

// What the first line of a client means.
struct Greeting {
  bool admitted = false;
  std::string_view answer;  // with its end; empty: the line is a command like any other
};

// `token` is what the first line must give, after the word `token`; nothing: every client is admitted, and what follows
// the word, if the line has it, does not matter.
[[nodiscard]] Greeting greet(std::string_view first_line, const std::optional<std::string>& token);

}  // namespace armature::cosim
