// What is in a Pico's files: node image.mjs IMAGE.elf. The second boot stage's CRC32 is right; those instructions, run by
// themselves, switch the flash interface on and jump to the program; the UF2 beside it is whole by npm `uf2`'s own reading,
// and holds exactly what the ELF puts into flash.
import { readFileSync } from "node:fs";
import { Pico, flashSegments } from "./pico.mjs";

const { decodeBlock } = await import(new URL("../../build/rp2040/node_modules/uf2/dist/cjs/uf2.js", import.meta.url));

const FLASH = 0x10000000;
const RP2040 = 0xe48bff56;
const path = process.argv[2];

function require(condition, text) {
  if (condition) return;
  process.stderr.write(`image.mjs: ${path}: ${text}\n`);
  process.exit(1);
}

/** The boot ROM's CRC32: polynomial 04C11DB7 from the most significant bit, start FFFFFFFF. By a table, unlike image.py. */
const table = Array.from({ length: 256 }, (_, index) => {
  let value = index << 24;
  for (let bit = 0; bit < 8; ++bit) value = (value << 1) ^ (value < 0 ? 0x04c11db7 : 0);
  return value;
});
const crc32 = (bytes) => bytes.reduce((crc, byte) => (crc << 8) ^ table[(crc >>> 24) ^ byte], -1) >>> 0;

const elf = readFileSync(path);
const flash = new Map();
for (const [address, bytes] of flashSegments(elf)) bytes.forEach((byte, i) => flash.set(address + i, byte));

// The second boot stage.
const boot2 = Uint8Array.from({ length: 256 }, (_, i) => flash.get(FLASH + i));
require(crc32([..."123456789"].map((c) => c.charCodeAt(0))) === 0x0376e6e7, "the test's own CRC32 is wrong");
require(crc32(boot2.subarray(0, 252)) === new DataView(boot2.buffer).getUint32(252, true), "wrong CRC32 of the second boot stage");

const pico = new Pico(path);
const entry = 0x20041f00;
boot2.forEach((byte, i) => pico.mcu.writeUint8(entry + i, byte));
const { core } = pico;
Object.assign(core, { VTOR: 0, SP: 0x20041f00, PC: entry });
core.LR = 0; // so the boot ROM calls it
let steps = 0;
while (core.PC !== (pico.mcu.readUint32(0x10000104) & ~1) && ++steps < 10_000) core.executeInstruction();
require(steps < 10_000, "the second boot stage does not reach the program");
require(core.VTOR === 0x10000100, "the second boot stage leaves the vector table where it was");
require(core.SP === pico.mcu.readUint32(0x10000100), "the second boot stage sets another stack pointer");
const serial = (offset) => pico.mcu.readUint32(0x18000000 + offset);
require(serial(0x08) === 1 && serial(0x14) === 2, "the flash interface is off, or has another divider");
require(serial(0x00) === 0x005f0300 && serial(0xf4) >>> 0 === 0xa0002022, "the flash interface reads in another mode");

// The UF2.
const file = readFileSync(path.replace(/\.elf$/, ".uf2"));
require(file.length % 512 === 0 && file.length > 0, "the UF2 is not made of whole blocks");
const dropped = new Map();
for (let i = 0; i < file.length / 512; ++i) {
  const block = decodeBlock(new Uint8Array(file.subarray(512 * i, 512 * (i + 1))));
  require(block.boardFamily === RP2040, "a block is for another chip");
  require(block.blockNumber === i && block.totalBlocks === file.length / 512, "blocks are miscounted");
  require(block.payload.length === 256 && block.flashAddress % 256 === 0, "a block is no page of flash");
  block.payload.forEach((byte, at) => dropped.set(block.flashAddress + at, byte));
}
for (const [address, byte] of flash) require(dropped.get(address) === byte, `the UF2 differs at ${address.toString(16)}`);
process.stdout.write(`${flash.size} bytes of flash, ${file.length / 512} blocks, second boot stage in ${steps} instructions\n`);
