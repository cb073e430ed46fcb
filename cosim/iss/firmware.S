# The bytes of the file ARMATURE_FIRMWARE.
  .section .rodata
  .global kArmatureFirmwareBegin, kArmatureFirmwareEnd
  .balign 8
kArmatureFirmwareBegin:
  .incbin ARMATURE_FIRMWARE
kArmatureFirmwareEnd:
  .section .note.GNU-stack, "", %progbits
