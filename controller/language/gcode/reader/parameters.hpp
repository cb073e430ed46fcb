// The parameters of a program: numbered, and named ones that are local to a subroutine or global.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string_view>

#include "controller/language/gcode/reader/error.hpp"

namespace armature::gcode {

// Values that the interpreter computes: places, modes. Programs only read them.
class ComputedParameters {
 public:
  [[nodiscard]] virtual std::optional<double> computed(std::string_view name) const noexcept = 0;
  [[nodiscard]] virtual std::optional<double> computed(int number) const noexcept = 0;

 protected:
  ~ComputedParameters() = default;
};

struct NamedValue {
  std::string_view name;
  double value;
};
[[nodiscard]] std::optional<double> find_value(std::string_view name,
                                               std::initializer_list<NamedValue> values) noexcept;
// The value of what is on or off.
[[nodiscard]] constexpr double flag(bool on) noexcept {
  return on ? 1.0 : 0.0;
}

// Numbers of parameters with a meaning. Lengths of coordinate systems are in mm.
inline constexpr int kHomeParameter = 5161;        // G28: X..C of the machine
inline constexpr int kSecondHomeParameter = 5181;  // G30
inline constexpr int kG92ActiveParameter = 5210;
inline constexpr int kG92Parameter = 5211;      // X..C
inline constexpr int kSystemParameter = 5220;   // 1..9
inline constexpr int kSystemsParameter = 5221;  // X..C of system 1; the others follow at intervals
inline constexpr int kSystemInterval = 20;
inline constexpr int kSystemRotation = 9;     // from X of a system
inline constexpr int kInputParameter = 5399;  // result of M66
inline constexpr int kToolParameter = 5400;   // the tool in the spindle
inline constexpr int kPlaceParameter = 5420;  // X..C of the present place

inline constexpr int kFirstStored = 5001;  // parameters from here on stay from program to program

class Parameters {
 public:
  static constexpr int kLast = 5602;
  static constexpr int kLocals = 30;  // #1..#30 belong to the subroutine
  static constexpr std::size_t kMaxNamed = 256;
  static constexpr std::size_t kMaxNameLength = 47;
  static constexpr std::size_t kMaxCalls = 10;

  explicit Parameters(const ComputedParameters& computed) noexcept : computed_(computed) {}

  // Forgets names, calls and #1..#5000; the others keep their values.
  void begin_program() noexcept;

  [[nodiscard]] std::optional<double> numbered(int number) const noexcept;
  [[nodiscard]] std::optional<double> named(std::string_view name) const noexcept;
  [[nodiscard]] std::optional<ErrorCode> set(int number, double value) noexcept;
  [[nodiscard]] std::optional<ErrorCode> set(std::string_view name, double value) noexcept;

  // For parameters that the interpreter itself knows to exist.
  [[nodiscard]] double& at(int number) noexcept { return numbers_[static_cast<std::size_t>(number)]; }
  [[nodiscard]] double at(int number) const noexcept { return numbers_[static_cast<std::size_t>(number)]; }

  // A call begins: #1.. are the arguments, the rest of the locals is 0. False if calls are nested too deep.
  [[nodiscard]] bool enter(std::span<const double> arguments) noexcept;
  void leave() noexcept;
  [[nodiscard]] std::size_t level() const noexcept { return level_; }

 private:
  struct Named {
    std::array<char, kMaxNameLength> name{};
    std::uint8_t length = 0;
    std::uint8_t level = 0;  // 0 also for global ones
    double value = 0.0;
    [[nodiscard]] std::string_view view() const noexcept { return {name.data(), length}; }
  };
  static bool is_global(std::string_view name) noexcept { return !name.empty() && name.front() == '_'; }
  [[nodiscard]] std::size_t find(std::string_view name) const noexcept;

  const ComputedParameters& computed_;
  std::array<double, kLast + 1> numbers_{};
  std::array<Named, kMaxNamed> named_{};
  std::size_t named_count_ = 0;
  std::array<std::array<double, kLocals>, kMaxCalls> saved_{};
  std::size_t level_ = 0;
};

}  // namespace armature::gcode
