// What the mock's cell does: modes and one weld played along its path, fast and simple. It decides nothing worth a test.
import { machine, pose, work } from './weld.mjs';

const STEP_S = 1 / 30;
const SPEED_UP = 4;
/** A start this much before what is welded welds nothing again. */
const SAME_MM = 0.5;

/** What tracking finds at a place: a part that lies elsewhere, and a tack that hides the joint for a while. */
function tracked(s) {
  const deviation = [1.2 * Math.sin(s / 260) + 0.05 * Math.sin(s / 7), 0.4 * Math.cos(s / 180)];
  const hidden = s % 400 > 370;
  return { head: 1, deviation_mm: deviation, correction_mm: deviation.map((d) => d - 0.03), confidence: hidden ? 0.4 : 0.96, sigma_mm: hidden ? 0.2 : 0.02, state: hidden ? 'coasted' : 'seen' };
}

/** A reason why a command is refused, as the server sends it. */
const lack = (key, text) => ({ key, code: 'text', text, arguments: [['text', { type: 'text', value: text }]] });

export class Cell {
  constructor(send) {
    this.send = send;
    this.t = 0;
    this.mode = 'off';
    this.axes = machine.axes.map((axis) => axis.home * 0.8);
    this.referenced = false;
    this.pass = 0;
    this.s = 0;
    this.welded = 0;
    this.override = 1;
    this.armedUntil = -1;
    this.before = 'weld';
    this.work = null;
    this.events = [];
    this.alarms = [];
    this.wants = null;
    this.number = 0;
    /** Welds that were left, by job and part. */
    this.unfinished = new Map();
    this.part = '';
    /** How much of what is welded is welded over on purpose, mm. */
    this.overlap = 0;
  }

  /** What is in the cell, as unfinished welds are remembered. */
  key() {
    return `${this.work?.job} ${this.part}`;
  }

  left() {
    const here = this.unfinished.get(this.key());
    if (here) return { ...here, here: true };
    const newest = [...this.unfinished.values()].at(-1);
    return newest ? { ...newest, here: false } : null;
  }

  event(what, text, user = null) {
    const event = { kind: 'event', number: (this.number += 1), t: this.t, at: new Date().toISOString(), what, key: what, code: 'text', text, arguments: [['text', { type: 'text', value: text }]], user };
    this.events = [...this.events.slice(-99), event];
    this.send(event);
  }

  turn(mode) {
    if (mode === this.mode) return;
    this.mode = mode;
    this.event('mode', `${mode}`);
  }

  load(job, from, part, overlap) {
    this.part = part ?? '';
    this.overlap = overlap ?? 0;
    this.work = work((this.work?.id ?? 0) + 1, job, from);
    this.send({ kind: 'work', work: this.work });
    this.event('work', `loaded ${job}`);
    return undefined;
  }

  lacks(ask) {
    const found = [];
    const allowed = { switch_on: ['off'], home: ['idle', 'ready'], start_jog: ['ready'], start_dry_run: ['ready'], start_weld: ['ready'], resume: ['hold'], reset: ['fault'] }[ask] ?? [];
    if (allowed.length > 0 && !allowed.includes(this.mode)) found.push(lack('mode', `allowed in ${allowed.join(', ')}`));
    if (['start_weld', 'start_dry_run'].includes(ask) && !this.work) found.push(lack('work', 'no program is loaded'));
    const burns = ask === 'start_weld' || (ask === 'resume' && this.before === 'weld');
    if (burns && this.armedUntil < this.t) found.push(lack('arming', 'arm first'));
    if (ask !== 'reset' && this.alarms.length > 0) found.push(lack('alarm', this.alarms[0].name));
    return found;
  }

  ask({ do: what, part, reweld }) {
    const [first] = this.lacks(what);
    if (first) return first;
    const left = this.unfinished.get(this.key());
    const [pass, s] = this.work?.from ?? [1, 0];
    const again = left && (pass < left.pass || (pass === left.pass && s < left.s_mm - this.overlap - SAME_MM));
    if (what === 'start_weld' && again && !reweld) {
      return lack('finished_pass', `part ${this.part} is welded up to pass ${left.pass}, ${left.s_mm.toFixed(1)} mm`);
    }
    const runs = ['weld', 'dry_run'].includes(this.mode);
    if (what === 'switch_on') this.turn(this.referenced ? 'ready' : 'idle');
    else if (what === 'switch_off') this.turn('off');
    else if (what === 'home') this.turn('homing');
    else if (what === 'start_jog') this.turn('jog');
    else if (what === 'arm') this.armedUntil = this.t + 60;
    else if (what === 'start_weld' || what === 'start_dry_run') {
      this.before = what === 'start_weld' ? 'weld' : 'dry_run';
      [this.pass, this.s] = this.work.from ?? [1, 0];
      this.welded = this.s;
      this.armedUntil = -1;
      this.turn(this.before);
    } else if (what === 'hold') this.turn(runs ? 'hold' : this.mode === 'jog' ? 'ready' : this.mode);
    else if (what === 'resume') {
      this.armedUntil = -1;
      this.turn(this.before);
    } else if (what === 'stop') {
      if (runs || this.mode === 'hold') {
        if (this.before === 'weld') {
          this.unfinished.delete(this.key());
          this.unfinished.set(this.key(), { pass: this.pass, s_mm: this.welded, finished: this.pass - 1, record: (this.number += 1), title: this.work.title, part: this.part });
        }
        this.event('left', `pass ${this.pass} at ${this.s.toFixed(1)} mm`);
        this.pass = 0;
        this.turn('ready');
      } else if (['jog', 'homing'].includes(this.mode)) this.turn('ready');
    } else if (what === 'override') this.override = part;
    else if (what === 'acknowledge') this.alarms = [];
    this.event('order', what, 'mock');
    if (what === 'acknowledge') this.send({ kind: 'alarms', list: this.alarms });
    return null;
  }

  jog(of, speeds) {
    if (this.mode === 'jog' && of === 'joints') this.wants = { speeds, until: this.t + 0.2 };
  }

  step() {
    this.t += STEP_S;
    if (this.mode === 'homing') {
      this.axes = this.axes.map((q, i) => q + Math.sign(machine.axes[i].home - q) * Math.min(1, Math.abs(machine.axes[i].home - q)));
      if (this.axes.every((q, i) => Math.abs(q - machine.axes[i].home) < 1e-6)) {
        this.referenced = true;
        this.turn('ready');
      }
    }
    if (this.mode === 'jog' && this.wants && this.wants.until > this.t) {
      this.axes = this.axes.map((q, i) => q + (this.wants.speeds[i] ?? 0) * machine.axes[i].max_speed * STEP_S);
    }
    if (this.mode === 'weld' || this.mode === 'dry_run') this.run();
  }

  run() {
    const pass = this.work.passes[this.pass - 1];
    this.s += pass.speed_mm_s * this.override * STEP_S * SPEED_UP;
    this.welded = Math.max(this.welded, this.s);
    const point = pass.path.find((p) => p.s_mm >= this.s);
    if (point) this.axes = point.axes;
    else if (this.pass < this.work.passes.length) {
      this.pass += 1;
      this.s = this.welded = 0;
      this.event('pass', `pass ${this.pass}`);
    } else {
      if (this.mode === 'weld') this.unfinished.delete(this.key());
      this.pass = 0;
      this.turn('ready');
    }
  }

  status() {
    const burns = this.mode === 'weld';
    const runs = burns || this.mode === 'dry_run';
    const { links, tip } = pose(this.axes);
    const noise = () => (Math.random() - 0.5) * 0.02;
    const powered = !['off', 'fault'].includes(this.mode);
    return {
      kind: 'status', t: this.t, mode: this.mode, pass: this.pass, s_mm: this.s, welded_mm: this.welded,
      stands: !runs, speed_mm_s: runs ? this.work.passes[this.pass - 1].speed_mm_s * this.override : 0, override_part: this.override, armed: this.armedUntil > this.t, powered,
      process: { state: burns ? 'burns' : 'off', on: burns, burning: burns, gas: burns, ready: true, stuck: false, fault: 0, phase: burns ? 'travel' : null,
        set: burns ? [240, 27, 8] : [null, null, null], measured: burns ? [238 + noise() * 200, 27.1 + noise() * 10, 8] : [0, 0, 0] },
      axes: this.axes.map((position) => ({ position, set: position, error: runs ? noise() : 0, current: powered ? 0.2 : 0, referenced: this.referenced, fault: false, limit_switch: false })),
      tip, links, conditions: [true, true],
      inputs: [true, true],
      tracking: burns ? [tracked(this.s)] : [],
      near: { distance_mm: Math.max(12, tip[2] + 60), least_mm: 1, between: ['gas nozzle', 'shell'], at: [[tip[0], tip[1], tip[2] + 12], [tip[0], tip[1], tip[2] - 8]] },
      ages: { drives: 0.001, source: 0.004, inputs: 0.01 }, missed: 7596, lost: 0, recording: burns ? 1 : null, left: this.left(), part: this.part, start: this.work ? (this.work.from ?? [1, 0]) : null, realtime: { missing: ['priority'], text: 'no real-time scheduling: permission denied' }, longest_gap_ms: 1203,
    };
  }
}
