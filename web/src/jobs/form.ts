import type { FormChange, FormEntry, FormValue, FormView } from '../wire';

/** Whether a path of the cell's is another one or is in it. */
export const isWithin = (path: string, above: string): boolean => path === above || path.startsWith(`${above}.`) || path.startsWith(`${above}[`);

/** All values of a form by their paths, without tables. */
export function values(form: FormView | null): Map<string, FormValue> {
  const found = new Map<string, FormValue>();
  const put = ({ path, value }: FormEntry): void => {
    if (value.kind === 'table') value.entries.forEach(put);
    else found.set(path, value);
  };
  form?.tables.forEach(({ entries }) => entries.forEach(put));
  return found;
}

/** The text at a path of a form; empty if there is none. */
export function textAt(form: FormView | null, path: string): string {
  const value = values(form).get(path);
  return value?.kind === 'text' ? value.text : '';
}

/** The form with values that are set already in the fields, before the cell has set them in the text. */
export function withChanges(form: FormView, changes: FormChange[]): FormView {
  return changes.reduce((now, change) => {
    if (change.op !== 'set') return now;
    const entry = (of: FormEntry): FormEntry => (isWithin(change.path, of.path) ? { ...of, value: put(of.value, of.path) } : of);
    const put = (value: FormValue, path: string): FormValue => {
      if (path === change.path) return valueOf(change.value) ?? value;
      if (value.kind === 'table') return { ...value, entries: value.entries.map(entry) };
      if (value.kind !== 'list') return value;
      return { ...value, items: value.items.map((item, i) => (isWithin(change.path, `${path}[${i}]`) ? put(item, `${path}[${i}]`) : item)) };
    };
    return { ...now, tables: now.tables.map((table) => (isWithin(change.path, table.path) || table.path === '' ? { ...table, entries: table.entries.map(entry) } : table)) };
  }, form);
}

/** A value as a form has it; none for tables. */
function valueOf(of: unknown): FormValue | null {
  if (typeof of === 'number') return { kind: 'number', number: of };
  if (typeof of === 'string') return { kind: 'text', text: of };
  if (typeof of === 'boolean') return { kind: 'truth', truth: of };
  const items = Array.isArray(of) ? of.map(valueOf) : [null];
  return items.includes(null) ? null : { kind: 'list', items: items as FormValue[] };
}
