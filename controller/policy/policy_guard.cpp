#include "controller/policy/policy_guard.hpp"

#include <algorithm>

namespace armature {

bool PolicyGuard::start(std::span<const std::uint32_t> image, std::uint32_t crc) noexcept {
  begun_ = usable_ = false;
  load(image, crc, image.size());
  return usable_;
}

bool PolicyGuard::load(std::span<const std::uint32_t> image, std::uint32_t crc, std::size_t words) noexcept {
  if (!begun_) {
    begun_ = true;
    loaded_ = 0;
    if (!block_.identified()) return true;
    block_.set_bound(share_);
    block_.begin_load();
  }
  const std::size_t count = std::min(words, image.size() - loaded_);
  block_.load_next(image.subspan(loaded_, count));
  loaded_ += count;
  if (loaded_ < image.size()) return false;
  block_.end_load(crc);
  usable_ = true;
  return true;
}

void PolicyGuard::request(std::span<const double> observation) noexcept {
  if (!usable_ || requested_) return;
  const auto bytes = scale_.quantised(observation);
  if (!bytes) {
    ++counts_.out_of_range;
    return;
  }
  block_.set_inputs(std::span{*bytes}.first(scale_.input_count));
  block_.start();
  requested_ = true;
}

PolicyScale::Correction PolicyGuard::collect() noexcept {
  if (!requested_) return {};
  const PolicyMlp::Status status = block_.status();
  if (status.busy) {  // the next request comes when the run has ended: its result is too old
    late_ = true;
    ++counts_.late;
    return {};
  }
  requested_ = false;
  const bool was_late = late_;
  late_ = false;
  if (was_late) return {};
  if (!status.done) {
    ++counts_.invalid;
    return {};
  }
  ++counts_.used;
  return scale_.correction(block_.outputs());
}

}  // namespace armature
