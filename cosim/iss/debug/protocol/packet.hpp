// The packets of gdb's remote serial protocol: `$payload#cs`, where cs is the sum of the payload's bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace armature::cosim::iss {

// The longest payload in either direction, in bytes.
inline constexpr std::size_t kLongestPayload = 0x4000;

// `payload` as a packet: the characters that the protocol uses are escaped.
[[nodiscard]] std::string packet_of(std::string_view payload);

// Finds packets in the bytes of a connection.
class PacketReader {
 public:
  struct Item {
    enum class Kind : std::uint8_t {
      kPacket,
      kInterrupt,  // Ctrl-C
      kBad,        // a wrong checksum, or a packet that is too long: to be sent again
      kForeign,    // a byte outside of packets that gdb does not send: it is no gdb
    };
    Kind kind = Kind::kPacket;
    std::string payload{};  // of a packet, without escapes
  };

  void append(std::string_view bytes) { bytes_ += bytes; }
  // The next one that is complete.
  [[nodiscard]] std::optional<Item> next();

 private:
  std::string bytes_;
};

}  // namespace armature::cosim::iss
