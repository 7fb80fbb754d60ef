// Cycles of the marked intervals of an image in rp2040js: node kernels.mjs IMAGE prints a line `report <instructions>
// <cycles>` for each. Markers are those of firmware/boards/cortex_m/cycle_markers.hpp, and are not counted.
import { Pico } from "./pico.mjs";

const [START, STOP, REPORT] = [0x46c9, 0x46d2, 0x46db];
let [counting, instructions, cycles, begin] = [false, 0, 0, 0];

const pico = new Pico(process.argv[2], {
  onInstruction(core) {
    const opcode = core.rp2040.readUint16(core.PC);
    if (opcode === START) {
      counting = true;
      begin = core.cycles + 1;
      return;
    }
    if (opcode === STOP) {
      counting = false;
      cycles += core.cycles - begin;
    } else if (opcode === REPORT) {
      process.stdout.write(`report ${instructions} ${cycles}\n`);
      [instructions, cycles] = [0, 0];
    }
    if (!counting) return;
    ++instructions;
    // rp2040js forgets lr when it counts what a PUSH stores.
    if (opcode >> 8 === 0xb5) ++cycles;
  },
});
pico.run(() => false, 10);
process.exitCode = pico.exitCode ?? 124;
