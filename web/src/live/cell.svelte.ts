import type {
  AlarmView,
  AskView,
  EventView,
  FromCell,
  LackView,
  Load,
  MachineView,
  RefusedView,
  Status,
  TeachOrder,
  TeachView,
  WorkView,
} from '../wire';
import { byUrgency } from '../panel/alarm_order';
import { api, usePage } from './api';
import { Link, type Answer, type LinkState, type Move } from './socket';
import { session } from './session.svelte';
import { Stopping } from './stopping.svelte';
import { shownSpeed, type Shown } from './speed';
import { Strip } from './status_strip';
import { Track } from './tracking_rows';

/** What is shown as numbers changes this often at most; charts and the 3D scene take every status. */
const SHOWN_MS = 100;
/** Older than this is greyed. */
export const STALE_MS = 500;
const MOST_EVENTS = 300;
/** The machine is asked for again after so long if there was no answer. */
const ASK_AGAIN_MS = 1000;

const CLOSED: TeachView = {
  phase: 'closed', job: '', key: null, why: null, way_mm: 0, nominal_mm: 0, frames: 0, confidence: 0, least_confidence: 0, picture: 0, size_px: [0, 0],
};

type Control = { station: number | null; user: string | null; mine: boolean };

/** Everything that the cell has said, for all parts of the panel. */
class Cell {
  state = $state<LinkState>('closed');
  status = $state.raw<Status | null>(null);
  /** Age of the newest status, ms. */
  age = $state(Infinity);
  /** How fast it goes, as it is shown. */
  speed = $state.raw<Shown>({ mm_s: NaN, of: 'path' });
  alarms = $state.raw<AlarmView[]>([]);
  events = $state.raw<EventView[]>([]);
  work = $state.raw<WorkView | null>(null);
  machine = $state.raw<MachineView | null>(null);
  /** How often the machine was asked for. */
  private asked = 0;
  control = $state.raw<Control>({ station: null, user: null, mine: false });
  /** Teaching by camera. */
  teach = $state.raw<TeachView>(CLOSED);
  /** What ran last, so what is held in a hold. */
  ran = $state<'dry_run' | 'weld' | null>(null);
  station = $state(0);
  version = $state('');
  /** Commands that the cell would refuse now, or that would have no effect, whoever gives them; null: it has not said. */
  unready = $state.raw<RefusedView[] | null>(null);
  /** What stands against the command that was last asked about. */
  lacks = $state.raw<{ ask: string; lacks: LackView[] } | null>(null);
  /** The last refused command, until the next one. */
  refused = $state.raw<{ ask: string; why: LackView } | null>(null);
  /** Times from asking to the answer, ms. */
  readonly answerTimes: number[] = [];
  readonly stopping = new Stopping({ socket: () => this.link?.ask({ do: 'stop' }) ?? null, request: () => api.stop() });
  readonly strip = new Strip();
  readonly track = new Track();
  /** The loaded program is tracked, as far as this panel has seen. */
  tracked = $state(false);

  /** Alarms that are not shelved, the most urgent first. */
  readonly seen = $derived(byUrgency(this.alarms.filter((alarm) => !alarm.shelved)));
  readonly stale = $derived(this.age > STALE_MS);
  /** What is shown is what the cell is doing now. */
  readonly current = $derived(this.state === 'open' && !this.stale);
  /** What the system does not grant to the cycle, in the system's words; empty if nothing is missing. */
  readonly unrealtime = $derived(this.status?.realtime.missing.length ? this.status.realtime.text : '');
  /** The longest time without a cycle, ms. */
  readonly longestGap = $derived(this.status?.longest_gap_ms ?? NaN);
  readonly mode = $derived(this.status?.mode ?? null);
  /** Axes follow the jog keys. */
  readonly jogs = $derived(this.mode === 'jog' || this.mode === 'teach');
  readonly powered = $derived(this.status?.powered ?? false);

  private link: Link | null = null;
  private worker: Worker | null = null;
  private ticker: ReturnType<typeof setInterval> | undefined;
  private heard = -Infinity;
  private shown = -Infinity;
  private newest: Status | null = null;
  private readonly listeners = new Set<(status: Status) => void>();

  begin(): void {
    if (this.link) return;
    const scheme = location.protocol === 'https:' ? 'wss' : 'ws';
    this.link = new Link(`${scheme}://${location.host}/api/live`, {
      state: (state) => this.turned(state),
      message: (message) => this.take(message),
    });
    this.worker = new Worker(new URL('./beat.worker.ts', import.meta.url), { type: 'module' });
    this.worker.onmessage = () => this.link?.send({ kind: 'beat' });
    this.ticker = setInterval(() => this.tick(), SHOWN_MS);
    this.link.open();
  }

  end(): void {
    this.link?.close();
    this.worker?.terminate();
    clearInterval(this.ticker);
    this.link = null;
    this.worker = null;
  }

  /** Sends a command; `null` keys of the answer mean that it was taken. */
  async ask(ask: AskView): Promise<Answer> {
    this.refused = null;
    const begun = performance.now();
    const answer = (await this.link?.ask(ask)) ?? { ok: false, why: null };
    this.answerTimes.push(performance.now() - begun);
    if (this.answerTimes.length > 200) this.answerTimes.shift();
    if (!answer.ok && answer.why) this.refused = { ask: ask.do, why: answer.why };
    return answer;
  }

  /** Why a command cannot be given now, as far as mode and power decide; null if it can. */
  against(order: string): LackView | null {
    return this.unready?.find((of) => of.ask === order)?.why ?? null;
  }

  can(order: string): boolean {
    return this.unready !== null && this.against(order) === null;
  }

  move(by: Move): void {
    this.link?.move(by);
  }

  async teaches(order: TeachOrder): Promise<Answer> {
    return (await this.link?.teach(order)) ?? { ok: false, why: null };
  }

  why(ask: string): void {
    this.link?.send({ kind: 'why', ask });
  }

  takeControl(over: boolean): void {
    this.link?.send({ kind: 'take_control', over });
  }

  giveControl(): void {
    this.link?.send({ kind: 'give_control' });
  }

  /** Plans the program of the cell once more, from where the axes are now, and loads it. */
  async reload(from: Load['from'], overlap_mm = 0): Promise<void> {
    const { work } = this;
    if (work) await api.load({ job: work.job, from, overlap_mm, part: this.status?.part || null, distortion: work.distortion });
  }

  /** Calls back for every status, until the function that is returned is called. */
  onStatus(listener: (status: Status) => void): () => void {
    this.listeners.add(listener);
    if (this.newest) listener(this.newest);
    return () => this.listeners.delete(listener);
  }

  async askMachine(): Promise<void> {
    const number = ++this.asked;
    const machine = await api.machine().catch(() => null);
    // Only the newest answer counts. Without one nothing may be shown or moved by the names of the machine before.
    if (number !== this.asked) return;
    this.machine = machine;
    this.strip.units = machine?.axes.map((axis) => axis.unit) ?? [];
    if (!machine && this.link) setTimeout(() => number === this.asked && this.link && void this.askMachine(), ASK_AGAIN_MS);
  }

  private turned(state: LinkState): void {
    this.state = state;
    if (state === 'open') return;
    this.control = { station: null, user: null, mine: false };
    this.lacks = null;
    this.unready = null;
    // The server may have ended the session.
    if (state === 'closed') void session.ask();
  }

  private tick(): void {
    this.age = performance.now() - this.heard;
    if (this.newest !== this.status) this.status = this.newest;
  }

  private take(message: FromCell): void {
    switch (message.kind) {
      case 'hello':
        this.station = message.station;
        usePage(message.station);
        this.version = message.version;
        break;
      case 'machine':
        void this.askMachine();
        break;
      case 'status':
        this.takeStatus(message);
        break;
      case 'alarms':
        this.alarms = message.list;
        break;
      case 'commands':
        this.unready = message.refused;
        break;
      case 'event':
        this.takeEvent(message);
        break;
      case 'work':
        if (message.work?.id !== this.work?.id) {
          this.track.clear();
          this.tracked = false;
        }
        this.work = message.work;
        break;
      case 'control':
        this.control = message;
        break;
      case 'teach':
        this.teach = message;
        break;
      case 'why':
        this.lacks = message;
        break;
      case 'answer':
        break;
    }
  }

  private takeStatus(status: Status): void {
    const now = performance.now();
    this.heard = now;
    this.newest = status;
    this.stopping.seen(status.mode);
    if (status.mode === 'dry_run' || status.mode === 'weld') this.ran = status.mode;
    this.strip.add(status);
    if (this.track.add(status, this.work?.passes[status.pass - 1]?.length_mm ?? 0)) this.tracked = true;
    // A mode that changed is shown at once.
    if (now - this.shown >= SHOWN_MS || status.mode !== this.status?.mode) {
      this.shown = now;
      this.age = 0;
      this.status = status;
      this.speed = shownSpeed(status, this.strip.newest('tip speed'));
    }
    for (const listener of this.listeners) listener(status);
  }

  private takeEvent(event: EventView): void {
    // After a reconnect the last hundred come again.
    if (this.events.some((e) => e.number === event.number && e.at === event.at)) return;
    this.events = [event, ...this.events].sort((a, b) => Date.parse(b.at) - Date.parse(a.at) || b.number - a.number).slice(0, MOST_EVENTS);
  }
}

export const cell = new Cell();
