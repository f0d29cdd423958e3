import type { AskView, FromCell, LackView, TeachOrder, ToCell } from '../wire';

/** What the cell said to a command. */
export type Answer = { ok: boolean; why: LackView | null };

/** How the connection stands. */
export type LinkState = 'closed' | 'opening' | 'open';

/** What the socket tells its owner. */
export type LinkEvents = {
  state(state: LinkState): void;
  message(message: FromCell): void;
};

/** A command that the connection lost is not known to have been done; nothing is ever sent twice. */
type Unnumbered<T> = T extends unknown ? Omit<T, 'seq'> : never;
/** A motion by hand, without its number. */
export type Move = Unnumbered<Extract<ToCell, { kind: 'jog' | 'step' | 'go' }>>;

const LOST: Answer = { ok: false, why: { key: 'lost', code: 'panel-lack-lost', text: 'the connection was lost', arguments: [] } };
const WAITS_MS = [300, 600, 1200, 2500];

/**
 * The socket to the cell. It opens anew by itself when it closes, and resumes nothing: numbers begin at 1 again, commands
 * without an answer are answered as lost, no token is asked for.
 */
export class Link {
  private socket: WebSocket | null = null;
  private seq = 0;
  private jogSeq = 0;
  private tries = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private readonly waiting = new Map<number, (answer: Answer) => void>();
  private wanted = false;

  constructor(
    private readonly address: string,
    private readonly events: LinkEvents,
    private readonly make: (address: string) => WebSocket = (a) => new WebSocket(a),
  ) {}

  open(): void {
    this.wanted = true;
    if (this.socket) return;
    clearTimeout(this.timer);
    this.events.state('opening');
    const socket = this.make(this.address);
    this.socket = socket;
    socket.onopen = () => {
      this.seq = 0;
      this.jogSeq = 0;
      this.tries = 0;
      this.events.state('open');
    };
    socket.onmessage = (event) => this.take(JSON.parse(event.data as string) as FromCell);
    socket.onclose = () => this.closed(socket);
  }

  close(): void {
    this.wanted = false;
    clearTimeout(this.timer);
    this.socket?.close();
  }

  ask(ask: AskView): Promise<Answer> {
    return this.command({ kind: 'command', seq: ++this.seq, ask });
  }

  teach(order: TeachOrder): Promise<Answer> {
    return this.command({ kind: 'teach', seq: ++this.seq, order });
  }

  private command(message: Extract<ToCell, { kind: 'command' | 'teach' }>): Promise<Answer> {
    if (!this.send(message)) return Promise.resolve(LOST);
    return new Promise((done) => this.waiting.set(message.seq, done));
  }

  /** Motion by hand, said again as long as a key is held. */
  move(by: Move): void {
    this.send({ ...by, seq: ++this.jogSeq });
  }

  /** False if there is no open connection: then nothing was sent, now or later. */
  send(message: ToCell): boolean {
    if (this.socket?.readyState !== 1) return false;
    this.socket.send(JSON.stringify(message));
    return true;
  }

  private take(message: FromCell): void {
    if (message.kind === 'answer') {
      this.waiting.get(message.seq)?.({ ok: message.ok, why: message.why });
      this.waiting.delete(message.seq);
    }
    this.events.message(message);
  }

  private closed(socket: WebSocket): void {
    if (this.socket !== socket) return;
    this.socket = null;
    this.waiting.forEach((done) => done(LOST));
    this.waiting.clear();
    this.events.state('closed');
    if (!this.wanted) return;
    const wait = WAITS_MS[Math.min(this.tries++, WAITS_MS.length - 1)];
    this.timer = setTimeout(() => this.open(), wait);
  }
}
