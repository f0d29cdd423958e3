/** A table of a text, from its header to its last line: what stands above the next header belongs to that. */
type Table = { name: string; from: number; to: number };

/** Joint preparations after ISO 9692-1, with sizes to begin with. */
export const PREPARATIONS: Record<string, Record<string, number | string>> = {
  square: { thickness_mm: 4, root_gap_mm: 1 },
  single_v: { thickness_mm: 10, angle_deg: 60, root_gap_mm: 2, root_face_mm: 2 },
  bevel: { thickness_mm: 10, angle_deg: 45, root_gap_mm: 2, root_face_mm: 2, prepared: 'first' },
  u: { thickness_mm: 16, angle_deg: 8, radius_mm: 6, land_mm: 0, root_gap_mm: 1, root_face_mm: 2 },
  j: { thickness_mm: 16, angle_deg: 15, radius_mm: 6, land_mm: 0, root_gap_mm: 1, root_face_mm: 2, prepared: 'first' },
  fillet: { leg_mm: 6, root_gap_mm: 0, prepared: 'first' },
  flare_bevel: { radius_mm: 10, unfilled_mm: 0, round: 'first' },
  flare_v: { radius_mm: 10, unfilled_mm: 0 },
  t_bevel: { thickness_mm: 12, cut_deg: 50, root_gap_mm: 2, root_face_mm: 1, leg_mm: 0, prepared: 'first' },
  t_j: { thickness_mm: 16, angle_deg: 20, radius_mm: 6, land_mm: 0, root_gap_mm: 2, root_face_mm: 1, leg_mm: 0, prepared: 'first' },
};

/** Tables that a job may have and that can be added, with numbers to begin with. */
const ADDED: Record<string, string> = {
  start: 'phi_deg = 20\n',
  placement: 'move_mm = [0, 0, 0]\n',
  torch: 'work_angle_deg = 0\ntravel_angle_deg = 0\n',
  sequence: 'preflow_s = 0.5\ntravel_delay_s = 0.3\ncrater_s = 0.8\npostflow_s = 3\n',
  tolerance: 'path_mm = 0.2\nspeed_percent = 5\nattitude_deg = 10\n',
  clearance: 'least_mm = 5\n',
};
export const ADDABLE = ['procedure', 'joint', ...Object.keys(ADDED)];

/** What of it this text can be given: jobs along a seam, which do not have it yet. */
export function addable(text: string): string[] {
  const names = tables(text).map(({ name }) => name);
  if (!names.some((name) => name.startsWith('seam'))) return [];
  const root = text.slice(0, firstHeader(text));
  const has = (of: string): boolean => names.some((name) => name === of || name.startsWith(`${of}.`)) || new RegExp(`^\\s*${of}\\s*[=.]`, 'm').test(root);
  return ADDABLE.filter((of) => !has(of));
}

/** The text with a table of these (see `addable`); `procedure`: the one to be named. */
export function added(text: string, what: string, procedure: string): string {
  if (what === 'procedure') {
    const at = text.search(/^\s*machine\s*=.*$/m);
    const end = at < 0 ? firstHeader(text) : text.indexOf('\n', text.indexOf('machine', at)) + 1;
    return `${text.slice(0, end)}procedure = ${JSON.stringify(procedure)}\n${text.slice(end)}`;
  }
  const body = what === 'joint' ? `[joint]\ncap_mm = 0\n\n${preparation('single_v', {})}` : `[${what}]\n${ADDED[what] ?? ''}`;
  return `${text.trimEnd()}\n\n${body}`;
}

/** The kind of joint preparation that a text has a table of; empty if none. */
export function kindOf(text: string): string {
  return tables(text).map(({ name }) => /^joint\.preparation\.(\w+)$/.exec(name)?.[1]).find((kind) => kind !== undefined) ?? '';
}

/** The text with another kind of preparation; sizes that both have stay, the seam's own are taken from `numbers`. */
export function withKind(text: string, kind: string, numbers: Record<string, number | string>): string {
  const table = tables(text).find(({ name }) => name.startsWith('joint.preparation.'));
  if (!table) return text;
  return `${text.slice(0, table.from)}${preparation(kind, numbers)}${text.slice(table.to)}`;
}

/** The text without a table and those within it. */
export function without(text: string, name: string): string {
  let left = text;
  for (const table of tables(text).reverse()) {
    if (table.name === name || table.name.startsWith(`${name}.`)) left = left.slice(0, table.from) + left.slice(table.to).replace(/^\n+/, '');
  }
  return `${left.trimEnd()}\n`;
}

function preparation(kind: string, numbers: Record<string, number | string>): string {
  const rows = Object.entries(PREPARATIONS[kind] ?? {}).map(([key, value]) => {
    const kept = numbers[key];
    return `${key} = ${JSON.stringify(typeof kept === typeof value ? kept : value)}\n`;
  });
  return `[joint.preparation.${kind}]\n${rows.join('')}`;
}

function firstHeader(text: string): number {
  return tables(text)[0]?.from ?? text.length;
}

/** Headers are lines of their own; a row of numbers has no letters. */
function tables(text: string): Table[] {
  const headers = [...text.matchAll(/^[ \t]*\[{1,2}[ \t]*([A-Za-z_][\w.-]*)[ \t]*\]{1,2}[ \t]*(#.*)?$/gm)];
  return headers.map((header, i) => {
    const next = headers[i + 1]?.index;
    const body = text.slice(header.index, next);
    // Blank lines and comments above the next header are not of this one.
    const own = next === undefined ? body : body.replace(/(\n[ \t]*(#[^\n]*)?)*$/, '\n');
    return { name: header[1] ?? '', from: header.index, to: header.index + own.length };
  });
}
