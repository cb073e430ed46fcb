// The characters of one direction of a serial line that belong together, as a text.
//
// A pause of more than four characters begins a new text: the controller, too, drops an incomplete frame then.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "controller/base/units.hpp"
#include "cosim/serial/serial_event.hpp"
#include "cosim/serial/serial_format.hpp"

namespace armature::cosim {

class SerialBurst {
 public:
  // `longest`: of the text.
  SerialBurst(const SerialFormat& format, std::size_t longest) : format_{format}, longest_{longest} {}

  // `event`: of this direction.
  void add(const SerialEvent& event);

  // The last characters, each as in serial.csv. Those that do not fit as a whole are left out.
  [[nodiscard]] std::string text() const;

 private:
  [[nodiscard]] bool is_after_pause(Cycles at) const;

  SerialFormat format_;
  std::size_t longest_;
  std::string bytes_;  // at most longest_
  std::optional<Cycles> last_at_;
};

}  // namespace armature::cosim
