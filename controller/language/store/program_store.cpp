#include "controller/language/store/program_store.hpp"

namespace armature {

static_assert(sizeof(ProgramStore) < 1'000'000, "the README states the size");  // NOLINT: a size is meant

void ProgramStore::FirstError::report(const Diagnostic& diagnostic) noexcept {
  if (diagnostic.severity != Diagnostic::Severity::kError) return;
  if (line == 0) line = diagnostic.line;
  if (!text.view().empty()) return;
  text << diagnostic.file << ':' << line << ':' << diagnostic.column << ": " << diagnostic.text.view();
}

ProgramStore::Loaded ProgramStore::load_first(const ProgramFiles& files, std::string_view names,
                                              std::string_view texts) noexcept {
  of_start_ = true;
  if (files.language == ProgramLanguage::kGcode) {
    gcode_->load({.text = texts, .ends = files.ends_of_texts()});
    program_ = &*gcode_;
    return Loaded::kYes;
  }
  for (std::size_t i = 0; i < files.count; ++i) {
    if (!loader_.load(files.name(i, names), files.text(i, texts))) return Loaded::kError;
  }
  return link();
}

void ProgramStore::load_sent_gcode(std::string_view text) noexcept {
  forget_first();
  gcode_->load({.text = text});
  program_ = &*gcode_;
}

ProgramStore::Loaded ProgramStore::load_sent_job(std::string_view text, bool further) noexcept {
  forget_first();
  program_ = nullptr;
  error_.clear();
  if (!further) memory_.clear();
  if (loader_.load({}, text)) {
    if (const Loaded linked = link(); linked == Loaded::kYes) {
      machine_->select(last_job());
      return linked;
    }
  }
  memory_.clear();
  return loader_.full() ? Loaded::kFull : Loaded::kError;
}

ProgramStore::Loaded ProgramStore::link() noexcept {
  if (!loader_.link()) return Loaded::kError;
  program_ = &*machine_;
  return Loaded::kYes;
}

void ProgramStore::forget_first() noexcept {
  if (!of_start_) return;
  of_start_ = false;
  memory_.clear();
  machine_.emplace(memory_, machine_setup_);
  gcode_.emplace(gcode_setup_);
}

bool ProgramStore::drop_sent_gcode() noexcept {
  if (!has_sent_gcode()) return false;
  program_ = nullptr;
  return true;
}

bool ProgramStore::select(std::size_t job) noexcept {
  if (of_start_ || program_ != &*machine_ || job >= memory_.job_count) return false;
  machine_->select(job);
  return true;
}

void ProgramStore::set_sent_gcode_frame(std::optional<FrameId> frame) noexcept {
  if (!of_start_) gcode_setup_.settings.frame = frame.value_or(frame_);
}

}  // namespace armature
