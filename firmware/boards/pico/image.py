#!/usr/bin/env python3
"""Finishes an image for the RP2040: puts the CRC32 of the second boot stage into its last four bytes, in the ELF itself,
and writes a UF2 beside it, the file to drop on the board's drive (RP2040 data sheet, section 2.8.4.2; the UF2 format's
own specification)."""

import pathlib
import struct
import sys

FLASH = 0x10000000
BOOT2 = 252
FAMILY = 0xE48BFF56
PAYLOAD = 256
UF2_START, UF2_MIDDLE, UF2_END, UF2_HAS_FAMILY = 0x0A324655, 0x9E5D5157, 0x0AB16F30, 0x2000


def crc32(data):
    """As the boot ROM computes it: polynomial 04C11DB7, most significant bit first, start FFFFFFFF, no final change."""
    crc = 0xFFFFFFFF
    for byte in data:
        crc ^= byte << 24
        for _ in range(8):
            crc = (crc << 1 ^ (0x04C11DB7 if crc & 0x80000000 else 0)) & 0xFFFFFFFF
    return crc


def flash_segments(elf):
    """(address, offset in the file, size) of what the ELF wants in flash."""
    headers, size, count = (struct.unpack_from(kind, elf, at)[0] for kind, at in (("<I", 28), ("<H", 42), ("<H", 44)))
    for i in range(count):
        kind, offset, _, address, in_file = struct.unpack_from("<5I", elf, headers + i * size)
        if kind == 1 and in_file and FLASH <= address < FLASH + 0x1000000:
            yield address, offset, in_file


def put_crc(elf):
    for address, offset, size in flash_segments(elf):
        if address == FLASH and size >= BOOT2 + 4:
            struct.pack_into("<I", elf, offset + BOOT2, crc32(elf[offset : offset + BOOT2]))
            return
    sys.exit("image.py: error: no second boot stage at the start of flash")


def uf2(elf):
    """Whole blocks of 256 bytes, gaps filled with FF as in erased flash."""
    flash = {}
    for address, offset, size in flash_segments(elf):
        for i in range(size):
            flash.setdefault((address + i) // PAYLOAD, bytearray(b"\xff" * PAYLOAD))[(address + i) % PAYLOAD] = elf[offset + i]
    blocks = sorted(flash)
    return b"".join(
        struct.pack("<8I", UF2_START, UF2_MIDDLE, UF2_HAS_FAMILY, block * PAYLOAD, PAYLOAD, number, len(blocks), FAMILY)
        + flash[block] + bytes(476 - PAYLOAD) + struct.pack("<I", UF2_END)
        for number, block in enumerate(blocks)
    )  # fmt: skip


def main():
    path = pathlib.Path(sys.argv[1])
    elf = bytearray(path.read_bytes())
    put_crc(elf)
    path.write_bytes(elf)
    path.with_suffix(".uf2").write_bytes(uf2(elf))


if __name__ == "__main__":
    main()
