// Runs an image until it ends: node run.mjs IMAGE. The console goes to stdout, the emulator's complaints to stderr, and
// the exit code is the program's.
import { Pico } from "./pico.mjs";

// The line that the board writes when its program ends is the emulator's exit code, and no part of the console.
let line = "";
function onText(text) {
  line += text;
  if (!line.endsWith("\n")) return;
  if (!/^exit \d+\n$/.test(line)) process.stdout.write(line);
  line = "";
}

const pico = new Pico(process.argv[2], { onText });
pico.run(() => false, 60);
process.stdout.write(line);
for (const complaint of pico.complaints) process.stderr.write(`${complaint}\n`);
process.exitCode = pico.exitCode ?? 124;
