export const tabs = ['weld', 'teach', 'jobs', 'records', 'setup'] as const;
export type Tab = (typeof tabs)[number];

/** Where the operator is in the panel. Nothing of it changes what the cell does. */
class Place {
  tab = $state<Tab>('weld');
  /** A place on a pass that is shown in 3D, tables and plots alike: pass from 0 and the sample of its path. */
  spot = $state.raw<{ pass: number; point: number } | null>(null);
}

export const place = new Place();
