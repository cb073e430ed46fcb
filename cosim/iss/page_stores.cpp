// Makes stores of the simulated cores fast.
//
// At each store Unicorn 2.0 looks for translated code in its page, to translate it again, with several allocations. The
// firmware does not change its code. So these functions, which the library calls by their names, replace its own: no
// code is looked for, and a page is marked as changed when the core first uses it, which lets its stores take the short
// way. Later versions look for code only in pages that have some.
#include <dlfcn.h>
#include <unicorn/unicorn.h>

#include <bit>
#include <cstdint>

#if UC_API_MAJOR == 2 && UC_API_MINOR == 0
extern "C" {
void* page_collection_lock_arm(void* /*engine*/, std::uint64_t /*start*/, std::uint64_t /*end*/) {
  return nullptr;
}
void page_collection_unlock_arm(void* /*pages*/) {}
void tb_invalidate_phys_page_fast_arm(void* /*engine*/, void* /*pages*/, std::uint64_t /*start*/, int /*bytes*/,
                                      std::uintptr_t /*caller*/) {}

void tlb_set_dirty_arm(void* core, std::uint32_t address);  // of the library

void tlb_set_page_with_attrs_arm(void* core, std::uint32_t address, std::uint64_t physical, unsigned attributes,
                                 int permissions, int mode, std::uint32_t bytes) {
  using Function = decltype(&tlb_set_page_with_attrs_arm);
  static const auto kOriginal = std::bit_cast<Function>(dlsym(RTLD_NEXT, "tlb_set_page_with_attrs_arm"));
  kOriginal(core, address, physical, attributes, permissions, mode, bytes);
  tlb_set_dirty_arm(core, address);
}
}
#endif
