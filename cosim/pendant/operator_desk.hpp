// What a person at a terminal pendant has selected, and what each key does.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cosim/pendant/operator_link.hpp"
#include "cosim/robot/robot_spec.hpp"

namespace armature::cosim {

// A program file that can be sent to the controller.
struct OperatorProgram {
  std::string name;
  pendant::Content kind = pendant::Content::kJob;  // or kGcode
  std::string text;
  std::vector<std::string> lines;
};

class OperatorDesk {
 public:
  using Time = OperatorLink::Time;
  static constexpr int kEnter = '\n', kUp = 0403, kDown = 0402;  // the arrows as ncurses numbers them

  // A terminal reports no release of a key, only repetitions while it is held down. The first one comes late.
  static constexpr Time kFirstPress{550'000};  // how long a jog lasts after the first press
  static constexpr Time kHeld{150'000};        // and after each repetition

  struct Key {
    int key;
    std::string_view shown;
    std::string_view does;  // empty: the key before says it
    void (OperatorDesk::*act)(int argument, Time now);
    int argument;
  };
  // All keys, for the help and the documentation.
  [[nodiscard]] static std::span<const Key> keys();

  // `robot`: for positions of joints in degrees; none: they are shown in pulses. The references must outlive the desk.
  OperatorDesk(OperatorLink& link, const RobotSpec* robot, std::vector<OperatorProgram> programs)
      : link_{link}, robot_{robot}, programs_{std::move(programs)} {}

  // A key was pressed. An unknown one does nothing.
  void press(int key, Time now);

  [[nodiscard]] const OperatorLink& link() const { return link_; }
  [[nodiscard]] int jog_percent() const;
  [[nodiscard]] int override_percent() const { return override_percent_; }
  // The distance of a press, such as `0.1 deg / 1 mm`; `continuous`.
  [[nodiscard]] std::string step_text() const;
  [[nodiscard]] int user_frame() const { return user_frame_; }
  // The position of a joint in degrees, or in pulses without a robot; 0-based.
  [[nodiscard]] std::string joint_text(std::size_t joint) const;
  [[nodiscard]] std::string_view joint_unit() const { return robot_ == nullptr ? "pulses" : "deg"; }
  [[nodiscard]] std::size_t joints() const { return robot_ == nullptr ? kAxes : robot_->axis_count; }
  // The selected program; nullptr without programs.
  [[nodiscard]] const OperatorProgram* program() const { return programs_.empty() ? nullptr : &programs_[selected_]; }
  [[nodiscard]] std::size_t programs() const { return programs_.size(); }
  [[nodiscard]] std::size_t selected() const { return selected_; }
  // The line of the selected program that the arm executes; 0: none.
  [[nodiscard]] std::int32_t current_line() const;
  // The line of it that the operator has gone to; 0: none since its last start.
  [[nodiscard]] std::int32_t cursor() const { return cursor_; }
  [[nodiscard]] bool has_breakpoint(std::int32_t line) const;

 private:
  // Their argument is that of the key.
  void jog(int direction, Time now);  // 2 * axis + 1 for the negative direction
  void change_coordinates(int, Time);
  void change_step(int, Time);
  void change_user_frame(int, Time);
  void change_jog_speed(int by, Time);
  void change_override(int by, Time);
  void switch_drives(int, Time);
  void stop(int, Time);
  void estop(int, Time);
  void reset(int, Time);
  void home(int, Time);
  void select_program(int, Time);
  void load_program(int kind, Time);
  void run(int mode, Time);
  void move_cursor(int by, Time);
  void run_from_cursor(int, Time);
  void toggle_breakpoint(int, Time);
  void remove_breakpoints(int, Time);
  void step(int, Time);
  void command(int opcode, Time);

  void start(pendant::RunMode mode, std::int32_t line);
  void send(pendant::Opcode opcode, std::uint8_t parameter = 0, std::int32_t payload = 0);
  [[nodiscard]] std::optional<std::int32_t> increment(std::size_t axis) const;
  // A line of the selected program as the page `line` has it; none: the controller has another program.
  [[nodiscard]] std::optional<std::int32_t> place_of(std::int32_t line) const;

  OperatorLink& link_;
  const RobotSpec* robot_;
  std::vector<OperatorProgram> programs_;
  std::size_t selected_ = 0;
  std::int32_t cursor_ = 0;
  std::size_t jog_speed_ = 4;  // of kJogPercents
  std::size_t step_ = 0;       // 0: continuous
  int override_percent_ = 100;
  int user_frame_ = 1;
  int jog_key_ = -1;  // the last one, and when it was pressed
  Time jog_pressed_{-kFirstPress};
};

}  // namespace armature::cosim
