/* The self-test of the vendor's AXI Timer driver, rewritten for the served RTL; then one period of 50 us.
 *
 * usage: timer_self_test tcp:PORT | PATH
 * The environment variable ARMATURE_TOKEN contains the token that the server printed; a path needs none.
 * build: cc -std=c99 timer_self_test.c -o timer_self_test
 */
#include "armature_client.h"

enum { TCSR = 0x0, TLR = 0x4, TCR = 0x8, TIMER_STRIDE = 0x10 };
enum { UDT = 0x002, ARHT = 0x010, LOAD = 0x020, ENIT = 0x040, ENT = 0x080, TINT = 0x100 };
enum { POLLS = 65535, TICK_CYCLES = 2500 };

static const uint32_t kBase = 0x42800000u;
static armature_client soc;

static void check(int result) {
  if (result == ARMATURE_OK) return;
  fprintf(stderr, "timer_self_test: %s\n", soc.error);
  exit(1);
}

static void fail(const char* what) {
  fprintf(stderr, "timer_self_test: %s\n", what);
  exit(1);
}

static uint32_t timer_read(uint32_t timer, uint32_t offset) {
  uint32_t value = 0;
  check(armature_read(&soc, kBase + timer * TIMER_STRIDE + offset, &value));
  return value;
}

static void timer_write(uint32_t timer, uint32_t offset, uint32_t value) {
  check(armature_write(&soc, kBase + timer * TIMER_STRIDE + offset, value));
}

/* Initialisation as in the driver: counter at 0, flag acknowledged, stopped. */
static void initialise(uint32_t timer) {
  timer_write(timer, TLR, 0);
  timer_write(timer, TCSR, TINT | LOAD);
  timer_write(timer, TCSR, 0);
}

/* The counter must leave 0 within the number of polls that the driver makes. */
static void self_test(uint32_t timer) {
  uint32_t first, polls = 0;
  initialise(timer);
  timer_write(timer, TCSR, ENT);
  first = timer_read(timer, TCR);
  while (timer_read(timer, TCR) == first) {
    if (++polls == POLLS) fail("the counter does not count");
  }
  timer_write(timer, TCSR, TINT | LOAD);
  timer_write(timer, TCSR, 0);
  if (timer_read(timer, TCR) != 0) fail("the counter was not loaded with 0");
}

/* Timer 0 as the trigger of the tick: two interrupts are one period apart. */
static uint64_t period(void) {
  uint64_t first = 0, second = 0;
  timer_write(0, TLR, TICK_CYCLES - 2);
  timer_write(0, TCSR, LOAD);
  timer_write(0, TCSR, ENT | ENIT | ARHT | UDT);
  check(armature_run_until_irq(&soc, 2 * TICK_CYCLES, &first));
  timer_write(0, TCSR, TINT | ENT | ENIT | ARHT | UDT);
  check(armature_run_until_irq(&soc, 2 * TICK_CYCLES, &second));
  initialise(0);
  return second - first;
}

int main(int argc, char** argv) {
  uint32_t timer;
  uint64_t cycles;
  if (argc != 2) {
    fprintf(stderr, "usage: timer_self_test tcp:PORT | PATH\n");
    return 2;
  }
  check(armature_open(&soc, argv[1]));
  for (timer = 0; timer < 2; ++timer) initialise(timer);
  for (timer = 0; timer < 2; ++timer) {
    self_test(timer);
    printf("timer %" PRIu32 " counts\n", timer);
  }
  cycles = period();
  printf("period %" PRIu64 " cycles\n", cycles);
  armature_close(&soc);
  if (cycles != TICK_CYCLES) fail("the period is wrong");
  return 0;
}
