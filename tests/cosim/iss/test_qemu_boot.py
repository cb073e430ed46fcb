"""test_qemu_boot.py CONTROLLER_ELF BOOT_IMAGE SCENARIO: the firmware starts on the Zynq-7020 of QEMU: page table, MMU, caches,
floating point, the controller, interrupt controller and timer, up to the first access of the logic, which QEMU does not have.

QEMU 7.2 has one core of the two. Without the program qemu-system-arm the test is skipped.
"""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

QEMU = "qemu-system-arm"
LONGEST_S = 60
SKIPPED = 77
HOST_MEMORY = 0x1000_0000  # controller/board/memory.ld
LOGIC = range(0x4000_0000, 0x4400_0000)
ACCESS = re.compile(r"Invalid (?:read|write) at addr 0x(\w+)")


def log_of_boot(elf, image, log):
    """What QEMU told until the first access of an address that it does not have."""
    words = [QEMU, "-M", "xilinx-zynq-a9", "-m", "1024", "-display", "none", "-serial", "none", "-monitor", "none"]
    words += ["-kernel", elf, "-device", f"loader,file={image},addr={HOST_MEMORY:#x},force-raw=on"]
    qemu = subprocess.Popen([*words, "-d", "int,guest_errors", "-D", log])
    try:
        end = time.monotonic() + LONGEST_S
        while time.monotonic() < end and qemu.poll() is None:
            text = log.read_text() if log.exists() else ""
            if ACCESS.search(text) or "Taking exception" in text:
                return text
            time.sleep(0.05)
        return log.read_text()
    finally:
        qemu.kill()
        qemu.wait()


def main(elf, boot_image, scenario):
    if not shutil.which(QEMU):
        print(f"{QEMU} is not installed")
        return SKIPPED
    with tempfile.TemporaryDirectory() as folder:
        image = pathlib.Path(folder, "boot.bin")
        subprocess.run([boot_image, scenario, image], check=True)
        text = log_of_boot(elf, image, pathlib.Path(folder, "log.txt"))
    access = ACCESS.search(text)
    if "Taking exception" in text or not access or int(access[1], 16) not in LOGIC:
        print(f"expected an access of the logic as the first one that QEMU refuses, and no exception:\n{text}")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
