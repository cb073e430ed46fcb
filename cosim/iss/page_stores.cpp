// Makes stores of the simulated cores twice as fast.
//
// At each store Unicorn 2.0 looks for translated code in its page, to translate it again, with several allocations. The
// firmware does not change its code. So these functions, which the library calls by their names, replace its own and do
// nothing. Later versions look for code only in pages that have some.
#include <unicorn/unicorn.h>

#include <cstdint>

#if UC_API_MAJOR == 2 && UC_API_MINOR == 0
extern "C" {
void* page_collection_lock_arm(void* /*engine*/, std::uint64_t /*start*/, std::uint64_t /*end*/) {
  return nullptr;
}
void page_collection_unlock_arm(void* /*pages*/) {}
void tb_invalidate_phys_page_fast_arm(void* /*engine*/, void* /*pages*/, std::uint64_t /*start*/, int /*bytes*/,
                                      std::uintptr_t /*caller*/) {}
}
#endif
