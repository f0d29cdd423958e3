import { api } from '../live/api';
import { cell } from '../live/cell.svelte';
import { place } from '../parts/place.svelte';

/** Touches of one point with the tool, positions of all axes each; kept when the page is left. */
class Touches {
  list = $state.raw<number[][]>([]);
}

export const touches = new Touches();

/** The job of the cell anew, so that what was kept of its machine is in force. */
export async function loadAnew(): Promise<void> {
  const work = cell.work;
  if (!work) return;
  await api.load({ job: work.job, from: null, part: place.part || null, distortion: work.distortion });
  await cell.askMachine();
}
