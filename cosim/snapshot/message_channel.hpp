// Messages between two processes of this program: values of trivially copyable types, in their order, each as a whole.
#pragma once

#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>

#include "cosim/net/file_descriptor.hpp"

namespace armature::cosim {

template <class T>
concept Message = std::is_trivially_copyable_v<T>;

class MessageChannel {
 public:
  MessageChannel() = default;  // without another end
  // The two ends. Throws std::system_error.
  [[nodiscard]] static std::pair<MessageChannel, MessageChannel> pair();

  // Returns false when the other end is closed.
  template <Message T>
  bool send(const T& message) {
    return send(&message, sizeof(T));
  }
  // Waits for the next message. Nothing: the other end is closed. The other end must have sent a T.
  template <Message T>
  [[nodiscard]] std::optional<T> receive() {
    return get<T>(Keep::kNo);
  }
  // The same, and the message stays in the channel.
  template <Message T>
  [[nodiscard]] std::optional<T> peek() {
    return get<T>(Keep::kYes);
  }
  // Waits for a message. Returns false when the other end is closed.
  [[nodiscard]] bool wait();

  // Whether wait() would return at once.
  [[nodiscard]] bool is_due() const;

  [[nodiscard]] int descriptor() const { return end_.get(); }
  void close() { end_.close(); }

 private:
  enum class Keep : bool { kNo, kYes };

  explicit MessageChannel(int end) : end_{end} {}
  bool send(const void* message, std::size_t size);
  bool get(void* message, std::size_t size, Keep keep);
  template <class T>
  std::optional<T> get(Keep keep) {
    T message;
    if (!get(&message, sizeof(T), keep)) return std::nullopt;
    return message;
  }

  FileDescriptor end_;
};

}  // namespace armature::cosim
