#include "cosim/cli/options/man_page.hpp"

#include <fmt/format.h>

#include <string_view>

#include "cosim/cli/command/command.hpp"
#include "cosim/cli/command/data_path.hpp"
#include "cosim/text/version.hpp"

namespace armature::cosim {
namespace {

// Text in which roff sees no command and changes no character. A line may end after a comma.
std::string roff(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (safe.ends_with(',') && c != ' ') safe += "\\:";
    switch (c) {
      case '\\':
        safe += "\\e";
        break;
      case '-':
        safe += "\\-";
        break;
      case '\'':
        safe += "\\(aq";
        break;
      case '`':
        safe += "\\(ga";
        break;
      case '^':
        safe += "\\(ha";
        break;
      case '~':
        safe += "\\(ti";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

// A line of text. At its beginning, a dot would be a command.
std::string text_line(std::string_view text) {
  return (text.starts_with('.') ? "\\&" : "") + roff(text) + "\n";
}

std::string bold(std::string_view text) {
  return "\\fB" + roff(text) + "\\fR";
}

std::string italic(std::string_view text) {
  return "\\fI" + roff(text) + "\\fR";
}

// The text below the options. Lines that are indented stay lines, as do those with columns; the others are paragraphs.
std::string paragraphs(std::string_view text) {
  std::string page;
  bool indented = false;
  const auto set_indented = [&](bool now) {
    if (now != indented) page += now ? ".PP\n.nf\n.RS 2\n" : ".RE\n.fi\n";
    indented = now;
  };
  bool gap = true;  // a paragraph begins
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (line.empty()) {
      gap = true;
      continue;
    }
    const std::size_t blanks = line.find_first_not_of(' ');
    set_indented(blanks > 0);
    if (indented) {
      page += text_line(line.substr(blanks));
      gap = true;
      continue;
    }
    const bool columns = line.find("  ") != std::string_view::npos;
    if (gap || line.starts_with("Exit code")) {
      page += ".PP\n";
    } else if (columns) {
      page += ".br\n";
    }
    page += text_line(line);
    gap = false;
  }
  set_indented(false);
  return page;
}

// `INT`, or `counts|paper`.
std::string value_text(const OptionRow& option) {
  if (option.choices.empty()) return option.kind;
  std::string words;
  for (const std::string& choice : option.choices) words += (words.empty() ? "" : "|") + choice;
  return words;
}

// `--jobs INT, -j INT`, or `scenario`.
std::string tag(const OptionRow& option) {
  std::string text;
  for (const std::string& name : option.names) {
    text += (text.empty() ? "" : ", ") + bold(name);
    if (option.most_values > 0 && !option.positional) text += " " + italic(value_text(option));
  }
  return text;
}

std::string option_entry(const OptionRow& option) {
  return ".TP\n" + tag(option) + "\n" + text_line(option.description);
}

// `armature plot folder --figure TEXT [options]`
std::string usage(const CommandRow& program, const CommandRow& command) {
  std::string text = bold(program.name) + " " + bold(command.name);
  bool more = false;
  for (const OptionRow& option : command.options) {
    if (!option.positional && !option.required) {
      more = true;
      continue;
    }
    const std::string dots = option.positional && option.most_values > 1 ? " ..." : "";
    const std::string word = option.positional ? italic(option.names.front()) : tag(option);
    text += option.required ? " " : " [";
    text += word;
    text += dots;
    if (!option.required) text += "]";
  }
  return text + (more ? " [options]" : "") + "\n";
}

std::string command_section(const CommandRow& program, const CommandRow& command) {
  std::string text =
      ".SS " + roff(command.name) + "\n" + usage(program, command) + ".PP\n" + text_line(command.summary + ".");
  for (const OptionRow& option : command.options) text += option_entry(option);
  return text + paragraphs(command.details);
}

std::string exit_codes() {
  std::string text;
  const auto code = [&text](int value, std::string_view meaning) {
    text += fmt::format(".TP\n{}\n{}", bold(std::to_string(value)), text_line(meaning));
  };
  code(kExitOk, "All is well.");
  code(kExitCheckFailed, "A golden, an expectation or an invariant failed.");
  code(kExitBadInput, "Bad input: an option or a file is wrong.");
  code(kExitInternal, "Internal error.");
  code(kExitInterrupted, "Ctrl-C or a signal has interrupted the program.");
  return text;
}

}  // namespace

std::string man_page(const CommandRow& program, const std::vector<CommandRow>& commands) {
  std::string page = fmt::format(".TH {} 1 \"\" \"{} {}\" \"\"\n", "ARMATURE", program.name, version());
  page += ".ad l\n.nh\n";  // neither stretched lines nor hyphens
  page += ".SH NAME\n" + roff(program.name) + " \\- " + roff(program.summary) + "\n";
  page += ".SH SYNOPSIS\n" + bold(program.name) + " [" + bold("--path") + " " + italic("DIR") + "] " +
          italic("command") + " ...\n";
  page += ".SH DESCRIPTION\n" + paragraphs(program.details);
  page += ".SH OPTIONS\nEvery command has the option " + bold("--help") + " and these:\n";
  for (const OptionRow& option : program.options) page += option_entry(option);
  page += ".SH COMMANDS\n";
  for (const CommandRow& command : commands) page += command_section(program, command);
  page += ".SH EXIT STATUS\n" + exit_codes();
  page += ".SH ENVIRONMENT\n.TP\n" + bold(kPathVariable) + "\n" +
          text_line("Folders of scenarios and robots, separated by colons.");
  page += ".TP\n" + bold("NO_COLOR") + "\n" + text_line("If it is not empty, verdicts have no colour on a terminal.");
  return page;
}

}  // namespace armature::cosim
