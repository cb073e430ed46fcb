#include "cosim/pendant/terminal.hpp"

#include <ncurses.h>
#include <unistd.h>

#include <array>

#include "cosim/text/input_error.hpp"

namespace armature::cosim {
namespace {

// By TerminalLine::Style.
constexpr std::array<attr_t, 6> kAttributes{A_NORMAL, A_BOLD, A_BOLD | A_REVERSE, A_REVERSE, A_UNDERLINE, A_DIM};
static_assert(KEY_UP == OperatorDesk::kUp && KEY_DOWN == OperatorDesk::kDown);

}  // namespace

Terminal::Terminal() {
  if (isatty(STDIN_FILENO) == 0 || isatty(STDOUT_FILENO) == 0) {
    throw InputError{"armature pendant", "needs a terminal for its input and output"};
  }
  if (newterm(nullptr, stdout, stdin) == nullptr) {
    throw InputError{"armature pendant", "this terminal is not known (TERM)"};
  }
  cbreak();
  noecho();
  nodelay(stdscr, true);
  keypad(stdscr, true);  // arrows are one key
  curs_set(0);
}

Terminal::~Terminal() {
  endwin();
}

std::optional<int> Terminal::key() {
  const int key = getch();
  if (key == ERR) return std::nullopt;
  return key == KEY_ENTER ? OperatorDesk::kEnter : key;  // that of the numeric keypad
}

void Terminal::show(const std::vector<TerminalLine>& lines) {
  erase();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    attrset(static_cast<int>(kAttributes[static_cast<std::size_t>(lines[i].style)]));
    mvaddstr(static_cast<int>(i), 0, lines[i].text.c_str());
  }
  attrset(A_NORMAL);
  refresh();
}

std::size_t Terminal::rows() const {
  return static_cast<std::size_t>(getmaxy(stdscr));
}

std::size_t Terminal::columns() const {
  return static_cast<std::size_t>(getmaxx(stdscr));
}

}  // namespace armature::cosim
