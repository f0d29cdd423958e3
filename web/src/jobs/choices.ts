/** What may stand in a field of a job or program, by the end of its path; the job's schema has the same lists (a test compares). */
const CHOICES: [RegExp, string[]][] = [
  [/(^|\.)passes\.\d+\.role$/, ['tack', 'root', 'fill', 'cap', 'cosmetic']],
  [/^start\.direction$/, ['counter-clockwise', 'clockwise']],
  [/^seam\..*\.joint$|^procedure\.joint$/, ['fillet', 'butt']],
  [/\.wall_faces$/, ['right', 'left']],
  [/^seam\.t_joint\.fillet$/, ['left', 'right', 'both']],
  [/^seam\.nozzle\.mount$/, ['set_on', 'set_in']],
  [/^seam\.nozzle\.curve$/, ['outer_toe', 'inner_root']],
  [/\.standard$/, ['din_28011', 'din_28013', 'asme_fd']],
  [/\.(prepared|round)$/, ['first', 'second']],
  [/^beads\.adapt$/, ['speed', 'wire_feed', 'weave_width', 'passes']],
  [/^beads\.order$/, ['walls_first', 'from_first', 'from_second']],
  [/(^|\.)weave\.figure$/, ['sine', 'triangle', 'trapezoid', 'circle', 'eight']],
  [/(^|\.)spare_axes\.position$/, ['flat', 'any']],
  [/(^|\.)at_hold$/, ['crater', 'off']],
  [/(^|\.)on_limit$/, ['refuse', 'slow']],
  [/(^|\.)points\.spans\.\d+\.along$/, ['line', 'arc', 'spline', 'taught', 'rapid', 'cubic']],
];

/** What a field may be; nothing where it may be anything. `path`: its table and key. */
export function choicesOf(path: string): string[] {
  return CHOICES.find(([where]) => where.test(path))?.[1] ?? [];
}
