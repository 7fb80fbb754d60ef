// A Raspberry Pi Pico in rp2040js with an image of this project and a display on its SPI0: what a test or the demo needs
// to run it, to see each byte on the display's wires at the time at which it is there, and to break things.
//
// There is no boot ROM here, so the second boot stage does not run: the core starts at the vector table, as it would
// behind it (boot2.mjs runs those instructions by themselves).
import { readFileSync } from "node:fs";

const modules = new URL("../../build/rp2040/node_modules/", import.meta.url);
const { RP2040, GPIOPinState, ConsoleLogger, LogLevel } = await import(new URL("rp2040js/dist/esm/index.js", modules));
const { SimulationClock } = await import(new URL("rp2040js/dist/esm/clock/simulation-clock.js", modules));

const FLASH = 0x10000000;
const FLASH_END = 0x11000000;
const VECTORS = 0x10000100;
const HARD_FAULT = 3;
const LOCKUP = 125;
// The stack's guard is a region of the memory protection unit, which rp2040js has not.
const NO_MPU = /^Unimplemented peripheral write to 0x(d9|da)/;
const pins = { chipSelect: 17, dataCommand: 20, reset: 21, backlight: 22 };
const watchdogLoad = 0x04;
const watchdogSelect = 0x08;
// Every block of the power-on state machine but the two oscillators (RP2040 data sheet, section 2.13).
const ALL_BUT_OSCILLATORS = 0x1fffc;
const serialPrescaler = 0x10;
const SPI0_RESET = 1 << 16;
const UNPACED = 0x3f;

/** What a record of a trace tells (panel_trace.cpp reads them). */
export const Kind = { byte: 0, reset: 1, clock: 2, read: 3, backlight: 4 };
const RECORD = 12;

/** The parts of an ELF that belong in flash, as [address, bytes]. */
export function flashSegments(elf) {
  const view = new DataView(elf.buffer, elf.byteOffset, elf.length);
  const [headers, size, count] = [view.getUint32(28, true), view.getUint16(42, true), view.getUint16(44, true)];
  const segments = [];
  for (let i = 0; i < count; ++i) {
    const at = headers + i * size;
    const [kind, offset, , address, bytes] = [0, 4, 8, 12, 16].map((field) => view.getUint32(at + field, true));
    if (kind === 1 && bytes !== 0 && address >= FLASH && address < FLASH_END)
      segments.push([address, elf.subarray(offset, offset + bytes)]);
  }
  return segments;
}

/** The bytes on the display's wires, in order: time in ns as a double, kind, levels (1 data, 2 selected, 4 not in reset),
 * value, nothing. A record of kind `clock` has the serial clock in hertz for its time. */
export class Trace {
  #bytes = Buffer.alloc(1 << 20);
  #used = 0;

  add(kind, time, levels, value) {
    if (this.#used + RECORD > this.#bytes.length) this.#bytes = Buffer.concat([this.#bytes, Buffer.alloc(this.#bytes.length)]);
    this.#bytes.writeDoubleLE(time, this.#used);
    this.#bytes[this.#used + 8] = kind;
    this.#bytes[this.#used + 9] = levels;
    this.#bytes[this.#used + 10] = value;
    this.#used += RECORD;
  }
  get records() {
    return this.#used / RECORD;
  }
  /** Drops the last command and what belongs to it: where a run stops, the display is in the middle of it. */
  dropLastCommand() {
    const isCommand = () => this.#bytes[this.#used + 8] === Kind.byte && (this.#bytes[this.#used + 9] & 1) === 0;
    while (this.#used > 0) {
      this.#used -= RECORD;
      if (isCommand()) return;
    }
  }
  data() {
    return this.#bytes.subarray(0, this.#used);
  }
}

export class Pico {
  console = "";
  trace = new Trace();
  /** Complaints of the emulator: accesses to nowhere, instructions that it does not know. */
  complaints = [];
  /** Cycle counts at which the watchdog was fed, which programs do once a frame. */
  fed = [];
  resets = 0;
  faults = 0;
  /** Byte number on the wires at which the serial interface stops for good; starts again by recover(). */
  stickAt = Infinity;
  /** Number of the transfer from memory to memory that never gets going. */
  stickFillAt = Infinity;
  /** Number of bytes sent at which the program hangs, interrupts and all, until something resets the chip. */
  hangAt = Infinity;
  /** How many times longer than its clock says a byte takes. */
  slowness = 1;
  /** What the display answers when it is asked who it is: {command, answer}. Without, its line stays high. */
  identity = null;
  /** Cycles in which the serial interface was sending. */
  wireCycles = 0;

  #clock = new SimulationClock();
  #elf;
  #stopped = false;
  #bytesSent = 0;
  #hung = false;
  #fills = 0;
  #answer = [];
  #exit = null;
  #pastCycles = 0;

  /** `options.onText(text)` is told of the console. */
  constructor(image, options = {}) {
    this.#elf = readFileSync(image);
    this.options = options;
    this.#powerUp();
  }

  get core() {
    return this.mcu.core;
  }
  /** Of the core since the start, resets included. */
  get cycles() {
    return this.#pastCycles + this.core.cycles;
  }
  get nanos() {
    return this.#clock.nanos;
  }
  get exitCode() {
    return this.#exit;
  }

  #powerUp() {
    const mcu = new RP2040(this.#clock);
    this.mcu = mcu;
    mcu.logger = this.#logger();
    for (const [address, bytes] of flashSegments(this.#elf)) mcu.flash.set(bytes, address - FLASH);
    mcu.core.VTOR = VECTORS;
    mcu.core.SP = mcu.readUint32(VECTORS);
    mcu.core.PC = mcu.readUint32(VECTORS + 4) & ~1;
    mcu.onBreak = () => (this.pendingFault = true);
    mcu.uart[0].onByte = (byte) => this.#onConsole(String.fromCharCode(byte));
    this.#connectDisplay(mcu);
    this.#watchWatchdog(mcu);
    this.#paceMemory(mcu);
  }

  #logger() {
    const logger = new ConsoleLogger(LogLevel.Warn, false);
    logger.warn = logger.error = (part, message) => {
      if (NO_MPU.test(message)) return;
      this.complaints.push(`${part}: ${message}`);
      // Silicon answers an access to nowhere with a fault, which rp2040js has not.
      if (/undefined address|invalid memory/.test(message)) this.pendingFault = true;
    };
    return logger;
  }

  #onConsole(text) {
    this.console += text;
    this.options.onText?.(text);
    const ended = /^exit (\d+)\n/m.exec(this.console);
    if (ended) this.#exit = Number(ended[1]);
  }

  #high(pin) {
    return this.mcu.gpio[pin].value === GPIOPinState.High;
  }
  #levels() {
    // Boards and modules pull the reset line up: it is low where the program drives it low.
    const reset = this.mcu.gpio[pins.reset].value === GPIOPinState.Low;
    return (this.#high(pins.dataCommand) ? 1 : 0) | (this.#high(pins.chipSelect) ? 0 : 2) | (reset ? 0 : 4);
  }

  #connectDisplay(mcu) {
    const spi = mcu.spi[0];
    let clockSeen = 0;
    const done = this.#clock.createAlarm(() => {
      if (this.mcu === mcu) spi.completeTransmit(this.#answer.length ? this.#answer.shift() : 0xff);
    });
    spi.onTransmit = (value) => {
      if (this.mcu !== mcu) return;
      const levels = this.#levels();
      const answering = this.#answerTo(levels, value);
      if (!answering && spi.clockFrequency !== clockSeen) {
        clockSeen = spi.clockFrequency;
        this.trace.add(Kind.clock, clockSeen, levels, 0);
      }
      const duration = (spi.dataBits / spi.clockFrequency) * 1e9 * this.slowness;
      this.trace.add(answering ? Kind.read : Kind.byte, this.nanos + duration, levels, value);
      this.wireCycles += duration / 8;
      if (++this.#bytesSent === this.hangAt) this.#hung = true;
      if (this.#bytesSent >= this.stickAt) this.#stopped = true;
      else done.schedule(duration);
    };
    // The PL022 is configured while it is off; rp2040js takes a new clock at any time.
    const writeSerial = spi.writeUint32.bind(spi);
    spi.writeUint32 = (offset, value) => {
      if (offset === serialPrescaler && spi.enabled) this.complaints.push("SPI0: the prescaler changes while the port is on");
      writeSerial(offset, value);
    };
    // Taking the block into reset empties it, which rp2040js leaves out.
    const resets = mcu.peripherals[0x4000c];
    const write = resets.writeUint32.bind(resets);
    resets.writeUint32 = (offset, value) => {
      if (offset === 0 && value & SPI0_RESET) {
        while (!spi.txFIFO.empty) spi.txFIFO.pull();
        while (!spi.rxFIFO.empty) spi.rxFIFO.pull();
        spi.busy = false;
        done.cancel();
        spi.fifosUpdated();
      }
      write(offset, value);
    };
    const resetPin = mcu.gpio[pins.reset];
    resetPin.addListener(() => this.trace.add(Kind.reset, this.nanos, this.#levels(), 0));
    // A transistor holds the light off while the pin floats, as it does after a reset.
    let lit = true;
    const light = () => {
      if (lit === this.#high(pins.backlight)) return;
      lit = this.#high(pins.backlight);
      this.trace.add(Kind.backlight, this.nanos, this.#levels(), lit ? 1 : 0);
    };
    mcu.gpio[pins.backlight].addListener(light);
    light();
  }

  /** Whether a byte belongs to a question to the display, which the panel's model does not see. */
  #answerTo(levels, value) {
    const isCommand = (levels & 1) === 0;
    if (isCommand) this.#asking = value === 0x04 || value === 0xd3;
    if (isCommand && this.#asking && value === this.identity?.command) this.#answer = [0xff, ...this.identity.answer];
    return this.#asking;
  }
  #asking = false;

  /** Transfers from memory to memory take a cycle each, of all channels together (RP2040 data sheet, section 2.5); in
   * rp2040js they take no time. */
  #paceMemory(mcu) {
    const { channels } = mcu.dma;
    for (const channel of channels) {
      const schedule = channel.scheduleTransfer.bind(channel);
      channel.scheduleTransfer = () => {
        if (channel.treq !== UNPACED) return schedule();
        if (channel.transCount === channel.transCountReload && ++this.#fills === this.stickFillAt) return;
        const rivals = channels.filter((other) => other.active && other.treq === UNPACED).length;
        channel.transferAlarm.schedule((rivals * 1e9) / mcu.clkSys);
      };
    }
  }

  #watchWatchdog(mcu) {
    const watchdog = mcu.peripherals[0x40058];
    const write = watchdog.writeUint32.bind(watchdog);
    watchdog.writeUint32 = (offset, value) => {
      if (offset === watchdogLoad) this.fed.push(this.cycles);
      write(offset, value);
    };
    // A watchdog that runs out resets the blocks that the power-on state machine is told to, none after power-up. rp2040js
    // says that it ran out, whatever is selected.
    watchdog.onWatchdogTrigger = () => {
      watchdog.timer.enable = false; // it runs out once; rp2040js's would ring for ever
      if (this.mcu !== mcu) return;
      const selected = mcu.peripherals[0x40010].readUint32(watchdogSelect);
      if (selected === ALL_BUT_OSCILLATORS) this.pendingReset = true;
      else this.complaints.push(`watchdog: it resets the blocks 0x${selected.toString(16)}, which is not the whole chip`);
    };
  }

  /** A serial interface that stuck works again. */
  recover() {
    this.stickAt = Infinity;
    this.#stopped = false;
  }
  get stuck() {
    return this.#stopped;
  }

  /** The reset pin, or the watchdog: the display keeps its power and its memory. */
  reset() {
    ++this.resets;
    this.#pastCycles += this.core.cycles;
    this.pendingReset = false;
    this.#hung = false;
    for (const channel of this.mcu.dma.channels) channel.abort();
    this.#answer = [];
    this.#powerUp();
  }

  /** Executes until `enough()` says so, the program ends, or `seconds` of the board's time have gone by. */
  run(enough, seconds) {
    const end = this.nanos + seconds * 1e9;
    while (this.#exit === null && this.nanos < end && !enough())
      for (let i = 0; i < 64 && this.#exit === null; ++i) this.#step();
    return this.#exit !== null || this.nanos < end;
  }

  #step() {
    const { core } = this;
    const cycleNanos = 1e9 / this.mcu.clkSys;
    if (core.waiting || this.#hung) {
      const nanos = Math.max(this.#clock.nanosToNextAlarm, cycleNanos);
      core.cycles += Math.round(nanos / cycleNanos);
      this.#clock.tick(nanos);
    } else {
      const before = core.cycles;
      this.options.onInstruction?.(core);
      core.executeInstruction();
      this.#clock.tick((core.cycles - before) * cycleNanos);
    }
    if (this.pendingFault) this.#fault();
    if (this.pendingReset) this.reset();
  }

  #fault() {
    this.pendingFault = false;
    ++this.faults;
    if (this.core.IPSR === HARD_FAULT) {
      // A fault in its handler locks the core up.
      this.complaints.push("lockup");
      this.#exit = LOCKUP;
      return;
    }
    // The address of the instruction that faulted is what the core would push.
    this.core.PC -= this.core.breakRewind;
    this.core.breakRewind = 0;
    this.core.exceptionEntry(HARD_FAULT);
    this.core.PC &= ~1;
    this.pendingFault = false;
  }
}
