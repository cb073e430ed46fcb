// The terminal that the pendant is shown on, while the object lives.
#pragma once

#include <optional>
#include <vector>

#include "cosim/pendant/screen.hpp"

namespace armature::cosim {

class Terminal {
 public:
  // Throws InputError when standard input or output is no terminal.
  Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
  ~Terminal();

  // The next key that was pressed; never blocks.
  [[nodiscard]] std::optional<int> key();
  void show(const std::vector<TerminalLine>& lines);
  [[nodiscard]] std::size_t rows() const;
  [[nodiscard]] std::size_t columns() const;
};

}  // namespace armature::cosim
