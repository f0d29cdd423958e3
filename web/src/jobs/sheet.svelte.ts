import { api } from '../live/api';
import { refusalText } from '../panel/refusal';
import type { FormAnswer, FormChange, FormView, WrongView } from '../wire';
import { withChanges } from './form';

/** A text and its form. The cell makes changes of entries, one after the other, and keeps everything else of the text. */
export class Sheet {
  text = $state('');
  /** The entries of the text, and in them what is on its way into it; the last ones that could be read. */
  form = $state.raw<FormView | null>(null);
  /** What is wrong with the text, as far as reading finds it. */
  wrong = $state.raw<WrongView | null>(null);
  /** It is TOML. */
  readable = $state(true);
  trouble = $state('');
  /** The entries of the text as it is now; none before they are read. */
  protected read: FormView | null = null;
  /** Counts the texts that were opened: what is answered later is not meant for the next one. */
  protected opened = 0;
  /** How many changes the cell is to make, one after the other. */
  protected operations = $state(0);
  private last: Promise<unknown> = Promise.resolve();
  /** Counts the changes that failed: those that waited behind one are dropped, as their paths may be of other elements now. */
  private failures = 0;

  /** Begins with a text, whose entries are read by `refresh`. */
  start(text: string): void {
    this.opened += 1;
    this.text = text;
    this.form = this.read = null;
    this.wrong = null;
    this.readable = true;
    this.trouble = '';
  }

  /** Another text. Changes of the same `group` within a second are one step of undo. */
  change(text: string, _group: string): void {
    this.text = text;
    this.read = null;
  }

  /** Waits until all that was changed is in the text. */
  async settled(): Promise<void> {
    while (this.operations > 0) await this.last;
  }

  /** Changes entries of the text. */
  edit(changes: FormChange[], group: string): Promise<boolean> {
    if (this.form) this.form = withChanges(this.form, changes);
    return this.carryOut((text) => api.form(text, changes), group);
  }

  /** Changes the program by operations. */
  operate(operations: unknown[]): Promise<boolean> {
    return this.carryOut(async (text) => api.form((await api.edit(text, operations)).text), `edit ${Date.now()}`);
  }

  /** Reads the entries of the text, unless they are known. */
  async refresh(): Promise<void> {
    const { text, opened } = this;
    if (this.read) return;
    try {
      const answer = await api.form(text);
      if (text === this.text && opened === this.opened) this.take(answer);
    } catch (error) {
      this.trouble = refusalText(error);
    }
  }

  protected take({ form, wrong }: FormAnswer): void {
    this.wrong = wrong;
    this.readable = form !== null;
    this.read = form;
    if (form && this.operations < 2) this.form = form;
  }

  private carryOut(send: (text: string) => Promise<FormAnswer>, group: string): Promise<boolean> {
    this.operations += 1;
    const { opened, failures } = this;
    const done = this.last.then(() => failures === this.failures && this.made(send, group, opened)).finally(() => {
      this.operations -= 1;
      // What was refused is as it was.
      if (this.operations === 0 && this.read) this.form = this.read;
    });
    this.last = done;
    return done;
  }

  private async made(send: (text: string) => Promise<FormAnswer>, group: string, opened: number): Promise<boolean> {
    try {
      while (opened === this.opened) {
        const before = this.text;
        const answer = await send(before);
        // Meanwhile changed by hand: once more, from there.
        if (opened !== this.opened || before !== this.text) continue;
        this.change(answer.text, group);
        this.take(answer);
        this.trouble = '';
        return true;
      }
    } catch (error) {
      this.failures += 1;
      this.trouble = refusalText(error);
    }
    return false;
  }
}
