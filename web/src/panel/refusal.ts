import { Refusal } from '../live/api';
import { message, named } from '../words/index.svelte';

/** What a failed request says to the operator: the kind in their language, the detail too where there are words for it. */
export function refusalText(error: unknown): string {
  if (!(error instanceof Refusal)) return String(error);
  const kind = named('trouble', error.key);
  return error.message === '' || error.key === 'lost' ? kind : `${kind}: ${message(error.said)}`;
}
