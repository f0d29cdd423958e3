import { en, type Key, type Table } from './en';

export type { Key } from './en';

/** Languages by their codes, each called by its own name. */
export const languages = { en: 'English', uk: 'Українська', zh: '中文', de: 'Deutsch', ru: 'Русский' } as const;
export type Language = keyof typeof languages;

/** Why an alarm comes, what follows, what to do. */
export type AlarmWords = { cause: string; consequence: string; action: string };

/** What there is of a language; alarms by their names in the cell's catalogue. */
type Tongue = { table: Table; alarms: Record<string, AlarmWords & { title: string }> };

/** Only the words of the chosen language cross the line; English is always there, and the cell's own for alarms. */
const FILES: Record<Exclude<Language, 'en'>, () => Promise<Tongue>> = {
  uk: () => import('./uk').then((of) => ({ table: of.uk, alarms: of.alarms })),
  zh: () => import('./zh').then((of) => ({ table: of.zh, alarms: of.alarms })),
  de: () => import('./de').then((of) => ({ table: of.de, alarms: of.alarms })),
  ru: () => import('./ru').then((of) => ({ table: of.ru, alarms: of.alarms })),
};
const tongues: Partial<Record<Language, Tongue>> = { en: { table: en, alarms: {} } };
const AGAIN_MS = 5000;
const KEPT = 'seamwright.language';

function first(): Language {
  const codes = [localStorage.getItem(KEPT), ...navigator.languages.map((code) => code.slice(0, 2))];
  return (codes.find((code) => code !== null && code in languages) as Language | undefined) ?? 'en';
}

class Words {
  language = $state<Language>('en');
  /** Says a sentence of the cell's in a language; they come after the panel's own words, which nothing waits for longer. */
  sentence = $state.raw((text: string, _: Language, __: (text: string) => string): string => text);
  /** Says a comment or title of a file that ships. */
  shipped = $state.raw((text: string, _: Language): string => text);

  /** The language that was chosen here, or the browser's. */
  async begin(): Promise<void> {
    await this.speak(first());
  }

  async choose(language: Language): Promise<void> {
    await this.speak(language);
    localStorage.setItem(KEPT, this.language);
  }

  /** From now on; if its words do not come, it stays as it was. */
  private async speak(language: Language): Promise<void> {
    if (language !== 'en') {
      const got = await FILES[language]().catch(() => null);
      if (!got) return;
      tongues[language] = got;
      void this.learn();
    }
    this.language = language;
    if (typeof document !== 'undefined') document.documentElement.lang = language;
  }

  /** The cell's sentences are shown as they came until they have words; a line that fails is tried again. */
  private async learn(): Promise<void> {
    try {
      ({ sentence: this.sentence, shipped: this.shipped } = await import('./sentences'));
    } catch {
      setTimeout(() => void this.learn(), AGAIN_MS);
    }
  }
}

export const words = new Words();

/** The words of a key in the chosen language, `{0}`, `{1}` .. filled in. */
export function t(key: Key, ...of: (string | number)[]): string {
  const text = (tongues[words.language]?.table ?? en)[key];
  return of.length === 0 ? text : text.replace(/\{(\d)\}/g, (_, i: string) => String(of[Number(i)] ?? ''));
}

/** The words of a key that is made of what the cell sent; what has no words is shown as it came. */
export function named(prefix: string, name: string): string {
  const key = `${prefix}.${name.replaceAll(' ', '_')}`;
  return key in en ? t(key as Key) : name;
}

const TEMPLATES = new Map(Object.entries(en).flatMap(([key, text]) => (key.startsWith('example.') ? [[text as string, key as Key] as const] : [])));

/** A job's title: that of a template in the chosen language, any other as its file says. */
export function titled(title: string): string {
  const key = TEMPLATES.get(title);
  return key ? t(key) : title;
}

/** A sentence that the cell said of a plan or a weld, in the chosen language; what has no words is shown as it came. */
export function said(text: string): string {
  return words.sentence(text, words.language, alarmTitle);
}

/** A comment or title of a job's or machine's file, in the chosen language if the file ships; a user's own as it is. */
export function shipped(text: string): string {
  return words.shipped(text, words.language);
}

/** What the note of a weld says, sentence by sentence. */
export function noted(text: string): string {
  return text.split('; ').map(said).join('; ');
}

/** What an alarm is about: a condition or what tracking lacks in words, an axis by its name. */
export function about(name: string): string {
  const words = named('interlock', name);
  return words === name ? said(name) : words;
}

/** What the catalogue calls an alarm and, where the library keeps its name, what it is about. */
const ALARM = /^([^:(]+?)(?: \((.*)\)|: (.*))?$/s;

/** An alarm in the chosen language; one that has no words there keeps those of the cell. */
export function alarmWords(of: AlarmWords & { name: string }): AlarmWords & { name: string } {
  const [, name = '', ...more] = ALARM.exec(of.name) ?? [];
  const row = tongues[words.language]?.alarms[name];
  if (!row) return of;
  const { title, ...rest } = row;
  const detail = more.find((text) => text !== undefined);
  return { name: detail === undefined ? title : `${title} (${about(detail)})`, ...rest };
}

/** An alarm's title in the chosen language. */
export function alarmTitle(name: string): string {
  return alarmWords({ name, cause: '', consequence: '', action: '' }).name;
}
