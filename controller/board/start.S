@ Start of both cores of the Zynq-7020: from reset, or from the boot ROM, to core0_main and core1_main in C++.
@ Source: ARM Cortex-A9 TRM (r4p1) sections 3.3, 4.2 and 4.3; ARMv7-A ARM (DDI 0406C) sections B3.5 and B4.1.
@
@ After reset the caches hold random lines, so they are invalidated before they are enabled. Memory is cached and shared
@ between the cores; without the MMU it would be neither, and LDREX would not work.

  .syntax unified
  .arm

  .set kSctlrOff, 0x00c50078   @ reset value: MMU, caches and branch prediction off
  .set kSctlrOn,  0x00001805   @ I-cache, branch prediction, D-cache, MMU
  .set kActlrSmp, 0x00000041   @ SMP: coherent; FW: broadcasts of maintenance
  .set kOffMasks, 0xd3         @ supervisor, IRQ and FIQ masked: the software waits by WFI and takes no interrupt

@ ---- exceptions: the cause is kept in r0 of a core that sleeps for ever
  .section .vectors, "ax"
  .global vectors
  .align 5
vectors:
  b     start_core0
  b     undefined
  b     supervisor_call
  b     prefetch_abort
  b     data_abort
  b     unused_exception
  b     unused_exception       @ IRQ and FIQ are masked
  b     unused_exception

  .macro sleeps_after name, cause
\name:
  mov   r0, #\cause
  b     sleep_for_ever
  .endm
  sleeps_after undefined, 1
  sleeps_after supervisor_call, 2
  sleeps_after prefetch_abort, 3
  sleeps_after data_abort, 4
  sleeps_after unused_exception, 5

  .global sleep_for_ever
sleep_for_ever:
  wfe
  b     sleep_for_ever

@ ---- start
  .section .text.start, "ax"
  .global start_core0
start_core0:
  msr   cpsr_c, #kOffMasks
  ldr   sp, =core0_stack_top
  bl    prepare_core

  ldr   r0, =bss_begin
  ldr   r1, =bss_end
  mov   r2, #0
clear:
  cmp   r0, r1
  strlo r2, [r0], #4
  blo   clear

  bl    write_page_table
  bl    enable_caches
  bl    prepare_core0
  .global core0_is_prepared
core0_is_prepared:             @ the controller is constructed; nothing has touched the logic
  bl    core0_main
  b     sleep_for_ever

@ The boot ROM keeps core 1 in WFE until core 0 has written this address to 0xfffffff0.
  .global start_core1
start_core1:
  msr   cpsr_c, #kOffMasks
  ldr   sp, =core1_stack_top
  bl    prepare_core
  bl    enable_caches
  bl    core1_main
  b     sleep_for_ever

@ Floating point, exception vectors, and empty caches.
prepare_core:
  mov   r12, lr
  ldr   r0, =kSctlrOff
  mcr   p15, 0, r0, c1, c0, 0
  isb
  mov   r0, #0
  mcr   p15, 0, r0, c8, c7, 0    @ TLBs
  mcr   p15, 0, r0, c7, c5, 0    @ I-cache
  mcr   p15, 0, r0, c7, c5, 6    @ branch predictor
  bl    invalidate_data_cache
  ldr   r0, =vectors
  mcr   p15, 0, r0, c12, c0, 0
  mrc   p15, 0, r0, c1, c0, 2
  orr   r0, r0, #0x00f00000      @ coprocessors 10 and 11: VFP and NEON
  mcr   p15, 0, r0, c1, c0, 2
  isb
  mov   r0, #0x40000000
  vmsr  fpexc, r0
  mov   r0, #0
  vmsr  fpscr, r0                @ round to nearest, denormals as IEEE 754 says
  dsb
  isb
  bx    r12

@ All lines of the L1 data cache, by set and way.
invalidate_data_cache:
  mov   r0, #0
  mcr   p15, 2, r0, c0, c0, 0    @ CSSELR: L1 data
  isb
  mrc   p15, 1, r0, c0, c0, 0    @ CCSIDR
  and   r1, r0, #7
  add   r1, r1, #4               @ log2 of the bytes in a line
  ldr   r2, =0x7fff
  and   r2, r2, r0, lsr #13      @ last set
  ldr   r3, =0x3ff
  ands  r3, r3, r0, lsr #3       @ last way
  clz   r4, r3                   @ position of the way in the operand
next_set:
  mov   r5, r3
next_way:
  lsl   r6, r5, r4
  orr   r6, r6, r2, lsl r1
  mcr   p15, 0, r6, c7, c6, 2    @ DCISW
  subs  r5, r5, #1
  bge   next_way
  subs  r2, r2, #1
  bge   next_set
  dsb
  bx    lr

@ MMU, caches and coherency, with the table that core 0 has written.
enable_caches:
  ldr   r0, =page_table
  orr   r0, r0, #0x4a            @ table walks: write-back, write-allocate, shared
  mcr   p15, 0, r0, c2, c0, 0    @ TTBR0
  mov   r0, #0
  mcr   p15, 0, r0, c2, c0, 2    @ TTBCR: TTBR0 for all addresses
  mov   r0, #1
  mcr   p15, 0, r0, c3, c0, 0    @ DACR: domain 0 as its permissions say
  mrc   p15, 0, r0, c1, c0, 1
  orr   r0, r0, #kActlrSmp
  mcr   p15, 0, r0, c1, c0, 1
  dsb
  isb
  mrc   p15, 0, r0, c1, c0, 0
  ldr   r1, =kSctlrOn
  orr   r0, r0, r1
  mcr   p15, 0, r0, c1, c0, 0
  dsb
  isb
  bx    lr
