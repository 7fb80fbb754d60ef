// Runs an image that shows frames on the display: node frames.mjs IMAGE --trace FILE --until TEXT [--seconds N], and what
// else is asked of it. Ends when the console says TEXT, writes the trace of the display's wires, and prints a line of JSON:
// what the board's time went into.
//
//   --feeds N            end when the watchdog has been fed N times instead; the trace ends with the last whole command
//   --stick BYTE         the serial interface stops for good at that byte, until the program has noticed
//   --stick-fill NUMBER  the DMA's transfer from memory to memory with that number never ends
//   --reset-at BYTE      somebody presses reset at that byte
//   --hang BYTE          the program hangs at that byte, until the watchdog resets the chip
//   --mute               nobody answers where an ILI9341 is expected: its line back is not connected
//   --ili9341            an ILI9341 answers when it is asked who it is
//   --slowness FACTOR    bytes take so many times longer than the serial clock says
//   --time ADDRESS       the cycles of each call of the function there, in `calls`
import { writeFileSync } from "node:fs";
import { parseArgs } from "node:util";
import { Pico } from "./pico.mjs";

const ILI9341 = { command: 0xd3, answer: [0x00, 0x00, 0x93, 0x41] };

const { values: options, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    trace: { type: "string" },
    until: { type: "string" },
    feeds: { type: "string", default: "Infinity" },
    seconds: { type: "string", default: "10" },
    stick: { type: "string", default: "Infinity" },
    "stick-fill": { type: "string", default: "Infinity" },
    "reset-at": { type: "string", default: "Infinity" },
    hang: { type: "string", default: "Infinity" },
    mute: { type: "boolean", default: false },
    ili9341: { type: "boolean", default: false },
    slowness: { type: "string", default: "1" },
    time: { type: "string" },
  },
});

const calls = [];
function timer(address) {
  let [from, back] = [0, -1];
  return (core) => {
    if (core.PC === address) [from, back] = [core.cycles, core.LR & ~1];
    else if (core.PC === back) {
      calls.push(core.cycles - from);
      back = -1;
    }
  };
}

const pico = new Pico(positionals[0], {
  onText: (text) => process.stderr.write(text),
  onInstruction: options.time ? timer(Number(options.time)) : undefined,
});
pico.stickAt = Number(options.stick);
pico.stickFillAt = Number(options["stick-fill"]);
pico.hangAt = Number(options.hang);
pico.slowness = Number(options.slowness);
if (options.ili9341 && !options.mute) pico.identity = ILI9341;
const resetAt = Number(options["reset-at"]);

function intervene() {
  if (pico.stuck && /bus_timeout/.test(pico.console)) pico.recover();
  if (pico.resets === 0 && pico.trace.records >= resetAt) pico.reset();
}

const feeds = Number(options.feeds);
const inTime = pico.run(() => {
  intervene();
  return (options.until !== undefined && pico.console.includes(options.until)) || pico.fed.length >= feeds;
}, Number(options.seconds));

if (pico.fed.length >= feeds) pico.trace.dropLastCommand();
if (options.trace) writeFileSync(options.trace, pico.trace.data());
for (const complaint of new Set(pico.complaints)) process.stderr.write(`emulator: ${complaint}\n`);
const frames = pico.fed.slice(1).map((cycles, i) => cycles - pico.fed[i]);
process.stdout.write(
  `${JSON.stringify({
    console: pico.console,
    exit: pico.exitCode,
    inTime,
    frames, // cycles from one feeding of the watchdog to the next
    calls,
    wireCycles: Math.round(pico.wireCycles),
    cycles: pico.cycles,
    resets: pico.resets,
    faults: pico.faults,
    complaints: pico.complaints.length,
  })}\n`,
);
process.exitCode = inTime && pico.complaints.length === 0 ? 0 : 1;
