import { alarms, type AlarmName, type AlarmWords } from './alarms';
import { en, type Key, type Table } from './en';

export type { Key } from './en';

/** Languages by their codes, each called by its own name. */
export const languages = { en: 'English', uk: 'Українська', zh: '中文', de: 'Deutsch', ru: 'Русский' } as const;
export type Language = keyof typeof languages;

/** Only the words of the chosen language cross the line; English is always there. */
const FILES: Record<Exclude<Language, 'en'>, () => Promise<Table>> = {
  uk: () => import('./uk').then((of) => of.uk),
  zh: () => import('./zh').then((of) => of.zh),
  de: () => import('./de').then((of) => of.de),
  ru: () => import('./ru').then((of) => of.ru),
};
const tables: Partial<Record<Language, Table>> = { en };
let sentence = (text: string, _: Language): string => text;
const KEPT = 'seamwright.language';

function first(): Language {
  const codes = [localStorage.getItem(KEPT), ...navigator.languages.map((code) => code.slice(0, 2))];
  return (codes.find((code) => code !== null && code in languages) as Language | undefined) ?? 'en';
}

class Words {
  language = $state<Language>('en');

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
      const got = await Promise.all([tables[language] ?? FILES[language](), import('./sentences')]).catch(() => null);
      if (!got) return;
      [tables[language], sentence] = [got[0], got[1].sentence];
    }
    this.language = language;
    if (typeof document !== 'undefined') document.documentElement.lang = language;
  }
}

export const words = new Words();

/** The words of a key in the chosen language, `{0}`, `{1}` .. filled in. */
export function t(key: Key, ...of: (string | number)[]): string {
  const text = (tables[words.language] ?? en)[key];
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

/** A sentence that the cell said of a plan, in the chosen language; what has no words is shown as it came. */
export function said(text: string): string {
  return sentence(text, words.language);
}

/** An alarm in the chosen language; one that has no words here keeps those of the cell. */
export function alarmWords(of: AlarmWords & { name: string }): AlarmWords & { name: string } {
  const table = alarms[words.language];
  if (!(of.name in table)) return of;
  const { title, ...row } = table[of.name as AlarmName];
  return { name: title, ...row };
}
