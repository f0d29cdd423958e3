/** Ends of the vertical axis: a tenth of room, and at least `height` in all; `zero`: it begins at 0 if nothing is below. */
export function ends(least: number | null, most: number | null, height: number, zero = false): [number, number] {
  if (least === null || most === null || !Number.isFinite(least) || !Number.isFinite(most)) return [0, height || 1];
  if (zero && least >= 0) return [0, Math.max(most * 1.1, height || 1e-6)];
  const room = Math.max((most - least) * 0.1, (height - (most - least)) / 2, Math.abs(most) * 0.01, 1e-6);
  return [least - room, most + room];
}
