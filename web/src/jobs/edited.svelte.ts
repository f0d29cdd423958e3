import { api, Refusal } from '../live/api';
import type { PlanAnswer, SectionView, WorkView } from '../wire';
import { refusalText } from '../parts/refusal';

const PLAN_AFTER_MS = 500;
/** What needs no plan is drawn while a number is still being written. */
const DRAW_AFTER_MS = 120;
const STEPS = 500;

/** The job that is being changed: its text, how it was before, and what the cell makes of it. */
class Edited {
  name = $state('');
  text = $state('');
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
  trouble = $state('');
  private past = $state.raw<string[]>([]);
  private future = $state.raw<string[]>([]);
  private timer: ReturnType<typeof setTimeout> | undefined;
  private asking: AbortController | null = null;
  private drawTimer: ReturnType<typeof setTimeout> | undefined;
  private drawing: AbortController | null = null;
  private group = '';
  private grouped = 0;

  readonly changed = $derived(this.text !== this.kept);
  readonly canUndo = $derived(this.past.length > 0);
  readonly canRedo = $derived(this.future.length > 0);

  begin(name: string, text: string, example: boolean, kept: string): void {
    this.name = name;
    this.text = text;
    this.kept = kept;
    this.example = example;
    this.open = true;
    this.past = [];
    this.future = [];
    this.answer = null;
    this.work = null;
    this.sections = [];
    this.trouble = '';
    this.planSoon(0);
  }

  end(): void {
    clearTimeout(this.timer);
    clearTimeout(this.drawTimer);
    this.asking?.abort();
    this.drawing?.abort();
    this.open = false;
    this.work = null;
  }

  /** Another text. Changes of the same `group` within a second are one step of undo. */
  change(text: string, group: string): void {
    if (text === this.text) return;
    const now = Date.now();
    if (group !== this.group || now - this.grouped > 1000) {
      this.past = [...this.past.slice(-STEPS), this.text];
    }
    this.group = group;
    this.grouped = now;
    this.future = [];
    this.text = text;
    this.planSoon();
  }

  undo(): void {
    const before = this.past.at(-1);
    if (before === undefined) return;
    this.future = [...this.future, this.text];
    this.past = this.past.slice(0, -1);
    this.to(before);
  }

  redo(): void {
    const after = this.future.at(-1);
    if (after === undefined) return;
    this.past = [...this.past, this.text];
    this.future = this.future.slice(0, -1);
    this.to(after);
  }

  async keep(name: string): Promise<boolean> {
    try {
      await api.keepJob(name, this.text);
      this.name = name;
      this.kept = this.text;
      this.example = false;
      this.trouble = '';
      return true;
    } catch (error) {
      this.trouble = refusalText(error);
      return false;
    }
  }

  /** Changes the program by operations, which the cell carries out with comments kept. */
  async operate(operations: unknown[]): Promise<boolean> {
    try {
      const { text } = await api.edit(this.text, operations);
      this.change(text, `edit ${Date.now()}`);
      this.trouble = '';
      return true;
    } catch (error) {
      this.trouble = refusalText(error);
      return false;
    }
  }

  /** Plans the same text again: a file that it names has changed. */
  planAgain(): void {
    this.planSoon(0);
  }

  private to(text: string): void {
    this.text = text;
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
    this.asking?.abort();
    const asking = new AbortController();
    this.asking = asking;
    this.plans = true;
    const text = this.text;
    try {
      const answer = await api.plan(text, asking.signal);
      if (asking.signal.aborted || text !== this.text) return;
      this.answer = answer;
      if (answer.kind === 'planned') this.work = answer.work;
      this.trouble = '';
    } catch (error) {
      // A newer request has taken this one's place.
      if (asking.signal.aborted || (error instanceof Refusal && error.key === 'busy')) return;
      this.trouble = refusalText(error);
    } finally {
      if (this.asking === asking) this.plans = false;
    }
  }
}

export const edited = new Edited();
