#include "controller/pendant/parts/program_store.hpp"

#include <algorithm>

namespace armature::pendant {

static_assert(sizeof(ProgramStore) < 1'200'000, "the README states the size");  // NOLINT: a size is meant

Answer ProgramStore::begin(Content content, std::int32_t size) noexcept {
  if (!receiver_.begin(size)) return {Status::kStoreFull, static_cast<std::int32_t>(kMaxCharacters)};
  content_ = content;
  if (program_ == &gcode_) program_ = nullptr;  // its text is overwritten
  return {};
}

Answer ProgramStore::commit(std::int32_t check) noexcept {
  lines_read_ = 0;
  const bool good = receiver_.complete() && receiver_.check() == check;
  const std::string_view text{receiver_.text().data(), receiver_.text().size()};
  receiver_.cancel();
  if (!good) return {.status = Status::kCheckFail};
  program_ = nullptr;
  if (content_ == Content::kGcode) {
    gcode_.load({.text = text});
    program_ = &gcode_;
    return {};
  }
  return load_job(text);
}

Answer ProgramStore::load_job(std::string_view text) noexcept {
  if (content_ == Content::kJob) memory_.clear();
  lines_read_ = std::count(text.begin(), text.end(), '\n') + 1;
  error_.line = 0;
  if (!loader_.load({}, text) || !loader_.link()) {
    memory_.clear();
    return {loader_.full() ? Status::kStoreFull : Status::kParseError, static_cast<std::int32_t>(error_.line)};
  }
  program_ = &machine_;
  return select(memory_.job_count - 1);
}

Answer ProgramStore::select(std::size_t job) noexcept {
  if (program_ != &machine_ || job >= memory_.job_count) return {.status = Status::kRange};
  machine_.select(job);
  return {.payload = static_cast<std::int32_t>(job)};
}

}  // namespace armature::pendant
