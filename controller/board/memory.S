@ memcpy and memset, 32 bytes at a time: the controller copies and clears many structures of 50 to 1000 bytes in a tick.
@ The last bytes are written once more with their neighbours, instead of one by one. Accesses are of bytes for the
@ processor, so nothing needs to be aligned, also without the MMU.

  .syntax unified
  .arm
  .fpu neon

  .section .text.memcpy, "ax"
  .global memcpy
  .type memcpy, %function
memcpy:                        @ r0: to, r1: from, r2: bytes; returns r0
  cmp   r2, #32
  add   r12, r0, r2            @ the end of both
  add   r2, r1, r2
  bls   copy_one_piece
  sub   r12, r12, #32          @ the last piece begins here
  sub   r2, r2, #32
  mov   r3, r0
copy:
  vld1.8 {d0-d3}, [r1]!
  vst1.8 {d0-d3}, [r3]!
  cmp   r3, r12
  blo   copy
  vld1.8 {d0-d3}, [r2]
  vst1.8 {d0-d3}, [r12]
  bx    lr
copy_one_piece:
  sub   r3, r12, r0
  cmp   r3, #16
  blo   copy_less
  vld1.8 {d0-d1}, [r1]
  sub   r2, r2, #16
  vld1.8 {d2-d3}, [r2]
  sub   r12, r12, #16
  vst1.8 {d0-d1}, [r0]
  vst1.8 {d2-d3}, [r12]
  bx    lr
copy_less:
  cmp   r3, #8
  blo   copy_bytes
  vld1.8 {d0}, [r1]
  sub   r2, r2, #8
  vld1.8 {d1}, [r2]
  sub   r12, r12, #8
  vst1.8 {d0}, [r0]
  vst1.8 {d1}, [r12]
  bx    lr
copy_bytes:
  cmp   r12, r0
  bxeq  lr
  ldrb  r3, [r2, #-1]!
  strb  r3, [r12, #-1]!
  b     copy_bytes
  .size memcpy, . - memcpy

  .section .text.memset, "ax"
  .global memset
  .type memset, %function
memset:                        @ r0: to, r1: byte, r2: bytes; returns r0
  cmp   r2, #32
  add   r12, r0, r2            @ the end
  vdup.8 q0, r1
  bls   set_one_piece
  vmov  q1, q0
  sub   r12, r12, #32          @ the last piece begins here
  mov   r3, r0
set:
  vst1.8 {d0-d3}, [r3]!
  cmp   r3, r12
  blo   set
  vst1.8 {d0-d3}, [r12]
  bx    lr
set_one_piece:
  cmp   r2, #16
  blo   set_less
  sub   r12, r12, #16
  vst1.8 {d0-d1}, [r0]
  vst1.8 {d0-d1}, [r12]
  bx    lr
set_less:
  cmp   r2, #8
  blo   set_bytes
  sub   r12, r12, #8
  vst1.8 {d0}, [r0]
  vst1.8 {d0}, [r12]
  bx    lr
set_bytes:
  cmp   r12, r0
  bxeq  lr
  strb  r1, [r12, #-1]!
  b     set_bytes
  .size memset, . - memset
