import type {
  AlarmEntry,
  ArchiveView,
  AuditRow,
  ChoicesView,
  DistortionRow,
  DeviceView,
  DraftAnswer,
  EditAnswer,
  FormAnswer,
  FormChange,
  JobRow,
  JobText,
  Load,
  Login,
  MachineView,
  MessageView,
  ParameterChange,
  ParametersView,
  PlaceAnswer,
  PlaceText,
  PlanAnswer,
  PostAnswer,
  RecordRow,
  RecordView,
  SensorAnswer,
  SensorChange,
  SensorsView,
  SessionView,
  StandingView,
  Shelving,
  Stopped,
  TaughtProgram,
  TaughtView,
  TeachProgram,
  ToolAnswer,
  ToolTip,
  ToolTouches,
  TraceView,
  TuningView,
  Trouble,
  UserChange,
  UserRow,
  WorkView,
} from '../wire';

/** A request that the server refused. */
export class Refusal extends Error {
  constructor(
    readonly status: number,
    readonly key: string,
    /** What the server says; text as it stands if it is not of Seamwright's server. */
    readonly said: MessageView | string,
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
    const trouble = JSON.parse(said) as Trouble;
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
  login: (login: Login) => request<SessionView>('POST', '/api/login', login),
  logout: () => request<void>('POST', '/api/logout'),
  /** STOP of a page without login. */
  stop: () => request<Stopped>('POST', '/api/stop'),
  session: () => request<SessionView>('GET', '/api/session'),
  machine: () => request<MachineView>('GET', '/api/machine'),
  /** The machine that a job names, by that name. */
  machineOfJob: (of: string) => request<MachineView>('GET', `/api/machine/of-job?${query({ name: of })}`),
  devices: () => request<DeviceView[]>('GET', '/api/devices'),
  catalogue: () => request<AlarmEntry[]>('GET', '/api/alarms/catalogue'),
  jobs: () => request<JobRow[]>('GET', '/api/jobs'),
  choices: () => request<ChoicesView>('GET', '/api/choices'),
  distortions: () => request<DistortionRow[]>('GET', '/api/distortions'),
  job: (of: string) => request<JobText>('GET', `/api/jobs/${name(of)}`),
  /** `over`: the text that it takes the place of, empty for none; `null`: whatever stands there. */
  keepJob: (of: string, text: string, over: string | null) => request<JobRow>('PUT', `/api/jobs/${name(of)}`, { text, over }),
  deleteJob: (of: string) => request<void>('DELETE', `/api/jobs/${name(of)}`),
  plan: (text: string, signal?: AbortSignal) => request<PlanAnswer>('POST', '/api/plan', { text }, signal),
  draft: (text: string, signal?: AbortSignal) => request<DraftAnswer>('POST', '/api/draft', { text }, signal),
  place: (asked: PlaceText) => request<PlaceAnswer>('POST', '/api/place', asked),
  load: (load: Load) => request<WorkView>('POST', '/api/load', load),
  post: (text: string, dialect: string) =>
    request<PostAnswer>('POST', '/api/post', { text, dialect }),
  /** The entries of a text, after changes of some; nothing is saved. */
  form: (text: string, changes: FormChange[] = []) => request<FormAnswer>('POST', '/api/form', { text, changes }),
  edit: (text: string, operations: unknown[]) =>
    request<EditAnswer>('POST', '/api/edit', { text, operations }),
  /** Positions of axes and tip; refused while an axis moves. */
  position: () => request<StandingView>('GET', '/api/position'),
  taught: () => request<TaughtView>('GET', '/api/teach'),
  taughtProgram: (how: TeachProgram) => request<TaughtProgram>('POST', '/api/teach/program', how),
  records: (query: Record<string, string>) =>
    request<RecordRow[]>('GET', `/api/records?${new URLSearchParams(query).toString()}`),
  record: (id: number) => request<RecordView>('GET', `/api/records/${id}`),
  /** The program as it was welded; null if it is not kept. */
  recordWork: (id: number) =>
    request<WorkView | null>('GET', `/api/records/${id}/work`).catch((error: unknown) => {
      if (error instanceof Refusal && error.status === 404) return null;
      throw error;
    }),
  trace: (id: number, columns: string[], most: number) =>
    request<TraceView>('GET', `/api/records/${id}/trace?columns=${columns.map(name).join(',')}&most=${most}`),
  tuning: (axis: string) => request<TuningView>('GET', `/api/tuning?axis=${name(axis)}`),
  parameters: () => request<ParametersView>('GET', '/api/parameters'),
  setParameters: (change: ParameterChange) => request<ParametersView>('PUT', '/api/parameters', change),
  findTool: (touches: ToolTouches) => request<ToolAnswer>('POST', '/api/tool', touches),
  keepTool: (tip: ToolTip) => request<ParametersView>('PUT', '/api/tool', tip),
  sensors: () => request<SensorsView>('GET', '/api/sensors'),
  /** What a picture of a grid of dots says of a camera. */
  findSensor: (plate: Plate, picture: Blob) =>
    request<SensorAnswer>('POST', `/api/sensor?${query(plate)}`, new Blob([picture], { type: 'image/png' })),
  gridPicture: (plate: Plate & { seed: number }) => answered(`/api/sensor/picture?${query(plate)}`).then((response) => response.blob()),
  keepSensor: (change: SensorChange) => request<SensorsView>('PUT', '/api/sensor', change),
  shelve: (of: Shelving) => request<void>('POST', '/api/alarms/shelve', of),
  audit: (asked: { most: number; text?: string; before?: number; after?: number }) => request<AuditRow[]>('GET', `/api/audit?${query(asked)}`),
  checkArchive: (file: Blob) => request<ArchiveView>('PUT', '/api/restore', file),
  restore: (own_password: string | null) => request<void>('POST', '/api/restore', { own_password }),
  users: () => request<UserRow[]>('GET', '/api/users'),
  keepUser: (of: string, change: UserChange) => request<UserRow>('PUT', `/api/users/${name(of)}`, change),
  deleteUser: (of: string, own_password: string | null) =>
    request<void>('DELETE', `/api/users/${name(of)}`, { own_password }),
};
