/** A value in a text, with where it stands. */
export type Value = { from: number; to: number } & (
  | { kind: 'number'; number: number }
  | { kind: 'text'; text: string }
  | { kind: 'truth'; truth: boolean }
  | { kind: 'list'; items: Value[] }
  | { kind: 'table'; entries: Entry[] }
);

/** `key = value` under its table. Tables of a list count from 0: `passes.0.points`. */
export type Entry = { table: string; key: string; value: Value; line: number; comment: string };

/**
 * Reads as much of TOML as jobs and programs are written in, with places, so that a number can be changed and everything
 * else of the text stays byte by byte. What it does not understand it leaves out: the cell's own reader is the judge.
 */
export function read(text: string): Entry[] {
  return new Reader(text).entries();
}

/** The text with a value in another's place. */
export function replaced(text: string, at: { from: number; to: number }, by: string): string {
  return text.slice(0, at.from) + by + text.slice(at.to);
}

/** Where another entry goes in an inline table: behind its last one, or between its empty braces. */
export function within(table: Value & { kind: 'table' }): { from: number; to: number } {
  const last = table.entries.at(-1)?.value.to;
  return last === undefined ? { from: table.from + 1, to: table.to - 1 } : { from: last, to: last };
}

/** The text with another key under those of a table, which has a line of its own there; nothing else changes. */
export function withKey(text: string, rows: Entry[], key: string, value: string): string {
  const last = rows.reduce((a, b) => (b.value.to > a.value.to ? b : a));
  // A dotted key says its table itself: so does the one under it.
  const begin = text.lastIndexOf('\n', last.value.from - 1) + 1;
  const written = /^[ \t]*((?:[A-Za-z0-9_-]+\.)*)/.exec(text.slice(begin, last.value.from))?.[1] ?? '';
  const end = text.indexOf('\n', last.value.to);
  const at = end < 0 ? text.length : end;
  return `${text.slice(0, at)}\n${written}${key} = ${value}${text.slice(at)}`;
}

/** A path as the cell writes it, `passes[0].spans[1].speed_mm_s`, as tables are called here: `passes.0.spans.1.speed_mm_s`. */
export const dotted = (path: string): string => path.replace(/\[(\d+)\]/g, '.$1');

/** How paths in an entry begin. */
const pathOf = (entry: Entry): string => `${entry.table === '' ? '' : `${entry.table}.`}${entry.key}.`;

/** The entry that a path of the cell's is or is in; none for what is not there. */
export function entryAt(entries: Entry[], path: string): Entry | null {
  const wanted = `${dotted(path)}.`;
  const found = entries.filter((entry) => wanted.startsWith(pathOf(entry)));
  return found.sort((a, b) => pathOf(b).length - pathOf(a).length)[0] ?? null;
}

/** What in an entry a path of the cell's is: a number from 0 in a list, a key in a table; none if it is the entry or is not in it. */
export function itemAt(entry: Entry, path: string): string | null {
  const [whole, wanted] = [pathOf(entry), dotted(path)];
  return wanted.startsWith(whole) ? wanted.slice(whole.length).split('.')[0] || null : null;
}

class Reader {
  private at = 0;
  private line = 1;

  constructor(private readonly text: string) {}

  entries(): Entry[] {
    const found: Entry[] = [];
    const counts = new Map<string, number>();
    let table = '';
    while (this.at < this.text.length) {
      this.blanks();
      const c = this.text[this.at];
      if (c === undefined) break;
      if (c === '[') {
        table = this.header(counts);
        continue;
      }
      const entry = this.entry(table);
      if (entry) found.push(entry);
      else this.restOfLine();
    }
    return found;
  }

  private header(counts: Map<string, number>): string {
    const row = this.restOfLine();
    const list = /^\[\[\s*([^\]]+?)\s*\]\]/.exec(row);
    const plain = /^\[\s*([^\]]+?)\s*\]/.exec(row);
    const path = (list?.[1] ?? plain?.[1] ?? '').split('.').map((part) => part.trim().replace(/^["']|["']$/g, ''));
    // Parts of the path that are lists stand for their newest element.
    let resolved = '';
    path.forEach((part, i) => {
      resolved = resolved ? `${resolved}.${part}` : part;
      const last = i === path.length - 1;
      if (list && last) {
        const next = (counts.get(resolved) ?? -1) + 1;
        counts.set(resolved, next);
        // What is under another element counts anew.
        for (const name of [...counts.keys()]) if (name.startsWith(`${resolved}.${next}.`)) counts.delete(name);
        resolved = `${resolved}.${next}`;
      } else if (counts.has(resolved)) resolved = `${resolved}.${counts.get(resolved)}`;
    });
    return resolved;
  }

  private entry(table: string): Entry | null {
    const match = /^([A-Za-z0-9_.-]+|"[^"\n]*")[ \t]*=[ \t]*/.exec(this.text.slice(this.at, this.at + 200));
    if (!match?.[1]) return null;
    const line = this.line;
    this.at += match[0].length;
    const value = this.value();
    if (!value) return null;
    const comment = /^[ \t]*#[ \t]*(.*)/.exec(this.restOfLine())?.[1] ?? '';
    // A dotted key is a key of a table within.
    const parts = match[1].replaceAll('"', '').split('.');
    const key = parts.pop() ?? '';
    return { table: [table, ...parts].filter((part) => part !== '').join('.'), key, value, line, comment };
  }

  private value(): Value | null {
    const from = this.at;
    const c = this.text[this.at];
    if (c === '"' || c === "'") return this.quoted(c, from);
    if (c === '[') return this.list(from);
    if (c === '{') return this.inline(from);
    const word = /^[^\s,\]}#]+/.exec(this.text.slice(this.at, this.at + 80))?.[0];
    if (!word) return null;
    this.at += word.length;
    const to = this.at;
    if (word === 'true' || word === 'false') return { kind: 'truth', truth: word === 'true', from, to };
    const number = Number(word.replaceAll('_', ''));
    return Number.isNaN(number) ? null : { kind: 'number', number, from, to };
  }

  private quoted(mark: string, from: number): Value | null {
    if (this.text.startsWith(mark.repeat(3), from)) {
      const end = this.text.indexOf(mark.repeat(3), from + 3);
      if (end < 0) return null;
      this.step(end + 3);
      return { kind: 'text', text: this.text.slice(from + 3, end), from, to: this.at };
    }
    let end = from + 1;
    while (end < this.text.length && this.text[end] !== mark && this.text[end] !== '\n') {
      end += mark === '"' && this.text[end] === '\\' ? 2 : 1;
    }
    if (this.text[end] !== mark) return null;
    this.at = end + 1;
    const inner = this.text.slice(from + 1, end);
    return { kind: 'text', text: mark === '"' ? unescaped(inner) : inner, from, to: this.at };
  }

  private list(from: number): Value | null {
    const items: Value[] = [];
    this.at += 1;
    for (;;) {
      this.blanks();
      if (this.text[this.at] === ']') break;
      const item = this.value();
      if (!item) return null;
      items.push(item);
      this.blanks();
      if (this.text[this.at] === ',') this.at += 1;
      else if (this.text[this.at] !== ']') return null;
    }
    this.at += 1;
    return { kind: 'list', items, from, to: this.at };
  }

  private inline(from: number): Value | null {
    const entries: Entry[] = [];
    this.at += 1;
    for (;;) {
      this.blanks();
      if (this.text[this.at] === '}') break;
      const match = /^([A-Za-z0-9_.-]+|"[^"\n]*")\s*=\s*/.exec(this.text.slice(this.at, this.at + 200));
      if (!match?.[1]) return null;
      this.step(this.at + match[0].length);
      const value = this.value();
      if (!value) return null;
      entries.push({ table: '', key: match[1], value, line: this.line, comment: '' });
      this.blanks();
      if (this.text[this.at] === ',') this.at += 1;
      else if (this.text[this.at] !== '}') return null;
    }
    this.at += 1;
    return { kind: 'table', entries, from, to: this.at };
  }

  /** Over blanks, ends of lines and comments. */
  private blanks(): void {
    for (;;) {
      const c = this.text[this.at];
      if (c === '#') {
        while (this.at < this.text.length && this.text[this.at] !== '\n') this.at += 1;
      } else if (c === ' ' || c === '\t' || c === '\r' || c === '\n') {
        if (c === '\n') this.line += 1;
        this.at += 1;
      } else return;
    }
  }

  private restOfLine(): string {
    const end = this.text.indexOf('\n', this.at);
    const to = end < 0 ? this.text.length : end;
    const row = this.text.slice(this.at, to);
    this.step(Math.min(to + 1, this.text.length));
    return row;
  }

  private step(to: number): void {
    for (let i = this.at; i < to; i += 1) if (this.text[i] === '\n') this.line += 1;
    this.at = to;
  }
}

function unescaped(inner: string): string {
  try {
    return JSON.parse(`"${inner}"`) as string;
  } catch {
    return inner;
  }
}
