import type * as Wire from '../wire';

/** A request that the server refused. */
export class Refusal extends Error {
  constructor(
    readonly status: number,
    readonly key: string,
    /** What the server says; text as it stands if it is not of Seamwright's server. */
    readonly said: Wire.MessageView | string,
  ) {
    super(typeof said === 'string' ? said : said.text);
  }
}

/** What must stand in the header of whatever changes something; `login` before there is a session. */
let token = 'login';

/** Number of this page's connection: what it asks anew takes the place of what this page asked before, not another one. */
let page = '';

export function usePage(station: number): void {
  page = String(station);
}

export function useToken(of: string): void {
  token = of;
}

async function request<T>(method: string, path: string, body?: unknown, signal?: AbortSignal): Promise<T> {
  const headers: Record<string, string> = {};
  if (page !== '') headers['x-seamwright-page'] = page;
  const file = body instanceof Blob;
  if (method !== 'GET') {
    headers['content-type'] = file ? (body.type.startsWith('image/') ? 'image/png' : 'application/x-tar') : 'application/json';
    headers['x-seamwright'] = token;
  }
  const text = method === 'GET' ? null : file ? body : JSON.stringify(body ?? {});
  const response = await answered(path, { method, headers, body: text, signal: signal ?? null });
  if (response.status === 204 || response.status === 202) return undefined as T;
  return (await response.json()) as T;
}

/** What the server answers if it takes what it is asked. */
async function answered(path: string, init: RequestInit = {}): Promise<Response> {
  let response: Response;
  try {
    response = await fetch(path, { ...init, cache: 'no-store' });
  } catch (error) {
    if (error instanceof DOMException && error.name === 'AbortError') throw error;
    throw new Refusal(0, 'lost', String(error));
  }
  if (response.ok) return response;
  const said = await response.text().catch(() => '');
  throw refusal(response.status, said || response.statusText);
}

/** What a refusal says: the server's own, or what stands before its handlers, which speaks plain text. */
export function refusal(status: number, said: string): Refusal {
  try {
    const trouble = JSON.parse(said) as Wire.Trouble;
    if (typeof trouble.key === 'string' && typeof trouble.text === 'string' && Array.isArray(trouble.arguments)) return new Refusal(status, trouble.key, trouble);
  } catch {
    // Plain text.
  }
  return new Refusal(status, status >= 400 && status < 500 ? 'input' : 'server', said.slice(0, 300));
}

const name = encodeURIComponent;

/** A plate with a grid of dots before a camera. */
type Plate = { name: string; pitch_mm: number; z_mm: number };

const query = (of: Record<string, string | number>): string =>
  new URLSearchParams(Object.entries(of).map(([key, value]) => [key, String(value)])).toString();

/** The server's routes, one function each. */
export const api = {
  login: (login: Wire.Login) => request<Wire.SessionView>('POST', '/api/login', login),
  logout: () => request<void>('POST', '/api/logout'),
  /** STOP of a page without login. */
  stop: () => request<Wire.Stopped>('POST', '/api/stop'),
  session: () => request<Wire.SessionView>('GET', '/api/session'),
  machine: () => request<Wire.MachineView>('GET', '/api/machine'),
  /** The machine that a job names, by that name. */
  machineOfJob: (of: string) => request<Wire.MachineView>('GET', `/api/machine/of-job?${query({ name: of })}`),
  devices: () => request<Wire.DeviceView[]>('GET', '/api/devices'),
  diagnostics: () => request<Wire.DiagnosticsView>('GET', '/api/diagnostics'),
  catalogue: () => request<Wire.AlarmEntry[]>('GET', '/api/alarms/catalogue'),
  jobs: () => request<Wire.JobRow[]>('GET', '/api/jobs'),
  choices: () => request<Wire.ChoicesView>('GET', '/api/choices'),
  distortions: () => request<Wire.DistortionRow[]>('GET', '/api/distortions'),
  job: (of: string) => request<Wire.JobText>('GET', `/api/jobs/${name(of)}`),
  /** `over`: the text that it takes the place of, empty for none; `null`: whatever stands there. */
  keepJob: (of: string, text: string, over: string | null) => request<Wire.JobRow>('PUT', `/api/jobs/${name(of)}`, { text, over }),
  deleteJob: (of: string) => request<void>('DELETE', `/api/jobs/${name(of)}`),
  plan: (text: string, signal?: AbortSignal) => request<Wire.PlanAnswer>('POST', '/api/plan', { text }, signal),
  /** Searches the best placement; it ends when nobody waits for it. */
  reach: (asked: Wire.ReachText, signal?: AbortSignal) => request<Wire.ReachAnswer>('POST', '/api/reach', asked, signal),
  /** What this page has asked to be planned and is not answered yet. */
  planning: () => request<Wire.PlanningView[]>('GET', '/api/planning'),
  draft: (text: string, signal?: AbortSignal) => request<Wire.DraftAnswer>('POST', '/api/draft', { text }, signal),
  place: (asked: Wire.PlaceText) => request<Wire.PlaceAnswer>('POST', '/api/place', asked),
  load: (load: Wire.Load) => request<Wire.WorkView>('POST', '/api/load', load),
  post: (text: string, dialect: string) =>
    request<Wire.PostAnswer>('POST', '/api/post', { text, dialect }),
  /** The entries of a text, after changes of some; nothing is saved. */
  form: (text: string, changes: Wire.FormChange[] = []) => request<Wire.FormAnswer>('POST', '/api/form', { text, changes }),
  edit: (text: string, operations: unknown[]) =>
    request<Wire.EditAnswer>('POST', '/api/edit', { text, operations }),
  /** Positions of axes and tip; refused while an axis moves. */
  position: () => request<Wire.StandingView>('GET', '/api/position'),
  /** Checks a target of motion by hand; nothing moves. */
  target: (asked: Wire.TargetText) => request<Wire.TargetAnswer>('POST', '/api/target', asked),
  taught: () => request<Wire.TaughtView>('GET', '/api/teach'),
  taughtProgram: (how: Wire.TeachProgram) => request<Wire.TaughtProgram>('POST', '/api/teach/program', how),
  schedules: () => request<Wire.ScheduleRow[]>('GET', '/api/schedules'),
  schedule: (of: string) => request<Wire.ScheduleView>('GET', `/api/schedules/${name(of)}`),
  /** `replace`: a table that stands under the name. */
  keepSchedule: (of: string, text: string, replace: boolean) => request<Wire.ScheduleRow>('PUT', `/api/schedules/${name(of)}`, { text, replace }),
  deleteSchedule: (of: string) => request<void>('DELETE', `/api/schedules/${name(of)}`),
  runSchedule: (of: string, options: Wire.ScheduleOptions) => request<void>('POST', `/api/schedules/${name(of)}/run`, options),
  cancelSchedule: (of: string) => request<void>('DELETE', `/api/schedules/${name(of)}/run`),
  /** The job of a row, as it would be opened. */
  seamJob: (of: string, row: string, machine: string) =>
    request<Wire.JobText>('GET', `/api/schedules/${name(of)}/job?${query(machine === '' ? { row } : { row, machine })}`),
  /** Address of a result file. */
  scheduleFile: (of: string, file: string) => `/api/schedules/${name(of)}/files/${file}`,
  records: (query: Record<string, string>) =>
    request<Wire.RecordRow[]>('GET', `/api/records?${new URLSearchParams(query).toString()}`),
  record: (id: number) => request<Wire.RecordView>('GET', `/api/records/${id}`),
  /** The program as it was welded; null if it is not kept. */
  recordWork: (id: number) =>
    request<Wire.WorkView | null>('GET', `/api/records/${id}/work`).catch((error: unknown) => {
      if (error instanceof Refusal && error.status === 404) return null;
      throw error;
    }),
  trace: (id: number, columns: string[], most: number) =>
    request<Wire.TraceView>('GET', `/api/records/${id}/trace?columns=${columns.map(name).join(',')}&most=${most}`),
  tuning: (axis: string) => request<Wire.TuningView>('GET', `/api/tuning?axis=${name(axis)}`),
  parameters: () => request<Wire.ParametersView>('GET', '/api/parameters'),
  setParameters: (change: Wire.ParameterChange) => request<Wire.ParametersView>('PUT', '/api/parameters', change),
  findTool: (touches: Wire.ToolTouches) => request<Wire.ToolAnswer>('POST', '/api/tool', touches),
  keepTool: (tip: Wire.ToolTip) => request<Wire.ParametersView>('PUT', '/api/tool', tip),
  frames: () => request<Wire.FramesView>('GET', '/api/frames'),
  keepFrame: (change: Wire.FrameChange) => request<Wire.FramesView>('PUT', '/api/frames', change),
  teachFrame: (points: Wire.FramePoints) => request<Wire.FrameTaught>('POST', '/api/frames/teach', points),
  sensors: () => request<Wire.SensorsView>('GET', '/api/sensors'),
  /** What a picture of a grid of dots says of a camera. */
  findSensor: (plate: Plate, picture: Blob) =>
    request<Wire.SensorAnswer>('POST', `/api/sensor?${query(plate)}`, new Blob([picture], { type: 'image/png' })),
  gridPicture: (plate: Plate & { seed: number }) => answered(`/api/sensor/picture?${query(plate)}`).then((response) => response.blob()),
  keepSensor: (change: Wire.SensorChange) => request<Wire.SensorsView>('PUT', '/api/sensor', change),
  shelve: (of: Wire.Shelving) => request<void>('POST', '/api/alarms/shelve', of),
  audit: (asked: { most: number; text?: string; before?: number; after?: number }) => request<Wire.AuditRow[]>('GET', `/api/audit?${query(asked)}`),
  checkArchive: (file: Blob) => request<Wire.ArchiveView>('PUT', '/api/restore', file),
  restore: (own_password: string | null) => request<void>('POST', '/api/restore', { own_password }),
  users: () => request<Wire.UserRow[]>('GET', '/api/users'),
  keepUser: (of: string, change: Wire.UserChange) => request<Wire.UserRow>('PUT', `/api/users/${name(of)}`, change),
  deleteUser: (of: string, own_password: string | null) =>
    request<void>('DELETE', `/api/users/${name(of)}`, { own_password }),
};
