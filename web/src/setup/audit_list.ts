import type { AuditRow } from '../wire';

/** Entries of the audit log that are shown, the newest first, and if there may be older ones. */
export type Listed = { rows: AuditRow[]; older: boolean };

/** What a first page shows; a page has `most` entries. */
export const begun = (page: AuditRow[], most: number): Listed => ({ rows: page, older: page.length === most });

/** With a page of older ones at its end. */
export const further = (of: Listed, page: AuditRow[], most: number): Listed => ({ rows: [...of.rows, ...page], older: page.length === most });

/** With what came since; so much that a page does not hold it all begins the list anew, or it would have a gap. */
export function renewed(of: Listed, page: AuditRow[], most: number): Listed {
  if (page.length === most) return begun(page, most);
  const newest = of.rows[0]?.id ?? 0;
  return { ...of, rows: [...page.filter((row) => row.id > newest), ...of.rows] };
}
