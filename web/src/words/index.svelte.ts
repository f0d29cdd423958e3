import type { AlarmView, MessageView } from '../wire';
import { Catalogue, languages, load, whole, type Language, type Tongue } from './catalogue';
import { loadShipped } from './shipped';

export { languages, type Language } from './catalogue';

const RETRY_MS = 5000;
const KEPT = 'seamwright.language';

/** The language of the address (`?language=de`, for tests also `pseudo`), the one that was chosen here, or the browser's. */
function first(): Tongue {
  const asked = typeof location === 'undefined' ? null : new URLSearchParams(location.search).get('language');
  if (asked === 'pseudo') return asked;
  const codes = [asked, localStorage.getItem(KEPT), ...navigator.languages.map((code) => code.slice(0, 2))];
  return (codes.find((code) => code !== null && code in languages) as Language | undefined) ?? 'en';
}

class Words {
  /** Words of the chosen language: the panel's first, then those of the cell's messages. */
  catalogue = $state.raw(new Catalogue('en', []));
  /** Comments and titles of supplied files in that language, by their English text. */
  shipped = $state.raw<Record<string, string>>({});

  get language(): Language {
    return this.catalogue.language;
  }

  /** Loads the language of this page, or English. */
  async begin(): Promise<void> {
    const tongue = first();
    if (await this.speak(tongue)) return;
    if (tongue !== 'en' && (await this.speak('en'))) return;
    // The page works without words, STOP above all.
    setTimeout(() => void this.begin(), RETRY_MS);
  }

  async choose(language: Language): Promise<void> {
    if (await this.speak(language)) localStorage.setItem(KEPT, language);
  }

  /** Changes the language; if its words cannot be loaded, the language stays. */
  private async speak(tongue: Tongue): Promise<boolean> {
    const sources = await load(tongue === 'pseudo' ? 'en' : tongue, 'first').catch(() => null);
    if (!sources) return false;
    this.catalogue = new Catalogue(tongue, sources);
    this.shipped = {};
    if (typeof document !== 'undefined') document.documentElement.lang = this.language;
    // Messages come with their English text.
    if (tongue !== 'en') void this.learn(tongue, sources, this.catalogue);
    return true;
  }

  /** Loads the words of the cell's messages, which are in English until then; what fails is tried again. */
  private async learn(tongue: Tongue, sources: readonly string[], now: Catalogue): Promise<void> {
    try {
      const [rest, shipped] = await Promise.all([load(now.language, 'rest'), loadShipped(now.language)]);
      if (this.catalogue !== now) return;
      [this.catalogue, this.shipped] = [new Catalogue(tongue, [...sources, ...rest]), shipped];
    } catch {
      setTimeout(() => void this.learn(tongue, sources, now), RETRY_MS);
    }
  }
}

export const words = new Words();

/** Code of a key's words: the panel's own, or those that reports have too. */
function code(key: string): string {
  const name = key.replace(/[._ ]/g, '-');
  return words.catalogue.has(`panel-${name}`) ? `panel-${name}` : name;
}
const value = (of: string | number) => (typeof of === 'number' && Number.isInteger(of) ? whole(of) : String(of));

/** The words of a key in the chosen language: `tab.weld` is `panel-tab-weld` in `messages/LANGUAGE/panel.ftl`, `value.current` is `value-current` in `words.ftl`. A test finds keys without words. */
export function t(key: string, of: Record<string, string | number> = {}): string {
  const found = words.catalogue.words(code(key), Object.fromEntries(Object.entries(of).map(([name, one]) => [name, value(one)])));
  // Before the catalogue is there, no key has words.
  if (found === undefined && words.catalogue.has(code('all'))) console.warn('no words:', key);
  return found ?? key;
}

/** The words of a key that is made of a name from the cell; a name without words is shown as it is. */
export function named(prefix: string, name: string): string {
  const key = `${prefix}.${name}`;
  return words.catalogue.has(code(key)) ? t(key) : name;
}

/** A message of the cell in the chosen language. Text, as in old records, stays as it is. */
export function message(of: MessageView | string): string {
  return typeof of === 'string' ? of : words.catalogue.text(of);
}

/** A comment or title of a job's or machine's file in the chosen language if the file is supplied; a user's own as it is. */
export function shipped(text: string): string {
  return words.shipped[text] ?? text;
}

/** What an alarm is about: a condition in words, an axis by its name, or what tracking lacks. */
export function about(of: MessageView | string): string {
  return named('interlock', message(of));
}

/** Title, cause, consequence, or operator action of an alarm, by its number in the catalogue. */
function alarmPart(number: number, part: 'title' | 'cause' | 'consequence' | 'action'): string | null {
  return words.catalogue.words(`alarm-${number}-${part}`, {});
}

type AlarmWords = Pick<AlarmView, 'name' | 'cause' | 'consequence' | 'action'>;

/** An alarm in the chosen language; without words there it keeps those of the cell. */
export function alarmWords(number: number, of: AlarmWords): AlarmWords {
  return {
    name: alarmPart(number, 'title') ?? of.name,
    cause: alarmPart(number, 'cause') ?? of.cause,
    consequence: alarmPart(number, 'consequence') ?? of.consequence,
    action: alarmPart(number, 'action') ?? of.action,
  };
}
