// The types of the server's routes, together with those few that have no Rust type of their own yet.
export type * from '../wire';

/** A row of `GET /api/alarms/catalogue`. */
export type AlarmEntry = {
  number: number;
  name: string;
  cause: string;
  consequence: string;
  action: string;
  reaction: string;
};

/** A row of `GET /api/audit`. */
export type AuditRow = { at: string; user: string; station: number | null; command: string; result: string };
