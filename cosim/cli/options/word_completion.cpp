#include "cosim/cli/options/word_completion.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "cosim/cli/options/value_kinds.hpp"

namespace armature::cosim {
namespace {

constexpr std::string_view kPathOption = "--path";

// A negative number is a value.
bool names_option(std::string_view word) {
  constexpr std::string_view kNumber = "0123456789.";
  return word.starts_with('-') && (word.size() == 1 || kNumber.find(word[1]) == std::string_view::npos);
}

bool has_choice(const OptionRow& option, const std::string& word) {
  return std::ranges::find(option.choices, word) != option.choices.end();
}

// An argument whose words are known can be left out if its words tell it from the next one.
bool can_be_left_out(const OptionRow& argument) {
  return !argument.required && !argument.choices.empty();
}

// The words before the one that is completed.
class WordsBefore {
 public:
  WordsBefore(const CommandRow& program, const std::vector<CommandRow>& commands)
      : program_{program}, commands_{commands} {}

  void add(const std::string& word) {
    if (names_option(word)) {
      const std::size_t equal = word.find('=');
      option_ = find(word.substr(0, equal));
      values_left_ = option_ == nullptr ? 0 : option_->most_values;
      if (equal != std::string::npos && values_left_ > 0) add_value(word.substr(equal + 1));
    } else if (values_left_ > 0) {
      add_value(word);
    } else if (!command_given_) {
      command_given_ = true;
      const auto found = std::ranges::find(commands_, word, &CommandRow::name);
      if (found == commands_.end()) return;
      command_ = &*found;
      for (const OptionRow& option : found->options) {
        if (option.positional) arguments_.push_back(&option);
      }
    } else {
      add_argument(word);
    }
  }

  [[nodiscard]] bool command_given() const { return command_given_; }
  [[nodiscard]] const std::vector<std::string>& path() const { return path_; }
  // All options that can be here.
  [[nodiscard]] std::vector<const OptionRow*> options() const {
    std::vector<const OptionRow*> all;
    for (const CommandRow* row : {command_, &program_}) {
      if (row == nullptr) continue;
      for (const OptionRow& option : row->options) {
        if (!option.positional) all.push_back(&option);
      }
    }
    return all;
  }
  [[nodiscard]] const OptionRow* find(std::string_view name) const {
    for (const OptionRow* option : options()) {
      if (std::ranges::find(option->names, name) != option->names.end()) return option;
    }
    return nullptr;
  }
  // The options or arguments of which the next word can be a value.
  [[nodiscard]] std::vector<const OptionRow*> takers() const {
    if (values_left_ > 0) return {option_};
    std::vector<const OptionRow*> all;
    for (std::size_t i = argument_; i < arguments_.size(); ++i) {
      all.push_back(arguments_[i]);
      if (!can_be_left_out(*arguments_[i])) break;
    }
    return all;
  }

 private:
  void add_value(const std::string& word) {
    --values_left_;
    if (option_->names.front() == kPathOption) path_.push_back(word);
  }

  void add_argument(const std::string& word) {
    while (argument_ < arguments_.size() && can_be_left_out(*arguments_[argument_]) &&
           !has_choice(*arguments_[argument_], word)) {
      ++argument_;
    }
    if (argument_ == arguments_.size() || ++values_ < arguments_[argument_]->most_values) return;
    ++argument_;
    values_ = 0;
  }

  const CommandRow& program_;
  const std::vector<CommandRow>& commands_;
  bool command_given_ = false;
  const CommandRow* command_ = nullptr;  // nullptr: not given, or unknown
  const OptionRow* option_ = nullptr;    // the latest one; nullptr: none, or unknown
  int values_left_ = 0;                  // that it can have
  std::vector<const OptionRow*> arguments_;
  std::size_t argument_ = 0;  // the next one
  int values_ = 0;            // that it has
  std::vector<std::string> path_;
};

void add_values(const OptionRow& option, const WordsBefore& before, const NamesOf& names_of, Offer& offer) {
  for (const std::string& choice : option.choices) offer.words.push_back({choice});
  const bool named = option.kind == kScenarioValue || option.kind == kRobotValue;
  if (named) {
    for (std::string& name : names_of(option.kind, before.path())) offer.words.push_back({std::move(name)});
  }
  if (named || option.kind == kFileValue) offer.paths = Offer::Paths::kFiles;
  if (option.kind == kFolderValue) offer.paths = Offer::Paths::kFolders;
}

}  // namespace

Offer complete_word(const CommandRow& program, const std::vector<CommandRow>& commands,
                    std::span<const std::string> words, const NamesOf& names_of) {
  constexpr std::string_view kEqual = "=";  // a word of bash
  WordsBefore before{program, commands};
  for (const std::string& word : words.first(words.size() - 1)) {
    if (word != kEqual) before.add(word);
  }
  const std::string begun = words.back() == kEqual ? std::string{} : words.back();
  Offer offer;
  const std::size_t equal = begun.find('=');
  if (names_option(begun) && equal != std::string::npos) {
    const OptionRow* const option = before.find(begun.substr(0, equal));
    if (option != nullptr && option->most_values > 0) add_values(*option, before, names_of, offer);
    for (OfferedWord& word : offer.words) word.word.insert(0, begun, 0, equal + 1);
  } else if (names_option(begun)) {
    for (const OptionRow* option : before.options()) {
      for (const std::string& name : option->names) offer.words.push_back({name, option->description});
    }
    offer.words.push_back({"--help", "Print the help and exit"});
  } else if (before.command_given() || !before.takers().empty()) {
    for (const OptionRow* option : before.takers()) add_values(*option, before, names_of, offer);
  } else {
    for (const CommandRow& command : commands) offer.words.push_back({command.name, command.summary});
  }
  std::erase_if(offer.words, [&](const OfferedWord& word) { return !word.word.starts_with(begun); });
  return offer;
}

}  // namespace armature::cosim
