/** What records are looked for and looked at: it stays while other pages are looked at. */
class Found {
  text = $state('');
  result = $state('');
  from = $state('');
  /** Welds that are to be compared. */
  chosen = $state.raw<number[]>([]);
  /** Welds whose page is open. */
  shown = $state.raw<number[]>([]);
}

export const found = new Found();
