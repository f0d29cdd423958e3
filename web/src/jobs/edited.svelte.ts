import { api, Refusal } from '../live/api';
import { session } from '../live/session.svelte';
import type { FormView, PlanAnswer, SectionView, WorkView, WrongView } from '../wire';
import { refusalText } from '../panel/refusal';
import { Sheet } from './sheet.svelte';

const PLAN_AFTER_MS = 500;
/** What needs no plan is drawn while a number is still being written. */
const DRAW_AFTER_MS = 120;
const STEPS = 500;
/** Forms of longer texts are read again when they are undone. */
const LONG_CHARS = 100_000;

/** A text to go back to, with its form and what is wrong with it if that is at hand. */
type Step = { text: string; form: FormView | null; wrong: WrongView | null };

/** The job that is being changed: its text, how it was before, and what the cell makes of it. */
class Edited extends Sheet {
  name = $state('');
  example = $state(false);
  /** The text as it is kept by the cell. */
  kept = $state('');
  open = $state(false);
  answer = $state.raw<PlanAnswer | null>(null);
  /** The newest good plan, for 3D, while the text is wrong for a moment. */
  work = $state.raw<WorkView | null>(null);
  /** The joint's cross-sections as the text has them now. */
  sections = $state.raw<SectionView[]>([]);
  plans = $state(false);
  /** For how long it has been planned, s; 0 while it is not. */
  planned_s = $state(0);
  /** Somebody has cancelled the plan of this text. */
  cancelled = $state(false);
  private past = $state.raw<Step[]>([]);
  private future = $state.raw<Step[]>([]);
  private timer: ReturnType<typeof setTimeout> | undefined;
  private asking: AbortController | null = null;
  private drawTimer: ReturnType<typeof setTimeout> | undefined;
  private drawing: AbortController | null = null;
  private group = '';
  private grouped = 0;

  readonly changed = $derived(this.text !== this.kept || this.operations > 0);
  /** Procedures that were changed here and not kept, by their names. */
  procedures = $state.raw<Readonly<Record<string, string>>>({});
  /** There is something that is lost when the job is left. */
  readonly unkept = $derived(this.changed || Object.keys(this.procedures).length > 0);
  readonly canUndo = $derived(this.past.length > 0);
  readonly canRedo = $derived(this.future.length > 0);

  begin(name: string, text: string, example: boolean, kept: string): void {
    this.start(text);
    this.name = name;
    this.kept = kept;
    this.example = example;
    this.open = true;
    this.past = [];
    this.future = [];
    this.answer = null;
    this.work = null;
    this.cancelled = false;
    this.procedures = {};
    this.sections = [];
    this.planSoon(0);
  }

  end(): void {
    clearTimeout(this.timer);
    clearTimeout(this.drawTimer);
    this.asking?.abort();
    this.drawing?.abort();
    this.opened += 1;
    this.open = false;
    this.work = null;
    this.procedures = {};
  }

  /** Another text of a procedure; none: as it is kept. */
  changeProcedure(name: string, text: string | null): void {
    const { [name]: _, ...others } = this.procedures;
    this.procedures = text === null ? others : { ...others, [name]: text };
  }

  override change(text: string, group: string): void {
    if (text === this.text) return;
    const now = Date.now();
    if (group !== this.group || now - this.grouped > 1000) this.past = [...this.past.slice(-STEPS), this.step()];
    this.group = group;
    this.grouped = now;
    this.future = [];
    super.change(text, group);
    this.planSoon();
  }

  async undo(): Promise<void> {
    await this.settled();
    const before = this.past.at(-1);
    if (before === undefined) return;
    this.future = [...this.future, this.step()];
    this.past = this.past.slice(0, -1);
    this.to(before);
  }

  async redo(): Promise<void> {
    await this.settled();
    const after = this.future.at(-1);
    if (after === undefined) return;
    this.past = [...this.past, this.step()];
    this.future = this.future.slice(0, -1);
    this.to(after);
  }

  /**
   * Keeps the text as it is now, with what is on its way into it. `false`: it is not kept, and `trouble` says why; `other`: another text
   * stands there, of this panel's other jobs or of somebody else, and `replace` was not asked for.
   */
  async keep(name: string, replace = false): Promise<boolean | 'other'> {
    await this.settled();
    const { text, opened } = this;
    const over = name === this.name && !this.example ? this.kept : '';
    try {
      await api.keepJob(name, text, replace ? null : over);
      if (opened !== this.opened) return true;
      this.name = name;
      // What was written in the meantime is not in it.
      this.kept = text;
      this.example = false;
      this.trouble = '';
      return true;
    } catch (error) {
      if (error instanceof Refusal && error.key === 'other') return 'other';
      this.trouble = refusalText(error);
      return false;
    }
  }

  /** Ends the plan that is being made; the cell stops working on it when its request is closed. */
  cancel(): void {
    if (!this.plans) return;
    this.asking?.abort();
    this.asking = null;
    this.plans = false;
    this.cancelled = true;
  }

  /** Plans the same text again: a file that it names has changed, or its plan was cancelled. */
  planAgain(): void {
    this.planSoon(0);
  }

  private step(): Step {
    return { text: this.text, form: this.text.length < LONG_CHARS ? this.read : null, wrong: this.wrong };
  }

  private to({ text, form, wrong }: Step): void {
    super.change(text, '');
    if (form) this.take({ text, form, wrong });
    this.group = '';
    this.planSoon();
  }

  private planSoon(wait = PLAN_AFTER_MS): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.plan(), wait);
    clearTimeout(this.drawTimer);
    this.drawTimer = setTimeout(() => void this.draw(), Math.min(wait, DRAW_AFTER_MS));
  }

  /** Parts, fixtures and sections at once; the plan, which takes longer, comes after. */
  private async draw(): Promise<void> {
    void this.refresh();
    if (!session.may('plan')) return;
    this.drawing?.abort();
    const drawing = new AbortController();
    this.drawing = drawing;
    try {
      const drawn = await api.draft(this.text, drawing.signal);
      if (drawing.signal.aborted || drawn.kind !== 'drawn') return;
      this.sections = drawn.sections;
      const { part, fixtures } = drawn;
      if (this.work) this.work = { ...this.work, part, fixtures };
    } catch {
      // What is wrong the plan says.
    }
  }

  private async plan(): Promise<void> {
    if (!session.may('plan')) return;
    this.asking?.abort();
    const asking = new AbortController();
    this.asking = asking;
    this.plans = true;
    this.cancelled = false;
    const text = this.text;
    const begun = Date.now();
    this.planned_s = 0;
    const clock = setInterval(() => (this.planned_s = Math.floor((Date.now() - begun) / 1000)), 500);
    try {
      const answer = await api.plan(text, asking.signal);
      if (asking.signal.aborted || text !== this.text) return;
      this.answer = answer;
      if (answer.kind === 'planned') this.work = answer.work;
      this.trouble = '';
    } catch (error) {
      // A newer request has taken this one's place.
      if (asking.signal.aborted || (error instanceof Refusal && ['busy', 'superseded'].includes(error.key))) return;
      this.trouble = refusalText(error);
    } finally {
      clearInterval(clock);
      if (this.asking === asking) this.plans = false;
    }
  }
}

export const edited = new Edited();
