import { refusalText } from './refusal';

/** What a page asks the server for: whether the answer is awaited, and what is said of it. `RequestResult.svelte` shows it. */
export class Asking {
  waits = $state(false);
  said = $state.raw<{ good: boolean; text: string } | null>(null);

  /** Does what asks; true if nothing was refused. What it returns is said. */
  async for(work: () => Promise<string | void>): Promise<boolean> {
    this.waits = true;
    this.said = null;
    try {
      const text = await work();
      if (text) this.said = { good: true, text };
      return true;
    } catch (error) {
      this.refuse(refusalText(error));
      return false;
    } finally {
      this.waits = false;
    }
  }

  refuse(text: string): void {
    this.said = { good: false, text };
  }
}
